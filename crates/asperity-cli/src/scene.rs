//! A scene file as the commands use it: models by id, separations as the file counts them.

use std::path::Path;

use anyhow::{Result, bail};
use asperity::{Model, Request, Scene};
use asperity_scene::{SceneFile, SeparationFrom};

use crate::args::SeparationUnit;
use crate::output;
use crate::table::Table;

/// A scene file that has been read.
pub struct LoadedScene {
    file: SceneFile,
    name: String,
}

/// A model, and what the answer calls it.
pub type NamedModel = (String, Model);

/// Separations as the scene counts them, in both units.
pub struct Places {
    pub sigmas: Vec<f64>,
    pub metres: Vec<f64>,
}

impl Places {
    /// Adds the two columns.
    pub fn columns(&self, table: &mut Table) {
        let column = |values: &[f64]| values.iter().copied().map(Some).collect();
        table.numbers("separation_over_sigma", "", column(&self.sigmas));
        table.numbers("separation_m", "m", column(&self.metres));
    }
}

impl LoadedScene {
    /// Reads the file; what deserves a word is said.
    pub fn load(path: &Path) -> Result<Self> {
        let file = asperity_scene::load(path)?;
        for warning in &file.warnings {
            output::say("warning", warning);
        }
        Ok(Self { file, name: path.display().to_string() })
    }

    pub fn scene(&self) -> &Scene {
        &self.file.scene
    }

    /// The models asked for, or all that the scene allows: those it does not are named.
    pub fn models(&self, asked: &[String]) -> Result<Vec<NamedModel>> {
        if !asked.is_empty() {
            return crate::args::once(asked).iter().map(|id| self.model(id)).collect();
        }
        let (models, left_out) = self.file.models();
        for model in &left_out {
            output::say("note", &format!("{} is left out: {}", model.id, model.reason));
        }
        if models.is_empty() {
            bail!("{}: no model can use this scene", self.name);
        }
        Ok(models.into_iter().map(|model| (model.id().to_string(), model)).collect())
    }

    /// A model with the scene's options, under the name it was asked for.
    pub fn model(&self, id: &str) -> Result<NamedModel> {
        let model = self.file.model(id)?;
        let (_, left_out) = self.file.models();
        if let Some(refused) = left_out.iter().find(|refused| refused.id == model.id()) {
            bail!("{}: {}", self.name, refused.reason);
        }
        if model.id() != id {
            output::say("note", &format!("{id} is {} by the scene's options", model.id()));
        }
        Ok((id.to_string(), model))
    }

    /// What separations are measured from, in words.
    pub fn datum(&self) -> &'static str {
        match self.file.separation_from {
            SeparationFrom::SurfaceMean => "the mean plane of the surface",
            _ => "the mean of the asperity heights",
        }
    }

    /// A request for separations as the scene counts them.
    pub fn request(&self, given: &[f64], unit: SeparationUnit) -> Request {
        let places = self.places(given, unit);
        let shifted = places.sigmas.iter().map(|s| self.file.to_asperity_mean(*s));
        let mut request = Request::new([]).at(shifted);
        if unit == SeparationUnit::M || self.file.separation_offset != 0.0 {
            request.separation_rounding = f64::EPSILON;
        }
        request
    }

    /// Separations as given, in both units.
    pub fn places(&self, given: &[f64], unit: SeparationUnit) -> Places {
        let sigma = self.file.scene.surface.asperity_height_std;
        let converted = |factor: &dyn Fn(f64) -> f64| given.iter().map(|s| factor(*s)).collect();
        match unit {
            SeparationUnit::Sigma => {
                Places { metres: converted(&|s| s * sigma), sigmas: given.to_vec() }
            }
            SeparationUnit::M => {
                Places { sigmas: converted(&|s| s / sigma), metres: given.to_vec() }
            }
        }
    }

    /// Separations that the library found, as the scene counts them.
    pub fn found(&self, separations: &[f64]) -> Places {
        let sigmas: Vec<f64> =
            separations.iter().map(|s| self.file.from_asperity_mean(*s)).collect();
        self.places(&sigmas, SeparationUnit::Sigma)
    }

    /// The load in newtons of a pressure on the nominal area.
    pub fn load_at(&self, pressure: f64) -> f64 {
        pressure * self.file.scene.nominal_area
    }
}
