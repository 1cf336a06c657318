//! The table of the README: the range of each model's deviations.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use asperity::{Described, Evidence};

use super::cases::models;
use super::picture::Shown;

/// The table, from the text of the evidence: for each model and material the range of the
/// deviations over surfaces and loads.
///
/// # Errors
/// A text that is not evidence.
pub fn table(text: &str) -> Result<String> {
    let evidence = Evidence::parse(text)?;
    let mut indices: Vec<f64> = vec![];
    for case in evidence.cases() {
        if !indices.iter().any(|known| known.total_cmp(&case.plasticity_index).is_eq()) {
            indices.push(case.plasticity_index);
        }
    }
    let materials: Vec<String> = indices
        .iter()
        .map(|index| if *index > 0.0 { format!("ψ = {index}") } else { "elastic".into() })
        .collect();
    let mut out = String::new();
    for (shown, what) in [(Shown::Area, "area"), (Shown::Stiffness, "stiffness")] {
        writeln!(out, "| {what}, % off | {} |", materials.join(" | "))?;
        writeln!(out, "|---|{}", "---:|".repeat(indices.len()))?;
        for model in models() {
            let mut row = vec![];
            for index in &indices {
                let of_material = evidence
                    .cases()
                    .iter()
                    .filter(|case| case.plasticity_index.total_cmp(index).is_eq());
                let off: Vec<f64> = of_material
                    .filter_map(|case| {
                        let found = case.models.iter().find(|(id, _)| id == model.id())?;
                        Some(100.0 * (shown.of(&found.1)? / shown.of(&case.bem)? - 1.0))
                    })
                    .collect();
                let ends = [f64::min, f64::max].map(|of| off.iter().copied().reduce(of));
                row.push(match ends {
                    [Some(low), Some(high)] => format!("{low:+.0} to {high:+.0}"),
                    _ => "–".into(),
                });
            }
            if row.iter().any(|cell| cell != "–") {
                writeln!(out, "| `{}` | {} |", model.id(), row.join(" | "))?;
            }
        }
        let mut spans = vec![];
        for index in &indices {
            let of_material =
                evidence.cases().iter().filter(|c| c.plasticity_index.total_cmp(index).is_eq());
            let span = of_material.filter_map(|case| {
                let [low, high] = shown.span(&case.bem)?;
                Some(50.0 * (high - low) / shown.of(&case.bem)?)
            });
            let widest = span.reduce(f64::max).context("a material without a case")?;
            spans.push(format!("±{widest:.0}"));
        }
        writeln!(out, "| *largest scatter between surfaces* | {} |\n", spans.join(" | "))?;
    }
    Ok(out)
}
