//! Options of the models for scene files, keywords and command lines.

use asperity::bem::{BemOptions, Continuation};
use asperity::film::friction_factor;
use asperity::recommended::{BEM, FLOW};
use asperity::{
    AbdoFarhang, AminiTehrani, AngleDensity, Asperities, AtReading, ContactError, Described,
    Displacement, FlowPressure, ForceComponent, Gao, GeometricHardness, JacksonGreen,
    LateralOptions, Model, Persson, Spectrum, Stick,
};
use serde::{Deserialize, Serialize};
use toml::{Table, Value};

use crate::document::{Document, Files};
use crate::keys::{joined, keys_of};
use crate::scan::ScanSpectrum;
use crate::{Place, SceneError};

/// Variants of the models; the defaults are the models' own.
///
/// As a scene file's `[options]`, as keywords and in serde formats, it is a map from the names of
/// these fields to values, each optional: a name, a number, or named numbers.
///
/// ```
/// use std::collections::BTreeMap;
///
/// use asperity_inputs::ModelOptions;
///
/// let mut options = ModelOptions::default();
/// options.set("at_reading", &"additive".into())?;
/// options.set("displacement", &BTreeMap::from([("zeta", 0.1), ("xi", 0.1)]).into())?;
/// assert_eq!(options.model("at")?.name(), "AT additive");
/// let mistyped = options.set("at_reading", &"aditive".into()).unwrap_err();
/// assert!(mistyped.to_string().contains("the nearest is \"additive\""));
/// # Ok::<(), asperity_inputs::SceneError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ModelOptions {
    /// The reading of the id `at` (`at-additive` and `at-overlap` are fixed).
    pub at_reading: AtReading,
    /// The distribution of the contact normals of Gao and AT.
    #[serde(with = "AngleChoice")]
    pub angle_density: AngleDensity,
    /// The tangential displacements of Gao and AT.
    pub displacement: Displacement,
    /// Whether friction limits the tangential forces of Gao and AT.
    pub stick: Stick,
    /// Which force Gao and AT sum.
    pub force: ForceComponent,
    /// The hardness of the id `jg` (`jg-cosine` is fixed).
    pub jg_hardness: GeometricHardness,
    /// The pressure under AF's embedded plastic asperity.
    pub af_flow_pressure: FlowPressure,
    /// H, from 0.1 to 1: the power-law spectrum of the mean gaps and stiffnesses of `persson` and
    /// `persson-fudge`. With a scan, it replaces the scan's spectrum, with a warning.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hurst_exponent: Option<f64>,
    /// The least gap over the standard deviation of the surface heights that `patir-cheng` takes
    /// for fluid in its friction factor; 0.01 by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_cut_off: Option<f64>,
    /// What lies beyond the edges of the scan that `bem` presses; by default as
    /// [`Continuation::of`] says, and repetition of a scan that is declared periodic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<Continuation>,
    /// Whether `bem` ignores the hardness.
    pub elastic: bool,
    /// The asperities for which ids stand (those of `ke-random` and `ke-pairs` are fixed); a scene
    /// file may also have this key in `[surface]`.
    pub asperities: Asperities,
}

/// Options of some models, with their ids on equal asperities; `asperities` is one of all models of
/// asperities.
const OF_MODELS: [(&str, &[&str]); 11] = [
    ("at_reading", &["at"]),
    ("angle_density", LATERAL),
    ("displacement", LATERAL),
    ("stick", LATERAL),
    ("force", LATERAL),
    ("jg_hardness", &["jg"]),
    ("af_flow_pressure", &["af"]),
    ("hurst_exponent", &["persson", "persson-fudge"]),
    ("friction_cut_off", &[FLOW]),
    ("boundary", &[BEM]),
    ("elastic", &[BEM]),
];
const LATERAL: &[&str] = &["gao", "at", "at-additive", "at-overlap"];

/// The spelling of `angle_density`.
#[derive(Serialize, Deserialize)]
#[serde(
    remote = "AngleDensity",
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"upright\" or { a20 = -0.5, a21 = 1.0, b21 = 1.0 }"
)]
enum AngleChoice {
    Upright,
    #[serde(untagged)]
    Harmonic {
        a20: f64,
        a21: f64,
        b21: f64,
    },
}

impl ModelOptions {
    /// Sets one option; on error, no option changes.
    ///
    /// # Errors
    /// [`SceneError::UnknownKey`] and [`SceneError::Value`], with a similar name and the values
    /// allowed.
    pub fn set(&mut self, name: &str, value: &Value) -> Result<(), SceneError> {
        let text = format!("{} = {value}\n", Value::from(name));
        *self = self.with_keys(&Document::new(None, Files::Nowhere, &text)?, "")?;
        Ok(())
    }

    /// Checks that an option changes the model of an id, which may fix its asperities or reading.
    ///
    /// # Errors
    /// [`SceneError::Refused`] with the ids that the option is for.
    pub fn check_for(id: &str, option: &str) -> Result<(), SceneError> {
        let known: Option<Model> = id.parse().ok();
        let of_asperities =
            |model: &Model| model.asperities() == Asperities::Equal && model.validity().asperities;
        let (is_for, which) = match OF_MODELS.iter().find(|(name, _)| *name == option) {
            Some((_, ids)) => {
                let id = known.as_ref().map_or(id, |model| model.equal().id());
                (ids.contains(&id), ids.join(", "))
            }
            None => {
                let which = "models of asperities whose ids do not end in -random or -pairs";
                (known.as_ref().is_some_and(of_asperities), which.into())
            }
        };
        let at = || Place::field(option).into();
        let refused = || SceneError::Refused {
            at: at(),
            reason: format!("does not change `{id}`; it is an option of {which}"),
        };
        is_for.then_some(()).ok_or_else(refused)
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

    fn lateral(&self) -> LateralOptions {
        let Self { angle_density, displacement, stick, force, .. } = *self;
        LateralOptions { angle_density, displacement, stick, force }
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
        let at = |option: &str| joined(section, option);
        self.angle_density.check().map_err(document.refused(&at("angle_density")))?;
        if let Some(hurst) = self.hurst_exponent {
            Spectrum::check_hurst(hurst).map_err(document.refused(section))?;
        }
        if let Some(cut_off) = self.friction_cut_off {
            friction_factor(1.0, cut_off).map_err(document.refused(section))?;
        }
        if let Displacement::Given { zeta, xi } = self.displacement {
            for (field, value) in [("zeta", zeta), ("xi", xi)] {
                if !(value >= 0.0 && value.is_finite()) {
                    let required = "a finite number, at least 0,";
                    let error = ContactError::OutOfRange { field, value, required };
                    return Err(document.refused(&at("displacement"))(error));
                }
            }
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
        let at = |reading| Model::known(AminiTehrani { reading, options: self.lateral() });
        let jg = |hardness| Model::known(JacksonGreen { hardness });
        let known: Model = id
            .parse()
            .map_err(|error| SceneError::from_contact(error, |_| Place::field("model").into()))?;
        let model = match known.equal().id() {
            "jg" => jg(self.jg_hardness),
            "jg-cosine" => jg(GeometricHardness::Cosine),
            "af" => Model::known(AbdoFarhang { flow_pressure: self.af_flow_pressure }),
            "gao" => Model::known(Gao { options: self.lateral() }),
            "at" => at(self.at_reading),
            "at-additive" => at(AtReading::Additive),
            "at-overlap" => at(AtReading::Overlap),
            id => match Persson::variance_of(id) {
                Some(variance) => {
                    let hurst_exponent = self.hurst_exponent;
                    Model::known(Persson { variance, hurst_exponent, spectrum: spectrum() })
                }
                None => known.equal().clone(),
            },
        };
        Ok(match known.asperities() {
            Asperities::Equal => self.on_surface(model),
            others => model.on(others),
        })
    }

    /// The model on the asperities of these options; theories of the whole surface have none.
    #[must_use]
    pub fn on_surface(&self, model: Model) -> Model {
        if model.validity().asperities { model.on(self.asperities) } else { model }
    }

    /// The models `known` with these options, each once: if `jg_hardness` or `at_reading` give `jg`
    /// or `at` the meaning of another id, that id replaces it.
    #[must_use]
    pub fn models(&self, known: Vec<Model>) -> Vec<Model> {
        let mut models: Vec<Model> = vec![];
        for known in known {
            let model = self.model(known.id()).unwrap_or(known);
            if !models.iter().any(|m| m.id() == model.id()) {
                models.push(model);
            }
        }
        models
    }
}
