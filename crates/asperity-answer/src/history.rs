//! A joint through a history of turning points.

use asperity::joints::{Joint, Path, UnloadingLaw};
use asperity::{At, ContactError, ContactModel, Quantity, Request, Separation, SeparationUnit};

use crate::number::rounded;
use crate::subject::Subject;
use crate::unloading::READ_0;
use crate::{AnswerError, Cell, Sheet};

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
            let law = joint.law().to_string();
            for point in &path.points {
                let at = Separation::metres(point.separation);
                let numbers = [
                    point.way as f64,
                    subject.place(at, SeparationUnit::Sigma)?,
                    subject.place(at, SeparationUnit::Metres)?,
                    point.force,
                    point.force / subject.file.scene.nominal_area,
                    point.stiffness,
                ];
                let names = [Cell::from(subject.id), law.as_str().into()];
                sheet.rows.push(names.into_iter().chain(numbers.map(Cell::from)).collect());
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
            warn_few(sheet, subject, &joint, &path)?;
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
    let (first, works) = (rounded(first), works.join(", "));
    let text = match &*works {
        "" => format!("{name}: closing to the turning point takes {first} J"),
        _ => format!(
            "{name}: first closing takes {first} J, the later paths {works} J (negative: returned), {all} J in total"
        ),
    };
    sheet.note("work", text);
}

/// Warns of points at which fewer than one asperity touches, and of zeros.
fn warn_few(
    sheet: &mut Sheet,
    subject: &Subject<'_>,
    joint: &Joint,
    path: &Path,
) -> Result<(), ContactError> {
    let virgin = subject.model.compile(joint.scene(), &Request::new([Quantity::Contacts]))?;
    let (mut few, mut opening) = (vec![], None);
    for point in &path.points {
        let (place, closest) = (At::metres(point.separation), point.closest);
        let contacts = if point.separation > closest {
            let found = match opening.take() {
                Some((from, found)) if f64::total_cmp(&from, &closest).is_eq() => found,
                _ => joint.unloading(At::metres(closest))?,
            };
            let contacts = found.contacts(point.separation - closest)?;
            opening = Some((closest, found));
            contacts
        } else {
            virgin.evaluate(Quantity::Contacts, virgin.separation(place)?)?
        };
        if contacts.value() < 1.0 {
            few.push(point);
        }
    }
    let Some(first) = few.first() else { return Ok(()) };
    let zeros = few.iter().filter(|point| point.force == 0.0 || point.stiffness == 0.0).count();
    let zeros = match zeros {
        0 => String::new(),
        count => format!("; at {count} of them values {READ_0}"),
    };
    let (id, law, count, all) = (subject.id, joint.law(), few.len(), path.points.len());
    let (at, way) = (At::metres(first.separation), first.way);
    let text = format!(
        "{id} by {law}: fewer than one asperity touches on average at {count} of {all} points, first at {at} on way {way}{zeros}"
    );
    sheet.warn("few-contacts", text);
    Ok(())
}
