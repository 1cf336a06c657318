//! A folder with a scene in it, and the program run there.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use asperity_scene::SceneFile;

/// Whether long cases run as well: `.ci/full` sets `ASPERITY_LONG`.
pub fn is_long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}

/// A scene without a shear modulus.
pub const NO_SHEAR: &str = include_str!("scenes/no-shear.toml");

/// A scene whose printed AT force is negative around a separation of 1.
pub const NEGATIVE: &str = include_str!("scenes/negative.toml");

/// A soft body on a rigid one, which adhere.
pub const SOFT: &str = include_str!("scenes/soft.toml");

/// The template with the lines that tell what conducts: those below the commented [interface] stand
/// in the second body then.
pub fn conducting() -> String {
    let template = asperity_scene::template();
    let template = template.replace("# thermal_conductivity", "thermal_conductivity");
    template.replace("# electrical_resistivity", "electrical_resistivity")
}

pub struct Bench {
    folder: tempfile::TempDir,
}

/// What a run left behind.
pub struct Run {
    pub code: Option<i32>,
    pub out: String,
    pub messages: String,
}

impl Bench {
    /// With the template as `scene.toml`.
    pub fn new() -> Self {
        let bench = Self { folder: tempfile::tempdir().unwrap() };
        bench.write("scene.toml", asperity_scene::template());
        bench
    }

    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_asperity"));
        command.current_dir(self.folder());
        command
    }

    /// Runs with these arguments, separated by blanks.
    pub fn run(&self, arguments: &str) -> Run {
        Run::of(self.command().args(arguments.split_whitespace()).output().unwrap())
    }

    /// Runs with these arguments, and presses Ctrl-C while the program is at work.
    #[cfg(unix)]
    pub fn interrupted(&self, arguments: &str) -> Run {
        let mut command = self.command();
        let piped = std::process::Stdio::piped;
        command.args(arguments.split_whitespace()).stdout(piped()).stderr(piped());
        let child = command.spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(1500));
        let kill = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(kill.unwrap().success());
        Run::of(child.wait_with_output().unwrap())
    }

    /// The data of a run that succeeds.
    pub fn data(&self, arguments: &str) -> String {
        let run = self.run(arguments);
        assert_eq!(run.code, Some(0), "asperity {arguments}\n{}", run.messages);
        run.out
    }

    pub fn scene(&self, name: &str) -> SceneFile {
        asperity_scene::load(self.path(name)).unwrap()
    }
}

impl Run {
    pub fn of(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("the program writes UTF-8");
        Self { code: output.status.code(), out: text(output.stdout), messages: text(output.stderr) }
    }
}

/// The cells of one column of a csv.
pub fn cells<'t>(text: &'t str, name: &str) -> Vec<&'t str> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let mut head = lines.next().unwrap().split(',');
    let place = head.position(|h| h == name).unwrap_or_else(|| panic!("no {name}"));
    lines.map(|line| line.split(',').nth(place).unwrap()).collect()
}

/// The numbers of one column.
pub fn column(text: &str, name: &str) -> Vec<f64> {
    cells(text, name).iter().map(|cell| cell.parse().unwrap()).collect()
}
