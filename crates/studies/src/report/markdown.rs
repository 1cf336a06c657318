//! The tables of `speed-vs-error.md`, from the text of the csv.

use std::fmt::Write as _;
use std::process::Command;

use anyhow::Result;

use super::external::External;
use super::methods::{HARD_TOLERANCE, METHODS};
use super::tables::significant;
use xtask::command::output;
use xtask::figures::report_csv::Row;
use xtask::table::{markdown_head, markdown_row, rows};

const METHODS_END: &str = "| `build-law` | building the law of a quantity, with its tables |
| `build-scene` | compiling a scene for eight separations from -1 to 6, law built before |

scipy and gsl integrate the laws that are sums of powers. Every method samples the same laws; those of Gao and AT are tables over the interference, already averaged over angles. For every method a tangent is the integral of the force law times (d + w)/σ_z², which includes the law's jumps.
";

/// The row of a method at the tolerance of the hard cases or, for a model without it, at its
/// tightest; the last row of a method without tolerances.
fn entry<'a>(rows: &'a [Row], pair: (&str, &str), method: &str) -> Option<&'a Row> {
    let own =
        |row: &&Row| (row.model.as_str(), row.quantity.as_str()) == pair && row.method == method;
    let loose = |row: &&Row| row.tolerance.parse().is_ok_and(|t: f64| t >= 0.99 * HARD_TOLERANCE);
    rows.iter().filter(own).rfind(loose).or(rows.iter().rfind(own))
}

/// The Markdown.
///
/// # Errors
/// A csv that is not `speed-vs-error.csv`.
pub fn text(speed: &str, libraries: &[External], machine: &str) -> Result<String> {
    let rows: Vec<Row> = rows(speed)?;
    let mut pairs: Vec<(&str, &str)> = rows.iter().map(|r| (&*r.model, &*r.quantity)).collect();
    pairs.dedup();
    let mut methods: Vec<(&str, &str)> =
        METHODS.iter().map(|(_, name, what)| (*name, *what)).collect();
    methods.extend(libraries.iter().map(|library| (library.name, &*library.what)));
    let heads: Vec<&str> = ["model", "quantity"].into_iter().chain(names(&methods)).collect();
    let mut text = format!(
        "# Speed against error

Written by `cargo xtask report`; measured on {machine}. Times are medians of one process and one run, on the same 56 points for every method: d/σ_z from -1 to 6, w_c/σ_z from 0.003 to 3. Errors are the worst on the hard cases with Gaussian heights, d/σ_z from -3 to 40 and w_c/σ_z from 1e-8 to 1e4 (tests/reference/hard_cases.csv), relative to the sum of the absolute values of the parts. speed-vs-error.csv holds all settings. Errors and evaluations do not depend on the machine and are guarded by tests; times do and are not.

## Time and worst error

Tolerance {HARD_TOLERANCE:e}, for methods that have one.

{}",
        markdown_head(&heads, 0)
    );
    for (model, quantity) in &pairs {
        let mut cells = vec![(*model).to_owned(), (*quantity).to_owned()];
        for method in names(&methods) {
            cells.push(match entry(&rows, (model, quantity), method) {
                Some(row) => format!("{}, {}", time(row)?, row.max_relative_error),
                None => String::new(),
            });
        }
        text += &markdown_row(&cells);
    }
    ratios(&mut text, &rows)?;
    text += "\n## Building\n\n";
    text += &markdown_head(&["model", "quantity", "law", "scene, law sampled"], 0);
    for pair in &pairs {
        let [law, scene] = ["build-law", "build-scene"].map(|build| entry(&rows, *pair, build));
        if let (Some(law), Some(scene)) = (law, scene) {
            let samples = format!("{}, {}", time(scene)?, scene.evaluations);
            text += &markdown_row(&[pair.0, pair.1, &time(law)?, &samples]);
        }
    }
    text += &format!("\n## Methods\n\n{}", markdown_head(&["method", "description"], 0));
    let known: Vec<&str> = names(&methods).collect();
    let missing = ["scipy", "gsl"].into_iter().filter(|name| !known.contains(name));
    let missing = missing.map(|name| (name, "not found on this machine"));
    for (name, what) in methods.iter().copied().chain(missing) {
        text += &markdown_row(&[&format!("`{name}`"), what]);
    }
    Ok(text + METHODS_END)
}

fn names<'m>(methods: &[(&'m str, &str)]) -> impl Iterator<Item = &'m str> {
    methods.iter().map(|method| method.0)
}

/// Ratios of times in this run.
fn ratios(text: &mut String, rows: &[Row]) -> Result<()> {
    *text += "\n## Ratios in this run\n\n";
    let ratio = |other: &Row, own: &Row| -> Result<String> {
        Ok(significant(other.median_ns.parse::<f64>()? / own.median_ns.parse::<f64>()?))
    };
    let ke = |method| entry(rows, ("ke", "force"), method);
    for own in ["compiled", "rule"].into_iter().filter_map(ke) {
        for other in ["gauss-kronrod", "tanh-sinh", "gsl", "scipy"].into_iter().filter_map(ke) {
            let (ours, theirs) = (&own.method, &other.method);
            let (few, many, times) = (&own.evaluations, &other.evaluations, ratio(other, own)?);
            writeln!(
                text,
                "* KE force at {HARD_TOLERANCE:e}: {theirs} takes {times} times as long as {ours} ({many} against {few} evaluations)"
            )?;
        }
    }
    for model in ["gao", "at"] {
        if let (Some(own), Some(ke)) = (entry(rows, (model, "force"), "compiled"), ke("compiled")) {
            writeln!(text, "* {model} force, compiled: {} times KE's force", ratio(own, ke)?)?;
        }
    }
    Ok(())
}

fn time(row: &Row) -> Result<String> {
    Ok(duration(row.median_ns.parse()?))
}

/// A time \[ns\] with a suitable unit.
fn duration(ns: f64) -> String {
    let (number, unit) = match ns {
        ns if ns < 1e3 => (ns, "ns"),
        ns if ns < 1e6 => (ns / 1e3, "µs"),
        ns => (ns / 1e6, "ms"),
    };
    format!("{} {unit}", significant(number))
}

/// One line: processor, cores, compiler, build, date.
pub fn this_machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "development build" } else { "release build" };
    let about = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = about.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let name = name.map_or("unknown processor", |(_, name)| name.trim());
    let arch = std::env::consts::ARCH.replace('_', "-");
    let printed = |command: &str, argument: &str| {
        let printed = output(Command::new(command).arg(argument));
        printed.unwrap_or_else(|_| format!("unknown {command}"))
    };
    let (compiler, date) = (printed("rustc", "--version"), printed("date", "+%F"));
    let compiler = compiler.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    format!("{name} ({arch}), {cores} cores, {compiler}, {build}, {}", date.trim())
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Context;
    use xtask::folder::{read as text_of, root};
    use xtask::table::rows_of;

    const CSV: &str = "model,quantity,method,tolerance,median_ns,max_relative_error,evaluations
ke,force,compiled,1e-9,40,1e-12,8
ke,force,compiled,1e-10,50,1e-15,8
ke,force,compiled,1e-11,60,1e-15,12
ke,force,gauss-kronrod,1e-10,5000,not-converged,300
ke,force,simpson,,4000,1.0e0,201
";

    #[test]
    fn table_and_ratios_are_those_of_the_hard_tolerance() -> Result<()> {
        let text = text(CSV, &[], "a machine")?;
        for part in [
            "| ke | force | 50.0 ns, 1e-15 | | 5.00 µs, not-converged | | | | | 4.00 µs, 1.0e0 |",
            "100 times as long as compiled (300 against 8 ",
            "`scipy` | not found",
        ] {
            assert!(text.contains(part), "{part}");
        }
        assert_eq!(xtask::figures::report_csv::machine(&text), Some("a machine"));
        let line = this_machine();
        assert!(line.contains("rustc ") && line.contains(" build, 20"), "{line}");
        Ok(())
    }

    #[test]
    fn the_readme_has_the_numbers_of_the_committed_report() -> Result<()> {
        let rows: Vec<Row> = rows_of(&root().join("figures/speed-vs-error.csv"))?;
        let of = |method| entry(&rows, ("ke", "force"), method).context("a row");
        let time = |method| -> Result<f64> { Ok(of(method)?.median_ns.parse()?) };
        let error: f64 = of("compiled")?.max_relative_error.parse()?;
        let ns = time("compiled")?;
        let wanted = format!(
            "KE's force at a tolerance of {HARD_TOLERANCE:e}, medians of one run: a value in an array takes {ns:.0} ns with an error of {error:.0e}; adaptive Gauss-Kronrod 21, split at the kinks, takes {:.0} times as long, scipy's `quad` {:.0} times.\n",
            time("gauss-kronrod")? / ns,
            time("scipy")? / ns,
        );
        assert!(text_of(&root().join("README.md"))?.contains(&wanted), "README.md: {wanted}");
        Ok(())
    }
}
