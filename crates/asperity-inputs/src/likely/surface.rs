//! Numbers of a surface that do not go with the others: their likely units.

use asperity::{CHECK_UNIT, Finding, Severity, Surface, short};

use crate::keys::Key;

/// Three numbers that describe a surface, in SI units.
pub(crate) struct Given<'a> {
    pub(crate) keys: [&'static str; 3],
    pub(crate) numbers: [f64; 3],
    /// Whether each was given with its unit, which is then not another one.
    pub(crate) stated: [bool; 3],
    /// The surface with other numbers, if there is one.
    pub(crate) surface: &'a dyn Fn([f64; 3]) -> Option<Surface>,
}

/// A number that does not go with the others.
pub(crate) struct OddNumber {
    pub(crate) key: &'static str,
    pub(crate) value: f64,
    /// What is wrong with it: "looks like um; 1.1 um is 1.1e-6 m".
    pub(crate) reason: String,
}

/// A number in a unit.
#[derive(Clone, Copy)]
struct Reading {
    unit: &'static str,
    si: &'static str,
    value: f64,
}

/// What each number in another unit adds to the distance from a typical surface.
const CHANGE: f64 = 3.0;
/// What units of centimetres, which are rare for roughness, add to it.
const CENTIMETRES: f64 = 1.0;
/// σ_z \[m\], R \[m\] and β_z of a typical machined surface.
const TYPICAL: [f64; 3] = [1e-6, 5e-5, 0.04];
/// Numbers as they are written in units other than SI.
const WRITTEN: std::ops::Range<f64> = 1e-4..1e7;
/// A factor below those of units.
const SLIGHT: f64 = 3.0;
/// Values that are tried for each decade of a number, and decades to either side.
const STEPS: i32 = 20;
const DECADES: i32 = 9;

impl Given<'_> {
    /// The number that does not go with the others; `None` for surfaces without an error, and where
    /// more than one of the numbers may be wrong.
    pub(crate) fn odd_number(&self) -> Option<OddNumber> {
        let is_explained = match self.worst(self.numbers) {
            Some(worst) => worst == Severity::Error,
            None => !self.is_near(),
        };
        let odd = || self.in_units().or_else(|| self.out_of_range());
        is_explained.then(odd).flatten()
    }

    /// Whether numbers without a surface have one if one of them changes by a factor that is none
    /// of units.
    fn is_near(&self) -> bool {
        (0..6).any(|change| {
            let mut numbers = self.numbers;
            let factor = if change < 3 { SLIGHT } else { 1.0 / SLIGHT };
            numbers.iter_mut().skip(change % 3).take(1).for_each(|x| *x *= factor);
            self.worst(numbers) >= Some(Severity::Warning)
        })
    }

    /// The most severe finding of the surface with these numbers, a note where there is none;
    /// `None` without a surface.
    fn worst(&self, numbers: [f64; 3]) -> Option<Severity> {
        let findings = (self.surface)(numbers)?.findings();
        Some(findings.first().map_or(Severity::Note, |found| found.severity))
    }

    /// The readings of a number, that in SI units first.
    fn readings(&self, k: usize) -> Vec<Reading> {
        let (Some(key), Some(given)) = (self.keys.get(k), self.numbers.get(k)) else {
            return vec![];
        };
        let units = Key::find("surface", key).and_then(Key::units);
        let units = units.map_or(&[][..], |(.., units)| units);
        let si = units.iter().find(|(_, power)| *power == 0).map_or("", |(si, _)| si);
        // Nobody writes 9e-7 cm or 8e8 1/cm2.
        let may_differ = WRITTEN.contains(&given.abs()) && self.stated.get(k) == Some(&false);
        let others = units.iter().filter(|(_, power)| *power != 0 && may_differ);
        let other = |(unit, power): &(&'static str, i32)| Reading {
            unit,
            si,
            value: given * 10f64.powi(*power),
        };
        [Reading { unit: si, si, value: *given }].into_iter().chain(others.map(other)).collect()
    }

    /// The numbers that, in other units, describe the surface nearest to a typical one, of those
    /// without an error: large numbers may be unusual in their unit as well.
    fn in_units(&self) -> Option<OddNumber> {
        let [first, second, third] = [0, 1, 2].map(|k| self.readings(k));
        let pairs = first.iter().flat_map(|a| second.iter().map(move |b| (a, b)));
        let all = pairs.flat_map(|(a, b)| third.iter().map(move |c| [*a, *b, *c]));
        let cost = |readings: &[Reading; 3]| {
            let surface = (self.surface)(readings.map(|reading| reading.value));
            let distance = surface.map_or(f64::INFINITY, |surface| {
                let Surface { asperity_height_std: std, asperity_radius: radius, .. } = surface;
                let numbers = [std, radius, surface.roughness_parameter()].into_iter();
                numbers.zip(TYPICAL).map(|(x, usual)| (x / usual).ln().abs()).sum()
            });
            let rarity = |r: &Reading| match r.unit {
                unit if unit == r.si => 0.0,
                unit if unit.contains("cm") => CHANGE + CENTIMETRES,
                _ => CHANGE,
            };
            distance + readings.iter().map(rarity).sum::<f64>()
        };
        let usual = all.filter(|readings| {
            self.worst(readings.map(|reading| reading.value)) >= Some(Severity::Warning)
        });
        let best = usual.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        let given = self.keys.into_iter().zip(self.numbers);
        let mut changed = best.into_iter().zip(given).filter(|(r, _)| r.unit != r.si);
        let hint = |Reading { unit, si, value }, given: f64| {
            let [given, meant] = [given, value].map(short);
            format!("looks like {unit}; {given} {unit} is {meant} {si}")
        };
        let (reading, (key, value)) = changed.next()?;
        let others = changed.map(|(reading, (key, value))| {
            format!("; {key} = {} {}", short(value), hint(reading, value))
        });
        let reason = others.fold(hint(reading, value), |all, other| all + &other);
        Some(OddNumber { key, value, reason })
    }
    /// The only number without a unit of which another value alone makes the surface usual.
    fn out_of_range(&self) -> Option<OddNumber> {
        let range = |k: usize| {
            let tried = (-STEPS * DECADES..=STEPS * DECADES).filter_map(|step| {
                let mut numbers = self.numbers;
                *numbers.get_mut(k)? *= 10f64.powf(f64::from(step) / f64::from(STEPS));
                let is_usual = self.worst(numbers) == Some(Severity::Note);
                is_usual.then(|| numbers.get(k).copied())?
            });
            let ends = |range: Option<[f64; 2]>, x: f64| {
                Some(range.map_or([x, x], |[a, b]| [a.min(x), b.max(x)]))
            };
            Some((k, tried.fold(None, ends)?))
        };
        let mut odd = (0..3).filter(|k| self.stated.get(*k) == Some(&false)).filter_map(range);
        let (k, [least, most]) = odd.next().filter(|_| odd.next().is_none())?;
        let others = self.keys.into_iter().enumerate().filter(|(other, _)| *other != k);
        let others: Vec<&str> = others.map(|(_, key)| key).collect();
        let [least, most] = [least, most].map(short);
        let reason = format!(
            "does not go with {}, beside which {least} to {most} is usual; {CHECK_UNIT}",
            others.join(" and ")
        );
        let (key, value) = (self.keys.get(k)?, self.numbers.get(k)?);
        Some(OddNumber { key, value: *value, reason })
    }
}

/// Mean curvatures of peaks below this \[1/m\], radii above 1 cm, are probably in 1/mm.
const FLAT: f64 = 100.0;

/// A warning for a mean curvature of peaks that is probably in 1/mm.
pub(crate) fn likely_curvature(spc: f64) -> Option<Finding> {
    (spc > 0.0 && spc < FLAT).then(|| {
        let [given, radius, meant] = [spc, 1.0 / spc, 1e3 * spc].map(short);
        let hint = format!("{given} looks like 1/mm; {given} 1/mm is {meant} 1/m");
        Finding::warning("unit", "spc", spc)
            .fact(format!("`spc` is {given} 1/m, peaks of radius {radius} m"))
            .advice(CHECK_UNIT)
            .likely_unit(hint)
    })
}
