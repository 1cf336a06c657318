//! Contacts of a scan under loads and on its way back, and models compared with them.

use std::collections::BTreeMap;

use asperity::bem::{BemError, Leak};
use asperity::{AsWritten, ContactModel, Dialect, Findings, Quantity, Request, linspace};
use asperity_answer::{
    self as answer, Press, Truths, Watch, beside_table, compared, heads, summary,
};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Arguments, Pressed, Pressing, load_cases, options};
use crate::ask::asked::arrays;
use crate::ask::long::run_interruptible;
use crate::convert::{
    Object, Quantities, object, refused, value_error, warn, warn_text, warn_unless,
};
use crate::model::engine::{Engines, models_among, raise_own};
use crate::scene::SceneFile;

/// The fields of the package's class, but for the maps; pressures and gaps of all pixels, if kept;
/// rows and columns.
type Contacts<'py> = (Bound<'py, PyDict>, Option<[Bound<'py, PyArray1<f64>>; 2]>, [usize; 2]);

/// The name of a field: that of its quantity, or of its column without the unit.
fn field(head: &str) -> String {
    let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.column() == head);
    let units = ["_N", "_m", "_m3_per_s"];
    let own = || units.iter().find_map(|unit| head.strip_suffix(unit)).unwrap_or(head).into();
    quantity.map_or_else(own, |quantity| quantity.to_string().replace('-', "_"))
}

/// Solves contacts at mean pressures, loads or mean gaps.
#[pyfunction]
pub(crate) fn bem<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    given: (String, Vec<f64>),
    maps_and_mask: (bool, bool),
    quantities: Option<Quantities>,
    leak: Option<(f64, f64)>,
) -> PyResult<Contacts<'py>> {
    let (maps, mask) = maps_and_mask;
    let leak = leak.map(|(viscosity, drop)| Leak::new(viscosity, drop)).transpose();
    let leak = leak.map_err(value_error)?;
    let quantities = quantities.map_or(vec![], |quantities| quantities.0);
    let Pressed { bem, file } = Pressed::new(pressed)?;
    let scene = &file.scene;
    let elements = bem.elements(&scene.interface).map_err(refused)?;
    let (area, pixels) = (scene.nominal_area, bem.map().heights().len());
    // Refuses what boundary elements or the interface lack before anything is solved.
    let request = Request::new(quantities.iter().copied());
    bem.compile(scene, &request).map_err(refused)?;
    let all = load_cases(given, area);
    let press = Press { leak, ..Press::new(&file, &bem, &all, &quantities) };
    let heads = press.heads();
    let missing = |numbers: usize| vec![f64::NAN; numbers * all.len()];
    let mut maps = maps.then(|| [missing(pixels), missing(pixels)]);
    let mut columns: Vec<Vec<f64>> = vec![missing(1); heads.len()];
    let (mut notes, mut failed, mut failures) = (Findings::default(), None, BTreeMap::new());
    run_interruptible(py, None, |stop| {
        let mut fail = |index, reason: String| match mask {
            true => drop(failures.insert(index, reason)),
            false => {
                // This error is raised, so the other contacts are not needed.
                stop.stop();
                failed.get_or_insert(value_error(reason));
            }
        };
        press.each(
            &elements,
            |_| stop.step(""),
            |index, solved| match solved {
                Ok(answer::Pressed { cells, notes: of_one, solution }) => {
                    for (column, cell) in columns.iter_mut().zip(&cells) {
                        column[index] = cell.number().unwrap_or(f64::NAN);
                        let reason = cell.reason().map(|reason| AsWritten.say(reason));
                        reason.into_iter().for_each(|reason| fail(index, reason));
                    }
                    let kept = maps.iter_mut().flatten();
                    for (all, map) in kept.zip([&solution.pressures, &solution.gaps]) {
                        all[index * pixels..][..pixels].copy_from_slice(map);
                    }
                    notes.extend(of_one);
                }
                Err(error) => fail(index, error.to_string()),
            },
        );
    })?;
    if let Some(error) = failed {
        return Err(error);
    }
    notes.extend(leak.iter().flat_map(Leak::findings));
    notes.iter().try_for_each(|note| warn_unless(py, &file.accept, note, 1))?;
    let fields = arrays(py, heads.iter().map(|head| field(head)).zip(columns))?;
    fields.set_item("failures", failures)?;
    fields.set_item("boundary", bem.continuation().name())?;
    fields.set_item("nominal_area", area)?;
    let maps = maps.map(|maps| maps.map(|map| PyArray1::from_vec(py, map)));
    Ok((fields, maps, bem.map().shape()))
}

/// Solves the contact at a mean pressure, load or mean gap, and after retreats \[m\] from it: those
/// given, or `points` of them to the end of contact. The fields of the package's class.
#[pyfunction]
pub(crate) fn bem_unloading<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    given: (String, Vec<f64>),
    retreats: Option<Vec<f64>>,
    points: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let Pressed { bem, file } = Pressed::new(pressed)?;
    let scene = &file.scene;
    let elements = bem.elements(&scene.interface).map_err(refused)?;
    let area = scene.nominal_area;
    let greatest = load_cases(given, area).remove(0);
    let (retreats, end, found) = run_interruptible(py, None, |stop| -> Result<_, BemError> {
        let path = elements.unloading_from(greatest)?;
        let end = path.last_contact();
        let retreats = retreats.unwrap_or_else(|| linspace(0.0, end, points));
        if stop.is_stopped() {
            return Err(BemError::Cancelled);
        }
        let found = path.at_retreats(&retreats, |_| stop.step(""));
        Ok((retreats, end, found.into_iter().collect::<Result<Vec<_>, _>>()?))
    })?
    .map_err(value_error)?;
    let stiffness = found.iter().map(|contact| match &contact.stiffness {
        Some(Ok(stiffness)) => Ok(stiffness * area),
        Some(Err(error)) => Err(value_error(error)),
        None => Ok(f64::NAN),
    });
    let open = found.iter().map(|contact| contact.mean_open_gap.unwrap_or(f64::NAN));
    let columns = [
        ("retreat", retreats),
        ("load", found.iter().map(|contact| contact.mean_pressure * area).collect()),
        ("pressure", found.iter().map(|contact| contact.mean_pressure).collect()),
        ("area_fraction", found.iter().map(|contact| contact.area).collect()),
        ("mean_gap", found.iter().map(|contact| contact.mean_gap).collect()),
        ("mean_open_gap", open.collect()),
        ("stiffness", stiffness.collect::<PyResult<_>>()?),
    ];
    let fields = arrays(py, columns)?;
    fields.set_item("last_contact", end)?;
    fields.set_item("boundary", bem.continuation().name())?;
    fields.set_item("nominal_area", area)?;
    Ok(fields)
}

/// Sentences about the nearest models, and beside solved surfaces.
type Sentences = (Option<String>, Vec<String>);
/// Heads, rows, sentences, the reasons of missing models by id, the reasons of failed pressures by
/// place, and the boundary.
type TruthFields<'py> = (
    Vec<&'static str>,
    Object<'py>,
    Sentences,
    BTreeMap<String, String>,
    BTreeMap<usize, String>,
    &'static str,
);

/// Models of a scene compared with boundary elements on its scan.
#[pyfunction]
pub(crate) fn truth<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    pressures: Vec<f64>,
    pressing: Pressing,
    engines: Engines,
    quantities: Quantities,
    refine_and_mask: (bool, bool),
) -> PyResult<TruthFields<'py>> {
    let (scene, (refine, mask)) = (&*scene.0, refine_and_mask);
    let Pressed { bem, .. } = Pressed::of_scene(py, scene.clone(), options(pressing)?)?;
    let quantities = compared(&quantities.0).map_err(value_error)?;
    let (models, left_out) = models_among(scene, &engines)?;
    let found = run_interruptible(py, None, |stop| {
        Truths::solve(scene, &bem, &models, &pressures, &quantities, refine, stop)
    })?;
    let found = found.map_err(value_error)?;
    if let Some((_, error)) = found.failed.first().filter(|_| !mask) {
        return Err(value_error(error));
    }
    let missing = found.missing();
    raise_own(py, &engines, missing.iter().map(|(_, why)| *why))?;
    scene.accepted(found.findings()).iter().try_for_each(|note| warn(py, note, 1))?;
    let left_out = left_out.into_iter();
    let mut refused: BTreeMap<String, String> =
        left_out.map(|model| (model.id, model.reason.to_string())).collect();
    for (id, why) in missing {
        warn_text(py, &scene.accept, "no-value", format!("{id}: {why}"))?;
        let reasons = refused.entry(id.into()).or_default();
        *reasons += if reasons.is_empty() { "" } else { "; " };
        *reasons += &why.to_string();
    }
    let failures = found.failed.iter().map(|(place, error)| (*place, error.to_string())).collect();
    let rows = object(py, &found.rows(scene.scene.nominal_area, &quantities))?;
    let nearest = (!models.is_empty() && !found.found.is_empty()).then(|| summary(&found.found));
    let sentences = (nearest, py.detach(|| beside_table(scene, &found.found)));
    let boundary = bem.continuation().name();
    Ok((heads(&quantities), rows, sentences, refused, failures, boundary))
}
