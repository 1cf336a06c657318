//! Units of scene files and of measurements: units.txt.

use std::sync::LazyLock;

/// The units of one dimension.
#[derive(Debug)]
pub struct Units {
    /// Its SI unit, as in scene files.
    pub si: &'static str,
    /// A number with a unit.
    pub example: &'static str,
    /// Units with their power of ten.
    pub decimal: Vec<(&'static str, i32)>,
    /// Units that are not decimal, or rare: their size in a power of ten of the SI unit.
    pub others: Vec<(&'static str, f64, i32)>,
}

/// All units, by dimension.
#[must_use]
pub fn units() -> &'static [Units] {
    static ALL: LazyLock<Vec<Units>> =
        LazyLock::new(|| include_str!("units.txt").lines().skip(1).filter_map(dimension).collect());
    &ALL
}

/// The units of a line.
fn dimension(line: &'static str) -> Option<Units> {
    let mut parts = line.split('|').map(str::trim);
    let (si, example) = (parts.next()?, parts.next()?);
    let [decimal, others] = [parts.next()?, parts.next()?]
        .map(|part| part.split_whitespace().collect::<Vec<&'static str>>());
    let decimal = decimal.chunks_exact(2).filter_map(|of| Some((of[0], of[1].parse().ok()?)));
    let other = |of: &[&'static str]| Some((of[0], of[1].parse().ok()?, of[2].parse().ok()?));
    let others = others.chunks_exact(3).filter_map(other).collect();
    Some(Units { si, example, decimal: decimal.collect(), others })
}

/// A unit without ignored characters, in ASCII: `um` for `µm`, `mm2` for `mm^2` and `mm²`.
#[must_use]
pub fn plain_unit(unit: &str) -> String {
    let left_out = |c: char| c.is_whitespace() || "^*\u{b7}".contains(c);
    let text: String = unit.chars().filter(|c| !left_out(*c)).collect();
    let text = text.replace(['\u{b5}', '\u{3bc}'], "u");
    let text = text.replace('\u{b2}', "2").replace('\u{b3}', "3");
    text.replace('\u{207b}', "-").replace(['\u{3a9}', '\u{2126}'], "ohm")
}

/// The units of a quantity with this SI unit and their sizes in it, those of scene files first;
/// shares have per cent.
#[must_use]
pub fn units_of(si: &str) -> Vec<(&'static str, f64)> {
    if si.is_empty() {
        return vec![("%", 0.01)];
    }
    let si = plain_unit(si);
    let known = units().iter().filter(|units| plain_unit(units.si) == si);
    let sizes = |units: &'static Units| {
        let decimal = units.decimal.iter().map(|(name, power)| (*name, 10f64.powi(*power)));
        let other =
            |(name, size, power): &(&'static str, f64, i32)| (*name, size * 10f64.powi(*power));
        decimal.chain(units.others.iter().map(other))
    };
    known.flat_map(sizes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_has_a_size() {
        let lines = include_str!("units.txt").lines().count() - 1;
        assert!(units().len() == lines && units().iter().all(|one| !one.decimal.is_empty()));
        assert_eq!(units().iter().map(|one| one.others.len()).sum::<usize>(), 23);
        let psi = units_of("Pa").into_iter().find(|(unit, _)| *unit == "psi");
        // The usual rounded value.
        assert!(psi.is_some_and(|(_, size)| (size / 6_894.757 - 1.0).abs() < 1e-7), "{psi:?}");
    }
}
