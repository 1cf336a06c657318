//! A joint that opens from its closest approach.

use asperity::joints::{Joint, Unloading, UnloadingLaw};
use asperity::{At, ContactError, Evaluation, SeparationUnit, linspace};

use crate::number::rounded;
use crate::subject::{Subject, unit_warning};
use crate::{AnswerError, Cell, Sheet};

/// Number of default retreats.
const POINTS: usize = 101;
/// The reason for values of 0.
pub(crate) const READ_0: &str =
    "are 0: they are below the smallest f64, and far fewer than one asperity touches";

/// Retreats from the closest approach, in a unit.
pub type Retreats<'r> = (&'r [f64], SeparationUnit);

/// Force, area, stiffness and contacts of a joint by each law as it opens by these retreats, by
/// default to the end of contact; findings have the work of a cycle and the end of contact.
///
/// # Errors
/// Those of [`Joint`], and the reason why nothing opens.
pub fn unloading(
    subject: &Subject<'_>,
    laws: &[UnloadingLaw],
    closest: At,
    retreats: Option<Retreats<'_>>,
    sheet: &mut Sheet,
) -> Result<(), AnswerError> {
    let with_area = laws.iter().any(|law| has_area(*law));
    let heads = ["model", "law", "retreat_m", "separation_over_sigma", "force_N", "pressure_Pa"];
    let area: &[&str] = if with_area { &["area_m2"] } else { &[] };
    sheet.under(&[&heads, area, &["stiffness_N_per_m", "contacts"]]);
    subject.fill(sheet, |sheet| {
        let (mut openings, mut last) = (vec![], None);
        for joint in subject.joints(laws)? {
            let opening = joint.unloading(closest)?;
            if opening.force(0.0)?.value() == 0.0 {
                let at = opening.closest();
                let text =
                    format!("nothing touches at a separation of {at}; choose a smaller one");
                return Err(text.into());
            }
            let end = opening.last_contact();
            note_work(sheet, subject, &joint, closest);
            note_end(sheet, &format!("{} by {}", subject.id, joint.law()), &end);
            // Only a default depends on the end of contact.
            last = last.into_iter().chain(end).reduce(f64::max);
            openings.push(opening);
        }
        if laws.contains(&UnloadingLaw::Brake) {
            let text = "brake: the area jumps at the start; the row of retreat 0 has the area after the jump";
            sheet.note("area-jumps", text);
        }
        if laws.len() > 1 && laws.contains(&UnloadingLaw::Etsion) {
            sheet.note("no-area", "etsion: area_m2 is blank, as this law gives no area");
        }
        let retreats = match retreats {
            Some(given) => metres(sheet, subject, given),
            None => match last.ok_or("the end of contact was not found; give --retreat")? {
                0.0 => vec![0.0],
                end => linspace(0.0, end, POINTS),
            },
        };
        for opening in &openings {
            add_rows(sheet, subject, opening, &retreats, with_area)?;
        }
        Ok(())
    })
}

/// Retreats in metres, with a warning of those that look like another unit.
pub(crate) fn metres(
    sheet: &mut Sheet,
    subject: &Subject<'_>,
    (values, unit): Retreats<'_>,
) -> Vec<f64> {
    let sigma = subject.file.scene.surface.asperity_height_std;
    sheet.findings.extend(unit_warning("retreat", values, unit, sigma));
    let metres = if unit == SeparationUnit::Sigma { sigma } else { 1.0 };
    values.iter().map(|value| metres * value).collect()
}

fn has_area(law: UnloadingLaw) -> bool {
    law != UnloadingLaw::Etsion
}

/// Notes the work of closing and opening.
fn note_work(sheet: &mut Sheet, subject: &Subject<'_>, joint: &Joint, closest: At) {
    let name = format!("{} by {}", subject.id, joint.law());
    let works = joint.work(closest).and_then(|work| {
        subject.warn_energy_gain(sheet, joint, closest, &work)?;
        let lost = work.lost();
        // A loss below its error is 0.
        Ok(match lost.relative_error() < 1.0 {
            true => [work.spent.value(), lost.value(), work.loss_factor()?],
            false => [work.spent.value(), 0.0, 0.0],
        })
    });
    match works.map(|works| works.map(rounded)) {
        Ok([spent, lost, factor]) => sheet.note(
            "work",
            format!(
                "{name}: closing takes {spent} J, of which {lost} J are dissipated in the first cycle (loss factor {factor})"
            ),
        ),
        Err(error) => sheet.warn("no-work", format!("{name}: the work is unavailable: {error}")),
    }
}

/// Tells where contact ends.
fn note_end(sheet: &mut Sheet, name: &str, end: &Result<f64, ContactError>) {
    match end {
        Ok(0.0) => {
            let text = "even at the closest approach, fewer than one asperity touches on average";
            sheet.warn("few-contacts", format!("{name}: {text}"));
        }
        Ok(end) => {
            let end = rounded(*end);
            let text = "beyond which fewer than one asperity touches on average";
            let text = format!("{name}: contact ends at a retreat of {end} m, {text}");
            sheet.note("end-of-contact", text);
        }
        Err(error) => {
            let text = format!("{name}: the end of contact was not found: {error}");
            sheet.note("no-end-of-contact", text);
        }
    }
}

/// The rows of one law, with warnings of blanks and zeros.
fn add_rows(
    sheet: &mut Sheet,
    subject: &Subject<'_>,
    opening: &Unloading,
    retreats: &[f64],
    with_area: bool,
) -> Result<(), ContactError> {
    let (contact, law) = (&subject.file.scene, opening.law());
    let closest = subject.place(opening.closest(), SeparationUnit::Sigma)?;
    let row = |retreat: f64| {
        let force = cell(opening.force(retreat))?;
        let pressure = force.number().map(|force| force / contact.nominal_area);
        let separation = closest + retreat / contact.surface.asperity_height_std;
        let mut row: Vec<Cell> = vec![subject.id.into(), law.to_string().as_str().into()];
        row.extend([retreat.into(), separation.into(), force, pressure.into()]);
        if with_area {
            row.push(if has_area(law) { cell(opening.area(retreat))? } else { Cell::BLANK });
        }
        row.extend([cell(opening.stiffness(retreat))?, cell(opening.contacts(retreat))?]);
        Ok(row)
    };
    let rows: Vec<Vec<Cell>> =
        retreats.iter().map(|retreat| row(*retreat)).collect::<Result<_, _>>()?;
    let context = format!("{} by {law}", subject.id);
    let blank = rows.iter().flatten().find_map(|cell| match cell {
        Cell::Blank(Some(reason)) => Some(reason),
        _ => None,
    });
    if let Some(reason) = blank {
        subject.warn_blank(sheet, format!("{context}: a value is blank: {reason}"));
    }
    let is_0 = |row: &&Vec<Cell>| row[4..].contains(&Cell::Number(0.0));
    let zeros = rows.iter().filter(is_0).filter_map(|row| row[2].number());
    if let Some(from) = zeros.reduce(f64::min).map(rounded) {
        let text = format!("{context}: from a retreat of {from} m on, values {READ_0}");
        subject.warn_blank(sheet, text);
    }
    sheet.rows.extend(rows);
    Ok(())
}

/// A value; blank where its integral fails.
fn cell(found: Result<Evaluation, ContactError>) -> Result<Cell, ContactError> {
    match found {
        Ok(found) => Ok(found.value().into()),
        Err(error @ ContactError::Integral { .. }) => {
            Ok(Cell::Blank(Some(error.to_string().into())))
        }
        Err(error) => Err(error),
    }
}
