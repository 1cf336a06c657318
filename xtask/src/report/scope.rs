//! The extent of a run: models, quantities, tolerances, times.

use std::path::PathBuf;
use std::time::Duration;

use anyhow::Result;
use asperity::{Model, Quantity};

use super::effort::Effort;
use super::methods::{Method, Setting};
use super::problem::tightest;
use crate::folder::{figures_folder, target_folder};

/// The quantities that are one integral of one law; the others follow from these.
const INTEGRALS: [Quantity; 4] =
    [Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::Tangent];

/// The extent of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every model and integral.
    Full,
    /// A few, in seconds, as a test of the whole run.
    Quick,
}

impl Scope {
    /// The pairs of model and quantity.
    ///
    /// # Errors
    /// Only if a model's name is unknown.
    pub fn pairs(self) -> Result<Vec<(Model, Quantity)>> {
        let (models, quantities) = match self {
            Self::Full => (Model::all(), &INTEGRALS[..]),
            Self::Quick => {
                let models = ["ke", "jg", "gao"].map(str::parse);
                let models = models.into_iter().collect::<Result<Vec<Model>, _>>()?;
                (models, &[Quantity::Force, Quantity::Tangent][..])
            }
        };
        let pairs = |model: Model| quantities.iter().map(move |q| (model.clone(), *q));
        Ok(models.into_iter().flat_map(pairs).collect())
    }

    /// Tolerances for a model, loosest first, down to its tightest.
    #[must_use]
    pub fn tolerances(self, model: &Model) -> Vec<f64> {
        let all: &[f64] = match self {
            Self::Full => &[1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-13],
            Self::Quick => &[1e-3, 1e-10],
        };
        all.iter().copied().filter(|tolerance| *tolerance >= tightest(model)).collect()
    }

    /// The settings of a method, row by row.
    #[must_use]
    pub fn settings(self, method: Method, model: &Model) -> Vec<Setting> {
        let points: &[usize] = if self == Self::Full { &[16, 32, 64, 128] } else { &[16, 128] };
        method.settings(&self.tolerances(model), points)
    }

    /// The folder of its files.
    #[must_use]
    pub fn folder(self) -> PathBuf {
        if self == Self::Full { figures_folder() } else { target_folder().join("report") }
    }

    /// The measuring time of each row.
    #[must_use]
    pub fn effort(self) -> Effort {
        let (repeats, batch, most) = if self == Self::Full { (21, 300, 60) } else { (3, 50, 5) };
        let (batch, most) = (Duration::from_micros(batch), Duration::from_millis(most));
        Effort { repeats, batch, most }
    }
}
