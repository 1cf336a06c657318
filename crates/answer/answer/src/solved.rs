//! What boundary elements gave on the scan of a scene, as an input of its answer.

use asperity::{At, Code, Compared, SolvedContact};
use asperity_scene::SceneFile;

use crate::subject::Outcome;
use crate::truth::{Truths, uncertain};
use crate::{AnswerError, Watch};

/// The solutions of boundary elements on the scan of a scene at these loads: an input of answers.
///
/// # Errors
/// A number that is known within a range, and the errors of boundary elements.
pub fn solve(file: &SceneFile, at: &[At], watch: &dyn Watch) -> Outcome<Vec<SolvedContact>> {
    if let Some(unknown) = file.unknowns().first() {
        let name = &unknown.name;
        return Err(AnswerError::from(format!(
            "{name} has a range, and a solution holds for one value: give {name} one value, or answer without a solution"
        )));
    }
    let pressures: Vec<f64> = at.iter().filter_map(|at| at.pressure(&file.scene)).collect();
    let bem = file.bem()?;
    let truths = Truths::solve(file, &bem, &[], &pressures, &Compared::ALL, false, watch)?;
    if let Some((_, error)) = truths.failed.into_iter().next() {
        return Err(error.into());
    }
    let solved = truths.found.into_iter().map(|truth| {
        let codes: Vec<Code> = truth.notes.iter().map(|note| note.code).collect();
        let uncertain = uncertain(&codes).map(Into::into);
        SolvedContact { pressure: truth.pressure, values: truth.bem, uncertain }
    });
    Ok(solved.collect())
}

/// What boundary elements gave at a mean pressure \[Pa\], an input of answers: values by the names
/// of quantities and `mean-gap`, without those that are not finite, and the codes of its notes.
pub fn solved_contact(
    pressure: f64,
    value: impl Fn(&str) -> Option<f64>,
    notes: &[String],
) -> SolvedContact {
    let named = [
        ("area-fraction", Compared::Area),
        ("tangent", Compared::Stiffness),
        ("unloading-stiffness", Compared::UnloadingStiffness),
        ("mean-gap", Compared::MeanGap),
    ];
    let finite = |(name, of)| Some((of, value(name).filter(|value| value.is_finite())?));
    let values = named.into_iter().filter_map(finite).collect();
    let codes: Vec<Code> = notes.iter().filter_map(|name| Code::named(name).ok()).collect();
    SolvedContact { pressure, values, uncertain: uncertain(&codes).map(Into::into) }
}
