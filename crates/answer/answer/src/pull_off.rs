//! The largest tension of surfaces with adhesion.

use asperity::recommended::{DMT, JKR_SEPARATION};
use asperity::{
    Code, ContactModel, Described, Model, Quantity, Request, Scene, SeparationUnit, Tolerance,
    short,
};
use asperity_scene::SceneFile;

use crate::models::note_adhesion;
use crate::number::rounded;
use crate::subject::measured;
use crate::{AnswerError, Cell, Sheet};

/// Tension \[% of the tension of asperities of equal height\] below which there is practically
/// none.
const SMALLEST: f64 = 1e-6;

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
) -> Result<(), AnswerError> {
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
        note_reduction(sheet, id, force, scene);
        let [sigma, metres] = [SeparationUnit::Sigma, SeparationUnit::Metres]
            .map(|unit| measured(file, scene, at, unit));
        sheet.add(&[id], [force, force / scene.nominal_area, sigma?, metres?]);
    }
    Ok(())
}

/// States the tension relative to asperities of equal height.
fn note_reduction(sheet: &mut Sheet, id: &str, force: f64, scene: &Scene) {
    // Pull-off force of one asperity in units of pi R w_a.
    let single = match id {
        JKR_SEPARATION => 1.5,
        DMT => 2.0,
        _ => return,
    };
    let Some(work) = scene.interface.work_of_adhesion else { return };
    let single = single * std::f64::consts::PI * scene.surface.asperity_radius * work;
    let percent = -100.0 * force / (scene.asperities() * single);
    if percent < SMALLEST {
        let text = format!("{id}: practically no pull-off force{}", hidden(scene));
        return sheet.result(text);
    }
    let (percent, of) = (rounded(percent), "of that of asperities of equal height");
    sheet.result(format!("{id}: roughness reduces the tension to {percent} % {of}"));
}

/// Why there is no pull-off force.
fn hidden(scene: &Scene) -> String {
    scene.adhesion_parameter().map_or(String::new(), |theta| {
        format!(": adhesion_parameter is {}, and above 10 roughness hides adhesion", short(theta))
    })
}
