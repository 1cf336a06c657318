//! Evaluations per second on one and two threads, and the memory that takes: each in a process of
//! its own, whose peak memory is that of the sweep and nothing else.

use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};
use asperity::{Case, Model, Quantity, Request, Scene, Sweep, Tolerance, linspace};

use super::scope::{Scope, scenes};

/// The task of `xtask` that runs one sweep; not for users.
pub const TASK: &str = "report-throughput";

/// One line of the table.
pub struct Throughput {
    /// What was run.
    pub what: String,
    /// Threads.
    pub threads: usize,
    /// Evaluations in a second.
    pub per_second: f64,
    /// Peak of the process's resident memory \[bytes\], where the system tells it.
    pub memory: Option<f64>,
}

/// What is swept.
const KINDS: [(&str, &str); 3] = [
    ("separations", "separations of one scene"),
    ("surfaces", "scenes of other roughness and density, streamed"),
    ("materials", "scenes of other materials, radius, roughness and density, streamed"),
];

/// Measures.
///
/// # Errors
/// When a process fails.
pub fn measure(scope: Scope) -> Result<Vec<Throughput>> {
    let program = std::env::current_exe()?;
    let mut lines = vec![];
    for (model, kind, full) in [
        ("ke", "separations", 1_000_000),
        ("ke", "materials", 1_000_000),
        ("gao", "separations", 1_000_000),
        ("gao", "surfaces", 100_000),
    ] {
        let count = if scope == Scope::Full { full } else { full / 10 };
        let what = KINDS.iter().find(|known| known.0 == kind).map_or(kind, |known| known.1);
        for threads in [1, 2] {
            let output = Command::new(&program)
                .args([TASK, model, kind, &count.to_string(), &threads.to_string()])
                .output()?;
            ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            let text = String::from_utf8(output.stdout)?;
            let mut numbers = text.split_whitespace().map(str::parse::<f64>);
            lines.push(Throughput {
                what: format!("{model} force, {count} {what}"),
                threads,
                per_second: numbers.next().context("no rate")??,
                memory: numbers.next().transpose()?,
            });
        }
    }
    Ok(lines)
}

/// Runs one sweep: model, kind, count and threads. Gives evaluations per second and peak memory.
///
/// # Errors
/// Other words, or a scene that is refused.
pub fn run(words: &[&str]) -> Result<String> {
    let [model, kind, count, threads] = words[..] else {
        bail!("{TASK} MODEL KIND COUNT THREADS was required");
    };
    let (model, count): (Model, usize) = (model.parse()?, count.parse()?);
    ensure!(KINDS.iter().any(|known| known.0 == kind), "{kind:?} is no kind of sweep");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.parse()?).build()?;
    let start = Instant::now();
    pool.install(|| sweep(&model, kind, count))?;
    let rate = count as f64 / start.elapsed().as_secs_f64();
    Ok(format!("{rate:e} {}", peak_memory().map_or(String::new(), |bytes| format!("{bytes:e}"))))
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
    Case { scene, separation: -1.0 + 7.0 * share(0.605_551) }
}

/// The most memory this process has had resident \[bytes\]; Linux only.
fn peak_memory() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let rest = text.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024.0 * rest.split_whitespace().next()?.parse::<f64>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_tells_its_rate_and_other_words_are_refused() -> Result<()> {
        for kind in KINDS {
            let line = run(&["ke", kind.0, "500", "2"])?;
            let numbers: Vec<f64> = line.split_whitespace().flat_map(str::parse).collect();
            assert!(numbers[0] > 100.0 && numbers.get(1).is_none_or(|b| *b > 1e6), "{line}");
        }
        assert!(run(&["ke", "moons", "500", "2"]).is_err() && run(&["ke"]).is_err());
        Ok(())
    }
}
