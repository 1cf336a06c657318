//! One axis with its ends, ticks and positions, from which plotters draws its grid. plotters' own
//! logarithmic axis has no labels within a decade and no lines before the first one, and its key
//! points fail for tiny numbers.

use std::ops::Range;

use plotters::coord::ranged1d::{
    KeyPointHint, KeyPointWeight, NoDefaultFormatting, Ranged, ValueFormatter,
};
use plotters::coord::types::RangedCoordf64;

use crate::error::PlotError;
use crate::figure::{Axis, Scale};
use crate::text::{number, power_of_ten, stepped};

/// Fraction of the axis left free beyond the values.
const AIR: f64 = 0.05;

/// An axis with its ends. Positions along it are the displayed numbers, divided by a power of ten
/// where they would be long, or their decimal logarithms.
#[derive(Debug, Clone)]
pub(crate) struct Ruler {
    log: bool,
    multiply: f64,
    /// The exponent of that power of ten; 0 for none.
    pub(crate) exponent: i32,
    low: f64,
    high: f64,
    ticks: Vec<f64>,
    minor: Vec<f64>,
}

impl Ruler {
    /// The axis with ends from its range, or else from the values on it, with room beyond them if
    /// `air` is true, and with at most `most` ticks.
    pub(crate) fn new(
        axis: &Axis,
        values: impl Iterator<Item = f64>,
        air: bool,
        most: usize,
    ) -> Result<Self, PlotError> {
        let log = axis.scale == Scale::Log;
        let usable = |value: &f64| value.is_finite() && (!log || *value > 0.0);
        let ends = || {
            values.filter(usable).fold(None, |ends: Option<(f64, f64)>, v| {
                Some(ends.map_or((v, v), |(low, high)| (low.min(v), high.max(v))))
            })
        };
        let csv = axis.range.or_else(ends).unwrap_or((1.0, 1.0));
        let (low, high) = (csv.0 * axis.multiply, csv.1 * axis.multiply);
        let refused = |required| PlotError::Range { axis: axis.label.clone(), low, high, required };
        if !(low.is_finite() && high.is_finite() && axis.multiply > 0.0) {
            return Err(refused("a finite range and a factor above 0"));
        }
        if axis.range.is_some() && low >= high || log && low <= 0.0 {
            return Err(refused("a range from low to high, above 0 if logarithmic,"));
        }
        let size = low.abs().max(high.abs()).log10().floor();
        let short = log || size == f64::NEG_INFINITY || (-2.0..5.0).contains(&size);
        let exponent = if short { 0 } else { size as i32 };
        let multiply = axis.multiply;
        let mut ruler = Self { log, multiply, exponent, low, high, ticks: vec![], minor: vec![] };
        (ruler.low, ruler.high) = (ruler.along(csv.0), ruler.along(csv.1));
        if axis.range.is_none() {
            ruler.widen(air);
        }
        ruler.mark(most);
        Ok(ruler)
    }

    /// Separates equal ends and adds room beyond them; 0 stays the end if it is the natural one.
    fn widen(&mut self, air: bool) {
        let (low, high) = (self.low, self.high);
        if high - low <= 1e-9 * low.abs().max(high.abs()) {
            let half = if self.log { 0.5 } else { (0.5 * low.abs()).max(0.01) };
            (self.low, self.high) = (low - half, high + half);
        } else if air {
            let room = AIR * (high - low);
            let natural = |end: f64, other: f64| {
                !self.log && end * other >= 0.0 && end.abs() < 0.2 * other.abs()
            };
            self.low = if natural(low, high) { 0.0 } else { low - room };
            self.high = if natural(high, low) { 0.0 } else { high + room };
        }
    }

    fn mark(&mut self, most: usize) {
        let round = |range: Range<f64>| RangedCoordf64::from(range).key_points(most.max(2));
        self.ticks = round(self.low..self.high);
        if !self.log {
            return;
        }
        let within = self.low - 1e-9..self.high + 1e-9;
        let digits = |digits: Range<u8>, only: fn(u8) -> bool| -> Vec<f64> {
            let decades = within.start.floor() as i32..=within.end.ceil() as i32;
            let digits = digits.filter(|digit| only(*digit)).map(|digit| f64::from(digit).log10());
            let all = decades.flat_map(|e| digits.clone().map(move |digit| f64::from(e) + digit));
            all.filter(|at| within.contains(at)).collect()
        };
        self.ticks.retain(|exponent| (exponent - exponent.round()).abs() < 1e-9);
        if self.ticks.len() < 2 {
            self.ticks = digits(1..6, |digit| [1, 2, 5].contains(&digit));
        }
        if self.ticks.len() < 2 {
            let (low, high) = (10f64.powf(self.low), 10f64.powf(self.high));
            self.ticks = round(low..high).into_iter().map(f64::log10).collect();
        }
        if self.ticks.windows(2).all(|pair| pair[1] - pair[0] < 1.5) {
            self.minor = digits(2..10, |_| true);
        }
    }

    /// The position of a number of the csv along the axis.
    fn along(&self, value: f64) -> f64 {
        let shown = value * self.multiply;
        match (self.log, self.exponent) {
            (true, _) => shown.max(0.0).log10(),
            (false, 0) => shown,
            // By powf: the power may be subnormal.
            (false, exponent) => shown / 10f64.powf(f64::from(exponent)),
        }
    }

    /// The position of a number of the csv: 0 at the low end, 1 at the high end. Infinite numbers,
    /// and those without a logarithm, are far outside.
    pub(crate) fn share(&self, value: f64) -> f64 {
        ((self.along(value) - self.low) / (self.high - self.low)).clamp(-1e6, 1e6)
    }

    /// Whether a number of the csv is between the ends.
    pub(crate) fn holds(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.share(value))
    }

    /// The low end in the units of the csv if the axis is logarithmic: the floor for values of 0
    /// and below.
    pub(crate) fn floor(&self) -> Option<f64> {
        self.log.then(|| 10f64.powf(self.low) / self.multiply)
    }

    /// The labels of the ticks.
    pub(crate) fn labels(&self) -> Vec<String> {
        self.ticks.iter().map(|tick| self.format_ext(tick)).collect()
    }
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, along: &f64, pixels: (i32, i32)) -> i32 {
        RangedCoordf64::from(self.low..self.high).map(along, pixels)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match hint.weight() {
            KeyPointWeight::Bold => self.ticks.clone(),
            KeyPointWeight::Any => self.minor.clone(),
        }
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format_ext(&self, along: &f64) -> String {
        let whole = |at: &f64| (at - at.round()).abs() < 1e-9;
        match self.log {
            true if self.ticks.iter().all(whole) => power_of_ten(along.round() as i32),
            true => number(10f64.powf(*along)),
            false => {
                let step =
                    self.ticks.windows(2).map(|pair| pair[1] - pair[0]).next().unwrap_or(1.0);
                stepped(*along, step)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ruler(axis: Axis, most: usize) -> Ruler {
        Ruler::new(&axis, std::iter::empty(), false, most).unwrap()
    }

    fn linear(low: f64, high: f64) -> Axis {
        Axis::new("x", "x").range(low, high)
    }

    #[test]
    fn tiny_and_huge_ranges_have_their_power_of_ten_taken_out() {
        for (size, exponent) in [(4e-6, -6), (4e300, 300), (4e-300, -300)] {
            let ruler = ruler(linear(0.0, size), 6);
            assert_eq!(ruler.exponent, exponent);
            assert_eq!(ruler.labels(), ["0", "1", "2", "3", "4"]);
            assert!((ruler.share(0.25 * size) - 0.25).abs() < 1e-12);
        }
    }

    #[test]
    fn ends_come_from_the_values_that_can_be_shown() {
        let log = Axis::new("y", "force").log();
        let fixed = Ruler::new(&log, [-3.0, 0.0, 0.03, 20.0].into_iter(), true, 6).unwrap();
        assert!(fixed.holds(0.028) && fixed.holds(21.0) && !fixed.holds(0.0));
        for values in [&[][..], &[0.0], &[5.0, 5.0], &[-1e308, 1e308], &[1e-320, 1.0], &[f64::NAN]]
        {
            for axis in [Axis::new("y", "y"), log.clone()] {
                let ruler = Ruler::new(&axis, values.iter().copied(), true, 6).unwrap();
                let shown = |v: &&f64| v.is_finite() && (axis.scale == Scale::Linear || **v > 0.0);
                assert!(values.iter().filter(shown).all(|v| ruler.holds(*v)), "{values:?}");
                assert!(ruler.ticks.len() < 20, "{values:?} {ruler:?}");
            }
        }
    }

    #[test]
    fn an_empty_range_and_a_log_range_from_zero_are_refused() {
        for axis in [linear(2.0, 2.0), linear(0.0, 2.0).log(), linear(0.0, 1.0).times(-1.0)] {
            let refused = Ruler::new(&axis, std::iter::empty(), false, 5);
            assert!(matches!(refused, Err(PlotError::Range { .. })), "{axis:?}");
        }
    }
}
