//! A scene file with its models by id; prints its warnings.

use std::path::Path;

use anyhow::{Result, bail};
use asperity::bem::Bem;
use asperity::recommended::YIELDING;
use asperity::{
    At, ContactError, ContactModel, Finding, Findings, Model, Quantity, Request, Severity,
    Tolerance,
};
use asperity_answer::{Subject, by_reason};
use asperity_inputs::{LeftOut, SceneFile};

use crate::output::{self, once, print_message, report};

/// A scene file and its name.
pub struct LoadedScene {
    pub file: SceneFile,
    pub name: String,
}

/// A model, and its name in the result.
pub type NamedModel = (String, Model);

impl LoadedScene {
    /// Reads the file, and reports what is unusual.
    pub fn load(path: &Path) -> Result<Self> {
        Self::load_for(path, &[])
    }

    /// Reads the file for these models, and reports on its asperities only if one of them uses
    /// asperities; otherwise a scan needs none.
    pub fn load_for(path: &Path, ids: &[String]) -> Result<Self> {
        let knows =
            |id: &String| id.parse().map_or(id != Bem::ID, |m: Model| m.validity().asperities);
        if !ids.is_empty() && !ids.iter().any(knows) {
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
        let found = self.file.warnings.iter().cloned().chain(self.file.findings());
        let found = found.collect::<Findings>().for_asperities(asperities);
        report(&found.at_least(Severity::Warning));
    }

    /// Reads the file; only its files are reported on.
    pub fn read(path: &Path) -> Result<Self> {
        let scene = Self::open(path)?;
        report(&scene.file.warnings);
        Ok(scene)
    }

    /// A model on this scene.
    pub fn subject<'a>(&'a self, (id, model): &'a NamedModel) -> Subject<'a> {
        let tolerance = Tolerance::default();
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
        report(
            &self.file.findings().into_iter().filter(|found| found.code == "adhesion").collect(),
        );
    }

    /// The reference model: the usual one unless another is given.
    pub fn reference(&self, requested: Option<&str>) -> Result<NamedModel> {
        self.model(requested.unwrap_or(asperity::usual_reference(&self.file.scene)))
    }

    /// The models given, of which some may be refused where they are compiled, or all that the
    /// scene allows; a note names the others.
    pub fn models(&self, requested: &[String], quantities: &[Quantity]) -> Result<Vec<NamedModel>> {
        let requested = by_name(requested);
        if !requested.is_empty() {
            let models =
                once(requested).iter().map(|id| self.named(id)).collect::<Result<Vec<_>>>()?;
            if !models.iter().all(|(_, model)| model.validity().adhesive) {
                self.note_adhesion();
            }
            return Ok(models);
        }
        let models = self.available(quantities);
        if models.is_empty() {
            bail!("{}: no model is available for this scene", self.name);
        }
        Ok(models.into_iter().map(|model| (model.id().to_string(), model)).collect())
    }

    /// All models that the scene allows and that have these quantities; a note names the others.
    fn available(&self, quantities: &[Quantity]) -> Vec<Model> {
        let (models, mut left_out) = self.file.models();
        let (models, refused): (Vec<_>, Vec<_>) = models
            .into_iter()
            .map(|model| {
                let request = Request::new(quantities.iter().copied());
                let refusal = model.compile(&self.file.scene, &request).err();
                // Anything else is an error of the scene.
                let refusal = refusal.filter(|e| matches!(e, ContactError::Unsupported { .. }));
                (model, refusal)
            })
            .partition(|(_, refusal)| refusal.is_none());
        let models: Vec<Model> = models.into_iter().map(|(model, _)| model).collect();
        left_out.extend(refused.into_iter().filter_map(|(model, refusal)| {
            Some(LeftOut { id: model.id().into(), reason: refusal? })
        }));
        note_left_out(&left_out);
        self.note_adhesion();
        models
    }

    /// The models given, or all that can be compared with boundary elements; a note names the
    /// others.
    pub fn models_beside_bem(
        &self,
        requested: &[String],
        quantities: &[Quantity],
    ) -> Result<Vec<Model>> {
        let requested = by_name(requested);
        if !requested.is_empty() {
            let models = self.models(requested, quantities)?;
            return Ok(models.into_iter().map(|(_, model)| model).collect());
        }
        let mut models = self.available(quantities);
        let (all, mut left_out) = self.file.models_beside_bem();
        let (allowed, noted) = self.file.models();
        left_out.retain(|model| !noted.contains(model));
        note_left_out(&left_out);
        let known = |model: &Model| allowed.iter().any(|known| known.id() == model.id());
        models.extend(all.into_iter().filter(|model| !known(model)));
        Ok(models)
    }

    /// The usual model where none is asked for; a note tells of a hardness that may be forgotten.
    pub fn default_model(&self) -> Result<NamedModel> {
        let named = self.reference(None)?;
        if self.file.scene.asperity().is_ok_and(|asperity| asperity.hardness.is_none()) {
            let text = format!(
                "{}: the default model is {}, which ignores yielding, as hardness is missing; {YIELDING} need it",
                self.name, named.0
            );
            print_message("note", &text);
        }
        Ok(named)
    }

    /// A model with the scene's options, under the given name; an error if the scene has not what
    /// it needs.
    pub fn model(&self, id: &str) -> Result<NamedModel> {
        let named = self.named(id)?;
        // Other models report what they lack with their answers.
        let averaged = named.1.asperity_model().is_some();
        if let Some(reason) = averaged.then(|| self.file.refusal(&named.1)).flatten() {
            bail!("{}: {reason}", self.name);
        }
        Ok(named)
    }

    fn named(&self, id: &str) -> Result<NamedModel> {
        let model = self.file.model(id)?;
        if model.id() != id {
            print_message(
                "note",
                &format!("{id} means {} by the options of the scene", model.id()),
            );
        }
        Ok((id.to_string(), model))
    }
}

/// The name in a list of models that stands for all that the scene allows.
pub const ALL_MODELS: &str = "all";

/// The models requested by name; none if all are requested.
fn by_name(requested: &[String]) -> &[String] {
    if requested.iter().any(|id| id == ALL_MODELS) { &[] } else { requested }
}

/// Notes the models that are left out, those of one reason together.
fn note_left_out(left_out: &[LeftOut]) {
    let reason = |model: &LeftOut| (model.id.clone(), model.reason.clone());
    for text in by_reason(&left_out.iter().map(reason).collect::<Vec<_>>()) {
        print_message("note", &format!("left out: {text}"));
    }
}
