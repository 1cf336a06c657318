//! The models that are asked: those named, or all that the scene allows.

use asperity::bem::Bem;
use asperity::recommended::YIELDING;
use asperity::{
    At, Best, Code, Compared, ContactError, ContactModel, Described, Finding, Findings, Model,
    Quantity, Request, Severity, Tolerance, usual_reference,
};
use asperity_scene::{LeftOut, SceneFile};

use crate::{AnswerError, Sheet};

/// The name in a list of models that stands for all that the scene allows.
pub const ALL_MODELS: &str = "all";

/// The one model of an answer, the usual one unless another is named; an error if the scene has
/// not what it needs.
///
/// # Errors
/// An unknown name, and the reason why the scene refuses the model.
pub fn one_model(file: &SceneFile, id: Option<&str>) -> Result<Model, AnswerError> {
    let model = file.model(id.unwrap_or(usual_reference(&file.scene)))?;
    // Other models report what they lack with their answers.
    let averaged = model.asperity_model().is_some();
    match averaged.then(|| file.refusal(&model)).flatten() {
        Some(reason) => Err(reason.into()),
        None => Ok(model),
    }
}

/// The usual model where none is named; a note tells of a hardness that may be forgotten.
///
/// # Errors
/// The errors of [`one_model`].
pub fn one_or_usual(
    file: &SceneFile,
    name: &str,
    id: Option<&str>,
    sheet: &mut Sheet,
) -> Result<Model, AnswerError> {
    let model = one_model(file, id)?;
    let elastic = file.scene.asperity().is_ok_and(|asperity| asperity.hardness.is_none());
    if id.is_none() && elastic {
        let text = format!(
            "the default model is {}, which ignores yielding, as hardness is missing; {YIELDING} need it",
            model.id()
        );
        let found = Finding::note(Code::DefaultModel, "hardness", f64::NAN).fact(text);
        sheet.findings.push(found.from_origin(name));
    }
    Ok(model)
}

/// The model for a joint: for `best` the valid model that is nearest to it in stiffness at a place,
/// as a joint unloads along the law of one model; a note says which.
///
/// # Errors
/// The errors of the scene.
pub fn of_joint(
    file: &SceneFile,
    model: Model,
    at: At,
    sheet: &mut Sheet,
) -> Result<Model, AnswerError> {
    file.need_flat()?;
    if model.id() != Best::<Model>::ID {
        return Ok(model);
    }
    let best = file.best().on(&file.scene, Tolerance::default())?;
    let by = best.by(Compared::Stiffness, at).ok_or("best has no model for this joint")?.clone();
    sheet.note(
        Code::DefaultModel,
        format!("best: a joint follows one law, here that of {}", by.id()),
    );
    Ok(by)
}

/// What is known best, and the valid model that is nearest to it in stiffness, which has all
/// quantities: the models that are shown where none is named.
///
/// # Errors
/// The errors of the scene.
pub fn best_and_nearest(file: &SceneFile, request: &Request) -> Result<Vec<String>, AnswerError> {
    if file.shape().is_some() {
        return Ok(vec![Best::<Model>::ID.into()]);
    }
    let middle = file.middle()?;
    let best = middle.best().on(&middle.scene, request.tolerance)?;
    let at = request.at.get(request.at.len() / 2).copied().unwrap_or(At::from(2.0));
    let nearest = best.by(Compared::Stiffness, at).map(|model| model.id());
    let ids = [Best::<Model>::ID].into_iter().chain(nearest);
    Ok(ids.map(String::from).collect())
}

/// The models given, of which some may be refused where they are compiled, or all of those
/// `allowed` by the scene that have these quantities; a note names the others.
///
/// # Errors
/// The errors of [`SceneFile::model`], and where it allows none.
pub fn models(
    file: &SceneFile,
    requested: &[String],
    allowed: fn(&SceneFile) -> (Vec<Model>, Vec<LeftOut>),
    quantities: &[Quantity],
    sheet: &mut Sheet,
) -> Result<Vec<Model>, AnswerError> {
    let models: Vec<Model> = if by_name(requested) {
        once(requested).iter().map(|id| file.model(id)).collect::<Result<_, _>>()?
    } else {
        let (mut models, mut left_out) = allowed(file);
        let request = Request::new(quantities.iter().copied());
        models.retain(|model| match model.compile(&file.scene, &request) {
            Err(reason @ ContactError::Unsupported { .. }) => {
                left_out.push(LeftOut { id: model.id().into(), reason });
                false
            }
            // Anything else is an error of the scene.
            _ => true,
        });
        let reasons =
            left_out.into_iter().map(|LeftOut { id, reason }| (reason_alone(&id, &reason), id));
        for (reason, ids) in grouped(reasons) {
            sheet.note(Code::LeftOut, format!("left out: {}: {reason}", once(&ids).join(", ")));
        }
        models
    };
    if models.is_empty() {
        return Err("no model is available for this scene".into());
    }
    if !models.iter().all(|model| model.validity().adhesive) {
        note_adhesion(file, sheet);
    }
    Ok(models)
}

/// Whether models are requested by name, not all.
fn by_name(requested: &[String]) -> bool {
    !requested.is_empty() && requested.iter().all(|id| id != ALL_MODELS)
}

/// Notes which models include the scene's adhesion, where it has any.
pub(crate) fn note_adhesion(file: &SceneFile, sheet: &mut Sheet) {
    sheet
        .extend(file.findings().into_iter().filter(|found| found.code == Code::Adhesion).collect());
}

/// The reason of a model whose id stands in front of it.
pub(crate) fn reason_alone(id: &str, reason: &ContactError) -> String {
    match reason {
        ContactError::Unsupported { model, what } if model == id => format!("cannot give {what}"),
        ContactError::Refused { model, reason } if model == id => reason.clone(),
        reason => reason.to_string(),
    }
}

/// Values under their keys, each once, in the order of the first.
pub fn grouped<K: PartialEq, V: PartialEq>(
    pairs: impl IntoIterator<Item = (K, V)>,
) -> Vec<(K, Vec<V>)> {
    let mut groups: Vec<(K, Vec<V>)> = vec![];
    for (key, value) in pairs {
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, values)) if values.contains(&value) => {}
            Some((_, values)) => values.push(value),
            None => groups.push((key, vec![value])),
        }
    }
    groups
}

/// Each once, in order.
pub fn once<T: PartialEq + Clone>(all: &[T]) -> Vec<T> {
    let mut kept: Vec<T> = vec![];
    for item in all {
        if !kept.contains(item) {
            kept.push(item.clone());
        }
    }
    kept
}

/// The findings about a scene: of its files, its numbers and, unless no model uses them, its
/// asperities.
#[must_use]
pub fn scene_findings(file: &SceneFile, asperities: bool) -> Findings {
    let found = file.warnings.iter().cloned().chain(file.findings());
    // The asperities of a scan follow from it.
    let used = |found: &Finding| asperities || !found.field.starts_with("asperity_");
    let found = found.filter(used).collect::<Findings>().for_asperities(asperities);
    found.at_least(Severity::Warning)
}

/// Whether one of these models uses the asperities of a scene; all do, if none is named.
#[must_use]
pub fn use_asperities(ids: &[String]) -> bool {
    let knows = |id: &String| id.parse().map_or(id != Bem::ID, |m: Model| m.validity().asperities);
    ids.is_empty() || ids.iter().any(knows)
}
