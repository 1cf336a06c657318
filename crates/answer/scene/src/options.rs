//! Options of the models for scene files, keywords and command lines.

use asperity::bem::{Bem, BemOptions, Continuation};
use asperity::film::friction_factor;
use asperity::{
    AngleDensity, ContactError, Displacement, FlowPressure, ForceComponent, LateralOptions, Model,
    Persson, PerssonVariance, Spectrum, Stick,
};
use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use crate::document::{Document, Files};
use crate::error::{Place, SceneError};
use crate::keys::{joined, keys_of};
use crate::measured::ScanSpectrum;

/// Variants of the models; the defaults are the models' own.
///
/// As a scene file's `[options]`, as keywords and in serde formats, it is a map from the names of
/// these fields to values, each optional: a name, a number, or named numbers.
///
/// ```
/// use std::collections::BTreeMap;
///
/// use asperity_scene::ModelOptions;
///
/// let mut options = ModelOptions::default();
/// options.set("force", &"vertical".into())?;
/// options.set("displacement", &BTreeMap::from([("zeta", 0.1), ("xi", 0.1)]).into())?;
/// assert_eq!(options.model("at")?.options().unwrap()["force"], "vertical");
/// let mistyped = options.set("force", &"verticle".into()).unwrap_err();
/// assert!(mistyped.to_string().contains("the nearest is \"vertical\""));
/// # Ok::<(), asperity_scene::SceneError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ModelOptions {
    /// The distribution of the contact normals of Gao and AT.
    pub angle_density: AngleDensity,
    /// The tangential displacements of Gao and AT.
    pub displacement: Displacement,
    /// Whether friction limits the tangential forces of Gao and AT.
    pub stick: Stick,
    /// Which force Gao and AT sum.
    pub force: ForceComponent,
    /// The pressure under AF's embedded plastic asperity.
    pub af_flow_pressure: FlowPressure,
    /// H, from 0.1 to 1: the power-law spectrum of the mean gaps and stiffnesses of `persson` and
    /// `persson-fudge`. With a scan, it replaces the scan's spectrum, with a warning.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hurst_exponent: Option<f64>,
    /// The least gap over the standard deviation of the surface heights that carries fluid in the
    /// friction factor of a film; 0.01 by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_cut_off: Option<f64>,
    /// What lies beyond the edges of the scan that `bem` presses; by default as
    /// [`Continuation::of`] says, and repetition of a scan that is declared periodic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<Continuation>,
    /// Whether `bem` ignores the hardness.
    pub elastic: bool,
}

impl ModelOptions {
    /// Sets one option; on error, no option changes.
    ///
    /// # Errors
    /// [`SceneError::Refused`] with a similar name and the values
    /// allowed.
    pub fn set(&mut self, name: &str, value: &Value) -> Result<(), SceneError> {
        let text = format!("{} = {value}\n", Value::from(name));
        *self = self.with_keys(&Document::new(None, Files::Nowhere, &text)?, "")?;
        Ok(())
    }

    /// Checks that an option changes the model of an id.
    ///
    /// # Errors
    /// [`SceneError::Refused`] at the option.
    pub fn check_for(id: &str, option: &str) -> Result<(), SceneError> {
        let has = |model: Model| {
            let has = model.options().is_some_and(|own| own.get(option).is_some());
            // With yielding there are areas alone, whatever the spectrum.
            has && Persson::variance_of(model.equal().id()) != Some(PerssonVariance::Plastic)
        };
        let is_pressed = id == Bem::ID && ["boundary", "elastic"].contains(&option);
        match is_pressed || id.parse().is_ok_and(has) {
            true => Ok(()),
            false => {
                Err(SceneError::refused(Place::field(option), format!("does not change {id}")))
            }
        }
    }

    /// The options that differ from the defaults, by name.
    #[must_use]
    pub fn changed(&self) -> Table {
        let [all, defaults] =
            [*self, Self::default()].map(|options| Table::try_from(options).unwrap_or_default());
        all.into_iter().filter(|(name, value)| defaults.get(name) != Some(value)).collect()
    }

    /// How boundary elements press a scan.
    #[must_use]
    pub fn bem(&self) -> BemOptions {
        BemOptions { boundary: self.boundary, elastic: self.elastic }
    }

    /// These options with those of a section.
    pub(crate) fn with_keys(
        &self,
        document: &Document<'_>,
        section: &str,
    ) -> Result<Self, SceneError> {
        let known = keys_of("options");
        document.check_keys(section, &known)?;
        let so_far = Table::try_from(self).unwrap_or_default();
        let options: Self = document.read_over(section, &known, so_far)?;
        options.check(document, section)?;
        Ok(options)
    }

    /// Checks the ranges of the numbers; `section` is their section in errors.
    fn check(&self, document: &Document<'_>, section: &str) -> Result<(), SceneError> {
        let Self { angle_density, displacement, stick, force, .. } = *self;
        let lateral = LateralOptions { angle_density, displacement, stick, force };
        lateral.check().map_err(|error| {
            let is_displacement =
                matches!(error, ContactError::OutOfRange { field: "zeta" | "xi", .. });
            let option = if is_displacement { "displacement" } else { "angle_density" };
            document.refused(&joined(section, option))(error)
        })?;
        if let Some(hurst) = self.hurst_exponent {
            Spectrum::check_hurst(hurst).map_err(document.refused(section))?;
        }
        if let Some(cut_off) = self.friction_cut_off {
            friction_factor(1.0, cut_off).map_err(document.refused(section))?;
        }
        Ok(())
    }

    /// The model of an id, with these options.
    ///
    /// # Errors
    /// [`SceneError::Refused`] for an unknown id, with a similar id and all ids.
    pub fn model(&self, id: &str) -> Result<Model, SceneError> {
        self.model_beside(|| None, id)
    }

    /// The model of an id, with these options; a theory of the whole surface gets the spectrum of a
    /// scan, or the reason why there is none.
    pub(crate) fn model_beside(
        &self,
        spectrum: impl FnOnce() -> Option<ScanSpectrum>,
        id: &str,
    ) -> Result<Model, SceneError> {
        let known: Model = id
            .parse()
            .map_err(|error| SceneError::from_contact(error, |_| Place::field("model").into()))?;
        if let Some(variance) = Persson::variance_of(known.equal().id()) {
            let hurst_exponent = self.hurst_exponent;
            let model = Persson { variance, hurst_exponent, spectrum: spectrum() };
            return Ok(Model::known(model).on(known.asperities()));
        }
        let own = known.options().unwrap_or_default();
        let all = serde_json::to_value(self).unwrap_or_default();
        let of_model = all.as_object().into_iter().flatten();
        let of_model = of_model.filter(|(name, _)| own.get(name).is_some());
        let of_model = of_model.map(|(name, value)| (name.clone(), value.clone())).collect();
        let made = known.with_options(&of_model);
        made.map_err(|error| SceneError::from_contact(error, |_| Place::field("model").into()))
    }
}
