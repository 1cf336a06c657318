//! From loads back to separations, on one scene or many.

use std::ops::Range;

use asperity::{Compiled, ContactError, Quantity};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::arrays::{self, Grain};
use crate::engine::{Engine, request, tolerance};
use crate::scenes::ManyScenes;

/// For every load [N], on scene `index[k]`, the separations that carry it: ascending, from the
/// scene's plane.
#[pyfunction]
pub(crate) fn separations<'py>(
    py: Python<'py>,
    engine: &Engine,
    scenes: &Bound<'py, PyAny>,
    index: PyReadonlyArray1<'py, i64>,
    loads: PyReadonlyArray1<'py, f64>,
    in_metres: bool,
    rtol: f64,
) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
    let scenes = ManyScenes::of(scenes)?;
    let (index, loads) = (index.as_slice()?.to_vec(), loads.as_slice()?.to_vec());
    let Some(model) = engine.model_of_all(&scenes)? else { return Ok(vec![]) };
    let request = request(&[Quantity::Force], tolerance(rtol)?);
    let compiled = |scene: usize| {
        scenes.with(scene, |file| model.compile(&file.scene, &request)).and_then(|inner| inner)
    };
    // On the scene's own plane.
    let at = |compiled: &Compiled, scene: usize, load: f64| {
        let found = compiled.separations_at(load)?;
        scenes.with(scene, |file| {
            let user = found.iter().map(|s| file.from_asperity_mean(*s));
            user.map(|s| if in_metres { file.in_metres(s) } else { s }).collect::<Vec<f64>>()
        })
    };
    let raise = |k: usize, error: ContactError| {
        let place = if scenes.size() > 1 { format!("scene {}: ", index[k]) } else { String::new() };
        engine.0.raise(py, &place, &error)
    };
    let runs = runs(&index);
    let found = if let [_] = runs[..] {
        // One scene: its loads are shared out.
        let scene = index[0] as usize;
        let compiled = py.detach(|| compiled(scene)).map_err(|error| raise(0, error))?;
        let one = |k: usize| at(&compiled, scene, loads[k]);
        arrays::collect(py, loads.len(), Grain::Scenes, one, raise)?
    } else {
        let one = |run: usize| {
            let scene = index[runs[run].start] as usize;
            let compiled = compiled(scene)?;
            runs[run].clone().map(|k| at(&compiled, scene, loads[k])).collect()
        };
        let raise = |run: usize, error| raise(runs[run].start, error);
        let found: Vec<Vec<Vec<f64>>> = arrays::collect(py, runs.len(), Grain::Scenes, one, raise)?;
        found.into_iter().flatten().collect()
    };
    Ok(found.into_iter().map(|separations| PyArray1::from_vec(py, separations)).collect())
}

/// Ranges of equal neighbours.
fn runs(index: &[i64]) -> Vec<Range<usize>> {
    let mut runs: Vec<Range<usize>> = vec![];
    for (k, scene) in index.iter().enumerate() {
        match runs.last_mut() {
            Some(run) if index[run.start] == *scene => run.end = k + 1,
            _ => runs.push(k..k + 1),
        }
    }
    runs
}
