//! A joint through a history of turning points.

use asperity::joints::{Joint, Path, UnloadingLaw};
use asperity::{At, ContactError, Separation, SeparationUnit};

use crate::number::rounded;
use crate::subject::Subject;
use crate::{AnswerError, Sheet};

/// The most paths whose work is listed.
const LISTED: usize = 6;
/// Points on each path between turning points.
const STEPS: usize = 50;

/// The paths of a new joint between turning points by each law; findings have the work of each.
///
/// # Errors
/// Those of [`Joint::path`].
pub fn history(
    subject: &Subject<'_>,
    laws: &[UnloadingLaw],
    turns: &[At],
    sheet: &mut Sheet,
) -> Result<(), AnswerError> {
    let heads = ["model", "law", "way", "separation_over_sigma", "separation_m", "force_N"];
    sheet.under(&[&heads, &["pressure_Pa", "stiffness_N_per_m"]]);
    subject.fill(sheet, |sheet| {
        for joint in subject.joints(laws)? {
            let path = joint.path(&joint.turning_points(turns)?, STEPS)?;
            let (law, area) = (joint.law().to_string(), subject.file.scene.nominal_area);
            for point in &path.points {
                let at = Separation::metres(point.separation);
                let [sigma, metres] = [SeparationUnit::Sigma, SeparationUnit::Metres]
                    .map(|unit| subject.place(at, unit));
                let (force, stiffness) = (point.force, point.stiffness);
                let numbers = [point.way as f64, sigma?, metres?, force, force / area, stiffness];
                sheet.add(&[subject.id, &law], numbers);
            }
            let name = format!("{} by {law}", subject.id);
            note_work(sheet, &name, &joint, &path);
            if let [_, .., last] = &path.points[..] {
                let closest = At::metres(last.closest);
                let work = joint.work(closest);
                let warned =
                    work.and_then(|work| subject.warn_energy_gain(sheet, &joint, closest, &work));
                match warned {
                    // Missing work has a warning of its own.
                    Err(ContactError::Integral { .. } | ContactError::OutOfRange { .. }) => {}
                    other => other?,
                }
            }
            let open = path.points.iter().filter(|point| point.force == 0.0).count();
            if open > 0 {
                let all = path.points.len();
                let text = format!("{name}: the joint is open at {open} of {all} points");
                sheet.warn("few-contacts", text);
            }
        }
        Ok(())
    })
}

/// Notes the work of the first closing and of the later paths.
fn note_work(sheet: &mut Sheet, name: &str, joint: &Joint, path: &Path) {
    let Some(first) = path.points.first() else { return };
    let first = match joint.work(At::metres(first.separation)) {
        Ok(work) => work.spent.value(),
        Err(error) => {
            return sheet.warn("no-work", format!("{name}: the work is unavailable: {error}"));
        }
    };
    let all = rounded(first + path.work.iter().sum::<f64>());
    let works: Vec<String> = path.work.iter().map(|work| rounded(*work)).collect();
    let (first, count) = (rounded(first), works.len());
    let text = match count {
        0 => format!("{name}: closing to the turning point takes {first} J"),
        1..=LISTED => format!(
            "{name}: first closing takes {first} J, the later paths {} J (negative: returned), {all} J in total",
            works.join(", ")
        ),
        _ => {
            let least = path.work.iter().copied().fold(f64::INFINITY, f64::min);
            let most = path.work.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let [least, most] = [least, most].map(rounded);
            format!(
                "{name}: first closing takes {first} J, each of the {count} later paths from {least} to {most} J (negative: returned), {all} J in total"
            )
        }
    };
    sheet.note("work", text);
}
