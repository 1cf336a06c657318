//! `evaluate_rows`: many scenes, some of which may fail without taking the others with them.

use asperity::{Case, ContactError, Surface, Sweep};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::arrays::{self, Grain};
use crate::engine::{Engine, asperity_separation, quantities, tolerance};
use crate::error::value_error;
use crate::scenes::{ManyScenes, Scenes};

/// Cases that a thread makes at a time.
const TOGETHER: usize = 256;

/// Columns in the order of the quantities, the rows that failed with their exceptions, ascending,
/// and the warnings of the model.
type Rows<'py> = (Vec<Bound<'py, PyArray1<f64>>>, Vec<(usize, Py<PyAny>)>, Vec<String>);

/// The quantities of every scene at its separation. A row that fails is NaN here, and named.
///
/// `roughness`: plasticity index and roughness parameter of every row, which then say what its
/// asperity radius and density are. `threads`: all cores, if none.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "called from one place, by the package itself")]
pub(crate) fn evaluate_rows<'py>(
    py: Python<'py>,
    engine: &Engine,
    scenes: &Bound<'py, Scenes>,
    separations: PyReadonlyArray1<'py, f64>,
    in_metres: bool,
    roughness: Option<(PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>)>,
    names: Vec<String>,
    rtol: f64,
    threads: Option<usize>,
) -> PyResult<Rows<'py>> {
    let (quantities, tolerance) = (quantities(&names)?, tolerance(rtol)?);
    let scenes = ManyScenes::Columns(scenes.get().clone());
    let separations = separations.as_slice()?.to_vec();
    let roughness = match &roughness {
        Some((index, parameter)) => {
            Some((index.as_slice()?.to_vec(), parameter.as_slice()?.to_vec()))
        }
        None => None,
    };
    let lengths = [scenes.size(), roughness.as_ref().map_or(separations.len(), |(i, _)| i.len())];
    if lengths.iter().any(|length| *length != separations.len()) {
        return Err(value_error(format!(
            "{} scenes were given with {} separations: as many of both was required",
            scenes.size(),
            separations.len()
        )));
    }
    let Some(model) = engine.model_of_all(&scenes)? else { return Ok((vec![], vec![], vec![])) };
    let sweep = Sweep::new(&*model, &quantities, tolerance);
    let case = |k: usize| {
        let of = |file: &asperity_scene::SceneFile| Case {
            separation: asperity_separation(file, separations[k], in_metres),
            scene: file.scene.clone(),
        };
        scenes.with(k, |file| {
            let Some((index, parameter)) = &roughness else { return Ok(of(file)) };
            let (interface, height_std) =
                (file.scene.interface, file.scene.surface.asperity_height_std);
            let surface =
                Surface::from_plasticity_index(index[k], parameter[k], height_std, &interface)?;
            file.with_numbers(interface, surface, file.scene.nominal_area).map(|file| of(&file))
        })?
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
    let pool = threads.map(|_| pool.build()).transpose().map_err(value_error)?;
    let mut columns = vec![vec![f64::NAN; separations.len()]; quantities.len()];
    let mut failed: Vec<(usize, Py<PyAny>)> = vec![];
    arrays::in_ranges(py, separations.len(), Grain::Values, |range| {
        let first = range.start;
        let work = || {
            let made: Vec<Result<Case, ContactError>> =
                range.into_par_iter().with_min_len(TOGETHER).map(case).collect();
            let mut refused = vec![];
            let (mut places, mut cases) =
                (Vec::with_capacity(made.len()), Vec::with_capacity(made.len()));
            for (k, case) in made.into_iter().enumerate() {
                match case {
                    Ok(case) => {
                        places.push(first + k);
                        cases.push(case);
                    }
                    Err(error) => refused.push((first + k, error)),
                }
            }
            (places, sweep.evaluate_all(&cases), refused)
        };
        let (places, answers, mut refused) = py.detach(|| match &pool {
            Some(pool) => pool.install(work),
            None => work(),
        });
        for (k, answer) in places.into_iter().zip(answers) {
            match answer {
                Ok(answer) => {
                    for (column, evaluation) in columns.iter_mut().zip(&answer) {
                        column[k] = evaluation.value();
                    }
                }
                Err(error) => refused.push((k, error)),
            }
        }
        refused.sort_by_key(|(k, _)| *k);
        for (k, error) in &refused {
            failed.push((*k, engine.0.raise(py, "", error).into_value(py).into_any()));
        }
        Ok(())
    })?;
    let warnings = model.warnings().iter().map(ToString::to_string).collect();
    let columns = columns.into_iter().map(|column| PyArray1::from_vec(py, column)).collect();
    Ok((columns, failed, warnings))
}
