//! Boundary elements on a scan, and models compared with them.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};

use asperity::bem::{Bem, BemError, ContactSummary, Continuation, LoadCase, Solution};
use asperity::{ContactModel, ContactState, Described, Diagnostics, Model, Request, Truth};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::ask::long::{SIGNAL_INTERVAL, pool};
use crate::convert::error::{refused, value_error, warn};
use crate::model::engine::quantities_of;
use crate::records::{Interface, instance, with_article};
use crate::scene::SceneFile;
use crate::topography::Topography;

/// The scan of a scene, or a topography with the two bodies and the form to remove.
pub(crate) enum Scan<'a> {
    Scene(&'a asperity_scene::SceneFile),
    Topography(&'a Topography, asperity::Interface, Option<&'a str>),
}

impl<'a> Scan<'a> {
    pub(crate) fn new(
        surface: &'a Bound<'_, PyAny>,
        interface: Option<&Bound<'_, PyAny>>,
        level: Option<&'a str>,
    ) -> PyResult<Self> {
        if let Ok(scene) = surface.cast::<SceneFile>() {
            return match interface {
                None => Ok(Self::Scene(&scene.get().0)),
                Some(_) => Err(PyTypeError::new_err(
                    "interface was given beside a scene, which has its own",
                )),
            };
        }
        let Ok(topography) = surface.cast::<Topography>() else {
            let found = with_article(surface);
            let reason = format!("surface must be a Topography or a Scene, not {found}");
            return Err(PyTypeError::new_err(reason));
        };
        let Some(interface) = interface else {
            let needed = "a Topography has none, pass an asperity.Interface";
            return Err(PyTypeError::new_err(format!("interface is missing: {needed}")));
        };
        let interface = instance::<Interface>("interface", interface)?.get().0;
        Ok(Self::Topography(topography.get(), interface, level))
    }

    pub(crate) fn bem(
        &self,
        py: Python<'_>,
        boundary: Option<&str>,
        elastic: bool,
    ) -> PyResult<(Bem, asperity::Interface)> {
        let named = |name: &str| {
            let required = "\"periodic\", \"periodic-part\" or \"free\" was required";
            let unknown = || value_error(format!("boundary is {name:?}: {required}"));
            Continuation::from_name(name).ok_or_else(unknown)
        };
        let boundary = boundary.map(named).transpose()?;
        match self {
            Self::Scene(file) => {
                let bem = file.bem(boundary, elastic).map_err(value_error)?;
                Ok((bem, file.scene.interface))
            }
            Self::Topography(topography, interface, level) => {
                let level = topography.form(py, *level, 1)?;
                // A plane taken from a periodic surface would add steps.
                let declared = topography.0.is_periodic().then_some(Continuation::Periodic);
                let boundary = boundary.or(declared);
                let periodic = [boundary, declared].contains(&Some(Continuation::Periodic));
                let scan = topography.0.clone().with_periodic(periodic);
                let levelled = scan.levelled(level).map_err(value_error)?;
                let map = asperity_scene::height_map(&levelled).map_err(|error| {
                    match levelled.missing_share() > 0.0 {
                        true => value_error(format!("{error}: use Topography.fill()")),
                        false => value_error(error),
                    }
                })?;
                Ok((Bem::new(map, boundary, elastic), *interface))
            }
        }
    }

    /// The scene whose nominal area and interface quantities use.
    fn contact(&self, bem: &Bem, interface: asperity::Interface) -> asperity::Scene {
        match self {
            Self::Scene(file) => file.scene.clone(),
            Self::Topography(..) => {
                // Boundary elements use no asperities.
                let surface = asperity::Surface::new(1.0, 1.0, 1.0);
                asperity::Scene::new(interface, surface, bem.map().area())
            }
        }
    }

    /// The area of the loads: the nominal area of a scene, or that of a topography.
    pub(crate) fn area(&self, bem: &Bem) -> f64 {
        match self {
            Self::Scene(file) => file.scene.nominal_area,
            Self::Topography(..) => bem.map().area(),
        }
    }
}

/// Numbers of the contacts by name, NaN where a contact failed; pressures and gaps of all pixels,
/// if kept; rows and columns; the reasons of failures by place; the boundary; the area of loads.
type Contacts<'py> = (
    Bound<'py, PyDict>,
    Option<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)>,
    [usize; 2],
    BTreeMap<usize, String>,
    &'static str,
    f64,
);

/// Solves contacts at mean pressures, loads or mean gaps.
#[pyfunction]
pub(crate) fn bem<'py>(
    scan: (Bound<'py, PyAny>, Option<Bound<'py, PyAny>>, Option<String>),
    given: &str,
    values: Vec<f64>,
    elastic: bool,
    boundary: Option<&str>,
    maps_and_mask: (bool, bool),
    quantities: Vec<String>,
) -> PyResult<Contacts<'py>> {
    let (py, (maps, mask)) = (scan.0.py(), maps_and_mask);
    let quantities = quantities_of(&quantities)?;
    let scan = Scan::new(&scan.0, scan.1.as_ref(), scan.2.as_deref())?;
    let (bem, interface) = scan.bem(py, boundary, elastic)?;
    bem.note().map_or(Ok(()), |note| warn(py, &note, 1))?;
    let elements = bem.elements(&interface).map_err(refused)?;
    let area = scan.area(&bem);
    let contact = scan.contact(&bem, interface);
    // Refuses what boundary elements or the interface lack before anything is solved.
    let request = Request::new(quantities.iter().copied());
    bem.compile(&contact, &request).map_err(refused)?;
    let of = |value| match given {
        "gap" => LoadCase::MeanGap(value),
        "load" => LoadCase::MeanPressure(value / area),
        _ => LoadCase::MeanPressure(value),
    };
    let all: Vec<LoadCase> = values.into_iter().map(of).collect();
    let mut solved: Vec<Option<Solution>> = vec![None; all.len()];
    let mut summaries: Vec<Option<ContactSummary>> = vec![None; all.len()];
    let (mut notes, mut failed, mut failures) = (Diagnostics::default(), None, BTreeMap::new());
    run_interruptible(py, |stop| {
        elements.solve_each(
            &all,
            |_| continue_unless(stop),
            |index, solution| match solution {
                Ok(mut solution) => {
                    if !quantities.is_empty() {
                        summaries[index] = Some(elements.summary(&solution, &quantities));
                    }
                    notes.extend(solution.notes.iter().cloned());
                    if !maps {
                        (solution.pressures, solution.gaps) = (vec![], vec![]);
                    }
                    solved[index] = Some(solution);
                }
                Err(error) if mask => {
                    failures.insert(index, error.to_string());
                }
                Err(error) => {
                    // This error is raised, so the other contacts are not needed.
                    stop.store(true, Ordering::Relaxed);
                    failed.get_or_insert(error);
                }
            },
        );
    })?;
    if let Some(error) = failed {
        return Err(value_error(error));
    }
    notes.iter().try_for_each(|note| warn(py, note, 1))?;
    let numbers = PyDict::new(py);
    let add = |name: &str, of: &dyn Fn(&Solution) -> f64| {
        let of = |solution: &Option<Solution>| solution.as_ref().map_or(f64::NAN, of);
        numbers.set_item(name, PyArray1::from_vec(py, solved.iter().map(of).collect()))
    };
    add("load", &|s| s.mean_pressure * area)?;
    add("pressure", &|s| s.mean_pressure)?;
    add("area_fraction", &|s| s.area)?;
    add("area_fraction_pixels", &|s| s.pixel_area)?;
    add("plastic_fraction", &|s| s.plastic_area)?;
    add("mean_gap", &|s| s.mean_gap)?;
    add("patches", &|s| s.patches.len() as f64)?;
    add("iterations", &|s| s.iterations as f64)?;
    add("residual", &|s| s.residual)?;
    for quantity in quantities {
        let mut values = vec![f64::NAN; summaries.len()];
        for (index, (value, summary)) in values.iter_mut().zip(&summaries).enumerate() {
            let Some(summary) = summary else { continue };
            match summary.evaluate(quantity, &contact) {
                Ok(found) => *value = found.map_or(f64::NAN, |found| found.value()),
                Err(error) if mask => {
                    failures.insert(index, error.to_string());
                }
                Err(error) => return Err(refused(error)),
            }
        }
        let name = quantity.to_string().replace('-', "_");
        numbers.set_item(name, PyArray1::from_vec(py, values))?;
    }
    let map = |of: &dyn Fn(&Solution) -> &Vec<f64>| {
        let pixels = bem.map().heights().len();
        let all = PyArray1::zeros(py, solved.len() * pixels, false);
        let mut numbers = all.readwrite();
        for (part, solution) in numbers.as_slice_mut()?.chunks_mut(pixels).zip(&solved) {
            match solution {
                Some(solution) => part.copy_from_slice(of(solution)),
                None => part.fill(f64::NAN),
            }
        }
        drop(numbers);
        PyResult::Ok(all)
    };
    let maps = match maps {
        true => Some((map(&|s| &s.pressures)?, map(&|s| &s.gaps)?)),
        false => None,
    };
    Ok((numbers, maps, bem.map().shape(), failures, bem.continuation().name(), area))
}

/// Area fraction, mean gap [m] and stiffness [N/m].
type State = (Option<f64>, Option<f64>, Option<f64>);
/// Pressure [Pa], a model's id, its numbers and their deviations from boundary elements.
type Row = (f64, String, State, State);
/// Sentences about the nearest models, and beside solved surfaces.
type Sentences = (Option<String>, Vec<String>);
/// Rows, sentences, the reasons of missing models by id, the reasons of failed pressures by place,
/// and the boundary.
type Truths =
    (Vec<Row>, Sentences, BTreeMap<String, String>, BTreeMap<usize, String>, &'static str);

/// Models of a scene compared with boundary elements on its scan.
#[pyfunction]
pub(crate) fn truth(
    py: Python<'_>,
    scene: &SceneFile,
    pressures: Vec<f64>,
    elastic: bool,
    boundary: Option<&str>,
    models: Option<Vec<String>>,
    refine_and_mask: (bool, bool),
) -> PyResult<Truths> {
    let (refine, mask) = refine_and_mask;
    let scene = &*scene.0;
    let (bem, _) = Scan::Scene(scene).bem(py, boundary, elastic)?;
    bem.note().map_or(Ok(()), |note| warn(py, &note, 1))?;
    let (models, left_out) = match models {
        None => scene.models_beside_bem(),
        Some(ids) => {
            let all = ids.iter().map(|id| scene.model(id));
            (all.collect::<Result<_, _>>().map_err(value_error)?, vec![])
        }
    };
    let mut failures = BTreeMap::new();
    let mut solved = |bem: &Bem, models: &[Model]| -> PyResult<Vec<Option<Truth>>> {
        let found = run_interruptible(py, |stop| {
            asperity::compare_with_bem(&scene.scene, bem, &pressures, models, |_| {
                continue_unless(stop)
            })
        })?;
        let found = found.map_err(refused)?.into_iter().enumerate();
        let kept = |(k, one): (usize, Result<Truth, BemError>)| match one {
            Err(error) if !mask => Err(value_error(error)),
            Err(error) => {
                failures.entry(k).or_insert(error.to_string());
                Ok(None)
            }
            Ok(one) => Ok(Some(one)),
        };
        found.map(kept).collect()
    };
    let found = solved(&bem, &models)?;
    let half = match refine {
        true => solved(&bem.half_grid().map_err(value_error)?, &[])?,
        false => vec![None; found.len()],
    };
    let (found, half): (Vec<Truth>, Vec<_>) =
        found.into_iter().zip(half).filter_map(|(found, half)| Some((found?, half))).unzip();
    let of_truth = |truth: &Truth| {
        let refused = truth.refused.iter().map(|(_, why)| why.clone());
        truth.notes.iter().cloned().chain(refused).collect::<Vec<_>>()
    };
    let notes: Diagnostics = found.iter().flat_map(of_truth).collect();
    notes.by_cause().iter().try_for_each(|note| warn(py, note, 1))?;
    let mut refused: BTreeMap<String, String> =
        left_out.into_iter().map(|model| (model.id, model.reason.to_string())).collect();
    for (model, why) in found.iter().flat_map(|truth| &truth.missing) {
        if !refused.contains_key(model.id()) {
            warn(py, format!("{model}: {why}"), 1)?;
            refused.insert(model.id().into(), why.to_string());
        }
    }
    let state = |s: ContactState| (s.area_fraction, s.mean_gap, s.stiffness);
    let rows = |(k, truth): (usize, &Truth)| -> Vec<Row> {
        let models = truth.models.iter().map(|(model, numbers)| (model.id(), numbers));
        let half = half[k].as_ref().map(|half| ("bem-half-grid", &half.bem));
        let all = std::iter::once(("bem", &truth.bem)).chain(half).chain(models);
        let row = |(id, numbers): (&str, &ContactState)| {
            (truth.pressure, id.into(), state(*numbers), state(truth.deviation(numbers)))
        };
        all.map(row).collect()
    };
    let nearest = (!models.is_empty() && !found.is_empty()).then(|| asperity::summary(&found));
    let sentences = (nearest, py.detach(|| scene.beside_table(&found)));
    let rows = found.iter().enumerate().flat_map(rows).collect();
    Ok((rows, sentences, refused, failures, bem.continuation().name()))
}

/// Runs `work` on the threads of this process while this thread, which gets the signals, checks for
/// them; a signal sets the flag that stops `work`.
pub(crate) fn run_interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> T + Send,
) -> PyResult<T> {
    let (stop, threads) = (AtomicBool::new(false), pool(None)?);
    let run = |done: Sender<T>| {
        // The receiver waits until the work ends.
        let _ = done.send(threads.install(|| work(&stop)));
    };
    let wait = |answer: Receiver<T>| {
        let mut raised = None;
        loop {
            match answer.recv_timeout(SIGNAL_INTERVAL) {
                Ok(answer) => return raised.map_or(Ok(answer), Err),
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the solver has panicked"));
                }
                Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                    raised = Python::attach(|py| py.check_signals()).err();
                    stop.store(raised.is_some(), Ordering::Relaxed);
                }
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
    };
    py.detach(|| {
        std::thread::scope(|scope| {
            let (done, answer) = channel();
            scope.spawn(|| run(done));
            wait(answer)
        })
    })
}

/// Continues until the flag is set.
pub(crate) fn continue_unless(stop: &AtomicBool) -> ControlFlow<()> {
    if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}
