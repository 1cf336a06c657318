//! A joint through a history of turning points.

use asperity::joints::{Joint, Path, UnloadingLaw};
use asperity::{At, Code, ContactError, Separation, SeparationUnit};

use crate::number::rounded;
use crate::subject::Subject;
use crate::{AnswerError, Sheet};

/// The most paths whose work is listed.
const LISTED: usize = 6;
/// Points on each path between turning points.
const STEPS: usize = 50;

/// The paths of a new joint between turning points by each law; results have the work of each.
///
/// # Errors
/// The errors of [`Joint::path`].
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
                sheet.add(&[subject.id(), &law], numbers);
            }
            report_work(sheet, subject, &joint, &path);
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
                let text = format!("the joint is open at {open} of {all} points");
                sheet.warn(Code::FewContacts, subject.by(joint.law(), &text));
            }
        }
        Ok(())
    })
}

/// Adds the work of the first closing and of each later path.
fn report_work(sheet: &mut Sheet, subject: &Subject<'_>, joint: &Joint, path: &Path) {
    let Some(first) = path.points.first() else { return };
    let by = |text: &str| subject.by(joint.law(), text);
    let closing = match joint.work(At::metres(first.separation)) {
        Ok(work) => work.spent.value(),
        Err(error) => {
            let text = by(&format!("the work is unavailable: {error}"));
            return sheet.warn(Code::NoValue, text);
        }
    };
    let [first, all] = [closing, closing + path.work.iter().sum::<f64>()].map(rounded);
    let later = &path.work[..];
    let text = match later.len() {
        0 => format!("closing to the turning point takes {first} J"),
        1..=LISTED => {
            let works = later.iter().map(|work| rounded(*work)).collect::<Vec<_>>().join(", ");
            format!(
                "first closing takes {first} J, the later paths {works} J (negative: returned), {all} J in total"
            )
        }
        count => {
            let least = rounded(later.iter().copied().fold(f64::INFINITY, f64::min));
            let most = rounded(later.iter().copied().fold(f64::NEG_INFINITY, f64::max));
            format!(
                "first closing takes {first} J, each of the {count} later paths from {least} to {most} J (negative: returned), {all} J in total"
            )
        }
    };
    sheet.result(by(&text));
}
