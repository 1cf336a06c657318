//! Our own methods: laws and compiled scenes, each built once for all methods and points, and their
//! values.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use anyhow::Result;
use asperity::{Contact, Request, Tolerance};
use asperity_quadrature::AnyScale;

use super::problem::{INTEGRALS, Job, NOT_CONVERGED, Outcome, Problem, integrated, law_behind};
use xtask::figures::report_csv::median;

/// Most batches of a time, the least duration of one, and of all where there are three.
const MOST_BATCHES: usize = 21;
const BATCH: Duration = Duration::from_micros(300);
const ENOUGH: Duration = Duration::from_millis(60);

/// Compiled scenes and rules, by everything they depend on.
#[derive(Debug, Default)]
pub struct Laws {
    scenes: Cache<dyn Contact>,
    rules: Cache<AnyScale>,
}

/// Shared values by their names.
type Cache<T> = Mutex<HashMap<String, Arc<T>>>;

/// The cached value, or a new one; if two threads make one, the first stays.
fn find_or<T: ?Sized>(
    cache: &Cache<T>,
    key: String,
    make: impl FnOnce() -> Result<Arc<T>>,
) -> Result<Arc<T>> {
    let cached = cache.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
    if let Some(cached) = cached {
        return Ok(cached);
    }
    let made = make()?;
    let mut cache = cache.lock().unwrap_or_else(PoisonError::into_inner);
    Ok(cache.entry(key).or_insert(made).clone())
}

impl Laws {
    /// The problem's scene compiled, the same for all its separations; its law is shared by the
    /// scenes of one asperity.
    ///
    /// # Errors
    /// The errors of [`asperity::ContactModel::compile`], as below.
    pub fn scene(&self, problem: &Problem, tolerance: f64) -> Result<Arc<dyn Contact>> {
        let Problem { model, scene, .. } = problem;
        let law = integrated(model, problem.quantity);
        let key = format!("{model} {law} {tolerance:e} {:?}", scene.asperity()?);
        let built = find_or(&self.scenes, key.clone(), || {
            let quantities = INTEGRALS.into_iter().filter(|q| integrated(model, *q) == law);
            let request = Request::new(quantities).within(Tolerance::new(tolerance)?);
            Ok(model.compile(scene, &request)?.into())
        })?;
        find_or(&self.scenes, format!("{key} {scene:?}"), || Ok(built.on(scene)?.into()))
    }

    /// The rules of the problem's law for any scale.
    fn rules(&self, problem: &Problem, tolerance: f64) -> Result<Arc<AnyScale>> {
        let Problem { model, quantity, scene, .. } = problem;
        let key = format!("{model} {quantity} {tolerance:e} {:?}", scene.asperity()?);
        find_or(&self.rules, key, || {
            let law = law_behind(model, *quantity, &scene.asperity()?, tolerance)?;
            Ok(Arc::new(AnyScale::new(law.density(), tolerance)))
        })
    }
}

/// A value of a compiled scene.
///
/// # Errors
/// When the model refuses the scene, as all below.
pub fn compiled(laws: &Laws, problem: &Problem, tolerance: f64) -> Result<Job> {
    let (quantity, separation) = (problem.quantity, problem.separation);
    let compiled = laws.scene(problem, tolerance)?;
    Ok(Box::new(move || {
        let found = compiled.evaluate(quantity, separation).map_err(|_| NOT_CONVERGED)?;
        Ok(Outcome { value: found.scaled, scaled: true })
    }))
}

/// A value on a scene that is not compiled, as in sweeps.
pub fn rule(laws: &Laws, problem: &Problem, tolerance: f64) -> Result<Job> {
    let rules = laws.rules(problem, tolerance)?;
    let (scale, s, slope) = (problem.scale(), problem.separation, problem.slope());
    let factor = problem.in_units(1.0);
    Ok(Box::new(move || {
        let found = if slope { rules.at(s, scale) } else { rules.value(s, scale) };
        let found = found.map_err(|_| NOT_CONVERGED)?;
        let value = factor * if slope { found.slope } else { found.value };
        Ok(Outcome { value, scaled: true })
    }))
}

/// Median time of one call \[ns\] over at least three batches, after two warm-up calls.
pub fn median_ns(mut call: impl FnMut()) -> f64 {
    let mut time = |calls: u32| {
        let start = Instant::now();
        (0..calls).for_each(|_| call());
        start.elapsed()
    };
    let once = time(1).min(time(1)).max(Duration::from_nanos(20));
    let calls = BATCH.as_nanos().div_ceil(once.as_nanos()).clamp(1, 1_000_000) as u32;
    let (start, mut batches) = (Instant::now(), vec![]);
    while batches.len() < MOST_BATCHES && (batches.len() < 3 || start.elapsed() < ENOUGH) {
        batches.push(time(calls).as_nanos() as f64 / f64::from(calls));
    }
    median(batches).unwrap_or(0.0)
}
