//! A scene file with its models by id; prints its warnings.

use std::path::Path;

use anyhow::{Result, bail};
use asperity::{At, ContactError, ContactModel, Finding, Model, Quantity, Request, Severity};
use asperity_scene::{LeftOut, SceneFile};

use crate::output::{self, once, say};

/// A scene file and its name.
pub struct LoadedScene {
    pub file: SceneFile,
    pub name: String,
}

/// A model, and its name in the result.
pub type NamedModel = (String, Model);

impl LoadedScene {
    /// Reads the file and prints its warnings.
    pub fn load(path: &Path) -> Result<Self> {
        Self::load_for(path, &[])
    }

    /// Reads the file for these models; warnings about asperities are left out where no model has
    /// asperities.
    pub fn load_for(path: &Path, ids: &[String]) -> Result<Self> {
        let knows =
            |id: &String| id.parse().map_or(id != "bem", |m: Model| m.validity().asperities);
        let asperities = ids.is_empty() || ids.iter().any(knows);
        let scene = Self::open(path)?;
        scene.print_file_warnings(asperities);
        scene.print_findings(asperities);
        Ok(scene)
    }

    /// Prints the findings of the scene; those about asperities only on request.
    pub fn print_findings(&self, asperities: bool) {
        let found = self.file.findings();
        let matters =
            |f: &&Finding| f.severity < Severity::Note && (asperities || !f.is_of_asperities());
        found.iter().filter(matters).for_each(|finding| say("warning", &finding.message));
    }

    /// Prints the warnings about the files of the scene.
    fn print_file_warnings(&self, asperities: bool) {
        let of_scan = self.file.measured.iter().flat_map(|m| &m.statistics.warnings);
        let left_out: Vec<String> = of_scan
            .filter(|warning| !asperities && warning.is_of_asperities())
            .map(ToString::to_string)
            .collect();
        let kept = |text: &&String| !left_out.iter().any(|out| text.ends_with(out));
        self.file.warnings.iter().filter(kept).for_each(|warning| say("warning", warning));
    }

    /// Reads the file and prints the warnings about its files alone.
    pub fn read(path: &Path) -> Result<Self> {
        let scene = Self::open(path)?;
        scene.print_file_warnings(true);
        Ok(scene)
    }

    fn open(path: &Path) -> Result<Self> {
        output::keep(path);
        Ok(Self { file: asperity_scene::load(path)?, name: path.display().to_string() })
    }

    /// Prints the findings on the results of models at loads or separations.
    pub fn print_findings_at(&self, models: &[&NamedModel], places: &[At]) {
        let of = |(id, model): &&NamedModel| {
            let found = self.file.findings_at(model, places).into_iter();
            let serious = found.filter(|finding| finding.severity < Severity::Note);
            serious.map(|finding| (id.clone(), finding)).collect::<Vec<_>>()
        };
        print_by_cause(&models.iter().flat_map(of).collect::<Vec<_>>());
    }

    /// Notes which models have adhesion, where the scene has any.
    pub fn note_adhesion(&self) {
        let found = self.file.findings().into_iter().find(|found| found.code == "adhesion");
        found.into_iter().for_each(|found| say("note", &found.message));
    }

    /// The reference model: the usual one unless another is given.
    pub fn reference(&self, asked: Option<&str>) -> Result<NamedModel> {
        self.model(asked.unwrap_or(asperity::usual_reference(&self.file.scene)))
    }

    /// The models given, or all that the scene allows; a note names the others.
    pub fn models(&self, asked: &[String], quantities: &[Quantity]) -> Result<Vec<NamedModel>> {
        if !asked.is_empty() {
            let models = once(asked).iter().map(|id| self.model(id)).collect::<Result<Vec<_>>>()?;
            if !models.iter().all(|(_, model)| model.validity().adhesive) {
                self.note_adhesion();
            }
            return Ok(models);
        }
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
        if models.is_empty() {
            bail!("{}: no model is available for this scene", self.name);
        }
        self.note_adhesion();
        Ok(models.into_iter().map(|model| (model.id().to_string(), model)).collect())
    }

    /// The models given, or all that can be compared with boundary elements; a note names the
    /// others.
    pub fn models_beside_bem(
        &self,
        asked: &[String],
        quantities: &[Quantity],
    ) -> Result<Vec<Model>> {
        let models = self.models(asked, quantities)?;
        let mut models: Vec<Model> = models.into_iter().map(|(_, model)| model).collect();
        if asked.is_empty() {
            let (all, mut left_out) = self.file.models_beside_bem();
            let (allowed, noted) = self.file.models();
            left_out.retain(|model| !noted.contains(model));
            note_left_out(&left_out);
            let known = |model: &Model| allowed.iter().any(|known| known.id() == model.id());
            models.extend(all.into_iter().filter(|model| !known(model)));
        }
        Ok(models)
    }

    /// A model with the scene's options, under the given name.
    pub fn model(&self, id: &str) -> Result<NamedModel> {
        let model = self.file.model(id)?;
        let (_, left_out) = self.file.models();
        if let Some(refused) = left_out.iter().find(|refused| refused.id == model.id()) {
            bail!("{}: {}", self.name, refused.reason);
        }
        if model.id() != id {
            say("note", &format!("{id} means {} by the options of the scene", model.id()));
        }
        Ok((id.to_string(), model))
    }
}

/// Prints the findings on the results of models: each cause once, with its worst value.
pub fn print_by_cause(findings: &[(String, Finding)]) {
    for code in once(&findings.iter().map(|(_, found)| found.code).collect::<Vec<_>>()) {
        let mut same: Vec<_> = findings.iter().filter(|(_, f)| f.code == code).collect();
        same.sort_by(|(_, a), (_, b)| b.excess().total_cmp(&a.excess()));
        let Some(((first, worst), others)) = same.split_first() else { continue };
        let others: Vec<&str> = others.iter().map(|(id, _)| id.as_str()).collect();
        let others: Vec<&str> = once(&others).into_iter().filter(|id| id != first).collect();
        let likewise = match &others[..] {
            [] => String::new(),
            ids => format!(" (likewise {})", ids.join(", ")),
        };
        say("warning", &format!("{worst}{likewise}"));
    }
}

/// Notes the models that are left out, those of one reason together.
fn note_left_out(left_out: &[LeftOut]) {
    let reason = |model: &LeftOut| (model.id.clone(), model.reason.clone());
    for text in by_reason(&left_out.iter().map(reason).collect::<Vec<_>>()) {
        say("note", &format!("left out: {text}"));
    }
}

/// Models and what they lack, one message for each reason.
pub fn by_reason(lacking: &[(String, ContactError)]) -> Vec<String> {
    let mut reasons: Vec<(String, Vec<&str>)> = vec![];
    for (id, reason) in lacking {
        // Of models that lack the same, each has its name in it.
        let reason = match reason {
            ContactError::Unsupported { what, .. } => format!(" cannot give {what}"),
            reason => format!(": {reason}"),
        };
        match reasons.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, ids)) if ids.contains(&id.as_str()) => {}
            Some((_, ids)) => ids.push(id),
            None => reasons.push((reason, vec![id])),
        }
    }
    reasons.into_iter().map(|(reason, ids)| format!("{}{reason}", ids.join(", "))).collect()
}
