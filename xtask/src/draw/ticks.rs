//! Round numbers along an axis, and their labels.

use super::figure::Scale;
use super::text;

/// A number on an axis, in the units that are shown.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    /// `None` for a minor tick.
    pub(crate) label: Option<String>,
}

/// The ticks of an axis and the power of ten that was taken out of their labels.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Ticks {
    pub(crate) ticks: Vec<Tick>,
    pub(crate) factor: Option<i32>,
}

/// A step of one, two or five times a power of ten, kept in whole numbers so
/// that its multiples come out as the nearest floats.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    digit: i32,
    exponent: i32,
}

impl Step {
    /// The least round step that divides the span into at most so many parts.
    pub(crate) fn for_span(span: f64, parts: f64) -> Self {
        let raw = span / parts.max(1.0);
        let exponent = raw.log10().floor() as i32;
        let lead = raw / 10f64.powi(exponent);
        for digit in [1, 2, 5] {
            if lead <= f64::from(digit) * (1.0 + 1e-9) {
                return Self { digit, exponent };
            }
        }
        Self { digit: 1, exponent: exponent + 1 }
    }

    /// The step as a number.
    pub(crate) fn size(self) -> f64 {
        self.multiple(1.0)
    }

    fn multiple(self, count: f64) -> f64 {
        let whole = count * f64::from(self.digit);
        if self.exponent < 0 {
            whole / 10f64.powi(-self.exponent)
        } else {
            whole * 10f64.powi(self.exponent)
        }
    }

    fn within(self, low: f64, high: f64) -> impl Iterator<Item = f64> {
        let first = (low / self.size() - 1e-6).ceil() as i64;
        let last = (high / self.size() + 1e-6).floor() as i64;
        (first..=last).map(move |count| self.multiple(count as f64))
    }

    fn minor(self) -> Self {
        match self.digit {
            1 => Self { digit: 2, exponent: self.exponent - 1 },
            2 => Self { digit: 5, exponent: self.exponent - 1 },
            _ => Self { digit: 1, exponent: self.exponent },
        }
    }
}

/// The ticks between two ends in shown units, at most `most` of them labelled.
pub(crate) fn between(scale: Scale, low: f64, high: f64, most: f64) -> Ticks {
    match scale {
        Scale::Linear => linear(low, high, most),
        Scale::Log => logarithmic(low, high, most),
    }
}

fn linear(low: f64, high: f64, most: f64) -> Ticks {
    let step = Step::for_span(high - low, most);
    let largest = low.abs().max(high.abs()).log10().floor() as i32;
    let factor = (!(-2..5).contains(&largest)).then_some(largest);
    let decimals = (factor.unwrap_or(0) - step.exponent).max(0) as usize;
    let scaled = |value: f64| value / 10f64.powi(factor.unwrap_or(0));
    let mut ticks: Vec<Tick> = step
        .within(low, high)
        .map(|at| Tick { at, label: Some(text::decimal(scaled(at), decimals)) })
        .collect();
    let near = step.size() * 1e-3;
    let minor: Vec<Tick> = step
        .minor()
        .within(low, high)
        .filter(|at| ticks.iter().all(|major| (major.at - at).abs() > near))
        .map(|at| Tick { at, label: None })
        .collect();
    ticks.extend(minor);
    Ticks { ticks, factor }
}

fn logarithmic(low: f64, high: f64, most: f64) -> Ticks {
    let slack = 1e-9;
    let first = (low.log10() - slack).floor() as i32;
    let last = (high.log10() + slack).ceil() as i32;
    let inside = |value: f64| value >= low * (1.0 - slack) && value <= high * (1.0 + slack);
    let decades: Vec<i32> = (first..=last).filter(|e| inside(power(1, *e))).collect();
    if decades.len() < 2 {
        let decades = high.log10() - low.log10();
        if decades < 0.5 {
            return linear(low, high, most);
        }
    }
    let every = ((decades.len() as f64 / most.max(2.0)).ceil() as i32).max(1);
    let plain = decades.len() < 2;
    let mut ticks = Vec::new();
    for exponent in first..=last {
        for digit in 1..10 {
            let at = power(digit, exponent);
            if !inside(at) {
                continue;
            }
            let label = match digit {
                1 if plain => Some(short(digit, exponent)),
                2 | 5 if plain => Some(short(digit, exponent)),
                1 if exponent.rem_euclid(every) == 0 => Some(text::power_of_ten(exponent)),
                _ => None,
            };
            if label.is_some() || every == 1 || digit == 1 {
                ticks.push(Tick { at, label });
            }
        }
    }
    Ticks { ticks, factor: None }
}

fn power(digit: i32, exponent: i32) -> f64 {
    Step { digit, exponent }.size()
}

fn short(digit: i32, exponent: i32) -> String {
    if (-3..4).contains(&exponent) {
        text::decimal(power(digit, exponent), (-exponent).max(0) as usize)
    } else if digit == 1 {
        text::power_of_ten(exponent)
    } else {
        format!("{digit}×{}", text::power_of_ten(exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> Vec<&str> {
        ticks.ticks.iter().filter_map(|tick| tick.label.as_deref()).collect()
    }

    #[test]
    fn linear_labels_are_round_and_short() {
        let ticks = between(Scale::Linear, 0.0, 4.0, 6.0);
        assert_eq!(labels(&ticks), ["0", "1", "2", "3", "4"]);
        let ticks = between(Scale::Linear, -0.3, 0.3, 4.0);
        assert_eq!(labels(&ticks), ["−0.2", "0.0", "0.2"]);
    }

    #[test]
    fn a_tiny_range_has_its_power_of_ten_taken_out() {
        let ticks = between(Scale::Linear, 0.0, 4e-6, 6.0);
        assert_eq!(ticks.factor, Some(-6));
        assert_eq!(labels(&ticks), ["0", "1", "2", "3", "4"]);
    }

    #[test]
    fn decades_are_labelled_as_powers_with_minor_ticks_between() {
        let ticks = between(Scale::Log, 1e-3, 10.0, 8.0);
        assert_eq!(labels(&ticks), ["10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]);
        assert_eq!(ticks.ticks.len(), 5 + 4 * 8);
    }

    #[test]
    fn a_short_log_range_still_has_labels() {
        assert_eq!(labels(&between(Scale::Log, 0.15, 0.9, 8.0)), ["0.2", "0.5"]);
    }
}
