//! Fitted models as notes, warnings and a table.

use anyhow::Result;
use asperity::fit::{Data, Fitted, Ranking};
use asperity_answer::{Cell, Sheet};
use asperity_inputs::Free;

use crate::output;
use crate::scene::{LoadedScene, NamedModel};

/// Notes on bounds that are not given, and remarks on each model; the misfit of the first one is
/// left to the error where no model describes the data.
pub fn print_notes(scene: &LoadedScene, ranking: &Ranking, free: &[Free]) {
    let all = &ranking.models;
    let usual = all.first().map(|one| scene.file.notes_on_bounds(free, one));
    usual.iter().flatten().for_each(|note| output::note("bounds", note));
    let hopeless = all.iter().all(|one| one.misfit().is_some());
    let found = all.iter().flat_map(Fitted::findings);
    output::show(&found.filter(|one| !hopeless || one.code != "misfit").collect::<Vec<_>>());
    let is_ranked = all.iter().any(|one| one.bic.is_some());
    if !hopeless && (is_ranked || all.len() > 1) {
        output::note("ranking", &ranking.summary);
    }
}

/// Reports what is unusual about the answers of models that describe the data.
pub fn print_findings(
    scene: &LoadedScene,
    data: &Data,
    models: &[NamedModel],
    ranking: &Ranking,
) -> Result<()> {
    let mut found = vec![];
    for fitted in ranking.models.iter().filter(|one| one.describes_data()) {
        if let Some((_, model)) = models.iter().find(|(id, _)| *id == fitted.model) {
            found.extend(scene.file.findings_of_fit(model, fitted, data)?);
        }
    }
    scene.report(found.into_iter().collect());
    Ok(())
}

/// One row for each model and parameter.
pub fn table(ranking: &Ranking) -> Sheet {
    let mut table =
        Sheet::new(&["model", "parameter", "value", "lower", "upper", "unit", "rms", "bic"]);
    for one in &ranking.models {
        for found in &one.parameters {
            let [value, lower, upper] =
                [Some(found.value), found.lower, found.upper].map(Cell::from);
            let others =
                [value, lower, upper, (&*found.unit).into(), one.rms.into(), one.bic.into()];
            table.add(&[&one.model, &found.name], others);
        }
    }
    table
}
