//! The numbers of speed in the README of the project, from the text of `speed-vs-error.csv`.

use anyhow::{Context, Result};

use crate::figures::report_csv::{Row, read as of_csv};

const MARKS: [&str; 2] = ["<!-- speed -->\n", "<!-- /speed -->"];
/// Model, quantity and tolerance that are shown.
const SHOWN: (&str, &str, f64) = ("ke", "force", 1e-10);

/// The README with the numbers of a csv between its marks.
///
/// # Errors
/// A csv that is not `speed-vs-error.csv`, a method without its row, a README without marks.
pub fn with_numbers(readme: &str, csv: &str) -> Result<String> {
    let (model, quantity, tolerance) = SHOWN;
    let rows = of_csv(csv)?;
    let of = |method: &str| {
        let shown = |row: &&Row| {
            (&*row.model, &*row.quantity, &*row.method) == (model, quantity, method)
                && row.requested() == Some(tolerance)
        };
        rows.iter().find(shown).with_context(|| format!("no row of {method} for {SHOWN:?}"))
    };
    let time = |method| -> Result<f64> { Ok(of(method)?.median_ns.parse()?) };
    let error: f64 = of("compiled")?.max_relative_error.parse()?;
    let ns = time("compiled")?;
    let [kronrod, scipy] = ["gauss-kronrod", "scipy"].map(|method| time(method).map(|t| t / ns));
    let text = format!(
        "KE's force at a tolerance of {tolerance:e}, medians of one run: a value of a compiled scene takes {ns:.0} ns with an error of {error:.0e}; adaptive Gauss-Kronrod 21, split at the kinks, takes {:.0} times as long, scipy's `quad` {:.0} times.\n",
        kronrod?, scipy?,
    );
    let (before, rest) = readme.split_once(MARKS[0]).context("README.md: no <!-- speed -->")?;
    let (_, after) = rest.split_once(MARKS[1]).context("README.md: no <!-- /speed -->")?;
    Ok([before, MARKS[0], &text, MARKS[1], after].concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::folder::{read, root};

    /// Written anew by `cargo xtask report`.
    #[test]
    fn the_readme_has_the_numbers_of_the_committed_report() {
        let [readme, csv] = ["README.md", "figures/speed-vs-error.csv"]
            .map(|name| read(&root().join(name)).unwrap());
        assert_eq!(readme, with_numbers(&readme, &csv).unwrap());
    }
}
