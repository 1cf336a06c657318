//! A model relative to boundary elements, in numbers and in words.

use serde::Serialize;

use crate::evidence::case::Compared;

/// A model relative to boundary elements, and an interval that holds nine of ten surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ratio {
    /// Model over boundary elements; of the mean gap the difference over Sq.
    pub ratio: f64,
    /// Ends of the interval.
    pub low: f64,
    /// Ends of the interval.
    pub high: f64,
}

impl Ratio {
    /// The ratio of a model with this deviation on a surface that was solved, without an interval.
    #[must_use]
    pub fn solved(deviation: f64, quantity: Compared) -> Self {
        let ratio = agreement(quantity) + deviation;
        Self { ratio, low: ratio, high: ratio }
    }

    /// The ratio that includes two: the interval of both, and the value farther from agreement.
    #[must_use]
    pub fn with(self, other: Self, quantity: Compared) -> Self {
        let far = |ratio: Self| ratio.deviation(quantity).abs();
        let ratio = if far(other) > far(self) { other.ratio } else { self.ratio };
        Self { ratio, low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The deviation of the model: 0 if it agrees.
    #[must_use]
    pub fn deviation(&self, quantity: Compared) -> f64 {
        self.ratio - agreement(quantity)
    }

    /// Half the width of the interval.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        0.5 * (self.high - self.low)
    }

    /// The deviation in plain words: `underestimates the area by 5 to 12 %`.
    #[must_use]
    pub fn words(&self, quantity: Compared) -> String {
        let name = quantity.label();
        let [low, high] = [self.low, self.high].map(|x| percent(x - agreement(quantity)));
        let unit = if quantity == Compared::MeanGap { "% of Sq" } else { "%" };
        let range = |from: f64, to: f64| match from < to {
            true => format!("{from} to {to}"),
            false => format!("{to}"),
        };
        match [low, high] {
            [0.0, 0.0] => format!("agrees in {name} within 0.5 {unit}"),
            [low, high] if low >= 0.0 => {
                format!("overestimates {name} by {} {unit}", range(low, high))
            }
            [low, high] if high <= 0.0 => {
                // Without a negative zero.
                format!("underestimates {name} by {} {unit}", range(0.0 - high, 0.0 - low))
            }
            [low, high] if quantity == Compared::MeanGap => {
                format!("differs in {name} by {low:+} to {high:+} {unit}")
            }
            [low, high] => format!("is within {low:+} to {high:+} {unit} of {name}"),
        }
    }
}

impl Compared {
    /// Its name in sentences.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Area => "the area",
            Self::Stiffness => "the stiffness of first loading",
            Self::UnloadingStiffness => "the unloading stiffness and conductances",
            Self::MeanGap => "the mean gap",
        }
    }
}

/// The number of a model that agrees.
fn agreement(quantity: Compared) -> f64 {
    if quantity == Compared::MeanGap { 0.0 } else { 1.0 }
}

/// Without a negative zero.
fn percent(share: f64) -> f64 {
    (100.0 * share).round() + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviations_in_words() {
        let of =
            |low, high, quantity| Ratio { ratio: 0.5 * (low + high), low, high }.words(quantity);
        let solved = |off| Ratio::solved(off, Compared::Area).words(Compared::Area);
        let said = [
            of(0.88, 0.95, Compared::Area),
            of(1.1, 1.3, Compared::Area),
            of(0.88, 1.003, Compared::Area),
            of(0.997, 1.12, Compared::Area),
            of(0.97, 1.04, Compared::Stiffness),
            of(-0.2, -0.1, Compared::MeanGap),
            of(-0.2, 0.1, Compared::MeanGap),
            solved(-0.12),
            solved(0.002),
        ];
        insta::assert_snapshot!(said.join("\n"));
    }

    #[test]
    fn of_two_ratios_the_farther_counts() {
        let [a, b] = [(0.9, 0.8, 1.0), (1.05, 0.95, 1.15)].map(|(ratio, low, high)| Ratio {
            ratio,
            low,
            high,
        });
        let both = a.with(b, Compared::Area);
        assert_eq!((both.ratio, both.low, both.high), (0.9, 0.8, 1.15));
        assert!((both.half_width() - 0.175).abs() < 1e-12);
    }
}
