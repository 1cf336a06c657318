//! The opening of a scan along its own path, by boundary elements.

use std::mem::discriminant;

use asperity::bem::BemError;
use asperity::{At, Code, Separation, SeparationUnit, linspace};

use crate::blanks::Blanks;
use crate::number::rounded;
use crate::slip_scan::load_case;
use crate::subject::{Outcome, Retreats, Subject, metres};
use crate::{Sheet, Watch};

/// Number of default retreats: each takes some solutions.
const POINTS: usize = 21;

/// Adds the rows of the scan as it opens from its greatest load, by default to the end of contact.
///
/// # Errors
/// The errors of boundary elements on the scene, and where no retreat is solved.
pub(crate) fn open_scan(
    subject: &Subject<'_>,
    closest: At,
    retreats: Option<Retreats<'_>>,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Outcome {
    let (id, scene) = (subject.id(), &subject.file.scene);
    let retreats = retreats.map(|given| metres(sheet, scene, given));
    let bem = subject.file.bem()?;
    sheet.findings.extend(bem.note());
    let greatest = load_case(scene, closest)?;
    watch.progress(&format!("{id}: the greatest load"));
    let path = bem.elements(&scene.interface)?.unloading_from(greatest)?;
    sheet.report(subject.file, path.notes().iter().cloned().collect());
    let end = path.last_contact();
    let retreats = retreats.unwrap_or_else(|| linspace(0.0, end, POINTS));
    let found = path.at_retreats(&retreats, |progress| {
        watch.step(&format!("{id}: retreat {} of {}", progress.done + 1, retreats.len()))
    });
    let mut blanks = Blanks::default();
    for (retreat, found) in retreats.iter().zip(found) {
        let found = match found {
            Ok(found) => found,
            Err(BemError::Cancelled) => continue,
            Err(error) => {
                let text = format!("at a retreat of {} m: {error}", rounded(*retreat));
                blanks.count("value", discriminant(&error), text);
                continue;
            }
        };
        let place = Separation::metres(found.mean_gap).from_surface_mean();
        let stiffness = found.stiffness.transpose().unwrap_or_else(|error| {
            blanks.count("stiffness", discriminant(&error), format!("no stiffness: {error}"));
            None
        });
        let (pressure, area) = (found.mean_pressure, scene.nominal_area);
        let separation = subject.place(place, SeparationUnit::Sigma)?;
        let numbers = [*retreat, separation, pressure * area, pressure, found.area * area];
        let stiffness = stiffness.map(|stiffness| stiffness * area);
        sheet.add(&[id, "own"], numbers.map(Some).into_iter().chain([stiffness]));
    }
    for text in blanks.texts(retreats.len()) {
        sheet.warn(Code::NoValue, format!("{id}: {text}"));
    }
    if sheet.rows.is_empty() {
        return Err("no retreat was solved".into());
    }
    let (end, text) = (rounded(end), "where the last pixel parts");
    sheet.result(format!("{id}: contact ends at a retreat of {end} m, {text}"));
    Ok(())
}
