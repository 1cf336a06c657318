//! The tables for readers: `speed-vs-error.md`, made of the csv's text.

use std::fmt::Write as _;

use anyhow::Result;

use super::external::External;
use super::methods::{self, HARD_TOLERANCE};
use super::sheet::Sheet;
use super::speed::significant;
use super::throughput::Throughput;

/// The row of a csv that these cells tell apart.
struct Rows<'a> {
    sheet: Sheet<'a>,
    time: usize,
    error: usize,
    evaluations: usize,
}

/// Time \[ns\], error or word, and evaluations, as they stand in the csv.
#[derive(Clone, Copy)]
struct Entry<'a> {
    time: f64,
    error: &'a str,
    evaluations: &'a str,
}

impl<'a> Rows<'a> {
    fn new(csv: &'a str) -> Result<Self> {
        let sheet = Sheet::new(csv);
        let [time, error, evaluations] =
            ["median_ns", "max_relative_error", "evaluations"].map(|name| sheet.column(name));
        Ok(Self { time: time?, error: error?, evaluations: evaluations?, sheet })
    }

    /// The row of a method at a tolerance; at the tightest there is, if a model is not asked for
    /// that, and the last row of a method without tolerances.
    fn entry(&self, pair: (&str, &str), method: &str) -> Option<Entry<'a>> {
        let rows = self.sheet.rows().iter();
        let rows: Vec<&Vec<&str>> =
            rows.filter(|row| (row[0], row[1], row[2]) == (pair.0, pair.1, method)).collect();
        let asked = |row: &&&Vec<&str>| {
            row[3].parse::<f64>().is_ok_and(|tolerance| tolerance >= 0.99 * HARD_TOLERANCE)
        };
        let row = rows.iter().rfind(asked).or(rows.last())?;
        let (error, evaluations) = (row[self.error], row[self.evaluations]);
        Some(Entry { time: row[self.time].parse().ok()?, error, evaluations })
    }

    fn pairs(&self) -> Vec<(&'a str, &'a str)> {
        let mut pairs: Vec<(&str, &str)> = vec![];
        for row in self.sheet.rows() {
            if pairs.last() != Some(&(row[0], row[1])) {
                pairs.push((row[0], row[1]));
            }
        }
        pairs
    }
}

/// The Markdown.
///
/// # Errors
/// A csv that is not `speed-vs-error.csv`.
pub fn text(
    speed: &str,
    throughput: &[Throughput],
    libraries: &[External],
    machine: &str,
) -> Result<String> {
    let rows = Rows::new(speed)?;
    let mut text = format!(
        "# Speed against error

Written by `cargo xtask report`; measured on {machine}. Times are medians of one process and one run, on the same 56 points for every method: d/σ_z from -1 to 6, w_c/σ_z from 0.003 to 3. Errors are the worst on the hard cases with Gaussian heights, d/σ_z from -3 to 40 and w_c/σ_z from 1e-8 to 1e4 (tests/reference/hard_cases.csv), relative to the sum of the sizes of signed parts. All settings stand in speed-vs-error.csv, every hard case in hard-cases.csv. Errors and evaluations do not depend on the machine and are guarded by tests; times do and are not.

## Time and worst error

Asked for {HARD_TOLERANCE:e} where a method takes a tolerance.

"
    );
    let columns = rows.sheet.values("method")?;
    let columns: Vec<&str> = columns.into_iter().filter(|m| !m.starts_with("build-")).collect();
    writeln!(text, "| model | quantity | {} |", columns.join(" | "))?;
    writeln!(text, "|---|---|{}", "---|".repeat(columns.len()))?;
    for pair in rows.pairs() {
        write!(text, "| {} | {} |", pair.0, pair.1)?;
        for method in &columns {
            match rows.entry(pair, method) {
                Some(entry) => write!(text, " {}, {} |", duration(entry.time), entry.error)?,
                None => write!(text, " |")?,
            }
        }
        text.push('\n');
    }
    ratios(&mut text, &rows)?;
    builds(&mut text, &rows)?;
    sweeps(&mut text, throughput)?;
    text.push_str("\n## Methods\n\n| method | what it is |\n|---|---|\n");
    for method in methods::all() {
        writeln!(text, "| `{}` | {} |", method.name, method.what)?;
    }
    for library in libraries {
        writeln!(text, "| `{}` | {} |", library.name, library.what)?;
    }
    for name in ["scipy", "gsl"] {
        if libraries.iter().all(|library| library.name != name) {
            writeln!(text, "| `{name}` | not found on this machine |")?;
        }
    }
    text.push_str("| `build-law` | the law of a quantity, with its tables where it has them |\n");
    text.push_str(
        "| `build-scene` | law built: a scene ready at eight separations from -1 to 6 |\n",
    );
    text.push_str(
        "\nscipy and gsl have the laws that are sums of powers. Every method samples the same laws; those of Gao and AT are tables over the interference, whose angles are averaged already. A tangent is the integral of the force law times (d + w)/σ_z², which holds the law's jumps, for every method.\n",
    );
    Ok(text)
}

/// What the issue of speed is about, in numbers of one run.
fn ratios(text: &mut String, rows: &Rows) -> Result<()> {
    text.push_str("\n## Ratios in this run\n\n");
    let ke = ("ke", "force");
    for ours in ["compiled", "rule"] {
        let Some(own) = rows.entry(ke, ours) else { continue };
        for other in ["gauss-kronrod", "tanh-sinh", "gsl", "scipy"] {
            if let Some(entry) = rows.entry(ke, other) {
                let ratio = significant(entry.time / own.time);
                writeln!(
                    text,
                    "* KE force at {HARD_TOLERANCE:e}: {other} takes {ratio} times as long as {ours} ({} against {} evaluations)",
                    entry.evaluations, own.evaluations
                )?;
            }
        }
    }
    if let Some(ke) = rows.entry(ke, "compiled") {
        for (model, quantity) in rows.pairs() {
            let angles = ["gao", "at"].contains(&model) && quantity == "force";
            if let Some(entry) = rows.entry((model, quantity), "compiled").filter(|_| angles) {
                let ratio = significant(entry.time / ke.time);
                writeln!(text, "* {model} {quantity}, compiled: {ratio} times KE's force")?;
            }
        }
    }
    Ok(())
}

fn builds(text: &mut String, rows: &Rows) -> Result<()> {
    text.push_str(
        "\n## Building\n\n| model | quantity | law | scene, law sampled |\n|---|---|---|---|\n",
    );
    for pair in rows.pairs() {
        let (law, scene) = (rows.entry(pair, "build-law"), rows.entry(pair, "build-scene"));
        if let (Some(law), Some(scene)) = (law, scene) {
            let (law, time) = (duration(law.time), duration(scene.time));
            writeln!(text, "| {} | {} | {law} | {time}, {} |", pair.0, pair.1, scene.evaluations)?;
        }
    }
    Ok(())
}

fn sweeps(text: &mut String, throughput: &[Throughput]) -> Result<()> {
    text.push_str("\n## Throughput\n\nAt a tolerance of 1e-10, from nothing: laws and rules are built on the way. Each in a process of its own.\n\n| what | threads | million evaluations a second | peak memory of the process |\n|---|---|---|---|\n");
    for line in throughput {
        let millions = significant(line.per_second / 1e6);
        let memory = line.memory.map_or("–".into(), |bytes| format!("{:.0} MB", bytes / 1e6));
        writeln!(text, "| {} | {} | {millions} | {memory} |", line.what, line.threads)?;
    }
    Ok(())
}

/// A time \[ns\] in the unit that suits it.
fn duration(ns: f64) -> String {
    let (number, unit) = match ns {
        ns if ns < 1e3 => (ns, "ns"),
        ns if ns < 1e6 => (ns / 1e3, "µs"),
        ns => (ns / 1e6, "ms"),
    };
    format!("{} {unit}", significant(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "model,quantity,method,tolerance,median_ns,max_relative_error,evaluations
ke,force,compiled,1e-9,40,1e-12,8
ke,force,compiled,1e-10,50,1e-15,8
ke,force,compiled,1e-11,60,1e-15,12
ke,force,gauss-kronrod,1e-10,5000,not-converged,300
ke,force,simpson,,4000,1.0e0,201
";

    #[test]
    fn the_table_holds_the_asked_tolerance_and_the_ratios_are_of_it() -> Result<()> {
        let text = text(CSV, &[], &[], "a machine")?;
        assert!(
            text.contains(
                "| ke | force | 50.0 ns, 1e-15 | 5.00 µs, not-converged | 4.00 µs, 1.0e0 |"
            )
        );
        assert!(text.contains("gauss-kronrod takes 100 times as long as compiled (300 against 8"));
        assert!(text.contains("`scipy` | not found") && text.contains("a machine"));
        Ok(())
    }
}
