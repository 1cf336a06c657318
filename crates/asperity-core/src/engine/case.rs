//! One thread's walk through the cases of a sweep: laws that stay are kept, shapes that recur are
//! shared.

use std::rc::Rc;
use std::sync::Arc;

use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::channel::Laws;
use crate::engine::sweep::{Shape, Sweep};
use crate::{AsperityModel, At, Case, ContactError, Evaluation, Part, Quantity, Request};

/// A shape of all threads, counted within one: no row writes what another thread reads.
pub(crate) struct LocalShape(pub(crate) Arc<Shape>);

/// One thread's view of a sweep.
pub(crate) struct Worker<'s> {
    pub(crate) sweep: &'s Sweep<'s>,
    /// Shapes of the case before, part by part: mostly those of the next one.
    recent: Vec<Rc<LocalShape>>,
}

type Answer = Result<Vec<Evaluation>, ContactError>;

impl<'s> Worker<'s> {
    pub(crate) fn new(sweep: &'s Sweep<'_>) -> Self {
        Self { sweep, recent: vec![] }
    }

    /// All quantities of each case.
    pub(crate) fn run(&mut self, cases: &[Case]) -> Vec<Answer> {
        let Some(model) = self.sweep.model.asperity_model() else {
            return cases.iter().map(|case| self.compiled(case)).collect();
        };
        let quantities = &self.sweep.quantities;
        self.walk(model, cases, |integrals, at| {
            let reading = integrals.reading(at)?;
            quantities.iter().map(|quantity| reading.of(*quantity, integrals)).collect()
        })
    }

    /// The separation of each case.
    pub(crate) fn separations(&mut self, cases: &[Case]) -> Vec<Result<f64, ContactError>> {
        let Some(model) = self.sweep.model.asperity_model() else {
            return cases.iter().map(|case| self.compiled_separation(case)).collect();
        };
        self.walk(model, cases, |integrals, at| Ok(integrals.reading(at)?.place.s))
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
                answer(&mut CaseIntegrals::new(self, &case.scene, &laws, neighbours)?, case.at)
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
        let Sweep { quantities, tolerance, .. } = self.sweep;
        let asperity = case.scene.asperity()?;
        let by_load = !matches!(case.at, At::Separation(_));
        match last.filter(|last| last.serve(&asperity, by_load)) {
            Some(last) => Ok(last),
            None => Laws::new(model, asperity, quantities, by_load, *tolerance).map(Rc::new),
        }
    }

    /// The shape of a part, at its place in the laws of a case.
    pub(crate) fn shape(&mut self, place: usize, part: &Part) -> Rc<LocalShape> {
        match self.recent.get(place) {
            Some(shape) if shape.0.part.recurs_in(part) => return shape.clone(),
            Some(_) => self.recent[place] = Rc::new(LocalShape(self.sweep.shape(part))),
            None => {
                let shape = Rc::new(LocalShape(self.sweep.shape(part)));
                self.recent.resize(place + 1, shape);
            }
        }
        self.recent[place].clone()
    }

    /// A model that has no laws of an asperity: nothing is shared.
    fn compiled(&self, case: &Case) -> Answer {
        let Sweep { model, quantities, tolerance, .. } = self.sweep;
        let request = Request::new(quantities.iter().copied()).within(*tolerance).at([case.at]);
        let contact = model.compile(&case.scene, &request)?;
        quantities.iter().map(|quantity| contact.evaluate_at(*quantity, case.at)).collect()
    }

    fn compiled_separation(&self, case: &Case) -> Result<f64, ContactError> {
        let Sweep { model, tolerance, .. } = self.sweep;
        let request = Request::new([Quantity::Force]).within(*tolerance).at([case.at]);
        let contact = model.compile(&case.scene, &request)?;
        Ok(contact.separation(case.at)?.place(&case.scene)?.s)
    }
}
