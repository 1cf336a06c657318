//! A scene file with its models by id; prints its warnings.

use std::path::Path;

use anyhow::{Context, Result};
use asperity::{At, Finding, Findings, Quantity, Severity, Tolerance};
pub use asperity_answer::{ALL_MODELS, NamedModel};
use asperity_answer::{AnswerError, Sheet, Subject, one_or_usual, scene_findings, use_asperities};
use asperity_inputs::SceneFile;

use crate::output::{self, report};

/// A scene file and its name.
pub struct LoadedScene {
    pub file: SceneFile,
    pub name: String,
}

impl LoadedScene {
    /// Reads the file, and reports what is unusual.
    pub fn load(path: &Path) -> Result<Self> {
        Self::load_for(path, &[])
    }

    /// Reads the file for these models, and reports on its asperities only if one of them uses
    /// asperities; otherwise a scan needs none.
    pub fn load_for(path: &Path, ids: &[String]) -> Result<Self> {
        if !use_asperities(ids) {
            return Self::load_scan(path, false);
        }
        let scene = Self::open(path)?;
        scene.report_for(true);
        Ok(scene)
    }

    /// Reads the file for models without asperities, on a scan that is declared periodic or as the
    /// file says.
    pub fn load_scan(path: &Path, periodic: bool) -> Result<Self> {
        let scene = Self::open_scan(path, periodic)?;
        // The asperities of a scan follow from it and are not used.
        let used = |found: &Finding| !found.field.starts_with("asperity_");
        let file = &scene.file;
        let found = file.warnings.iter().cloned().chain(file.findings()).filter(used);
        let found = found.collect::<Findings>().for_asperities(false);
        report(&found.at_least(Severity::Warning));
        Ok(scene)
    }

    /// Reads the file for models with and without asperities: a scan may have none.
    pub fn load_any(path: &Path, periodic: bool) -> Result<Self> {
        let scene = Self::open_scan(path, periodic)?;
        scene.report_for(true);
        Ok(scene)
    }

    fn open_scan(path: &Path, periodic: bool) -> Result<Self> {
        output::keep(path);
        let file = asperity_inputs::load_scan(path, periodic)?;
        Ok(Self { file, name: path.display().to_string() })
    }

    fn report_for(&self, asperities: bool) {
        report(&scene_findings(&self.file, asperities));
    }

    /// Reads the file; only its files are reported on.
    pub fn read(path: &Path) -> Result<Self> {
        let scene = Self::open(path)?;
        report(&scene.file.warnings);
        Ok(scene)
    }

    /// A model on this scene, with a tolerance of its values.
    pub fn subject<'a>(&'a self, (id, model): &'a NamedModel, tolerance: Tolerance) -> Subject<'a> {
        Subject { file: &self.file, name: &self.name, id, model, tolerance }
    }

    /// Reports the findings about the scene.
    pub fn report_scene(&self) {
        report(&self.file.findings().at_least(Severity::Warning));
    }

    /// Reads the file, and reports nothing.
    pub fn open(path: &Path) -> Result<Self> {
        output::keep(path);
        Ok(Self { file: asperity_inputs::load(path)?, name: path.display().to_string() })
    }

    /// Reports what is unusual about the answers of models at places.
    pub fn report_answers(&self, models: &[&NamedModel], places: &[At]) {
        let found = models.iter().flat_map(|(_, model)| self.file.findings_at(model, places));
        self.report(found.collect());
    }

    /// Reports warnings and errors that the scene does not accept, one for each cause.
    pub fn report(&self, found: Findings) {
        report(&self.file.accepted(found).at_least(Severity::Warning));
    }

    /// Notes which models include the scene's adhesion, where it has any.
    pub fn note_adhesion(&self) {
        let mut sheet = Sheet::default();
        asperity_answer::note_adhesion(&self.file, &mut sheet);
        output::show(&sheet.findings);
    }

    /// A sheet, as this function fills it; its findings are shown, also where it fails.
    pub fn answer<T>(&self, fill: impl FnOnce(&mut Sheet) -> Result<T>) -> Result<(Sheet, T)> {
        let mut sheet = Sheet::default();
        let filled = fill(&mut sheet);
        let accepted = |code: &str| self.file.accept.iter().any(|accepted| accepted == code);
        sheet.findings.retain(|one| one.severity == Severity::Error || !accepted(one.code));
        output::show(&sheet.findings);
        match filled.map_err(anyhow::Error::downcast::<AnswerError>) {
            Ok(filled) => Ok((sheet, filled)),
            // These have the name of the file.
            Err(Ok(AnswerError::Scene(error))) => Err(error.into()),
            Err(Ok(error)) => Err(error).with_context(|| self.name.clone()),
            Err(Err(error)) => Err(error),
        }
    }

    fn model_of(&self, find: impl FnOnce(&mut Sheet) -> Result<NamedModel>) -> Result<NamedModel> {
        Ok(self.answer(find)?.1)
    }

    /// The reference model: the usual one unless another is given.
    pub fn reference(&self, requested: Option<&str>) -> Result<NamedModel> {
        self.model_of(|sheet| Ok(asperity_answer::reference(&self.file, requested, sheet)?))
    }

    /// The models given, of which some may be refused where they are compiled, or all that the
    /// scene allows; a note names the others.
    pub fn models(&self, requested: &[String], quantities: &[Quantity]) -> Result<Vec<NamedModel>> {
        let find =
            |sheet: &mut _| Ok(asperity_answer::models(&self.file, requested, quantities, sheet)?);
        Ok(self.answer(find)?.1)
    }

    /// The usual model where none is asked for; a note tells of a hardness that may be forgotten.
    pub fn default_model(&self) -> Result<NamedModel> {
        self.model_of(|sheet| Ok(one_or_usual(&self.file, &self.name, None, sheet)?))
    }

    /// A model with the scene's options, under the given name; an error if the scene has not what
    /// it needs.
    pub fn model(&self, id: &str) -> Result<NamedModel> {
        self.model_of(|sheet| Ok(asperity_answer::one_model(&self.file, id, sheet)?))
    }
}
