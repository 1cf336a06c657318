//! Many scenes, one model: parts that recur in their laws are integrated once.

use crate::engine::laws::{Laws, any_load};
use crate::engine::parallel::{both, map_runs};
use crate::engine::shapes::Shapes;
use crate::engine::worker::Worker;
use crate::{Case, ContactError, ContactModel, Evaluation, Quantity, Tolerance};

/// Cases handed to a thread at a time,
const CASES_PER_RUN: usize = 256;
/// and where each takes milliseconds: neighbours still share their integrals.
const SLOW_CASES_PER_RUN: usize = 4;
/// Cases of a stream that are held in memory.
const HELD: usize = 16_384;

/// One model on many scenes. A part of a law that recurs, up to its units and a factor, is
/// integrated once for all scales; other parts are integrated for each case, without preparation.
/// Threads share the integrals.
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
    pub(crate) shapes: Shapes,
}

impl<'m> Sweep<'m> {
    /// A sweep without laws: they are built for the scenes.
    #[must_use]
    pub fn new(model: &'m dyn ContactModel, quantities: &[Quantity], tolerance: Tolerance) -> Self {
        Self { model, quantities: quantities.to_vec(), tolerance, shapes: Shapes::default() }
    }

    /// The quantities of one case, in the order of the sweep's.
    ///
    /// # Errors
    /// Those of [`ContactModel::compile`] and
    /// [`ContactEngine::evaluate_at`](crate::ContactEngine::evaluate_at).
    pub fn evaluate(&self, case: &Case) -> Result<Vec<Evaluation>, ContactError> {
        Worker::new(self).run(std::slice::from_ref(case)).pop().unwrap_or(Ok(vec![]))
    }

    /// Every case on all cores, in order. The digits do not depend on the number of threads.
    #[must_use]
    pub fn evaluate_all(&self, cases: &[Case]) -> Vec<Result<Vec<Evaluation>, ContactError>> {
        map_runs(cases, self.run_length(cases), |cases| Worker::new(self).run(cases))
    }

    /// The separation d/σ_z of every case; for a load, the largest that carries it.
    #[must_use]
    pub fn separations(&self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        map_runs(cases, self.run_length(cases), |cases| Worker::new(self).separations(cases))
    }

    /// The number of cases of a run, by the laws of the first: the digits must not depend on times
    /// or threads.
    fn run_length(&self, cases: &[Case]) -> usize {
        let is_slow = |case: &Case| {
            let Self { model, quantities, tolerance, .. } = self;
            let asperity = model.scene_of(&case.scene).and_then(|scene| scene.asperity());
            let laws = asperity.and_then(|asperity| {
                Laws::new(*model, asperity, quantities, any_load(&[case.at]), *tolerance)
            });
            // Without laws of an asperity each case is compiled.
            model.asperity_model().is_none() || laws.is_ok_and(|laws| laws.are_costly())
        };
        if cases.first().is_some_and(is_slow) { SLOW_CASES_PER_RUN } else { CASES_PER_RUN }
    }

    /// Every case on all cores, delivered in order with its number. Some thousand cases at a time
    /// are in memory.
    ///
    /// # Errors
    /// The first error of `deliver`, which ends the stream.
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
            let (answers, next) =
                both(|| self.evaluate_all(&held), || cases.by_ref().take(HELD).collect::<Vec<_>>());
            for answer in answers {
                deliver(count, answer)?;
                count += 1;
            }
            held = next;
        }
        Ok(())
    }
}
