//! The largest tension of surfaces with adhesion.

use asperity::{
    Code, ContactModel, Described, Model, Quantity, Request, Scene, SeparationUnit, Tolerance,
    short,
};
use asperity_scene::SceneFile;

use crate::models::note_adhesion;
use crate::ranges::with_ranges;
use crate::subject::{Outcome, measured};
use crate::{AnswerError, Cell, Sheet};

/// The largest tension of models with adhesion, and its separation; blank if there is no tensile
/// force.
///
/// # Errors
/// The errors of the models on the scene.
pub fn pull_off(
    file: &SceneFile,
    models: &[Model],
    tolerance: Tolerance,
    sheet: &mut Sheet,
) -> Outcome {
    with_ranges(file, sheet, |file, sheet| fill(file, models, tolerance, sheet))
}

fn fill(file: &SceneFile, models: &[Model], tolerance: Tolerance, sheet: &mut Sheet) -> Outcome {
    let heads = ["model", "force_N", "pressure_Pa", "separation_over_sigma", "separation_m"];
    let scene = &file.scene;
    sheet.under(&[&heads]);
    note_adhesion(file, sheet);
    for model in models {
        let id = model.id();
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        let contact = model.compile(scene, &request);
        let found = contact.and_then(|contact| asperity::pull_off(&*contact));
        let found = found.map_err(|error| AnswerError::from(error).of_model(id))?;
        let Some(found) = found else {
            sheet.note(Code::NoValue, format!("{id}: no pull-off force{}", hidden(scene)));
            sheet.add(&[id], [Cell::BLANK]);
            continue;
        };
        sheet.report(file, file.judge(model, None, &[found.separation.into()]));
        let (force, at) = (found.force.value(), found.separation);
        let [sigma, metres] = [SeparationUnit::Sigma, SeparationUnit::Metres]
            .map(|unit| measured(file, scene, at, unit));
        sheet.add(&[id], [force, force / scene.nominal_area, sigma?, metres?]);
    }
    Ok(())
}

/// Why there is no pull-off force.
fn hidden(scene: &Scene) -> String {
    scene.adhesion_parameter().map_or(String::new(), |theta| {
        format!(": adhesion_parameter is {}, and above 10 roughness hides adhesion", short(theta))
    })
}
