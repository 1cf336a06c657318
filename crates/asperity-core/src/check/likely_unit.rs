//! Numbers outside their usual range, and the unit that explains them.

use crate::Finding;
use crate::finding::short;

/// A unit that users may give in place of SI: name, and value in SI units. Lists start with the
/// likeliest.
pub(super) type Unit = (&'static str, f64);

/// Units of moduli and strengths \[Pa\].
pub(super) const PRESSURES: &[Unit] = &[("GPa", 1e9), ("MPa", 1e6), ("kPa", 1e3)];

/// The advice about an unusual number.
pub const CHECK_UNIT: &str = "check the number and its unit";

/// A number of a scene: name, usual range, SI unit, the units in which it may be given by mistake,
/// and the advice where none of them explains the value.
#[derive(Clone, Copy)]
pub(super) struct Input {
    pub(super) field: &'static str,
    pub(super) usual: [f64; 2],
    pub(super) si: &'static str,
    pub(super) units: &'static [Unit],
    pub(super) advice: &'static str,
}

impl Input {
    pub(super) const fn new(
        field: &'static str,
        usual: [f64; 2],
        si: &'static str,
        units: &'static [Unit],
    ) -> Self {
        Self { field, usual, si, units, advice: CHECK_UNIT }
    }

    pub(super) const fn advice(self, advice: &'static str) -> Self {
        Self { advice, ..self }
    }

    /// The finding of a value outside the usual range, with the first unit in which it
    /// `makes_sense`.
    pub(super) fn finding(&self, value: f64) -> Option<Finding> {
        let usual = |x: f64| within(x, self.usual);
        (!usual(value)).then(|| self.in_unit(value, self.unit(value, usual).as_slice()))
    }

    /// The first unit in which a value makes sense.
    pub(super) fn unit(&self, value: f64, makes_sense: impl Fn(f64) -> bool) -> Option<Unit> {
        self.units.iter().copied().find(|(_, factor)| makes_sense(value * factor))
    }

    /// The finding of a value in these likely units, if there are any; ten times outside the usual
    /// range the value is implausible.
    pub(super) fn in_unit(&self, value: f64, units: &[Unit]) -> Finding {
        let found = Finding::warning(UNUSUAL, self.field, value).usual(self.usual).unit(self.si);
        let found = found.implausible(implausible(value, self.usual)).advice(self.advice);
        match units {
            [] => found,
            units => found.likely_unit(likely(value, units, self.si)),
        }
    }
}

pub(super) const UNUSUAL: &str = "unusual-size";

/// Whether a value is in a range, ends included.
pub(super) fn within(value: f64, [from, to]: [f64; 2]) -> bool {
    (from..=to).contains(&value)
}

/// Whether a value is ten times outside the usual range.
pub(super) fn implausible(value: f64, [from, to]: [f64; 2]) -> bool {
    value < 0.1 * from || value > 10.0 * to
}

/// "116 looks like GPa; 116 GPa is 1.16e11 Pa", or "200 looks like HV or MPa; 200 HV is 2.115e9 Pa,
/// 200 MPa is 2e8 Pa".
fn likely(value: f64, units: &[Unit], si: &str) -> String {
    let given = short(value);
    let names: Vec<&str> = units.iter().map(|(name, _)| *name).collect();
    let is = |(name, factor): &Unit| format!("{given} {name} is {} {si}", short(value * factor));
    let each: Vec<String> = units.iter().map(is).collect();
    format!("{given} looks like {}; {}", names.join(" or "), each.join(", "))
}
