//! Numbers outside their usual range, and the units that explain them.

use std::iter::once;

use asperity_core::{Code, Finding, short};

/// A unit that users may give in place of SI: name, and value in SI units.
pub(super) type Unit = (&'static str, f64);

/// Units of moduli and strengths \[Pa\].
pub(super) const PRESSURES: &[Unit] = &[("GPa", 1e9), ("MPa", 1e6)];
const HEIGHTS: &[Unit] = &[("um", 1e-6), ("mm", 1e-3), ("nm", 1e-9)];
const DENSITIES: &[Unit] = &[("1/mm2", 1e6), ("1/um2", 1e12)];

/// The advice about an unusual number.
pub(super) const CHECK_UNIT: &str = "check the number and its unit";

/// A number of a scene: name, usual range, SI unit, and the units in which it may be given by
/// mistake, the likeliest first.
#[derive(Clone, Copy)]
pub(super) struct Input<'u> {
    pub(super) field: &'static str,
    pub(super) usual: [f64; 2],
    pub(super) si: &'static str,
    pub(super) units: &'u [Unit],
}

/// From cleaved mica to the texture of asphalt.
pub(super) const HEIGHT: [f64; 2] = [3e-11, 2e-3];
/// Numbers of a surface: R from a sharp tip to a lens, η from the stones of asphalt, a centimetre
/// apart, to atomic corrugation.
pub(super) const SURFACE: [Input<'static>; 11] = [
    Input::new("asperity_height_std", HEIGHT, "m", HEIGHTS),
    Input::new("asperity_radius", [2e-9, 5e-2], "m", &[("mm", 1e-3), ("um", 1e-6)]),
    Input::new("asperity_density", [5e3, 1e16], "1/m2", DENSITIES),
    Input::new("surface_height_std", HEIGHT, "m", HEIGHTS),
    Input::new("sq", HEIGHT, "m", HEIGHTS),
    Input::new("ra", HEIGHT, "m", HEIGHTS),
    Input::new("rz", HEIGHT, "m", HEIGHTS),
    Input::new("spd", [1e6, 1e16], "1/m2", DENSITIES),
    Input::new("spc", [100.0, 5e8], "1/m", &[("1/mm", 1e3), ("1/um", 1e6)]),
    Input::new("m0", [1e-21, 4e-6], "m2", &[("um2", 1e-12), ("nm2", 1e-18)]),
    Input::new("m4", [100.0, 1e17], "1/m2", DENSITIES),
];

/// `looks like um; 1.1 um is 1.1e-6 m` for a number of a surface, by its key, that only another
/// unit makes usual.
#[doc(hidden)]
#[must_use]
pub fn likely_unit(key: &str, value: f64) -> Option<String> {
    let key = if key == "rq" { "ra" } else { key };
    let input = SURFACE.iter().find(|input| input.field == key)?;
    Some(input.looks_like(value, input.unit(value)?))
}

impl<'u> Input<'u> {
    pub(super) const fn new(
        field: &'static str,
        usual: [f64; 2],
        si: &'static str,
        units: &'u [Unit],
    ) -> Self {
        Self { field, usual, si, units }
    }

    /// The finding of a value outside the usual range, with the first unit that makes it usual.
    pub(super) fn finding(&self, value: f64) -> Option<Finding> {
        (!within(value, self.usual)).then(|| self.in_unit(value, self.unit(value)))
    }

    /// The first unit that makes an unusual value usual.
    fn unit(&self, value: f64) -> Option<Unit> {
        let is_usual = |size| within(value * size, self.usual);
        self.units.iter().copied().find(|(_, size)| !is_usual(1.0) && is_usual(*size))
    }

    fn looks_like(&self, value: f64, (unit, size): Unit) -> String {
        let [given, meant] = [value, value * size].map(short);
        format!("looks like {unit}; {given} {unit} is {meant} {}", self.si)
    }

    /// The finding of a value in this likely unit, if there is one; ten times outside the usual
    /// range the value is implausible.
    pub(super) fn in_unit(&self, value: f64, unit: Option<Unit>) -> Finding {
        let found =
            Finding::warning(Code::UnusualSize, self.field, value).usual(self.usual).unit(self.si);
        let found = found.implausible(implausible(value, self.usual)).advice(CHECK_UNIT);
        match unit {
            Some(unit) => {
                found.likely_unit(format!("{} {}", short(value), self.looks_like(value, unit)))
            }
            None => found,
        }
    }
}

/// Findings of the numbers that in other units, the fewest and likeliest, go with the others; none
/// where no units explain them. `cost` is that of the values in these units, if they go together.
pub(super) fn in_other_units(
    numbers: &[(Input<'_>, f64)],
    cost: impl Fn(&[f64], &[Option<Unit>]) -> Option<f64>,
) -> Vec<Finding> {
    let mut choices: Vec<Vec<Option<Unit>>> = vec![vec![]];
    for (input, _) in numbers {
        let units = || once(None).chain(input.units.iter().copied().map(Some));
        let longer = |one: Vec<_>| units().map(move |unit| [&one[..], &[unit]].concat());
        choices = choices.into_iter().flat_map(longer).collect();
    }
    let ranked = choices.into_iter().filter_map(|units| {
        let size = |unit: &Option<Unit>| unit.map_or(1.0, |(_, size)| size);
        let meant: Vec<f64> =
            numbers.iter().zip(&units).map(|((_, value), unit)| value * size(unit)).collect();
        Some((units.iter().flatten().count(), cost(&meant, &units)?, units))
    });
    let best = ranked.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let found = numbers.iter().zip(best.into_iter().flat_map(|(.., units)| units));
    let found = found.filter_map(|((input, value), unit)| {
        Some(input.in_unit(*value, Some(unit?)).implausible(true))
    });
    found.collect()
}

/// Whether a value is in a range, ends included.
pub(super) fn within(value: f64, [from, to]: [f64; 2]) -> bool {
    (from..=to).contains(&value)
}

/// Whether a value is ten times outside the usual range.
pub(super) fn implausible(value: f64, [from, to]: [f64; 2]) -> bool {
    value < 0.1 * from || value > 10.0 * to
}
