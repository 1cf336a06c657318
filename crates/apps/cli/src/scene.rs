//! A scene file with its models by id; prints its warnings.

use std::path::Path;

use anyhow::{Context, Error, Result};
use asperity::bem::{Bem, BemOptions, Continuation};
use asperity::{At, Findings, Model, Severity, Tolerance};
use asperity_answer::{
    AnswerError, Sheet, Subject, one_model, one_or_usual, scene_findings, solve, use_asperities,
};
use asperity_scene::SceneFile;

use crate::input::args::EndArgs;
use crate::input::destinations;
use crate::interrupt::Terminal;
use crate::output::{self, print_results, show};

/// A scene file and its name.
pub struct LoadedScene {
    pub file: SceneFile,
    pub name: String,
}

impl LoadedScene {
    /// Reads the file, and reports nothing.
    pub fn open(path: &Path) -> Result<Self> {
        Self { file: asperity_scene::load(path)?, name: path.display().to_string() }.kept()
    }

    /// Reads the file for these models, and reports what is unusual; on its asperities only if one
    /// of the models uses asperities; otherwise a scan needs none.
    pub fn load(path: &Path, ids: &[String]) -> Result<Self> {
        if !use_asperities(ids) {
            return Self::load_scan(path, BemOptions::default());
        }
        let scene = Self::open(path)?;
        scene.report_scene(true);
        Ok(scene)
    }

    /// Reads the file of a scan, which may have no asperities and, with a periodic boundary, is
    /// declared periodic whatever the file says; reports what is unusual, but for its asperities.
    pub fn load_scan(path: &Path, given: BemOptions) -> Result<Self> {
        let is_periodic = given.boundary == Some(Continuation::Periodic);
        let file = asperity_scene::load_scan(path, is_periodic)?.pressing(given);
        let scene = Self { file, name: path.display().to_string() }.kept()?;
        scene.report_scene(false);
        Ok(scene)
    }

    /// The scene at one end of its ranges, which a note names.
    pub fn taken_at(self, end: &EndArgs) -> Result<Self> {
        let (file, note) = self.file.taken_at(&end.at)?;
        show(&file.accepted(note.into_iter().collect()));
        Ok(Self { file, ..self })
    }

    /// Solves the scan at these loads, as an input of answers.
    pub fn solve(&mut self, at: &[At]) -> Result<()> {
        self.file.solved = self.answer(|_, watch| solve(&self.file, at, watch))?.1;
        Ok(())
    }

    /// The boundary elements of the scene's scan.
    pub fn bem(&self) -> Result<Bem> {
        self.file.need_flat()?;
        self.file.bem().map_err(|error| Error::msg(format!("{}: {error}", self.name)))
    }

    /// The scene, whose files no output may overwrite, and which accepts what the command accepts.
    fn kept(mut self) -> Result<Self> {
        self.file = self.file.accepting(output::accepted());
        self.file.files().iter().try_for_each(|file| destinations::protect(file))?;
        Ok(self)
    }

    /// Reports the findings about the scene.
    pub fn report_scene(&self, asperities: bool) {
        show(&self.file.accepted(scene_findings(&self.file, asperities)));
    }

    /// A model on this scene, with a tolerance of its values.
    pub fn subject<'a>(&'a self, model: &'a Model, tolerance: Tolerance) -> Subject<'a> {
        Subject { file: &self.file, name: &self.name, model, tolerance }
    }

    /// Reports warnings that the scene does not accept, one for each cause.
    pub fn report(&self, found: Findings) {
        show(&self.file.accepted(found).at_least(Severity::Warning));
    }

    /// A sheet, as this function fills it before the terminal; its findings are shown, also
    /// where it fails.
    pub fn answer<T, E: Into<Error>>(
        &self,
        fill: impl FnOnce(&mut Sheet, &Terminal) -> Result<T, E>,
    ) -> Result<(Sheet, T)> {
        let (mut sheet, terminal) = (Sheet::default(), Terminal::default());
        let filled = fill(&mut sheet, &terminal);
        drop(terminal);
        sheet.findings.retain(|one| !one.is_accepted(&self.file.spec.accept));
        show(&sheet.findings);
        print_results(&sheet.results);
        match filled.map_err(|error| error.into().downcast::<AnswerError>()) {
            Ok(filled) => Ok((sheet, filled)),
            // These have the name of the file.
            Err(Ok(AnswerError::Scene(error))) => Err(error.into()),
            Err(Ok(error)) => Err(error).with_context(|| self.name.clone()),
            Err(Err(error)) => Err(error),
        }
    }

    /// The model of this id, or the usual one, with the scene's options; an error if the scene has
    /// not what it needs.
    pub fn model(&self, requested: Option<&str>) -> Result<Model> {
        self.answer(|_, _| one_model(&self.file, requested)).map(|(_, model)| model)
    }

    /// The same with a note where the usual one may ignore a hardness that was forgotten.
    pub fn one_or_usual(&self, id: Option<&str>) -> Result<Model> {
        Ok(self.answer(|sheet, _| one_or_usual(&self.file, &self.name, id, sheet))?.1)
    }
}
