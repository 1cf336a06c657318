//! A solved case with the results of boundary elements and of the models.

use serde::Serialize;

/// One family of surfaces, one material and one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvidenceCase {
    /// m₀ m₄/m₂² of profiles, the mean of all directions.
    pub alpha: f64,
    /// Skewness of the heights.
    pub skewness: f64,
    /// Rms slope across the lay over that along it.
    pub slope_ratio: f64,
    /// ψ = √(σ_z/w_c); 0 for elastic cases.
    pub plasticity_index: f64,
    /// p/(E g), with the root mean square gradient g.
    pub load: f64,
    /// Number of surfaces with the same moments.
    pub surfaces: usize,
    /// Contact patches of at least 12 pixels on all of them.
    pub patches: usize,
    /// Share of the contact at the hardness.
    pub plastic_share: f64,
    /// Boundary elements: the mean of the surfaces.
    pub bem: EvidenceRow,
    /// Results of the models, by id.
    #[serde(skip)]
    pub models: Vec<(String, EvidenceRow)>,
}

/// Dimensionless results; `None` if not available. Spans are one standard error of the mean to
/// either side, for boundary elements only.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// Real over nominal area.
    pub area_fraction: Option<f64>,
    /// Span of the area.
    pub area_span: Option<[f64; 2]>,
    /// -dp/d(gap) √m₀/E in first loading.
    pub stiffness: Option<f64>,
    /// Span of the stiffness.
    pub stiffness_span: Option<[f64; 2]>,
    /// -dp/d(gap) √m₀/E at the start of unloading, in proportion to conductances.
    pub unloading_stiffness: Option<f64>,
    /// Span of the unloading stiffness.
    pub unloading_stiffness_span: Option<[f64; 2]>,
    /// Mean gap over √m₀.
    pub mean_gap: Option<f64>,
    /// Span of the mean gap.
    pub mean_gap_span: Option<[f64; 2]>,
}

/// A quantity that is compared with boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Compared {
    /// Real area.
    Area,
    /// Stiffness of first loading.
    Stiffness,
    /// Stiffness at the start of unloading; conductances and tangential stiffness, too.
    UnloadingStiffness,
    /// Mean gap.
    MeanGap,
}

impl Compared {
    /// All four.
    pub const ALL: [Self; 4] =
        [Self::Area, Self::Stiffness, Self::UnloadingStiffness, Self::MeanGap];

    /// Its name in columns and keys.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Stiffness => "stiffness",
            Self::UnloadingStiffness => "unloading_stiffness",
            Self::MeanGap => "mean_gap",
        }
    }
}

impl EvidenceRow {
    /// A row of values, each with its standard error, in the order of [`Compared::ALL`].
    #[must_use]
    pub(crate) fn of(values: [Option<f64>; 4], errors: [Option<f64>; 4]) -> Self {
        let span = |k: usize| values[k].zip(errors[k]).map(|(x, error)| [x - error, x + error]);
        Self {
            area_fraction: values[0],
            area_span: span(0),
            stiffness: values[1],
            stiffness_span: span(1),
            unloading_stiffness: values[2],
            unloading_stiffness_span: span(2),
            mean_gap: values[3],
            mean_gap_span: span(3),
        }
    }

    /// The value of a quantity.
    #[must_use]
    pub fn value(&self, quantity: Compared) -> Option<f64> {
        match quantity {
            Compared::Area => self.area_fraction,
            Compared::Stiffness => self.stiffness,
            Compared::UnloadingStiffness => self.unloading_stiffness,
            Compared::MeanGap => self.mean_gap,
        }
    }

    /// Its standard error.
    #[must_use]
    pub fn error(&self, quantity: Compared) -> Option<f64> {
        let span = match quantity {
            Compared::Area => self.area_span,
            Compared::Stiffness => self.stiffness_span,
            Compared::UnloadingStiffness => self.unloading_stiffness_span,
            Compared::MeanGap => self.mean_gap_span,
        };
        span.map(|[low, high]| 0.5 * (high - low))
    }
}
