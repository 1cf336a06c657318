//! The largest tension of surfaces with adhesion: `curve --pull-off`.

use std::path::Path;

use anyhow::{Result, bail};
use asperity_answer::ALL_MODELS;

use crate::input::args::{ModelArgs, OutputArgs};
use crate::input::refuse;
use crate::output::once;
use crate::scene::LoadedScene;

/// Writes the largest tension.
pub fn pull_off(asked: &ModelArgs, path: &Path, output: &OutputArgs) -> Result<()> {
    let scene = LoadedScene::load(path, &[])?;
    if scene.file.scene.interface.work_of_adhesion.is_none() {
        let how = "set it in the scene, for example work_of_adhesion = \"50 mJ/m2\"";
        bail!("{}: work_of_adhesion is missing: {how}", scene.name);
    }
    let parting = |id: &String| if id == "jkr" { "jkr-separation".into() } else { id.clone() };
    let all = asked.models.is_empty() || asked.models.iter().any(|id| id == ALL_MODELS);
    let ids: Vec<String> = match all {
        true => ["dmt", "jkr-separation"].map(String::from).into(),
        false => asked.models.iter().map(parting).collect(),
    };
    let mut models = vec![];
    for id in once(&ids) {
        let model = scene.model(Some(&id))?;
        let text = format!("{id} has no adhesion; use dmt, jkr or jkr-separation");
        refuse([(!model.validity().adhesive, text)]);
        models.push(model);
    }
    let (sheet, ()) = scene.answer(|sheet, _| {
        asperity_answer::pull_off(&scene.file, &models, asked.tolerance, sheet)
    })?;
    output.write(&sheet)
}
