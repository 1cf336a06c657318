//! The cases of a sweep on one thread: unchanged laws are kept, shapes that recur are shared.

use std::borrow::Cow;
use std::rc::Rc;

use crate::engine::averages::separation_at;
use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::laws::{Laws, any_load};
use crate::engine::row_integrals::RowIntegrals;
use crate::engine::shapes::RecentShapes;
use crate::{At, Case, Contact, ContactError, Evaluation, Quantity, Request, Scene, Sweep};

/// One thread's view of a sweep.
pub(crate) struct Worker<'s> {
    sweep: &'s Sweep<'s>,
    shapes: RecentShapes<'s>,
}

impl<'s> Worker<'s> {
    pub(crate) fn new(sweep: &'s Sweep<'_>) -> Self {
        Self { sweep, shapes: RecentShapes::new(&sweep.shapes, sweep.tolerance) }
    }

    /// All quantities of each case.
    pub(crate) fn run(&mut self, cases: &[Case]) -> Vec<Result<Vec<Evaluation>, ContactError>> {
        let quantities = &self.sweep.quantities;
        if self.sweep.model.asperity_model().is_none() {
            let each = |contact: &dyn Contact, case: &Case| {
                quantities.iter().map(|quantity| contact.evaluate_at(*quantity, case.at)).collect()
            };
            return self.compiled(quantities, cases, each);
        }
        self.walk(cases, |integrals, at| {
            let mut row = RowIntegrals::<_>::new(integrals, quantities, &at)?;
            quantities.iter().map(|quantity| row.quantity(*quantity)).collect()
        })
    }

    /// The separation of each case.
    pub(crate) fn separations(&mut self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        if self.sweep.model.asperity_model().is_none() {
            let separation = |contact: &dyn Contact, case: &Case| {
                Ok(contact.separation(case.at)?.in_sigma(&case.scene)?.s)
            };
            return self.compiled(&[Quantity::Force], cases, separation);
        }
        self.walk(cases, |integrals, at| Ok(separation_at(integrals, &at)?.s))
    }

    /// `answer` of every case, with its laws and those of its neighbours at hand.
    fn walk<T>(
        &mut self,
        cases: &[Case],
        answer: impl Fn(&mut CaseIntegrals<'_>, At) -> Result<T, ContactError>,
    ) -> Vec<Result<T, ContactError>> {
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

    /// `answer` of every case of a model without laws of an asperity: nothing is shared.
    fn compiled<T>(
        &self,
        quantities: &[Quantity],
        cases: &[Case],
        answer: impl Fn(&dyn Contact, &Case) -> Result<T, ContactError>,
    ) -> Vec<Result<T, ContactError>> {
        let Sweep { model, tolerance, .. } = self.sweep;
        let of = |case: &Case| {
            let request = Request::new(quantities.iter().copied()).within(*tolerance).at([case.at]);
            answer(&*model.compile(&case.scene, &request)?, case)
        };
        cases.iter().map(of).collect()
    }
}
