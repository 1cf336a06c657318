//! Libraries outside this workspace: scipy, when python3 has it, and GSL, when it is installed.
//!
//! Both integrate the scaled integrand, split at the kinks, like our own classical methods. They
//! read it as numbers from standard input, which limits them to laws that are sums of powers.

use std::fmt::Write as _;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use anyhow::{Context, Result, bail, ensure};
use asperity::Formula;

use super::problem::{Failure, NOT_CONVERGED, Outcome, Problem};
use xtask::command::output;
use xtask::folder::write as save;

/// A library of this machine.
pub struct External {
    /// Its name as a method.
    pub name: &'static str,
    /// Its description.
    pub what: String,
    /// The program with its arguments; the last is a file of ours.
    command: Vec<PathBuf>,
}

/// A relative tolerance, how many times the problem is run to take the median (0 takes no time),
/// and the problem, whose law is a sum of powers.
pub type Task = (f64, usize, Arc<Problem>);

/// The result of a task, and its median time \[ns\].
pub type Answer = (Result<Outcome, Failure>, f64);

/// Whether a problem can be passed to another library.
#[must_use]
pub fn can_take(problem: &Problem) -> bool {
    problem.law.parts.iter().all(|part| matches!(part.form, Formula::Powers(_)))
}

/// The words that a command prints, if it succeeds.
fn output_of(command: &str, arguments: &[&str]) -> Option<Vec<String>> {
    let printed = output(Command::new(command).args(arguments)).ok()?;
    Some(printed.split_whitespace().map(str::to_owned).collect())
}

/// The libraries of this machine, with the files that they need in a folder.
///
/// # Errors
/// When GSL is installed and a program that uses it cannot be built.
pub fn find(folder: &Path) -> Result<Vec<External>> {
    let mut found = vec![];
    if let Some(version) = output_of("python3", &["-c", "import scipy; print(scipy.__version__)"]) {
        let script = folder.join("quad.py");
        save(&script, include_str!("external/quad.py"))?;
        found.push(External {
            name: "scipy",
            what: format!("scipy {} quad per branch, scaled", version.join(" ")),
            command: vec!["python3".into(), script],
        });
    }
    if let Some(flags) = output_of("gsl-config", &["--cflags", "--libs"]) {
        let version = output_of("gsl-config", &["--version"]).unwrap_or_default();
        let (source, program) = (folder.join("qag.c"), folder.join("qag"));
        save(&source, include_str!("external/qag.c"))?;
        let mut cc = Command::new("cc");
        cc.args(["-O2", "-o"]).args([&program, &source]).args(&flags).arg("-lm");
        output(&mut cc).context("GSL is installed, but its program does not build")?;
        let what = format!("GSL {} qag with 21 points per branch, scaled", version.join(" "));
        found.push(External { name: "gsl", what, command: vec![program] });
    }
    Ok(found)
}

impl External {
    /// Runs the tasks, all in one process.
    ///
    /// # Errors
    /// When the process fails or its output is malformed.
    pub fn run(&self, tasks: &[Task]) -> Result<Vec<Answer>> {
        let [program, arguments @ ..] = &self.command[..] else { bail!("no program") };
        let path = arguments.last().unwrap_or(program).with_extension("tasks");
        save(&path, tasks.iter().map(line).collect::<Result<String>>()?)?;
        let input = File::open(&path)?;
        let text = output(Command::new(program).args(arguments).stdin(input))?;
        ensure!(text.lines().count() == tasks.len(), "{}: answers are missing", self.name);
        tasks.iter().zip(text.lines()).map(|(task, line)| answer(&task.2, line)).collect()
    }
}

/// One line: tolerance, repeats, s, slope, scale, the breaks, the parts.
fn line((tolerance, repeats, problem): &Task) -> Result<String> {
    let (slope, breaks) = (u8::from(problem.slope()), problem.breaks());
    let (s, scale) = (problem.separation, problem.scale());
    let mut line = format!("{tolerance:e} {repeats} {s:e} {slope} {scale:e}");
    write!(line, " {}", breaks.len())?;
    breaks.iter().try_for_each(|t| write!(line, " {t:e}"))?;
    write!(line, " {}", problem.law.parts.len())?;
    for part in &problem.law.parts {
        let Formula::Powers(powers) = &part.form else {
            bail!("a law that is not a sum of powers")
        };
        let (start, end) = (part.range.start, part.range.end.min(f64::MAX));
        write!(line, " {start:e} {end:e} {:e} {}", part.sign, powers.len())?;
        for power in powers {
            write!(line, " {:e} {:e} {:e}", power.coefficient, power.origin, power.exponent)?;
        }
    }
    Ok(line + "\n")
}

/// Reads a line: value, evaluations, 1 for converged, time.
fn answer(problem: &Problem, line: &str) -> Result<Answer> {
    let fields: Vec<&str> = line.split_whitespace().collect();
    let [value, evaluations, converged, ns] = fields[..] else { bail!("answer {line:?}") };
    let (value, evaluations) = (problem.in_units(value.parse()?), Some(evaluations.parse()?));
    let found = Outcome { value, scaled: true, evaluations };
    let found = if converged == "1" { Ok(found) } else { Err(NOT_CONVERGED) };
    Ok((found, ns.parse()?))
}
