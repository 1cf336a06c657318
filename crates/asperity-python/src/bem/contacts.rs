//! Contacts of a scan under loads and on its way back, and models compared with them.

use std::collections::BTreeMap;

use asperity::bem::{Bem, BemError, ContactSummary, Leak, Solution};
use asperity::joints::UnloadingLaw;
use asperity::{ContactModel, Findings, Request, Severity, Tolerance, linspace};
use asperity_answer::{
    Amplitude, FLOWS, Sheet, Slip, Subject, Truths, Watch, beside_table, once, stick_map, summary,
};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Arguments, Pressed, load_cases};
use crate::ask::asked::arrays;
use crate::ask::long::run_interruptible;
use crate::convert::axis::Axis;
use crate::convert::{
    Object, Quantities, object, refused, value_error, warn, warn_text, warn_unless,
};
use crate::scene::{SceneFile, models_among};
use crate::tables::columns;

/// The fields of the package's class, but for the maps; pressures and gaps of all pixels, if kept;
/// rows and columns.
type Contacts<'py> = (Bound<'py, PyDict>, Option<[Bound<'py, PyArray1<f64>>; 2]>, [usize; 2]);

/// The name of a number of a solution, and the number.
type Head = (&'static str, fn(&Solution) -> f64);

/// The numbers of a solution by name; the load still over the area.
const HEADS: [Head; 9] = [
    ("load", |s| s.mean_pressure),
    ("pressure", |s| s.mean_pressure),
    ("area_fraction", |s| s.area),
    ("area_fraction_pixels", |s| s.pixel_area),
    ("plastic_fraction", |s| s.plastic_area),
    ("mean_gap", |s| s.mean_gap),
    ("patches", |s| s.patches.len() as f64),
    ("iterations", |s| s.iterations as f64),
    ("residual", |s| s.residual),
];

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
    let mut quantities = quantities.map_or(vec![], |quantities| quantities.0);
    quantities.extend(leak.iter().flat_map(|_| FLOWS.map(|(gap, ..)| gap)));
    let quantities = once(&quantities);
    let Pressed { bem, scene, accept } = Pressed::new(pressed)?;
    let elements = bem.elements(&scene.interface).map_err(refused)?;
    let area = scene.nominal_area;
    // Refuses what boundary elements or the interface lack before anything is solved.
    let request = Request::new(quantities.iter().copied());
    bem.compile(&scene, &request).map_err(refused)?;
    let all = load_cases(given, area);
    let pixels = bem.map().heights().len();
    let missing = |numbers: usize| vec![f64::NAN; numbers * all.len()];
    let mut maps = maps.then(|| [missing(pixels), missing(pixels)]);
    let mut columns: Vec<Vec<f64>> = vec![missing(1); HEADS.len() + quantities.len()];
    let (mut notes, mut failed, mut failures) = (Findings::default(), None, BTreeMap::new());
    run_interruptible(py, None, |stop| {
        let mut fail = |index, error: PyErr, message| match mask {
            true => drop(failures.insert(index, message)),
            false => {
                // This error is raised, so the other contacts are not needed.
                stop.stop();
                failed.get_or_insert(error);
            }
        };
        elements.solve_each(
            &all,
            |_| stop.step(""),
            |index, solution| match solution {
                Ok(solution) => {
                    let (heads, of_joints) = columns.split_at_mut(HEADS.len());
                    for (column, (_, number)) in heads.iter_mut().zip(HEADS) {
                        column[index] = number(&solution);
                    }
                    heads[0][index] *= area;
                    let summary =
                        (!quantities.is_empty()).then(|| elements.summary(&solution, &quantities));
                    for (column, &quantity) in of_joints.iter_mut().zip(&quantities) {
                        match summary.as_ref().map(|summary| summary.evaluate(quantity, &scene)) {
                            Some(Ok(Some(found))) => column[index] = found.value(),
                            Some(Err(error)) => {
                                fail(index, refused(error.clone()), error.to_string())
                            }
                            _ => {}
                        }
                    }
                    let kept = maps.iter_mut().flatten();
                    for (all, map) in kept.zip([&solution.pressures, &solution.gaps]) {
                        all[index * pixels..][..pixels].copy_from_slice(map);
                    }
                    notes.extend(solution.notes);
                    notes.extend(summary.iter().flat_map(ContactSummary::sealed));
                }
                Err(error) => fail(index, value_error(&error), error.to_string()),
            },
        );
    })?;
    if let Some(error) = failed {
        return Err(error);
    }
    notes.extend(leak.and_then(|leak| leak.finding()));
    notes.iter().try_for_each(|note| warn_unless(py, &accept, note, 1))?;
    let names = HEADS.iter().map(|(name, _)| (*name).to_string());
    let names = names.chain(quantities.iter().map(|q| q.to_string().replace('-', "_")));
    let mut names: Vec<String> = names.collect();
    for (leak, (gap, direction, head)) in leak.iter().flat_map(|leak| FLOWS.map(|one| (leak, one)))
    {
        let gaps = quantities.iter().position(|one| *one == gap).map(|k| &columns[HEADS.len() + k]);
        let flow = |gap: &f64| leak.flow(*gap, bem.map(), direction);
        let flows: Vec<f64> = gaps.into_iter().flatten().map(flow).collect();
        columns.push(flows);
        names.push(head.trim_end_matches("_m3_per_s").into());
    }
    let fields = arrays(py, names.into_iter().zip(columns))?;
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
    let Pressed { bem, scene, .. } = Pressed::new(pressed)?;
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
    let columns = [
        ("retreat", retreats),
        ("load", found.iter().map(|contact| contact.mean_pressure * area).collect()),
        ("pressure", found.iter().map(|contact| contact.mean_pressure).collect()),
        ("area_fraction", found.iter().map(|contact| contact.area).collect()),
        ("mean_gap", found.iter().map(|contact| contact.mean_gap).collect()),
        ("stiffness", stiffness.collect::<PyResult<_>>()?),
    ];
    let fields = arrays(py, columns)?;
    fields.set_item("last_contact", end)?;
    fields.set_item("boundary", bem.continuation().name())?;
    fields.set_item("nominal_area", area)?;
    Ok(fields)
}

/// The loop of a cycle of this amplitude \[m\] on the scan of a scene under a load or pressure, and
/// whether each pixel slips (1) or sticks (2) at the amplitude. The fields of the package's class,
/// rows and columns.
#[pyfunction]
pub(crate) fn bem_slip<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    given: (Axis, f64),
    friction: f64,
    cycle: (f64, usize),
) -> PyResult<(Bound<'py, PyDict>, [usize; 2])> {
    let (file, model) = (&*scene.0, scene.0.model(Bem::ID).map_err(value_error)?);
    let ((axis, number), (amplitude, points)) = (given, cycle);
    let (at, tolerance) = (axis.at(number, file.separation_from), Tolerance::default());
    let subject = Subject { file, name: "", id: Bem::ID, model: &model, tolerance };
    let slip = Slip { subject, law: UnloadingLaw::Hertz, friction };
    let (mut sheet, cycle) = (Sheet::default(), [Amplitude::Shift(amplitude)]);
    let states = run_interruptible(py, None, |stop| {
        slip.answer(&[at], &cycle, points, &mut sheet, stop)?;
        stick_map(&subject, at, friction, amplitude, stop)
    })?;
    let states = states.map_err(value_error)?;
    let mut warnings = sheet.findings.iter().filter(|found| found.severity < Severity::Note);
    warnings.try_for_each(|found| warn_unless(py, &file.accept, found, 1))?;
    let fields = columns(py, &sheet)?;
    fields.set_item("states", PyArray1::from_vec(py, states))?;
    Ok((fields, file.bem(None, false).map_err(value_error)?.map().shape()))
}

/// Sentences about the nearest models, and beside solved surfaces.
type Sentences = (Option<String>, Vec<String>);
/// Rows, sentences, the reasons of missing models by id, the reasons of failed pressures by place,
/// and the boundary.
type TruthFields<'py> =
    (Object<'py>, Sentences, BTreeMap<String, String>, BTreeMap<usize, String>, &'static str);

/// Models of a scene compared with boundary elements on its scan.
#[pyfunction]
pub(crate) fn truth<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    pressures: Vec<f64>,
    elastic: bool,
    boundary: Option<&str>,
    models: Option<Vec<String>>,
    refine_and_mask: (bool, bool),
) -> PyResult<TruthFields<'py>> {
    let (refine, mask) = refine_and_mask;
    let scene = &*scene.0;
    let Pressed { bem, .. } = Pressed::of_scene(py, scene, boundary, elastic)?;
    let (models, left_out) = models_among(scene, models)?;
    let found = run_interruptible(py, None, |stop| {
        Truths::solve(scene, &bem, &models, &pressures, refine, stop)
    })?;
    let found = found.map_err(value_error)?;
    if let Some((_, error)) = found.failed.first().filter(|_| !mask) {
        return Err(value_error(error));
    }
    scene.accepted(found.findings()).iter().try_for_each(|note| warn(py, note, 1))?;
    let mut refused: BTreeMap<String, String> =
        left_out.into_iter().map(|model| (model.id, model.reason.to_string())).collect();
    for (id, why) in found.missing() {
        if !refused.contains_key(id) {
            warn_text(py, &scene.accept, "no-value", format!("{id}: {why}"))?;
            refused.insert(id.into(), why.to_string());
        }
    }
    let failures = found.failed.iter().map(|(place, error)| (*place, error.to_string())).collect();
    let rows = object(py, &found.rows(scene.scene.nominal_area))?;
    let nearest =
        (!models.is_empty() && !found.found.is_empty()).then(|| summary(&found.found, &found.half));
    let sentences = (nearest, py.detach(|| beside_table(scene, &found.found)));
    Ok((rows, sentences, refused, failures, bem.continuation().name()))
}
