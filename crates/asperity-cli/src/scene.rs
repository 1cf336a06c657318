//! A scene file as the commands use it: its models by id.

use std::path::Path;

use anyhow::{Result, bail};
use asperity::{At, ContactError, ContactModel, Finding, Model, Quantity, Request, Severity};
use asperity_scene::{LeftOut, SceneFile};

use crate::output::{self, once, say};

/// A scene file that has been read.
pub struct LoadedScene {
    pub file: SceneFile,
    pub name: String,
}

/// A model, and what the answer calls it.
pub type NamedModel = (String, Model);

impl LoadedScene {
    /// Reads the file; what deserves a word is said.
    pub fn load(path: &Path) -> Result<Self> {
        Self::load_for(path, &[])
    }

    /// Reads the file for these models: where none of them knows asperities, what is said is not of
    /// them.
    pub fn load_for(path: &Path, ids: &[String]) -> Result<Self> {
        let knows =
            |id: &String| id.parse().map_or(id != "bem", |m: Model| m.validity().asperities);
        let asperities = ids.is_empty() || ids.iter().any(knows);
        let scene = Self::open(path)?;
        scene.tell_files(asperities);
        scene.tell_findings(asperities);
        Ok(scene)
    }

    /// Says what is unusual about the scene; what is so about its asperities only where they matter.
    pub fn tell_findings(&self, asperities: bool) {
        let found = self.file.findings();
        let matters =
            |f: &&Finding| f.severity < Severity::Note && (asperities || !f.is_of_asperities());
        found.iter().filter(matters).for_each(|finding| say("warning", &finding.message));
    }

    /// Says what the files of the scene deserve.
    fn tell_files(&self, asperities: bool) {
        let of_scan = self.file.measured.iter().flat_map(|m| &m.statistics.warnings);
        let left_out: Vec<String> = of_scan
            .filter(|warning| !asperities && warning.is_of_asperities())
            .map(ToString::to_string)
            .collect();
        let told = |word: &&String| !left_out.iter().any(|out| word.ends_with(out));
        self.file.warnings.iter().filter(told).for_each(|warning| say("warning", warning));
    }

    /// Reads the file; only what its files deserve is said.
    pub fn read(path: &Path) -> Result<Self> {
        let scene = Self::open(path)?;
        scene.tell_files(true);
        Ok(scene)
    }

    fn open(path: &Path) -> Result<Self> {
        output::keep(path);
        Ok(Self { file: asperity_scene::load(path)?, name: path.display().to_string() })
    }

    /// Says what is unusual about the answers of models at places.
    pub fn tell(&self, models: &[&NamedModel], places: &[At]) {
        let of = |(id, model): &&NamedModel| {
            let found = self.file.findings_at(model, places).into_iter();
            let serious = found.filter(|finding| finding.severity < Severity::Note);
            serious.map(|finding| (id.clone(), finding)).collect::<Vec<_>>()
        };
        tell(&models.iter().flat_map(of).collect::<Vec<_>>());
    }

    /// Says which models know the scene's adhesion, where it has any.
    pub fn tell_adhesion(&self) {
        let found = self.file.findings().into_iter().find(|found| found.code == "adhesion");
        found.into_iter().for_each(|found| say("note", &found.message));
    }

    /// The model that others are held against: the usual one unless another is asked for.
    pub fn reference(&self, asked: Option<&str>) -> Result<NamedModel> {
        self.model(asked.unwrap_or(asperity::usual_reference(&self.file.scene)))
    }

    /// The models asked for, or all that the scene allows: those it does not are named.
    pub fn models(&self, asked: &[String], quantities: &[Quantity]) -> Result<Vec<NamedModel>> {
        if !asked.is_empty() {
            let models = once(asked).iter().map(|id| self.model(id)).collect::<Result<Vec<_>>>()?;
            if !models.iter().all(|(_, model)| model.validity().adhesive) {
                self.tell_adhesion();
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
        tell_left_out(&left_out);
        if models.is_empty() {
            bail!("{}: no model can use this scene", self.name);
        }
        self.tell_adhesion();
        Ok(models.into_iter().map(|model| (model.id().to_string(), model)).collect())
    }

    /// The models asked for, or all that can stand beside boundary elements: those that cannot are
    /// named.
    pub fn models_beside_bem(
        &self,
        asked: &[String],
        quantities: &[Quantity],
    ) -> Result<Vec<Model>> {
        let models = self.models(asked, quantities)?;
        let mut models: Vec<Model> = models.into_iter().map(|(_, model)| model).collect();
        if asked.is_empty() {
            let (all, mut left_out) = self.file.models_beside_bem();
            let (allowed, told) = self.file.models();
            left_out.retain(|model| !told.contains(model));
            tell_left_out(&left_out);
            let known = |model: &Model| allowed.iter().any(|known| known.id() == model.id());
            models.extend(all.into_iter().filter(|model| !known(model)));
        }
        Ok(models)
    }

    /// A model with the scene's options, under the name it was asked for.
    pub fn model(&self, id: &str) -> Result<NamedModel> {
        let model = self.file.model(id)?;
        let (_, left_out) = self.file.models();
        if let Some(refused) = left_out.iter().find(|refused| refused.id == model.id()) {
            bail!("{}: {}", self.name, refused.reason);
        }
        if model.id() != id {
            say("note", &format!("{id} is {} by the scene's options", model.id()));
        }
        Ok((id.to_string(), model))
    }
}

/// Says what is unusual about the answers of models: one cause once, of the worst of them.
pub fn tell(findings: &[(String, Finding)]) {
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

/// Says what models lack, those of one reason together.
fn tell_left_out(left_out: &[LeftOut]) {
    let reason = |model: &LeftOut| (model.id.clone(), model.reason.clone());
    for told in told_together(&left_out.iter().map(reason).collect::<Vec<_>>()) {
        say("note", &format!("left out: {told}"));
    }
}

/// Models and what they lack, in words: those of one reason together.
pub fn told_together(lacking: &[(String, ContactError)]) -> Vec<String> {
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
