//! What a sheet is about: a model on a scene, with the names that messages have for both.

use std::error::Error;

use asperity::joints::{EnergyGain, Joint, UnloadingLaw, Work};
use asperity::{
    At, ContactError, Finding, Findings, Model, Separation, SeparationUnit, Severity, Tolerance,
};
use asperity_inputs::{SceneFile, mistaken_unit};

use crate::Sheet;

/// A model on a scene.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// The name of the scene in messages.
    pub name: &'a str,
    /// The name of the model in rows and messages.
    pub id: &'a str,
    /// The model.
    pub model: &'a Model,
    /// Relative tolerance of every value.
    pub tolerance: Tolerance,
}

/// Why there is no sheet, and the findings that precede the reason.
#[derive(Debug, Clone, thiserror::Error)]
#[error("{reason}")]
pub struct Unanswered {
    /// The reason.
    pub reason: String,
    /// Findings, in the order in which they are to be read.
    pub findings: Vec<Finding>,
}

/// Fills a sheet, or tells why it cannot.
pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;

impl Sheet {
    /// A sheet under these columns; an error begins with what it is about, if anything.
    pub(crate) fn filled(
        about: &str,
        heads: &[&str],
        fill: impl FnOnce(&mut Self) -> Outcome,
    ) -> Result<Self, Unanswered> {
        let mut sheet = Self::new(heads);
        match fill(&mut sheet) {
            Ok(()) => Ok(sheet),
            Err(error) => {
                let colon = if about.is_empty() { "" } else { ": " };
                let reason = format!("{about}{colon}{error}");
                Err(Unanswered { reason, findings: sheet.findings })
            }
        }
    }

    /// Adds the warnings and errors that the scene does not accept, one for each cause.
    pub(crate) fn report(&mut self, file: &SceneFile, found: Findings) {
        self.extend(file.accepted(found).at_least(Severity::Warning));
    }
}

impl Subject<'_> {
    /// A sheet under these columns about this model on this scene.
    pub(crate) fn sheet(
        &self,
        heads: &[&str],
        fill: impl FnOnce(&mut Sheet) -> Outcome,
    ) -> Result<Sheet, Unanswered> {
        Sheet::filled(&format!("{}: {}", self.name, self.id), heads, fill)
    }

    /// A separation from the plane of the scene, in this unit.
    pub(crate) fn place(&self, at: Separation, unit: SeparationUnit) -> Result<f64, ContactError> {
        Ok(at.measured_in(unit, self.file.separation_from, &self.file.scene)?.value)
    }

    /// Joints of these unloading laws.
    pub(crate) fn joints(&self, laws: &[UnloadingLaw]) -> Result<Vec<Joint>, ContactError> {
        let scene = &self.file.scene;
        laws.iter().map(|law| Joint::new(self.model, scene, *law, self.tolerance)).collect()
    }

    /// Warns of a joint that creates energy when it is closed to a place and opened.
    pub(crate) fn warn_energy_gain(
        &self,
        sheet: &mut Sheet,
        joint: &Joint,
        closest: At,
        work: &Work,
    ) -> Result<(), ContactError> {
        let gain = joint.energy_gain(closest, work)?;
        sheet.report(self.file, gain.iter().map(EnergyGain::finding).collect());
        Ok(())
    }
}

/// A warning of values that look like another unit, by the largest of them; `name` is their option.
#[must_use]
pub fn unit_warning(
    name: &str,
    values: &[f64],
    unit: SeparationUnit,
    height_std: f64,
) -> Option<Finding> {
    let value = values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let message = mistaken_unit(name, value, unit, height_std)?;
    let text = format!("{message}; write lengths with their unit, for example 2um");
    Some(Finding::warning("likely-unit", name.to_string(), value).fact(text))
}
