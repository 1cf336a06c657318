//! Evaluations per second on one and two threads, and the memory that takes.

use std::fs;
use std::time::Instant;

use anyhow::Result;
use asperity::{Model, Quantity, Request, linspace};

use super::scope::{Scope, scenes};

/// One line of the table.
pub struct Throughput {
    /// What was run.
    pub what: String,
    /// Threads of the pool.
    pub threads: usize,
    /// Evaluations in a second; the best of three runs.
    pub per_second: f64,
    /// Growth of the resident memory at its peak [bytes], where the system tells it.
    pub memory: Option<f64>,
}

/// Measures.
///
/// # Errors
/// When a pool cannot be made, or a scene is refused.
pub fn measure(scope: Scope) -> Result<Vec<Throughput>> {
    let count = match scope {
        Scope::Full => 1_000_000,
        Scope::Quick => 20_000,
    };
    let mut lines = vec![];
    for id in ["ke", "gao"] {
        let model: Model = id.parse()?;
        let scene = &scenes()?[1];
        let request = Request::new([Quantity::Force]).at(linspace(-1.0, 6.0, count));
        let compiled = model.compile(scene, &request)?;
        let run = || Ok(compiled.respond(&request).map(|answer| answer.separations.len())?);
        let what = format!("{} force, {count} separations of one scene", model.name());
        lines.extend(on_pools(&what, count, run)?);
    }
    Ok(lines)
}

/// Runs something of so many evaluations on pools of one and two threads.
fn on_pools(
    what: &str,
    evaluations: usize,
    run: impl Fn() -> Result<usize> + Sync,
) -> Result<Vec<Throughput>> {
    let mut lines = vec![];
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let mut best = f64::INFINITY;
        let mut memory = None;
        for _ in 0..3 {
            let before = forget_peak();
            let start = Instant::now();
            pool.install(&run)?;
            best = best.min(start.elapsed().as_secs_f64());
            memory = before.zip(status("VmHWM:")).map(|(before, peak)| (peak - before).max(0.0));
        }
        let per_second = evaluations as f64 / best;
        lines.push(Throughput { what: what.to_owned(), threads, per_second, memory });
    }
    Ok(lines)
}

/// Makes the peak of resident memory begin anew; gives the memory now [bytes]. Linux only.
fn forget_peak() -> Option<f64> {
    fs::write("/proc/self/clear_refs", "5").ok()?;
    status("VmRSS:")
}

/// A line of /proc/self/status [bytes].
fn status(name: &str) -> Option<f64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let rest = text.lines().find_map(|line| line.strip_prefix(name))?;
    Some(1024.0 * rest.split_whitespace().next()?.parse::<f64>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_has_its_line_and_memory_is_seen_to_grow() -> Result<()> {
        let lines =
            on_pools("a megabyte", 1000, || Ok(std::hint::black_box(vec![1u8; 16 << 20]).len()))?;
        assert_eq!(lines.iter().map(|line| line.threads).collect::<Vec<_>>(), [1, 2]);
        assert!(lines.iter().all(|line| line.per_second > 0.0));
        if let Some(memory) = lines[0].memory {
            assert!(memory > 4e6, "{memory}");
        }
        Ok(())
    }
}
