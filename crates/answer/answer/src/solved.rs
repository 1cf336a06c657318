//! What boundary elements gave on the scan of a scene, as an input of its answer.

use asperity::bem::{BemError, LoadCase, Progress};
use asperity::{At, Code, Compared, Quantity, SolvedContact};
use asperity_scene::SceneFile;

use crate::subject::Outcome;
use crate::{AnswerError, Press, Pressed, Watch};

/// The compared quantities by their names; the mean gap is no quantity of models.
const NAMED: [(&str, Compared); 4] = [
    ("area-fraction", Compared::Area),
    ("tangent", Compared::Stiffness),
    ("unloading-stiffness", Compared::UnloadingStiffness),
    ("mean-gap", Compared::MeanGap),
];

/// Why a solution with one of these notes is uncertain; the first reason counts.
const UNCERTAIN: [(Code, &str); 3] = [
    (Code::ShortWaves, "the grid is too coarse for the shortest waves of the scan"),
    (Code::FewPixels, "too few pixels or patches are in contact"),
    (Code::FewPatches, "too few pixels or patches are in contact"),
];

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
    let given: Vec<LoadCase> = pressures.iter().copied().map(LoadCase::MeanPressure).collect();
    let bem = file.bem()?;
    let press = Press::new(file, &bem, &given, &Compared::QUANTITIES);
    let heads = press.heads();
    let contact = |pressure: f64, Pressed { cells, notes, .. }: Pressed| {
        let value = |name: &str| {
            let head = name.parse().map_or_else(|_| "mean_gap_m".into(), Quantity::column);
            cells[heads.iter().position(|known| *known == head)?].number()
        };
        let notes: Vec<String> = notes.iter().map(|note| note.code.name().into()).collect();
        solved_contact(pressure, value, &notes)
    };
    let mut all: Vec<_> = given.iter().map(|_| Err(BemError::Cancelled)).collect();
    let progress = |of: &Progress| {
        watch.step(&format!("boundary elements: contact {} of {}", of.done + 1, given.len()))
    };
    press.each(&bem.elements(&file.scene.interface)?, progress, |k, pressed| {
        all[k] = pressed.map(|pressed| contact(pressures[k], pressed));
    });
    Ok(all.into_iter().collect::<Result<_, _>>()?)
}

/// What boundary elements gave at a mean pressure \[Pa\], an input of answers: values by the names
/// of quantities and `mean-gap`, without those that are not finite, and the codes of its notes.
pub fn solved_contact(
    pressure: f64,
    value: impl Fn(&str) -> Option<f64>,
    notes: &[String],
) -> SolvedContact {
    let finite = |(name, of)| Some((of, value(name).filter(|value| value.is_finite())?));
    let is_noted = |(code, _): &&(Code, &str)| notes.iter().any(|name| name == code.name());
    let uncertain = UNCERTAIN.iter().find(is_noted).map(|(code, why)| (*code, (*why).into()));
    SolvedContact { pressure, values: NAMED.into_iter().filter_map(finite).collect(), uncertain }
}
