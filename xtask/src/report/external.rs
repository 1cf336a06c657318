//! Libraries outside this workspace: scipy, when python3 has it, and GSL, when it is installed.
//!
//! Both get the scaled integrand, split at the kinks, as our own classical methods do, and both get
//! it as numbers on standard input: laws that are sums of powers, and no others.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;

use anyhow::{Context, Result, bail, ensure};
use asperity::Form;

use super::methods::{Failure, Outcome};
use super::problem::Problem;

/// A library that was found.
pub struct External {
    /// Its name as a method.
    pub name: &'static str,
    /// What the Markdown says of it.
    pub what: String,
    command: PathBuf,
    arguments: Vec<String>,
}

/// Problems for one setting, all answered in one process.
pub struct Group {
    /// Relative tolerance.
    pub tolerance: f64,
    /// How many times all of them are run in turn, to take the median; 0 takes no time.
    pub repeats: usize,
    /// The problems; every law a sum of powers.
    pub problems: Vec<Arc<Problem>>,
}

/// What came back for a group.
pub struct Answers {
    /// Median time of one integral \[ns\], if it was taken.
    pub median_ns: Option<f64>,
    /// One for each problem.
    pub outcomes: Vec<Result<Outcome, Failure>>,
}

/// Whether a problem can be handed over.
#[must_use]
pub fn can_take(problem: &Problem) -> bool {
    problem.law.parts.iter().all(|part| matches!(part.form, Form::Powers(_)))
}

/// A folder for what is made on the way; it goes with the value.
pub struct Workshop(PathBuf);

impl Workshop {
    /// An empty folder.
    ///
    /// # Errors
    /// When there is no room for it.
    pub fn new() -> Result<Self> {
        let folder = std::env::temp_dir().join(format!("asperity-report-{}", std::process::id()));
        std::fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
        Ok(Self(folder))
    }
}

impl Drop for Workshop {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The words a command prints, if it succeeds.
fn words(command: &str, arguments: &[&str]) -> Option<Vec<String>> {
    let output = Command::new(command).args(arguments).stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.split_whitespace().map(str::to_owned).collect())
}

/// Those that are there. One that is installed and does not work is an error.
///
/// # Errors
/// When GSL is said to be there and a program that uses it cannot be built.
pub fn find(workshop: &Workshop) -> Result<Vec<External>> {
    let mut found = vec![];
    if let Some(version) = words("python3", &["-c", "import scipy; print(scipy.__version__)"]) {
        let script = workshop.0.join("quad.py");
        std::fs::write(&script, include_str!("external/quad.py"))?;
        found.push(External {
            name: "scipy",
            what: format!("scipy {} quad per branch, scaled", version.join(" ")),
            command: "python3".into(),
            arguments: vec![script.display().to_string()],
        });
    }
    let flags = words("pkg-config", &["--cflags", "--libs", "gsl"])
        .or_else(|| words("gsl-config", &["--cflags", "--libs"]));
    if let Some(flags) = flags {
        let version = words("pkg-config", &["--modversion", "gsl"])
            .or_else(|| words("gsl-config", &["--version"]))
            .unwrap_or_default();
        let (source, program) = (workshop.0.join("qag.c"), workshop.0.join("qag"));
        std::fs::write(&source, include_str!("external/qag.c"))?;
        let built = Command::new("cc")
            .args(["-O2", "-o"])
            .args([&program, &source])
            .args(&flags)
            .arg("-lm")
            .output()
            .context("GSL is installed, and cc is not")?;
        let said = String::from_utf8_lossy(&built.stderr);
        ensure!(built.status.success(), "GSL is installed, and its program does not build: {said}");
        let what = format!("GSL {} qag with 21 points per branch, scaled", version.join(" "));
        found.push(External { name: "gsl", what, command: program, arguments: vec![] });
    }
    Ok(found)
}

impl External {
    /// Runs the groups.
    ///
    /// # Errors
    /// When the process fails or answers something else.
    pub fn run(&self, groups: &[Group]) -> Result<Vec<Answers>> {
        let mut input = String::new();
        for group in groups {
            writeln!(input, "{:e} {} {}", group.tolerance, group.repeats, group.problems.len())?;
            for problem in &group.problems {
                write_problem(&mut input, problem)?;
            }
        }
        let mut process = Command::new(&self.command)
            .args(&self.arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .with_context(|| self.name)?;
        let mut stdin = process.stdin.take().context("no standard input")?;
        // Written beside, or both sides would wait for each other.
        let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
        let output = process.wait_with_output()?;
        ensure!(output.status.success(), "{} failed: {}", self.name, output.status);
        if !matches!(writer.join(), Ok(Ok(()))) {
            bail!("{} did not read its input", self.name);
        }
        let text = String::from_utf8(output.stdout)?;
        let mut lines = text.lines();
        groups.iter().map(|group| answers(group, &mut lines)).collect()
    }
}

/// One line: s, slope, exponential, scale, the breaks, the parts.
fn write_problem(out: &mut String, problem: &Problem) -> Result<()> {
    let flag = |flag: bool| u8::from(flag);
    let (slope, exponential) = (flag(problem.slope()), flag(problem.exponential()));
    write!(out, "{:e} {slope} {exponential} {:e}", problem.separation, problem.scale())?;
    let breaks = problem.breaks();
    write!(out, " {}", breaks.len())?;
    breaks.iter().try_for_each(|t| write!(out, " {t:e}"))?;
    write!(out, " {}", problem.law.parts.len())?;
    for part in &problem.law.parts {
        let Form::Powers(powers) = &part.form else { bail!("a law that is no sum of powers") };
        let end = part.range.end.min(f64::MAX);
        write!(out, " {:e} {end:e} {:e} {}", part.range.start, part.sign, powers.len())?;
        for power in powers {
            write!(out, " {:e} {:e} {:e}", power.coefficient, power.origin, power.exponent)?;
        }
    }
    writeln!(out)?;
    Ok(())
}

/// A line with the time, then for each problem value, evaluations and 1 where it converged.
fn answers<'a>(group: &Group, lines: &mut impl Iterator<Item = &'a str>) -> Result<Answers> {
    let mut next = || lines.next().context("an answer is missing");
    let time: f64 = next()?.trim().parse()?;
    let mut outcomes = vec![];
    for problem in &group.problems {
        let line = next()?;
        let fields: Vec<&str> = line.split_whitespace().collect();
        let [value, evaluations, converged] = fields[..] else { bail!("answer {line:?}") };
        let value = problem.in_units(value.parse()?);
        outcomes.push(if converged == "1" {
            Ok(Outcome { value, scaled: true, evaluations: Some(evaluations.parse()?) })
        } else {
            Err(Failure::NotConverged)
        });
    }
    Ok(Answers { median_ns: (group.repeats > 0).then_some(time), outcomes })
}
