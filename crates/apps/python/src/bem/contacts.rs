//! Contacts of a scan under loads and on its way back, and models compared with them.

use std::collections::BTreeMap;

use asperity::bem::{BemError, Leak};
use asperity::{AsWritten, ContactModel, Dialect, Findings, Quantity, Request, linspace};
use asperity_answer::{self as answer, Press, Sheet, Watch, compared, truth_of};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Arguments, Pressed, Pressing, load_cases, options};
use crate::ask::asked::arrays;
use crate::ask::long::run_interruptible;
use crate::convert::{Quantities, refused, value_error, warn_unless};
use crate::model::engine::{Engines, answered, models_among};
use crate::scene::SceneFile;
use crate::tables::{Table, table, warn_of};

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
    run_interruptible(py, |stop| {
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
    notes.iter().try_for_each(|note| warn_unless(py, &file.spec.accept, note, 1))?;
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
    let (retreats, end, found) = run_interruptible(py, |stop| -> Result<_, BemError> {
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

/// Models of a scene, or these, compared with boundary elements on its scan.
#[pyfunction]
pub(crate) fn truth<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    pressures: Vec<f64>,
    pressing: Pressing,
    engines: Engines,
    quantities: Quantities,
    refine: bool,
) -> PyResult<Table<'py>> {
    let file = &*scene.0;
    let Pressed { bem, .. } = Pressed::of_scene(py, file.clone(), options(pressing)?)?;
    let quantities = compared(&quantities.0).map_err(value_error)?;
    let mut sheet = Sheet::default();
    let models = models_among(file, &engines, &[], &mut sheet)?;
    let of = (file, "truth", &bem);
    let found = run_interruptible(py, |stop| {
        truth_of(of, &models, &pressures, &quantities, refine, &mut sheet, stop)
    })?;
    answered(found, &engines, &sheet)?;
    warn_of(py, file, &sheet)?;
    table(py, &sheet)
}
