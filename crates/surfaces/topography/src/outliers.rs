//! What was found of the outliers of a surface.

use serde::Serialize;

/// The share of m₄ or of ⟨z⁴⟩ from which outliers matter: R is 2.5 % too small at 0.05 of m₄.
pub(crate) const MATTERS: f64 = 0.05;

/// The outliers of a surface, from [`outliers`](crate::Topography::outliers).
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Outliers {
    /// Their number.
    pub count: usize,
    /// The one furthest outside its neighbours: its distance above the highest of them, or, if
    /// negative, below the lowest \[m\], without regard to up to three (in profiles two) other
    /// outliers. 0 without outliers.
    pub largest: f64,
    /// The share of m₄ that is due to them, 0 to 1.
    pub m4_share: f64,
    /// The share of the fourth moment of the heights, ⟨z⁴⟩ = Sku Sq⁴, that is due to them, 0 to 1.
    pub kurtosis_share: f64,
    /// Their indices, ascending; of two surfaces together there are none.
    #[serde(skip)]
    pub points: Vec<usize>,
}

impl Outliers {
    /// Whether they change the parameters of the surface: at least 5 % of m₄ or of ⟨z⁴⟩.
    #[must_use]
    pub fn matter(&self) -> bool {
        self.m4_share.max(self.kurtosis_share) >= MATTERS
    }

    /// Those of two surfaces; `weight` is the share of the first one in the summed m₄.
    pub(crate) fn plus(&self, other: &Self, weight: f64) -> Self {
        let largest = if self.largest.abs() > other.largest.abs() { self } else { other };
        Self {
            count: self.count + other.count,
            largest: largest.largest,
            m4_share: weight * self.m4_share + (1.0 - weight) * other.m4_share,
            kurtosis_share: self.kurtosis_share.max(other.kurtosis_share),
            points: vec![],
        }
    }
}
