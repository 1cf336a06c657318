//! scipy's `quad`, when python3 has it.
//!
//! It integrates the scaled integrand, split at the kinks, as our adaptive rule does, and reads it
//! as json from standard input, which limits it to laws that are sums of powers.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use anyhow::{Context, Result, bail, ensure};
use asperity::{Formula, Part};
use serde_json::json;

use super::problem::{Failure, NOT_CONVERGED, Outcome, Problem};
use xtask::command::output;
use xtask::folder::write as save;

/// scipy on this machine.
pub struct Scipy {
    /// Our program for it.
    script: PathBuf,
}

/// A relative tolerance, how many times the problem is run to take the median (0 takes no time),
/// and the problem, whose law is a sum of powers.
pub type Task = (f64, usize, Arc<Problem>);

/// The result of a task, and its median time \[ns\].
pub type Answer = (Result<Outcome, Failure>, f64);

/// Whether a problem can be passed to it.
#[must_use]
pub fn can_take(problem: &Problem) -> bool {
    problem.law.parts.iter().all(|part| matches!(part.form, Formula::Powers(_)))
}

impl Scipy {
    /// scipy with the files that it needs in a folder.
    ///
    /// # Errors
    /// When python3 has no scipy.
    pub fn find(folder: &Path) -> Result<Self> {
        output(Command::new("python3").args(["-c", "import scipy"])).context("scipy is missing")?;
        let script = folder.join("quad.py");
        save(&script, include_str!("quad.py"))?;
        Ok(Self { script })
    }

    /// Runs the tasks, all in one process.
    ///
    /// # Errors
    /// When the process fails or its output is malformed.
    pub fn run(&self, tasks: &[Task]) -> Result<Vec<Answer>> {
        let path = self.script.with_extension("tasks");
        save(&path, tasks.iter().map(line).collect::<Result<String>>()?)?;
        let text = output(Command::new("python3").arg(&self.script).stdin(File::open(&path)?))?;
        ensure!(text.lines().count() == tasks.len(), "scipy: answers are missing");
        tasks.iter().zip(text.lines()).map(|(task, line)| answer(&task.2, line)).collect()
    }
}

/// One line of json: tolerance, repeats, the breaks, and the integrand.
fn line((tolerance, repeats, problem): &Task) -> Result<String> {
    let part = |part: &Part| {
        let Formula::Powers(powers) = &part.form else {
            bail!("a law that is not a sum of powers")
        };
        let powers = powers.iter().map(|power| [power.coefficient, power.origin, power.exponent]);
        let (start, end) = (part.range.start, part.range.end.min(f64::MAX));
        Ok(json!([start, end, part.sign, powers.collect::<Vec<_>>()]))
    };
    let parts = problem.law.parts.iter().map(part).collect::<Result<Vec<_>>>()?;
    let integrand = json!([problem.separation, problem.slope(), problem.scale(), parts]);
    Ok(json!([tolerance, repeats, problem.breaks(), integrand]).to_string() + "\n")
}

/// Reads a line: value, 1 for converged, time.
fn answer(problem: &Problem, line: &str) -> Result<Answer> {
    let fields: Vec<&str> = line.split_whitespace().collect();
    let [value, converged, ns] = fields[..] else { bail!("answer {line:?}") };
    let found = Outcome { value: problem.in_units(value.parse()?), scaled: true };
    let found = if converged == "1" { Ok(found) } else { Err(NOT_CONVERGED) };
    Ok((found, ns.parse()?))
}
