//! Findings about a scene at a load, and which model to trust there.

use asperity::{At, Described, Diagnostics, Quantity, Request, Severity};
use asperity_scene::SceneFile;
use serde::Serialize;

use crate::refusal::Refusal;

/// Largest deviation of a simpler model from the reference.
const WITHIN: f64 = 0.1;

/// Which model to trust, and on what evidence.
#[derive(Debug, Serialize)]
pub(crate) struct Advice {
    pub(crate) reference: String,
    pub(crate) simplest: Option<String>,
    /// Sentences, the verdict first.
    pub(crate) summary: Vec<String>,
}

/// Findings about the scene and about these models at a load.
pub(crate) fn check(file: &SceneFile, ids: &[String], at: At) -> Result<Diagnostics, Refusal> {
    let mut found: Diagnostics = file.warnings.iter().cloned().chain(file.findings()).collect();
    let valid = !found.iter().any(|found| found.severity == Severity::Error);
    if valid {
        for id in ids {
            let model = file.model(id)?;
            found.extend(file.findings_at(&model, &[at]));
        }
    }
    Ok(file.accepted(found))
}

/// Compares the models that the scene allows with each other and with boundary elements.
pub(crate) fn advise(file: &SceneFile, at: At) -> Result<Advice, Refusal> {
    let (models, _) = file.models_beside_bem();
    let reference = file.model(asperity::usual_reference(&file.scene))?;
    let request = Request::new([Quantity::Area, Quantity::Tangent]).at([at]);
    let advice = file.recommend_among(models, &request, &reference, WITHIN)?;
    let verdict = advice.verdict(|model| model.name().to_string());
    Ok(Advice {
        reference: reference.id().into(),
        simplest: advice.simplest.as_ref().map(|model| model.id().into()),
        summary: [verdict].into_iter().chain(advice.summary()).collect(),
    })
}
