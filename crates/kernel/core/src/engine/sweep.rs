//! Many scenes, one model: parts that recur in their laws are integrated once.

use std::borrow::Cow;
use std::rc::Rc;

use crate::engine::averages::separation_at;
use crate::engine::case_integrals::{CaseIntegrals, RecentShapes, Shapes};
use crate::engine::laws::{Laws, any_load};
use crate::engine::parallel::map_runs;
use crate::engine::row_integrals::RowIntegrals;
use crate::{
    At, Contact, ContactError, ContactModel, Evaluation, Quantity, Request, Scene, Tolerance,
};

/// Cases handed to a thread at a time,
const CASES_PER_RUN: usize = 256;
/// and where each takes milliseconds: neighbours still share their integrals.
const SLOW_CASES_PER_RUN: usize = 4;

/// A scene at one separation or load.
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
/// let rougher: Vec<Case> = (0..10_000).map(rougher).collect();
/// for answer in sweep.evaluate_all(&rougher) {
///     println!("{} N", answer?[0].value());
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Sweep<'m> {
    model: &'m dyn ContactModel,
    quantities: Vec<Quantity>,
    tolerance: Tolerance,
    shapes: Shapes,
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
    /// The errors of [`ContactModel::compile`] and
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
}

/// One thread's view of a sweep.
struct Worker<'s> {
    sweep: &'s Sweep<'s>,
    shapes: RecentShapes<'s>,
}

impl<'s> Worker<'s> {
    fn new(sweep: &'s Sweep<'_>) -> Self {
        Self { sweep, shapes: RecentShapes::new(&sweep.shapes, sweep.tolerance) }
    }

    /// All quantities of each case.
    fn run(&mut self, cases: &[Case]) -> Vec<Result<Vec<Evaluation>, ContactError>> {
        let quantities = &self.sweep.quantities;
        let each = |contact: &dyn Contact, case: &Case| {
            quantities.iter().map(|quantity| contact.evaluate_at(*quantity, case.at)).collect()
        };
        self.walk(cases, (quantities, each), |integrals, at| {
            let mut row = RowIntegrals::<_>::new(integrals, quantities, &at)?;
            quantities.iter().map(|quantity| row.quantity(*quantity)).collect()
        })
    }

    /// The separation of each case.
    fn separations(&mut self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        let each = |contact: &dyn Contact, case: &Case| {
            Ok(contact.separation(case.at)?.in_sigma(&case.scene)?.s)
        };
        let answer = |integrals: &mut CaseIntegrals<'_>, at| Ok(separation_at(integrals, &at)?.s);
        self.walk(cases, (&[Quantity::Force], each), answer)
    }

    /// `answer` of every case, with its laws and its neighbours' at hand; without laws of an
    /// asperity nothing is shared, and `each` answers from the contact compiled for `quantities`.
    fn walk<T>(
        &mut self,
        cases: &[Case],
        (quantities, each): (&[Quantity], impl Fn(&dyn Contact, &Case) -> Result<T, ContactError>),
        answer: impl Fn(&mut CaseIntegrals<'_>, At) -> Result<T, ContactError>,
    ) -> Vec<Result<T, ContactError>> {
        let Sweep { model, tolerance, .. } = self.sweep;
        if model.asperity_model().is_none() {
            let asked = Request::new(quantities.iter().copied()).within(*tolerance);
            let of = |case: &Case| {
                each(&*model.compile(&case.scene, &asked.clone().at([case.at]))?, case)
            };
            return cases.iter().map(of).collect();
        }
        let mut before: Option<Rc<Laws>> = None;
        let mut next = cases.first().map(|case| self.averaged(case, None));
        let mut answers = Vec::with_capacity(cases.len());
        for (k, case) in cases.iter().enumerate() {
            let Some(now) = next.take() else { break };
            let last = now.as_ref().ok().map(|(_, laws)| laws.clone());
            next = cases.get(k + 1).map(|case| self.averaged(case, last.clone()));
            let after = next.as_ref().and_then(|next| next.as_ref().ok());
            answers.push(now.and_then(|(scene, laws)| {
                let neighbours = [before.as_deref(), after.map(|(_, laws)| &**laws)];
                let shared = (&mut self.shapes, neighbours);
                answer(&mut CaseIntegrals::sharing(shared, &scene, &laws)?, case.at)
            }));
            before = last;
        }
        answers
    }

    /// The scene of a case over whose heights laws are averaged, and these: those of the last case,
    /// if the asperity is the same.
    fn averaged<'c>(
        &self,
        case: &'c Case,
        last: Option<Rc<Laws>>,
    ) -> Result<(Cow<'c, Scene>, Rc<Laws>), ContactError> {
        let Sweep { model, quantities, tolerance, .. } = self.sweep;
        let scene = model.scene_of(&case.scene)?;
        let asperity = scene.asperity()?;
        let by_load = any_load(&[case.at]);
        match last.filter(|last| last.serve(&asperity, by_load)) {
            Some(last) => Ok((scene, last)),
            None => {
                let laws = Laws::new(*model, asperity, quantities, by_load, *tolerance)?;
                Ok((scene, Rc::new(laws)))
            }
        }
    }
}
