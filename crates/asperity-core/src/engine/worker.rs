//! The cases of a sweep on one thread: unchanged laws are kept, shapes that recur are shared.

use std::rc::Rc;

use crate::engine::averages::place;
use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::laws::{Laws, any_load};
use crate::engine::row::Row;
use crate::engine::shapes::{RecentShapes, Shapes};
use crate::{
    AsperityModel, At, Case, ContactError, ContactModel, Evaluation, Quantity, Request, Tolerance,
};

/// The quantities and tolerance of a sweep.
#[derive(Debug)]
pub(crate) struct Question<'m> {
    pub(crate) model: &'m dyn ContactModel,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) tolerance: Tolerance,
}

/// One thread's view of a sweep.
pub(crate) struct Worker<'s> {
    question: &'s Question<'s>,
    shapes: RecentShapes<'s>,
}

type Answer = Result<Vec<Evaluation>, ContactError>;

impl<'s> Worker<'s> {
    pub(crate) fn new(question: &'s Question<'_>, shapes: &'s Shapes) -> Self {
        Self { question, shapes: RecentShapes::new(shapes, question.tolerance) }
    }

    /// All quantities of each case.
    pub(crate) fn run(&mut self, cases: &[Case]) -> Vec<Answer> {
        let Some(model) = self.question.model.asperity_model() else {
            return cases.iter().map(|case| self.compiled(case)).collect();
        };
        let quantities = &self.question.quantities;
        self.walk(model, cases, |integrals, at| {
            let mut row = Row::<_>::new(integrals, quantities, &at)?;
            quantities.iter().map(|quantity| row.quantity(*quantity)).collect()
        })
    }

    /// The separation of each case.
    pub(crate) fn separations(&mut self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        let Some(model) = self.question.model.asperity_model() else {
            return cases.iter().map(|case| self.compiled_separation(case)).collect();
        };
        self.walk(model, cases, |integrals, at| Ok(place(integrals, &at)?.s))
    }

    /// `answer` of every case, with its laws and those of its neighbours at hand.
    fn walk<T>(
        &mut self,
        model: &dyn AsperityModel,
        cases: &[Case],
        answer: impl Fn(&mut CaseIntegrals<'_>, At) -> Result<T, ContactError>,
    ) -> Vec<Result<T, ContactError>> {
        let mut before: Option<Rc<Laws>> = None;
        let mut next = cases.first().map(|case| self.laws(model, case, None));
        let mut answers = Vec::with_capacity(cases.len());
        for (k, case) in cases.iter().enumerate() {
            let Some(now) = next.take() else { break };
            let known = now.as_ref().ok().cloned();
            next = cases.get(k + 1).map(|case| self.laws(model, case, known.clone()));
            let after = next.as_ref().and_then(|next| next.as_ref().ok());
            answers.push(now.and_then(|laws| {
                let neighbours = [before.as_deref(), after.map(|laws| &**laws)];
                let tolerance = self.question.tolerance;
                let shared = (&mut self.shapes, neighbours);
                let mut integrals = CaseIntegrals::sharing(shared, &case.scene, &laws, tolerance)?;
                answer(&mut integrals, case.at)
            }));
            before = known;
        }
        answers
    }

    /// The laws of a case: those of the last one, if the asperity is the same.
    fn laws(
        &self,
        model: &dyn AsperityModel,
        case: &Case,
        last: Option<Rc<Laws>>,
    ) -> Result<Rc<Laws>, ContactError> {
        let Question { quantities, tolerance, .. } = self.question;
        let asperity = case.scene.asperity()?;
        let by_load = any_load(&[case.at]);
        match last.filter(|last| last.serve(&asperity, by_load)) {
            Some(last) => Ok(last),
            None => Laws::new(model, asperity, quantities, by_load, *tolerance).map(Rc::new),
        }
    }

    /// A model without laws of an asperity: nothing is shared.
    fn compiled(&self, case: &Case) -> Answer {
        let Question { model, quantities, tolerance } = self.question;
        let request = Request::new(quantities.iter().copied()).within(*tolerance).at([case.at]);
        let contact = model.compile(&case.scene, &request)?;
        quantities.iter().map(|quantity| contact.evaluate_at(*quantity, case.at)).collect()
    }

    fn compiled_separation(&self, case: &Case) -> Result<f64, ContactError> {
        let Question { model, tolerance, .. } = self.question;
        let request = Request::new([Quantity::Force]).within(*tolerance).at([case.at]);
        let contact = model.compile(&case.scene, &request)?;
        Ok(contact.separation(case.at)?.place(&case.scene)?.s)
    }
}
