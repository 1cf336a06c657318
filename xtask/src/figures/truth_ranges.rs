//! `figures/truth.md`: the range of each model's deviations.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use asperity::{Compared, Described, Evidence, EvidenceCase, Model, Persson, PerssonVariance};

/// Light loads are those up to this p/(E g).
const LIGHT: f64 = 5e-4;
/// Loads above this are left out of the table of heavier loads, where half of the surface touches.
const HEAVIEST: f64 = 0.2;

const PREFACE: &str = "\
# Models relative to boundary elements

Lowest and highest deviation of each model over the solved surfaces and loads of a column, from the
[table of solved surfaces](../crates/asperity/data/truth.csv). p is the mean pressure, E the
equivalent modulus, g the rms gradient, ψ the plasticity index, α the bandwidth m₀m₄/m₂², Sq the
rms height; elastic surfaces have no hardness. The last rows state the largest standard error of
boundary elements, and the bandwidths that were solved.

";

/// Models of asperities in the table: each of the paper's once, and four with random asperities.
const COMPARED: [&str; 13] = [
    "gw",
    "ceb",
    "zmc",
    "ke",
    "etsion",
    "jg",
    "af",
    "gao",
    "at",
    "gw-random",
    "zmc-random",
    "ke-random",
    "jg-random",
];

/// The models that are compared with boundary elements. Persson's spectrum is a power law, as that
/// of the solved surfaces beyond their roll-off.
#[must_use]
pub fn models() -> Vec<Model> {
    let hurst_exponent = Some(Evidence::HURST);
    let whole = PerssonVariance::ALL
        .map(|variance| Model::known(Persson { variance, hurst_exponent, spectrum: None }));
    let compared = |model: &Model| COMPARED.contains(&model.id());
    let of_asperities = Model::all().into_iter().chain(Model::all_random());
    of_asperities.filter(compared).chain(whole).collect()
}

/// Numbers of the table are equal digit by digit.
fn same(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

/// A column: its head and its cases.
type Column = (String, Box<dyn Fn(&EvidenceCase) -> bool>);

/// The tables, from the text of the evidence: for each model the range of the deviations over
/// surfaces and loads. Isotropic Gaussian surfaces by material, under light and heavier loads; then
/// skewed surfaces and those with a lay.
///
/// # Errors
/// A text that is not evidence.
pub fn table(text: &str) -> Result<String> {
    let evidence = Evidence::parse(text)?;
    let plain = |case: &EvidenceCase| case.skewness == 0.0 && case.slope_ratio <= 1.0;
    let mut indices: Vec<f64> = vec![];
    for case in evidence.cases().iter().filter(|case| plain(case)) {
        if !indices.iter().any(|known| known.total_cmp(&case.plasticity_index).is_eq()) {
            indices.push(case.plasticity_index);
        }
    }
    indices.sort_by(f64::total_cmp);
    let material =
        |index: f64| if index > 0.0 { format!("ψ = {index}") } else { "elastic".into() };
    let by_material = |light: bool| -> Vec<Column> {
        let column = |index: &f64| -> Column {
            let index = *index;
            let holds = move |case: &EvidenceCase| {
                plain(case)
                    && case.plasticity_index.total_cmp(&index).is_eq()
                    && (case.load <= LIGHT) == light
                    && case.load <= HEAVIEST
            };
            (material(index), Box::new(holds))
        };
        indices.iter().map(column).collect()
    };
    let shapes: Vec<Column> = [
        ("skewness -2", -2.0, 1.0),
        ("skewness -1", -1.0, 1.0),
        ("skewness +1", 1.0, 1.0),
        ("lay 2", 0.0, 2.0),
        ("lay 4", 0.0, 4.0),
        ("lay 8", 0.0, 8.0),
    ]
    .map(|(name, skewness, ratio)| -> Column {
        let holds = move |case: &EvidenceCase| {
            same(case.skewness, skewness)
                && same(case.slope_ratio, ratio)
                && case.plasticity_index > 0.0
                && case.load <= HEAVIEST
        };
        (name.into(), Box::new(holds))
    })
    .into_iter()
    .collect();
    let mut out = String::from(PREFACE);
    let light = format!("Light loads: p/(E g) up to {LIGHT:e}");
    let heavier = format!("Heavier loads: p/(E g) from {LIGHT:e} to {HEAVIEST}");
    for (columns, heading) in [
        (by_material(true), light),
        (by_material(false), heavier),
        (shapes, "With a hardness, by shape of the surface".into()),
    ] {
        writeln!(out, "## {heading}\n")?;
        for (quantity, what) in Compared::ALL.into_iter().zip([
            "area, % off",
            "stiffness, % off",
            "unloading stiffness and conductance, % off",
            "distance of the mean planes less that of boundary elements, % of Sq",
        ]) {
            write_table(&mut out, &evidence, (quantity, what), &columns)?;
        }
    }
    Ok(out)
}

fn write_table(
    out: &mut String,
    evidence: &Evidence,
    (quantity, what): (Compared, &str),
    columns: &[Column],
) -> Result<()> {
    let heads: Vec<&str> = columns.iter().map(|(head, _)| head.as_str()).collect();
    writeln!(out, "| {what} | {} |", heads.join(" | "))?;
    writeln!(out, "|---|{}", "---:|".repeat(columns.len()))?;
    let ends = |off: &mut dyn Iterator<Item = f64>| {
        off.fold(None, |ends: Option<[f64; 2]>, x| {
            Some(ends.map_or([x; 2], |[low, high]| [low.min(x), high.max(x)]))
        })
    };
    for model in models() {
        let cell = |(_, holds): &Column| {
            let cases = evidence.cases().iter().filter(|case| holds(case));
            let mut off = cases.filter_map(|case| {
                let (_, found) = case.models.iter().find(|(id, _)| id == model.id())?;
                let bem = case.bem.value(quantity)?;
                let relative = Evidence::relative(quantity, found.value(quantity)?, bem);
                let exact = if quantity == Compared::MeanGap { 0.0 } else { 1e3 };
                Some(0.1 * (relative - exact))
            });
            ends(&mut off)
        };
        let row: Vec<String> = columns
            .iter()
            .map(|column| match cell(column) {
                Some([low, high]) => format!("{low:+.0} to {high:+.0}"),
                None => "–".into(),
            })
            .collect();
        if row.iter().any(|cell| cell != "–") {
            writeln!(out, "| `{}` | {} |", model.id(), row.join(" | "))?;
        }
    }
    let mut errors = vec![];
    for (_, holds) in columns {
        let cases = evidence.cases().iter().filter(|case| holds(case));
        let mut each = cases.filter_map(|case| {
            let unit =
                if quantity == Compared::MeanGap { 1.0 } else { case.bem.value(quantity)? };
            Some(100.0 * case.bem.error(quantity)? / unit)
        });
        errors.push(ends(&mut each).map_or("–".into(), |[_, most]| format!("±{most:.0}")));
    }
    writeln!(out, "| *largest standard error* | {} |", errors.join(" | "))?;
    let bandwidths = columns.iter().map(|(_, holds)| {
        let cases = evidence.cases().iter().filter(|case| holds(case));
        let mut solved: Vec<f64> = cases.map(|case| case.alpha).collect();
        solved.sort_by(f64::total_cmp);
        solved.dedup();
        let each: Vec<String> = solved.iter().map(|alpha| format!("{alpha:.1}")).collect();
        each.join(", ")
    });
    let bandwidths: Vec<String> = bandwidths.collect();
    writeln!(out, "| *bandwidths α* | {} |\n", bandwidths.join(" | ")).context("text")
}
