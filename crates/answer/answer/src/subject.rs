//! What a sheet is about: a model on a scene, with the names that messages have for both.

use std::borrow::Cow;

use asperity::joints::{EnergyGain, Joint, UnloadingLaw, Work};
use asperity::{
    At, ContactError, Described, Finding, Findings, Model, Scene, Separation, SeparationUnit,
    Severity, Tolerance,
};
use asperity_scene::{SceneFile, mistaken_unit};

use crate::{AnswerError, Sheet};

/// A model on a scene.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// The name of the scene in messages.
    pub name: &'a str,
    /// The model.
    pub model: &'a Model,
    /// Relative tolerance of every value.
    pub tolerance: Tolerance,
}

/// A result, or the reason why there is none.
pub(crate) type Outcome<T = ()> = Result<T, AnswerError>;

/// A separation of a contact on a scene from the plane of the file, in this unit.
pub(crate) fn measured(
    file: &SceneFile,
    scene: &Scene,
    at: Separation,
    unit: SeparationUnit,
) -> Result<f64, ContactError> {
    Ok(at.measured_in(unit, file.spec.separation_from, scene)?.value)
}

impl Sheet {
    /// Adds the warnings that the scene does not accept, one for each cause.
    pub(crate) fn report(&mut self, file: &SceneFile, found: Findings) {
        self.extend(file.accepted(found).at_least(Severity::Warning));
    }
}

impl Subject<'_> {
    /// The id of the model, in rows and messages.
    #[must_use]
    pub fn id(&self) -> &str {
        self.model.id()
    }

    /// Fills a sheet; an error is about the model.
    pub(crate) fn fill<T>(
        &self,
        sheet: &mut Sheet,
        fill: impl FnOnce(&mut Sheet) -> Outcome<T>,
    ) -> Outcome<T> {
        fill(sheet).map_err(|error| error.of_model(self.id()))
    }

    /// The scene over whose heights the model averages.
    pub(crate) fn scene(&self) -> Result<Cow<'_, Scene>, ContactError> {
        self.model.scene_of(&self.file.scene)
    }

    /// A separation from the plane of the scene, in this unit.
    pub(crate) fn place(&self, at: Separation, unit: SeparationUnit) -> Result<f64, ContactError> {
        measured(self.file, &*self.scene()?, at, unit)
    }

    /// Joints of these unloading laws.
    pub(crate) fn joints(&self, laws: &[UnloadingLaw]) -> Result<Vec<Joint>, ContactError> {
        let scene = &self.file.scene;
        laws.iter().map(|law| Joint::new(self.model, scene, *law, self.tolerance)).collect()
    }

    /// A text about the model with an unloading law.
    pub(crate) fn by(&self, law: UnloadingLaw, text: &str) -> String {
        format!("{} by {law}: {text}", self.id())
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

/// Retreats from the closest approach, in a unit.
pub type Retreats<'r> = (&'r [f64], SeparationUnit);

/// Retreats in metres, with a warning of those that look like another unit.
pub(crate) fn metres(sheet: &mut Sheet, scene: &Scene, (values, unit): Retreats<'_>) -> Vec<f64> {
    let sigma = scene.surface.asperity_height_std;
    sheet.findings.extend(unit_warning("retreat", values, unit, sigma));
    let metres = if unit == SeparationUnit::Sigma { sigma } else { 1.0 };
    values.iter().map(|value| metres * value).collect()
}

/// A warning of values of an unlikely size, by the largest of them; `name` is their option.
#[must_use]
pub fn unit_warning(
    name: &str,
    values: &[f64],
    unit: SeparationUnit,
    height_std: f64,
) -> Option<Finding> {
    let value = values.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
    let remedy = "write lengths with their unit, for example 2um";
    mistaken_unit(name, value, unit, height_std, remedy)
}
