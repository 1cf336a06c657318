//! A joint through a history of turning points.

use asperity::joints::{Joint, Path, UnloadingLaw};
use asperity::{At, Code, ContactError, Finding, Separation, SeparationUnit};

use crate::number::rounded;
use crate::sheet::warning;
use crate::subject::{OfLaws, Subject};
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
        let mut found = OfLaws::new();
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
            found.extend(work(&joint, &path).map(|found| (found, joint.law())));
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
                found.push((Err(warning(Code::FewContacts, text).into()), joint.law()));
            }
        }
        subject.report_laws(sheet, found);
        Ok(())
    })
}

/// The work of the first closing and of the later paths, which are listed if they are few.
fn work(joint: &Joint, path: &Path) -> Option<Result<String, Box<Finding>>> {
    let closing = match joint.work(At::metres(path.points.first()?.separation)) {
        Ok(work) => work.spent.value(),
        Err(error) => {
            return Some(Err(
                warning(Code::NoValue, format!("the work is unavailable: {error}")).into()
            ));
        }
    };
    let later = &path.work[..];
    let [first, all] = [closing, closing + later.iter().sum::<f64>()].map(rounded);
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
    Some(Ok(text))
}
