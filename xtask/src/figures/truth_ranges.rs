//! `figures/truth.md`: the range of each model's deviations.

use anyhow::Result;
use asperity::{Compared, Described, Evidence, EvidenceCase, Model, Persson, PerssonVariance};

use crate::table::{markdown_head, markdown_row};

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

/// Skewnesses, and ratios of slopes.
const SHAPES: [(&str, f64, f64); 6] = [
    ("skewness -2", -2.0, 1.0),
    ("skewness -1", -1.0, 1.0),
    ("skewness +1", 1.0, 1.0),
    ("lay 2", 0.0, 2.0),
    ("lay 4", 0.0, 4.0),
    ("lay 8", 0.0, 8.0),
];
/// The cell of a column without deviations.
pub const NOTHING: &str = "–";

/// Models of asperities in the table: each of the paper's once, and four with random asperities.
const COMPARED: &str = "gw ceb zmc ke etsion jg af gao at gw-random zmc-random ke-random jg-random";

/// The models that are compared with boundary elements. Persson's spectrum is a power law, as that
/// of the solved surfaces beyond their roll-off.
#[must_use]
pub fn models() -> Vec<Model> {
    let hurst_exponent = Some(Evidence::HURST);
    let whole = PerssonVariance::ALL
        .map(|variance| Model::known(Persson { variance, hurst_exponent, spectrum: None }));
    let compared = |model: &Model| COMPARED.split(' ').any(|id| id == model.id());
    let of_asperities = Model::all().into_iter().chain(Model::all_random());
    of_asperities.filter(compared).chain(whole).collect()
}

/// Numbers of the table are equal digit by digit.
#[must_use]
pub fn equal(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

/// Whether the surfaces of a case are isotropic and Gaussian.
#[must_use]
pub fn is_plain(case: &EvidenceCase) -> bool {
    case.skewness == 0.0 && case.slope_ratio <= 1.0
}

/// The name of a plasticity index.
#[must_use]
pub fn material(index: f64) -> String {
    if index > 0.0 { format!("ψ = {index}") } else { "elastic".into() }
}

/// The lowest and the highest deviation as a cell.
#[must_use]
pub fn ends(off: impl IntoIterator<Item = f64>) -> String {
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = off.into_iter().fold(nothing, |(l, h), x| (l.min(x), h.max(x)));
    if low > high { NOTHING.into() } else { format!("{low:+.0} to {high:+.0}") }
}

/// A column: its head and its cases.
type Column<'e> = (String, Vec<&'e EvidenceCase>);

/// The tables, from the text of the evidence: for each model the range of the deviations over
/// surfaces and loads. Isotropic Gaussian surfaces by material, under light and heavier loads; then
/// skewed surfaces and those with a lay.
///
/// # Errors
/// A text that is not evidence.
pub fn table(text: &str) -> Result<String> {
    let evidence = Evidence::parse(text)?;
    let chosen = |holds: &dyn Fn(&EvidenceCase) -> bool| -> Vec<&EvidenceCase> {
        evidence.cases().iter().filter(|case| case.load <= HEAVIEST && holds(case)).collect()
    };
    let mut indices: Vec<f64> =
        chosen(&is_plain).iter().map(|case| case.plasticity_index).collect();
    indices.sort_by(f64::total_cmp);
    indices.dedup();
    let by_material = |light: bool| -> Vec<Column> {
        let column = |index: &f64| {
            let holds = |case: &EvidenceCase| {
                is_plain(case)
                    && equal(case.plasticity_index, *index)
                    && (case.load <= LIGHT) == light
            };
            (material(*index), chosen(&holds))
        };
        indices.iter().map(column).collect()
    };
    let shape = |(name, skewness, ratio): (&str, f64, f64)| {
        let holds = |case: &EvidenceCase| {
            equal(case.skewness, skewness)
                && equal(case.slope_ratio, ratio)
                && case.plasticity_index > 0.0
        };
        (name.to_owned(), chosen(&holds))
    };
    let mut out = String::from(PREFACE);
    for (columns, heading) in [
        (by_material(true), format!("Light loads: p/(E g) up to {LIGHT:e}")),
        (by_material(false), format!("Heavier loads: p/(E g) from {LIGHT:e} to {HEAVIEST}")),
        (SHAPES.map(shape).to_vec(), "With a hardness, by shape of the surface".into()),
    ] {
        out += &format!("## {heading}\n\n");
        for (quantity, what) in Compared::ALL.into_iter().zip([
            "area, % off",
            "stiffness, % off",
            "unloading stiffness and conductance, % off",
            "distance of the mean planes less that of boundary elements, % of Sq",
        ]) {
            out += &of_quantity(quantity, what, &columns);
        }
    }
    Ok(out)
}

fn of_quantity(quantity: Compared, what: &str, columns: &[Column]) -> String {
    let heads: Vec<&str> =
        [what].into_iter().chain(columns.iter().map(|(head, _)| head.as_str())).collect();
    let mut out = markdown_head(&heads, columns.len());
    let row = |name: String, cell: &dyn Fn(&[&EvidenceCase]) -> String| -> Vec<String> {
        [name].into_iter().chain(columns.iter().map(|(_, cases)| cell(cases))).collect()
    };
    let is_gap = quantity == Compared::MeanGap;
    for model in models() {
        let off = |case: &&EvidenceCase| {
            let (_, found) = case.models.iter().find(|(id, _)| id == model.id())?;
            let (found, bem) = (found.value(quantity)?, case.bem.value(quantity)?);
            let relative = Evidence::relative(quantity, found, bem);
            Some(0.1 * (relative - if is_gap { 0.0 } else { 1e3 }))
        };
        let row = row(format!("`{}`", model.id()), &|cases| ends(cases.iter().filter_map(off)));
        if row[1..].iter().any(|cell| cell != NOTHING) {
            out += &markdown_row(&row);
        }
    }
    let error = |case: &&EvidenceCase| {
        let unit = if is_gap { 1.0 } else { case.bem.value(quantity)? };
        Some(100.0 * case.bem.error(quantity)? / unit)
    };
    out += &markdown_row(&row("*largest standard error*".into(), &|cases| {
        let largest = cases.iter().filter_map(error).reduce(f64::max);
        largest.map_or(NOTHING.into(), |most| format!("±{most:.0}"))
    }));
    out += &markdown_row(&row("*bandwidths α*".into(), &|cases| {
        let mut solved: Vec<f64> = cases.iter().map(|case| case.alpha).collect();
        solved.sort_by(f64::total_cmp);
        solved.dedup();
        solved.iter().map(|alpha| format!("{alpha:.1}")).collect::<Vec<_>>().join(", ")
    }));
    out + "\n"
}
