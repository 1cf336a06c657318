//! One axis made definite: its ends, its ticks, and where a number falls on it.

use anyhow::{Result, bail};

use super::figure::{Axis, Scale};
use super::ticks::{self, Step, Ticks};

/// An axis with its ends known.
#[derive(Debug, Clone)]
pub(crate) struct Ruler {
    scale: Scale,
    multiply: f64,
    low: f64,
    high: f64,
    /// What is written along the axis.
    pub(crate) ticks: Ticks,
}

impl Ruler {
    /// Fixes the ends of an axis by its range or else by the values on it.
    /// `room` asks for air beyond the values; `most` is the count of labels that fit.
    pub(crate) fn new(axis: &Axis, values: &[f64], room: bool, most: f64) -> Result<Self> {
        let name = &axis.label;
        if !(axis.multiply.is_finite() && axis.multiply > 0.0) {
            bail!("axis `{name}`: the factor {} is not above zero", axis.multiply);
        }
        let shown: Vec<f64> = values
            .iter()
            .map(|value| value * axis.multiply)
            .filter(|value| value.is_finite() && (axis.scale == Scale::Linear || *value > 0.0))
            .collect();
        let (low, high) = match axis.range {
            Some((from, to)) => (from * axis.multiply, to * axis.multiply),
            None if shown.is_empty() => {
                bail!("axis `{name}`: column `{}` has no value to show", axis.column)
            }
            None => ends(axis.scale, &shown, room, most),
        };
        if !(low.is_finite() && high.is_finite() && low < high) {
            bail!("axis `{name}`: the range {low} to {high} is empty");
        }
        if axis.scale == Scale::Log && low <= 0.0 {
            bail!("axis `{name}`: a logarithmic range cannot begin at {low}");
        }
        let ticks = ticks::between(axis.scale, low, high, most);
        Ok(Self { scale: axis.scale, multiply: axis.multiply, low, high, ticks })
    }

    /// Where a number of the CSV falls: 0 at the low end, 1 at the high end.
    /// Infinite ends and what a logarithm does not know go far outside.
    pub(crate) fn share(&self, value: f64) -> f64 {
        self.share_of_shown(value * self.multiply)
    }

    /// The same for a number in shown units, such as a tick.
    pub(crate) fn share_of_shown(&self, value: f64) -> f64 {
        let share = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log if value > 0.0 => {
                (value.log10() - self.low.log10()) / (self.high.log10() - self.low.log10())
            }
            Scale::Log => -1e6,
        };
        share.clamp(-1e6, 1e6)
    }

    /// Whether a number of the CSV is between the ends.
    pub(crate) fn holds(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.share(value))
    }

    /// The low end in the units of the CSV if the axis is logarithmic: what is
    /// not above zero has to be cut there.
    pub(crate) fn floor(&self) -> Option<f64> {
        (self.scale == Scale::Log).then_some(self.low / self.multiply)
    }
}

fn ends(scale: Scale, shown: &[f64], room: bool, most: f64) -> (f64, f64) {
    let low = shown.iter().copied().fold(f64::INFINITY, f64::min);
    let high = shown.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    match scale {
        Scale::Linear => linear_ends(low, high, room, most),
        Scale::Log if high / low < 1.0 + 1e-9 => (low / 3.0, high * 3.0),
        Scale::Log if room => (round_down(low / 1.1), round_up(high * 1.1)),
        Scale::Log => (low, high),
    }
}

fn linear_ends(low: f64, high: f64, room: bool, most: f64) -> (f64, f64) {
    let size = low.abs().max(high.abs());
    if high - low <= size * 1e-9 {
        let half = if size > 0.0 { size * 0.5 } else { 1.0 };
        return (low - half, high + half);
    }
    if !room {
        return (low, high);
    }
    let air = (high - low) * 0.03;
    let half_step = Step::for_span(high - low, most).size() / 2.0;
    let from_zero = low >= 0.0 && low < 0.2 * high;
    let to_zero = high <= 0.0 && -high < -0.2 * low;
    let down = if from_zero { 0.0 } else { ((low - air) / half_step).floor() * half_step };
    let up = if to_zero { 0.0 } else { ((high + air) / half_step).ceil() * half_step };
    (down, up)
}

fn round_down(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    let digit = [5.0, 2.0].into_iter().find(|digit| digit * decade <= value);
    digit.unwrap_or(1.0) * decade
}

fn round_up(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    let digit = [1.0, 2.0, 5.0].into_iter().find(|digit| digit * decade >= value);
    digit.unwrap_or(10.0) * decade
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_changes_the_labels_and_not_the_places() -> anyhow::Result<()> {
        let plain = Axis::new("x", "x (m)").range(0.0, 4e-6);
        let micro = plain.clone().times(1e6);
        let plain = Ruler::new(&plain, &[], false, 6.0)?;
        let micro = Ruler::new(&micro, &[], false, 6.0)?;
        assert!((plain.share(1e-6) - micro.share(1e-6)).abs() < 1e-12);
        assert_eq!(micro.ticks.factor, None);
        Ok(())
    }

    #[test]
    fn a_log_axis_takes_its_ends_from_what_is_above_zero() -> anyhow::Result<()> {
        let axis = Axis::new("y", "force").log();
        let ruler = Ruler::new(&axis, &[-3.0, 0.0, 0.03, 20.0], true, 6.0)?;
        assert!(ruler.holds(0.02) && ruler.holds(50.0) && !ruler.holds(0.0));
        assert!(Ruler::new(&axis, &[-3.0, 0.0], true, 6.0).is_err());
        Ok(())
    }

    #[test]
    fn an_empty_range_and_a_log_range_from_zero_are_refused() {
        assert!(Ruler::new(&Axis::new("x", "x").range(2.0, 2.0), &[], false, 5.0).is_err());
        assert!(Ruler::new(&Axis::new("x", "x").log().range(0.0, 2.0), &[], false, 5.0).is_err());
    }
}
