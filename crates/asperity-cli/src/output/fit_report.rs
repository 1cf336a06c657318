//! Fitted models as notes, warnings and a table.

use asperity::Finding;
use asperity::fit::{Fitted, Ranking};
use asperity_answer::{Cell, Sheet};
use asperity_inputs::Free;

use crate::output::show;
use crate::scene::LoadedScene;

/// Reports the bounds that are not given, doubts, unusual results and the order of the models; the
/// misfit of the first model is left to the error where no model describes the data.
pub fn report(scene: &LoadedScene, ranking: &Ranking, free: &[Free]) {
    let all = &ranking.models;
    let note = |code, text: String| Finding::note(code, "", f64::NAN).fact(text);
    let bounds = all.first().map_or(vec![], |one| scene.file.notes_on_bounds(free, one));
    let mut found: Vec<Finding> = bounds.into_iter().map(|text| note("bounds", text)).collect();
    let hopeless = all.iter().all(|one| one.misfit().is_some());
    let of_fits = scene.file.findings_of_fits(ranking).into_iter();
    found.extend(of_fits.filter(|one| !hopeless || one.code != "misfit"));
    let is_ranked = all.iter().any(|one| one.bic.is_some());
    if !hopeless && (is_ranked || all.len() > 1) {
        found.push(note("ranking", ranking.summary.clone()));
    }
    show(&found);
}

/// One row for each model and parameter.
pub fn table(ranking: &Ranking) -> Sheet {
    let mut table =
        Sheet::new(&["model", "parameter", "value", "lower", "upper", "unit", "rms", "bic"]);
    let rows = |one: &Fitted| {
        for found in &one.parameters {
            let [value, lower, upper] =
                [Some(found.value), found.lower, found.upper].map(Cell::from);
            let others =
                [value, lower, upper, (&*found.unit).into(), one.rms.into(), one.bic.into()];
            table.add(&[&one.model, &found.name], others);
        }
    };
    ranking.distinct().for_each(rows);
    table
}
