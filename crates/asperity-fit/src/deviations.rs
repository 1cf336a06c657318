//! Residuals that are many times the standard deviations of the data.

use asperity_core::short;

use crate::columns::STD;
use crate::{Data, Observation};

/// Residuals beyond this many standard deviations, as a root mean square, deserve a note.
const MANY: f64 = 5.0;
/// Beyond this many, the standard deviations are not those of the data.
const LARGEST_RATIO: f64 = 100.0;

/// Residuals that are many times the standard deviations.
pub(crate) struct Deviations {
    /// The root mean square of residuals over standard deviations, for the degrees of freedom.
    ratio: f64,
    /// Standard deviations in per cent, which explain the ratio.
    in_percent: Option<String>,
}

impl Deviations {
    /// `None` without standard deviations or degrees of freedom, or where the residuals are of
    /// their size.
    pub(crate) fn new(data: &Data, values: &[f64], freedom: usize) -> Option<Self> {
        let ratio = |in_percent: bool| {
            let square = |(one, value): (&Observation, &f64)| {
                let std = one.std? * if in_percent { 0.01 * one.value.abs() } else { 1.0 };
                Some(((value - one.value) / std).powi(2))
            };
            let sum: f64 = data.iter().zip(values).filter_map(square).sum();
            (sum / freedom as f64).sqrt()
        };
        let here = ratio(false);
        if freedom == 0 || !data.has_std() || !(here > MANY && here.is_finite()) {
            return None;
        }
        let is_percent = (1.0 / MANY..MANY).contains(&ratio(true));
        let one = data.iter().find(|one| one.std.is_some()).filter(|_| is_percent);
        let in_percent = one.and_then(|one| {
            let (std, column) = (one.std?, one.measured.column());
            let [given, value, meant] = [std, one.value, 0.01 * std * one.value.abs()].map(short);
            Some(format!(
                "{column}{STD} = {given} looks like per cent of the value; {given} % of {value} is {meant}"
            ))
        });
        Some(Self { ratio: here, in_percent })
    }

    /// Whether the unit of the standard deviations explains the ratio, and no line of the data.
    pub(crate) fn is_in_percent(&self) -> bool {
        self.in_percent.is_some()
    }

    fn sentence(&self, outlier: Option<&str>) -> String {
        let [ratio, chi] = [self.ratio, self.ratio * self.ratio].map(short);
        let advice = self.in_percent.as_deref().or(outlier).unwrap_or(
            "intervals are too narrow; check the standard deviations, or leave them out",
        );
        format!(
            "the residuals are {ratio} times the standard deviations (reduced chi squared {chi}); {advice}"
        )
    }

    /// The sentence where the standard deviations are not those of the data.
    pub(crate) fn misfit(&self, outlier: Option<&str>) -> Option<String> {
        (self.ratio > LARGEST_RATIO).then(|| self.sentence(outlier))
    }

    /// The sentence where the model is far from the data, or the standard deviations are small, and
    /// no outlier explains that.
    pub(crate) fn note(&self, outlier: Option<&str>) -> Option<String> {
        (self.ratio <= LARGEST_RATIO && outlier.is_none()).then(|| self.sentence(None))
    }
}
