//! Axes: where a number lies, and which numbers are written.

use asperity::Output;

use crate::number::rounded;

/// From this ratio of the largest to the smallest value on, a logarithmic axis shows more.
const WIDE: f64 = 50.0;

/// A linear or logarithmic axis between two pixels.
pub struct Axis {
    low: f64,
    high: f64,
    logarithmic: bool,
    from: f64,
    to: f64,
}

impl Axis {
    /// An axis that just holds these numbers.
    pub fn linear(values: impl Iterator<Item = f64>, (from, to): (f64, f64)) -> Self {
        let (mut low, mut high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if !low.is_finite() || !high.is_finite() {
            (low, high) = (0.0, 1.0);
        }
        if high - low <= 1e-12 * high.abs().max(low.abs()) {
            // One value stands in the middle.
            let room = if low == 0.0 { 1.0 } else { 0.1 * low.abs() };
            (low, high) = (low - room, high + room);
        }
        Self { low, high, logarithmic: false, from, to }
    }

    /// Logarithmic where the output is a size that spans decades, and mostly positive.
    pub fn fitting(values: &[f64], output: Output, pixels: (f64, f64)) -> Self {
        let positive: Vec<f64> = values.iter().copied().filter(|v| *v > 0.0).collect();
        let least = positive.iter().copied().fold(f64::INFINITY, f64::min);
        let most = positive.iter().copied().fold(0.0, f64::max);
        let is_size =
            output.regime().is_none() && !matches!(output, Output::LnForce | Output::LnArea);
        if is_size && most / least >= WIDE && 2 * positive.len() > values.len() {
            let decades = positive.iter().map(|v| v.log10());
            let axis = Self::linear(decades, pixels);
            return Self { logarithmic: true, ..axis.rounded_out() };
        }
        let zero = is_size.then_some(0.0);
        Self::linear(values.iter().copied().chain(zero), pixels).with_room()
    }

    /// Ends at decades, unless that leaves much of the axis empty.
    fn rounded_out(self) -> Self {
        let (low, high) = (self.low.floor(), self.high.ceil());
        if high - low < 1.5 * (self.high - self.low) { Self { low, high, ..self } } else { self }
    }

    /// A little room above and below, but none below 0.
    fn with_room(self) -> Self {
        let room = 0.04 * self.high - 0.04 * self.low;
        let low = if self.low == 0.0 { 0.0 } else { self.low - room };
        Self { low, high: self.high + room, ..self }
    }

    /// The pixel of a value; none for what a logarithmic axis cannot show.
    pub fn pixel(&self, value: f64) -> Option<f64> {
        let at = if self.logarithmic { value.log10() } else { value };
        (value > 0.0 || !self.logarithmic).then(|| self.place(at))
    }

    fn place(&self, at: f64) -> f64 {
        // In two steps, because the difference of huge ends may overflow.
        let share = (at / 2.0 - self.low / 2.0) / (self.high / 2.0 - self.low / 2.0);
        self.from + share * (self.to - self.from)
    }

    /// Pixels and labels of the numbers that are written.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let step = self.step();
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        (first..=last)
            .map(|k| {
                let at = k as f64 * step;
                (self.place(at), if self.logarithmic { power(at) } else { plain(at, step) })
            })
            .collect()
    }

    /// 1, 2 or 5 times a power of ten, four to nine of them on the axis; whole decades.
    fn step(&self) -> f64 {
        let raw = self.high / 8.0 - self.low / 8.0;
        let ten = 10f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|f| f * ten).into_iter().find(|s| *s >= raw);
        let step = step.unwrap_or(ten);
        if self.logarithmic && self.high - self.low > 2.0 { step.max(1.0).round() } else { step }
    }
}

fn power(exponent: f64) -> String {
    if exponent.fract() == 0.0 {
        format!("10<tspan dy=\"-6\" font-size=\"10\">{exponent:.0}</tspan>")
    } else {
        rounded(10f64.powf(exponent)).replace('e', "·10^")
    }
}

fn plain(value: f64, step: f64) -> String {
    // What a sum of steps leaves of 0.
    rounded(if value.abs() < 1e-9 * step { 0.0 } else { (value / step).round() * step })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::linear([0.0, 4.0].into_iter(), (0.0, 100.0));
        assert_eq!(labels(&axis), ["0", "0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4"]);
        assert!(axis.ticks().iter().all(|(at, _)| (0.0..=100.0).contains(at)));
        let axis = Axis::linear([-0.3, 0.1].into_iter(), (0.0, 100.0));
        assert!(labels(&axis).contains(&"0".to_string()), "{:?}", labels(&axis));
    }

    #[test]
    fn values_over_decades_get_a_logarithmic_axis_and_negative_ones_no_place_on_it() {
        let axis = Axis::fitting(&[1e-3, 1.0, 1e3, -2.0], Output::Force, (100.0, 0.0));
        assert_eq!(axis.ticks().len(), 7);
        assert!(axis.pixel(-2.0).is_none() && axis.pixel(0.0).is_none());
        assert!(axis.pixel(1.0).is_some_and(|p| (p - 50.0).abs() < 1e-9));
        let axis = Axis::fitting(&[1e-3, -1.0, -1e3], Output::Force, (100.0, 0.0));
        assert!(axis.pixel(-1e3).is_some());
    }

    #[test]
    fn odd_ranges_still_make_an_axis() {
        for values in [vec![], vec![0.0], vec![5.0, 5.0], vec![-1e308, 1e308], vec![1e-320, 1.0]] {
            let axis = Axis::fitting(&values, Output::Area, (100.0, 0.0));
            let inside = |v: &f64| axis.pixel(*v).is_none_or(|p| (-1e-6..=100.000001).contains(&p));
            assert!(values.iter().all(inside), "{values:?}");
            assert!(axis.ticks().len() < 20, "{values:?}");
        }
    }
}
