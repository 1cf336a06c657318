//! `figures/truth.md`: the range of each model's deviations.

use asperity::{Compared, Described, Evidence, EvidenceCase};
use xtask::figures::compared::{NOTHING, equal, is_plain, material, models};
use xtask::table::{markdown_head, markdown_row};

/// Light loads are those up to this p/(E g).
const LIGHT: f64 = 5e-4;
/// Loads above this are left out of the table of heavier loads, where half of the surface touches.
const HEAVIEST: f64 = 0.2;

const PREFACE: &str = "\
# Models relative to boundary elements

Lowest and highest deviation of each model over the solved surfaces and loads of a column, from the
[table of solved surfaces](../crates/answer/judge/data/truth.csv). p is the mean pressure, E the
equivalent modulus, g the rms gradient, ψ the plasticity index, α the bandwidth m₀m₄/m₂², Sq the
rms height; elastic surfaces have no hardness. The last rows state the largest standard error of
boundary elements, and the bandwidths that were solved.

";

/// Skewnesses, and ratios of slopes.
const SHAPES: [(f64, f64); 6] =
    [(-2.0, 1.0), (-1.0, 1.0), (1.0, 1.0), (0.0, 2.0), (0.0, 4.0), (0.0, 8.0)];
/// The name of a skewness or of a ratio of slopes.
fn shape_name(skewness: f64, slope_ratio: f64) -> String {
    let is_lay = slope_ratio > 1.0;
    if is_lay { format!("lay {slope_ratio}") } else { format!("skewness {skewness:+}") }
}

/// The lowest and the highest deviation as a cell.
fn ends(off: impl IntoIterator<Item = f64>) -> String {
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = off.into_iter().fold(nothing, |(l, h), x| (l.min(x), h.max(x)));
    if low > high { NOTHING.into() } else { format!("{low:+.0} to {high:+.0}") }
}

/// A column: its head and its cases.
type Column<'e> = (String, Vec<&'e EvidenceCase>);

/// Numbers in order, each once.
fn distinct(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers
}

/// The tables of the evidence: for each model the range of the deviations over surfaces and loads.
/// Isotropic Gaussian surfaces by material, under light and heavier loads; then skewed surfaces and
/// those with a lay.
#[must_use]
pub fn table(evidence: &Evidence) -> String {
    let cases = || evidence.cases().iter().filter(|case| case.load <= HEAVIEST);
    let plain = || cases().filter(|case| is_plain(case));
    let by_material = |light: bool| -> Vec<Column> {
        let column = |index: f64| {
            let same = |case: &&EvidenceCase| equal(case.plasticity_index, index);
            let own = plain().filter(same).filter(|case| (case.load <= LIGHT) == light);
            (material(index), own.collect())
        };
        distinct(plain().map(|case| case.plasticity_index)).into_iter().map(column).collect()
    };
    let shape = |(skewness, ratio)| {
        let same = |c: &&EvidenceCase| equal(c.skewness, skewness) && equal(c.slope_ratio, ratio);
        let own = cases().filter(same).filter(|case| case.plasticity_index > 0.0);
        (shape_name(skewness, ratio), own.collect())
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
    out
}

fn of_quantity(quantity: Compared, what: &str, columns: &[Column]) -> String {
    let row = |first: &str, cell: &dyn Fn(&Column) -> String| -> Vec<String> {
        [first.to_owned()].into_iter().chain(columns.iter().map(cell)).collect()
    };
    let mut out = markdown_head(&row(what, &|column| column.0.clone()), columns.len());
    let is_gap = quantity == Compared::MeanGap;
    for model in models() {
        let off = |case: &&EvidenceCase| {
            let (_, found) = case.models.iter().find(|(id, _)| id == model.id())?;
            let (found, bem) = (found.value(quantity)?, case.bem.value(quantity)?);
            let relative = Evidence::relative(quantity, found, bem);
            Some(0.1 * (relative - if is_gap { 0.0 } else { 1e3 }))
        };
        let row =
            row(&format!("`{}`", model.id()), &|(_, cases)| ends(cases.iter().filter_map(off)));
        if row[1..].iter().any(|cell| cell != NOTHING) {
            out += &markdown_row(&row);
        }
    }
    let error = |case: &&EvidenceCase| {
        let unit = if is_gap { 1.0 } else { case.bem.value(quantity)? };
        Some(100.0 * case.bem.error(quantity)? / unit)
    };
    out += &markdown_row(&row("*largest standard error*", &|(_, cases)| {
        let largest = cases.iter().filter_map(error).reduce(f64::max);
        largest.map_or(NOTHING.into(), |most| format!("±{most:.0}"))
    }));
    out += &markdown_row(&row("*bandwidths α*", &|(_, cases)| {
        let solved = distinct(cases.iter().map(|case| case.alpha));
        solved.iter().map(|alpha| format!("{alpha:.1}")).collect::<Vec<_>>().join(", ")
    }));
    out + "\n"
}
