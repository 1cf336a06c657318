//! A joint that opens from its closest approach.

use asperity::bem::Bem;
use asperity::joints::{Joint, Unloading, UnloadingLaw};
use asperity::{At, Code, ContactError, Evaluation, SeparationUnit, linspace};

use crate::blanks::{Blanks, kind};
use crate::number::rounded;
use crate::subject::{Outcome, Retreats, Subject, metres};
use crate::unloading_scan::open_scan;
use crate::{Sheet, Watch};

/// Number of default retreats.
const POINTS: usize = 101;

/// Force, area, stiffness and contacts of a joint by each law as it opens by these retreats, by
/// default to the end of contact; results have the work of a cycle and the end of contact. A scan
/// opens along its own path, by boundary elements.
///
/// # Errors
/// The errors of [`Joint`] or of boundary elements, and the reason why nothing opens.
pub fn unloading(
    subject: &Subject<'_>,
    laws: &[UnloadingLaw],
    closest: At,
    retreats: Option<Retreats<'_>>,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Outcome {
    let is_scan = subject.id() == Bem::ID;
    let with_area = is_scan || laws.iter().any(|law| has_area(*law));
    let heads = ["model", "law", "retreat_m", "separation_over_sigma", "force_N", "pressure_Pa"];
    let area: &[&str] = if with_area { &["area_m2"] } else { &[] };
    let contacts: &[&str] = if is_scan { &[] } else { &["contacts"] };
    sheet.under(&[&heads, area, &["stiffness_N_per_m"], contacts]);
    subject.fill(sheet, |sheet| {
        if is_scan {
            return open_scan(subject, closest, retreats, sheet, watch);
        }
        let (mut openings, mut last) = (vec![], None);
        for joint in subject.joints(laws)? {
            let opening = joint.unloading(closest)?;
            if opening.force(0.0)?.value() == 0.0 {
                let at = opening.closest();
                return Err(format!(
                    "nothing touches at a separation of {at}; choose a smaller one"
                )
                .into());
            }
            let end = opening.last_contact();
            report_work(sheet, subject, &joint, closest);
            report_end(sheet, subject, joint.law(), &end);
            // Only a default depends on the end of contact.
            last = last.into_iter().chain(end).reduce(f64::max);
            openings.push(opening);
        }
        let retreats = match retreats {
            Some(given) => metres(sheet, &*subject.scene()?, given),
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

fn has_area(law: UnloadingLaw) -> bool {
    law != UnloadingLaw::Etsion
}

/// Adds the work of closing and opening.
fn report_work(sheet: &mut Sheet, subject: &Subject<'_>, joint: &Joint, closest: At) {
    let works = joint.work(closest).and_then(|work| {
        subject.warn_energy_gain(sheet, joint, closest, &work)?;
        let lost = work.lost();
        // A loss below its error is 0.
        Ok(match lost.relative_error() < 1.0 {
            true => [work.spent.value(), lost.value(), work.loss_factor()?],
            false => [work.spent.value(), 0.0, 0.0],
        })
    });
    let by = |text: &str| subject.by(joint.law(), text);
    match works.map(|works| works.map(rounded)) {
        Ok([spent, lost, factor]) => sheet.result(by(&format!(
            "closing takes {spent} J, of which {lost} J are dissipated in the first cycle (loss factor {factor})"
        ))),
        Err(error) => {
            sheet.warn(Code::NoValue, by(&format!("the work is unavailable: {error}")));
        }
    }
}

/// Adds where contact ends.
fn report_end(
    sheet: &mut Sheet,
    subject: &Subject<'_>,
    law: UnloadingLaw,
    end: &Result<f64, ContactError>,
) {
    let by = |text: &str| subject.by(law, text);
    let few = "fewer than one asperity touches on average";
    match end {
        Ok(0.0) => {
            sheet.warn(Code::FewContacts, by(&format!("even at the closest approach, {few}")));
        }
        Ok(end) => {
            let end = rounded(*end);
            let text = format!("contact ends at a retreat of {end} m, beyond which {few}");
            sheet.result(by(&text));
        }
        Err(error) => {
            sheet.note(Code::NoValue, by(&format!("the end of contact was not found: {error}")));
        }
    }
}

/// Adds the rows of one law, and warnings of blanks.
fn add_rows(
    sheet: &mut Sheet,
    subject: &Subject<'_>,
    opening: &Unloading,
    retreats: &[f64],
    with_area: bool,
) -> Result<(), ContactError> {
    let (scene, law) = (subject.scene()?, opening.law());
    let closest = subject.place(opening.closest(), SeparationUnit::Sigma)?;
    let (name, mut blanks) = (law.to_string(), Blanks::default());
    // Blank where the integral fails.
    let mut value = |found: Result<Evaluation, ContactError>| match found {
        Ok(found) => Ok(Some(found.value())),
        Err(error @ ContactError::Integral { .. }) => {
            blanks.count("value", kind(&error), error.to_string());
            Ok(None)
        }
        Err(error) => Err(error),
    };
    for &retreat in retreats {
        let force = value(opening.force(retreat))?;
        let pressure = force.map(|force| force / scene.nominal_area);
        let separation = closest + retreat / scene.surface.asperity_height_std;
        let mut numbers = vec![Some(retreat), Some(separation), force, pressure];
        if with_area {
            numbers.push(if has_area(law) { value(opening.area(retreat))? } else { None });
        }
        numbers.push(value(opening.stiffness(retreat))?);
        numbers.push(value(opening.contacts(retreat))?);
        sheet.add(&[subject.id(), &name], numbers);
    }
    blanks.texts(retreats.len()).for_each(|text| sheet.warn(Code::NoValue, subject.by(law, &text)));
    Ok(())
}
