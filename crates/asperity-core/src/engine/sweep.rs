//! Many scenes, one model: what their laws have in common is integrated once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

use asperity_quadrature::{AnyScale, Density};

use crate::engine::case::Worker;
use crate::{At, ContactError, ContactModel, Evaluation, Part, Quantity, Scene, Tolerance};

/// Cases handed to a thread at a time.
const TOGETHER: usize = 256;
/// Cases of a stream that are held in memory.
const HELD: usize = 16_384;
/// Shapes that are kept.
const SHAPES: usize = 64;

/// A scene, and where it is asked about.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Case {
    /// The scene.
    pub scene: Scene,
    /// A separation or a load.
    pub at: At,
}

impl Case {
    /// A scene at a separation or under a load; a plain number is a separation d/σ_z from the mean
    /// of the asperity heights.
    #[must_use]
    pub fn new(scene: Scene, at: impl Into<At>) -> Self {
        Self { scene, at: at.into() }
    }
}

/// One model on many scenes: the part of a law that recurs, up to its units and a factor, is
/// integrated once, whatever the scale it comes back at; one that does not recur is integrated
/// where it is asked for, and nothing is prepared for it. Threads share what has been built.
///
/// ```
/// # use asperity_core::*;
/// # fn demo(model: &dyn ContactModel, scene: Scene) -> Result<(), ContactError> {
/// let sweep = Sweep::new(model, &[Quantity::Force], Tolerance::default());
/// let rougher = |k: u32| {
///     let mut scene = scene.clone();
///     scene.surface.asperity_height_std *= 1.0 + 1e-6 * f64::from(k);
///     Case::new(scene, 1.0)
/// };
/// // A million scenes, 16384 at a time in memory, in order.
/// sweep.stream((0..1_000_000).map(rougher), |_, answer| {
///     println!("{} N", answer?[0].value());
///     Ok::<(), ContactError>(())
/// })?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Sweep<'m> {
    pub(crate) model: &'m dyn ContactModel,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) tolerance: Tolerance,
    shapes: RwLock<Vec<Arc<Shape>>>,
}

/// A part of a law without its factor, and its integral.
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) part: Part,
    pub(crate) integral: AnyScale,
    /// Whether it has been found again.
    recurs: AtomicBool,
}

impl<'m> Sweep<'m> {
    /// Prepares nothing: laws are built for the scenes that come.
    #[must_use]
    pub fn new(model: &'m dyn ContactModel, quantities: &[Quantity], tolerance: Tolerance) -> Self {
        Self { model, quantities: quantities.to_vec(), tolerance, shapes: RwLock::default() }
    }

    /// The quantities of one case, in the order of the sweep's.
    ///
    /// # Errors
    /// Those of [`ContactModel::compile`] and [`Contact::evaluate_at`](crate::Contact::evaluate_at).
    pub fn evaluate(&self, case: &Case) -> Result<Vec<Evaluation>, ContactError> {
        match Worker::new(self).run(std::slice::from_ref(case)).pop() {
            Some(answer) => answer,
            None => Ok(vec![]),
        }
    }

    /// Every case on all cores, in order. The digits do not depend on the number of threads.
    #[must_use]
    pub fn evaluate_all(&self, cases: &[Case]) -> Vec<Result<Vec<Evaluation>, ContactError>> {
        crate::engine::parallel::map_runs(cases, TOGETHER, |cases| Worker::new(self).run(cases))
    }

    /// For every case its separation d/σ_z: that of its load, the largest that carries it.
    #[must_use]
    pub fn separations(&self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        crate::engine::parallel::map_runs(cases, TOGETHER, |cases| {
            Worker::new(self).separations(cases)
        })
    }

    /// Every case on all cores, delivered in order with its number; however many there are, some
    /// thousand are in memory.
    ///
    /// # Errors
    /// What `deliver` refuses: the stream ends there.
    pub fn stream<E>(
        &self,
        cases: impl IntoIterator<Item = Case, IntoIter: Send>,
        mut deliver: impl FnMut(usize, Result<Vec<Evaluation>, ContactError>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut cases = cases.into_iter();
        let mut count = 0;
        let mut held: Vec<Case> = cases.by_ref().take(HELD).collect();
        while !held.is_empty() {
            // The next cases are made while these are answered.
            let (answers, next) = crate::engine::parallel::both(
                || self.evaluate_all(&held),
                || cases.by_ref().take(HELD).collect::<Vec<_>>(),
            );
            for answer in answers {
                deliver(count, answer)?;
                count += 1;
            }
            held = next;
        }
        Ok(())
    }

    /// The shape of a part, new or known.
    pub(crate) fn shape(&self, part: &Part) -> Arc<Shape> {
        let known = |shapes: &[Arc<Shape>]| shapes.iter().find(|s| s.part.recurs_in(part)).cloned();
        let shapes = self.shapes.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(shape) = known(&shapes) {
            shape.recurs.store(true, Ordering::Relaxed);
            return shape;
        }
        drop(shapes);
        let mut shapes = self.shapes.write().unwrap_or_else(PoisonError::into_inner);
        // Another thread may have been faster.
        if let Some(shape) = known(&shapes) {
            return shape;
        }
        let part = part.without_factor();
        let density = Density { pieces: vec![part.piece()] };
        let integral = AnyScale::new(density, self.tolerance.relative());
        let shape = Arc::new(Shape { part, integral, recurs: AtomicBool::new(false) });
        if shapes.len() >= SHAPES {
            shapes.retain(|shape| shape.recurs.load(Ordering::Relaxed));
        }
        if shapes.len() < SHAPES {
            shapes.push(shape.clone());
        }
        shape
    }
}
