//! The committed figures equal the models, and the guard detects differences.

use std::fs;
use std::path::{Path, PathBuf};

use xtask::files::{stale, write};
use xtask::folder::figures_folder;

#[test]
fn committed_figures_are_up_to_date() {
    assert_eq!(stale(&figures_folder(), &[]).unwrap(), Vec::<String>::new());
}

/// A copy of the committed figures of one name, in a folder that is removed on drop.
struct Copy(PathBuf);

impl Copy {
    fn of(name: &str, label: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("asperity-{label}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        for ending in ["csv", "svg"] {
            let file = format!("{name}.{ending}");
            fs::copy(figures_folder().join(&file), folder.join(&file)).unwrap();
        }
        Self(folder)
    }

    fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The text with every number multiplied by 1 + `change`.
fn perturbed(text: &str, change: f64) -> String {
    let field = |field: &str| match field.parse::<f64>() {
        Ok(number) => format!("{:e}", number * (1.0 + change)),
        Err(_) => field.to_owned(),
    };
    let lines = text.lines().map(|line| line.split(',').map(field).collect::<Vec<_>>().join(","));
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

#[test]
fn the_guard_fails_at_1e_6_and_passes_at_1e_12() {
    let name = "fig07-area-models";
    let copy = Copy::of(name, "guard");
    let csv = copy.path().join(format!("{name}.csv"));
    let committed = fs::read_to_string(&csv).unwrap();

    fs::write(&csv, perturbed(&committed, 1e-6)).unwrap();
    let found = stale(copy.path(), &[name]).unwrap();
    assert!(found.contains(&format!("{name}.csv")), "{found:?}");

    let nudged = perturbed(&committed, 1e-12);
    fs::write(&csv, &nudged).unwrap();
    // The csv may stay unchanged; a picture is drawn from its exact text.
    assert!(!stale(copy.path(), &[name]).unwrap().contains(&format!("{name}.csv")));
    write(copy.path(), &[name]).unwrap();
    assert_eq!(fs::read_to_string(&csv).unwrap(), nudged);
    assert_eq!(stale(copy.path(), &[name]).unwrap(), Vec::<String>::new());
}

#[test]
fn a_touched_picture_or_a_missing_file_is_named_and_nothing_is_written() {
    let name = "angle-density";
    let copy = Copy::of(name, "stale");
    let svg = copy.path().join(format!("{name}.svg"));
    let touched = fs::read_to_string(&svg).unwrap() + " ";
    fs::write(&svg, &touched).unwrap();
    assert_eq!(stale(copy.path(), &[name]).unwrap(), [format!("{name}.svg")]);
    assert_eq!(fs::read_to_string(&svg).unwrap(), touched);
    fs::remove_file(&svg).unwrap();
    assert_eq!(stale(copy.path(), &["angle"]).unwrap(), [format!("{name}.svg")]);
    assert!(!svg.exists());
}

#[test]
fn unknown_figures_are_refused_with_the_list() {
    let message = stale(&figures_folder(), &["fig11"]).unwrap_err().to_string();
    assert!(message.contains("fig11") && message.contains("fig05-force-models"), "{message}");
}
