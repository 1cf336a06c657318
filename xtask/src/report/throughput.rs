//! Evaluations per second on one and two threads, and memory. Each sweep runs in a separate
//! process, whose peak memory is that of the sweep alone.

use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use asperity::{Case, Model, Quantity, Request, Scene, Sweep, Tolerance, linspace};

use super::points::scenes;
use super::scope::Scope;
use super::tables::significant;
use crate::command::output;

/// The task of `xtask` that runs one sweep; not for users.
pub const TASK: &str = "report-throughput";

/// The sweeps: model, kind, count and description.
const SWEEPS: [(&str, &str, usize, &str); 4] = [
    ("ke", "separations", 1_000_000, "separations of one scene"),
    (
        "ke",
        "materials",
        1_000_000,
        "scenes of other materials, radius, roughness and density, streamed",
    ),
    ("gao", "separations", 1_000_000, "separations of one scene"),
    ("gao", "surfaces", 100_000, "scenes of other roughness and density, streamed"),
];

/// Measures; returns the rows of a table: sweep, threads, million evaluations per second, and peak
/// of the process's resident memory, where the system reports it.
///
/// # Errors
/// When a process fails.
pub fn measure(scope: Scope) -> Result<Vec<[String; 4]>> {
    let program = std::env::current_exe()?;
    let mut lines = vec![];
    for (model, kind, full, what) in SWEEPS {
        let count = if scope == Scope::Full { full } else { full / 10 };
        for threads in ["1", "2"] {
            let sweep = [TASK, model, kind, &count.to_string(), threads];
            let text = output(Command::new(&program).args(sweep))?;
            let (millions, memory) = text.trim().split_once(' ').context("no rate")?;
            let what = format!("{model} force, {count} {what}");
            lines.push([what, threads.into(), millions.into(), memory.into()]);
        }
    }
    Ok(lines)
}

/// Runs one sweep. Returns million evaluations per second and peak memory.
///
/// # Errors
/// Another model or kind, or a scene that is refused.
pub fn run(model: &str, kind: &str, count: usize, threads: usize) -> Result<String> {
    let model: Model = model.parse()?;
    ensure!(SWEEPS.iter().any(|sweep| sweep.1 == kind), "{kind:?} is not a kind of sweep");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let start = Instant::now();
    pool.install(|| sweep(&model, kind, count))?;
    let millions = significant(count as f64 / start.elapsed().as_secs_f64() / 1e6);
    let memory = peak_memory().map_or("–".into(), |bytes| format!("{:.0} MB", bytes / 1e6));
    Ok(format!("{millions} {memory}"))
}

fn sweep(model: &Model, kind: &str, count: usize) -> Result<()> {
    let base = &scenes()?[1];
    if kind == "separations" {
        let request = Request::new([Quantity::Force]).at(linspace(-1.0, 6.0, count));
        black_box(model.solve(base, &request)?);
        return Ok(());
    }
    let sweep = Sweep::new(&**model, &[Quantity::Force], Tolerance::default());
    let cases = (0..count).map(|k| case(base, k, kind == "materials"));
    sweep.stream(cases, |_, answer| {
        black_box(answer?);
        Ok(())
    })
}

/// Scene and separation number `k`: multiples of irrational numbers fill their ranges evenly.
fn case(base: &Scene, k: usize, materials: bool) -> Case {
    let share = |step: f64| (k as f64 * step).fract();
    let mut scene = base.clone();
    scene.surface.asperity_height_std *= 0.5 + share(0.618_034);
    scene.surface.asperity_density *= 0.5 + share(0.414_214);
    if materials {
        scene.surface.asperity_radius *= 0.5 + share(0.236_068);
        scene.interface.equivalent_modulus *= 0.7 + 0.6 * share(0.645_751);
        scene.interface.hardness =
            scene.interface.hardness.map(|h| h * (0.8 + 0.4 * share(0.162_278)));
    }
    Case::new(scene, -1.0 + 7.0 * share(0.605_551))
}

/// Peak of the resident memory of this process \[bytes\]; Linux only.
fn peak_memory() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let rest = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024.0 * rest.split_whitespace().next()?.parse::<f64>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_returns_its_rate_and_unknown_kinds_are_refused() -> Result<()> {
        for (_, kind, ..) in SWEEPS {
            let line = run("ke", kind, 500, 2)?;
            let numbers: Vec<f64> = line.split_whitespace().flat_map(str::parse).collect();
            assert!(numbers[0] > 0.0 && numbers.get(1).is_none_or(|mb| *mb > 1.0), "{line}");
        }
        assert!(run("ke", "moons", 500, 2).is_err() && run("moon", "surfaces", 500, 2).is_err());
        Ok(())
    }
}
