//! Models compared with boundary elements: the table on which advice is based.

mod case;
mod coordinates;
mod expected;
mod interval;
mod process;

use std::sync::OnceLock;

use coordinates::{Coordinates, Ranges};
use process::Process;

pub(crate) use case::Lacking;
pub use case::compile_known;

pub use crate::evidence::case::{Compared, EvidenceCase, EvidenceRow};
pub use crate::evidence::coordinates::SurfaceShape;
pub use crate::evidence::expected::{Estimate, ExpectedContact};
use asperity_core::ContactError;

/// Boundary elements on generated surfaces, and models beside them, as `cargo xtask truth` computes
/// them: periodic, 256 x 256 to 2048 x 2048 pixels with shortest waves of 8 pixels, from
/// `bem::RandomSurface`; isotropic and Gaussian, or skewed, or with a lay;
/// elastic and with plasticity indices (moments, E, S and H as the models use them).
///
/// [`expected`](Self::expected) interpolates between them.
#[derive(Debug, Clone)]
pub struct Evidence {
    cases: Vec<EvidenceCase>,
    /// Of the cases, in their order.
    places: Vec<Coordinates>,
    /// [Their ranges](Coordinates::ranges).
    ranges: Ranges,
    /// Through the cases, one for each of [`Compared::ALL`], made at first use.
    processes: [OnceLock<Option<Process>>; Compared::ALL.len()],
}

impl Evidence {
    /// The committed table, a csv with the columns [`COLUMNS`](Self::COLUMNS).
    pub const CSV: &'static str = include_str!("../../data/truth.csv");

    /// Further columns, four for each model: ratios of its area, stiffness and unloading
    /// stiffness to boundary elements, and its mean gap less theirs over √m₀, all in thousandths;
    /// empty if not available. No answer needs them.
    pub const MODELS: &'static str = include_str!("../../data/truth-models.csv");

    /// Columns of the cases and of boundary elements: means over the surfaces and their standard
    /// errors. Stiffnesses -dp/d(gap) are in units of E/√m₀, mean gaps in √m₀: distances of the
    /// mean planes, as the separations of models are, with the gaps of plastic pixels below 0.
    pub const COLUMNS: &'static str = case::COLUMNS;

    /// Hurst exponent of the spectra of the solved surfaces.
    pub const HURST: f64 = 0.8;

    /// Root mean square gradient of the solved surfaces, to which stiffnesses are proportional.
    pub const GRADIENT: f64 = 0.05;

    /// The number of a model in the table, from a result of it and of boundary elements.
    #[must_use]
    pub fn relative(quantity: Compared, model: f64, bem: f64) -> f64 {
        match quantity {
            Compared::MeanGap => (model - bem) / case::UNIT,
            _ => model / bem / case::UNIT,
        }
    }

    /// The committed evidence.
    ///
    /// # Errors
    /// The errors of [`parse`](Self::parse).
    pub fn committed() -> Result<&'static Self, ContactError> {
        static READ: OnceLock<Result<Evidence, ContactError>> = OnceLock::new();
        READ.get_or_init(|| Self::parse(Self::CSV)).as_ref().map_err(Clone::clone)
    }

    /// The lines of the committed table, each with the columns of models.
    pub fn lines_with_models() -> impl Iterator<Item = String> {
        let lines = Self::CSV.lines().zip(Self::MODELS.lines());
        lines.map(|(own, models)| format!("{own},{models}"))
    }

    /// The committed evidence with the results of models.
    ///
    /// # Errors
    /// The errors of [`parse`](Self::parse).
    pub fn with_models() -> Result<Self, ContactError> {
        Self::parse(&Self::lines_with_models().collect::<Vec<_>>().join("\n"))
    }

    /// Reads evidence from a text like [`CSV`](Self::CSV), if need be with columns of models.
    ///
    /// # Errors
    /// [`ContactError::Refused`] with line, column and content of the first invalid field, or if
    /// there are no cases.
    pub fn parse(text: &str) -> Result<Self, ContactError> {
        Self::of_cases(case::cases(text)?)
    }

    fn of_cases(cases: Vec<EvidenceCase>) -> Result<Self, ContactError> {
        let places = cases.iter().map(Coordinates::of_case);
        let places: Vec<_> = places.collect::<Result<_, ContactError>>()?;
        let ranges = Coordinates::ranges(&places);
        Ok(Self { cases, places, ranges, processes: Default::default() })
    }

    /// All cases, ordered by surface, material and load.
    #[must_use]
    pub fn cases(&self) -> &[EvidenceCase] {
        &self.cases
    }
}

#[cfg(test)]
mod tests;
