//! A model applied to a scene, for callers.

use std::fmt;

use crate::engine::parallel;
use crate::error::require;
use crate::request::quantity::LEAK;
use crate::response::row_check::RowCheck;
use crate::response::{Answered, Response, fill};
use crate::{
    At, Column, ContactError, Datum, Evaluation, FillReport, Finding, Plan, Quantity, Request,
    Scene, Separation, SeparationUnit, Share,
};

/// A model applied to a scene: shared by threads, for many evaluations.
///
/// Its own methods are those for callers: `evaluate`, `force_and_tangent`, `respond`, `separation`,
/// `separation_in`, `shares` and `prepare`. [`ContactEngine`] has the rest: all separations of a
/// load, plain arrays, plans and the pull-off, and what a model that is no average over heights
/// implements.
///
/// Compiling integrates nothing: each range of separations (a unit below 0, a few tenths above) is
/// integrated at its first call, which takes 0.04 to 0.5 ms for most models, 50 to 100 ms for
/// models of inclined contacts and up to a second for asperities of different radii, and
/// allocates. `prepare` does so beforehand for a range of separations.
pub trait Contact: ContactEngine {}

impl<E: ContactEngine> Contact for E {}

/// A range in which a value of most surfaces lies.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// Its ends, in the unit of the value.
    pub lower: f64,
    /// Its ends, in the unit of the value.
    pub upper: f64,
    /// Of what it is: `nine of ten surfaces of this spectrum, 1 cm2 with some 40000 contacts`.
    pub of: String,
}

/// What answers behind a [`Contact`]: to be implemented by a model that is no average over heights.
pub trait ContactEngine: fmt::Debug + Send + Sync {
    /// The model's name.
    fn model(&self) -> &str;

    /// The scene.
    fn scene(&self) -> &Scene;

    /// The requested quantities.
    fn quantities(&self) -> &[Quantity];

    /// Whether the surfaces attract each other, so that forces may be negative.
    fn is_adhesive(&self) -> bool {
        false
    }

    /// Notes on the answers at these places.
    fn notes(&self, at: &[At]) -> Vec<Finding> {
        let _ = at;
        vec![]
    }

    /// A quantity at one place.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] for a quantity that was not asked for;
    /// [`ContactError::SeparationOutOfRange`], [`ContactError::OutOfReach`] for a load that no
    /// separation carries, [`ContactError::NoValue`] for a ratio where nothing touches, and
    /// [`ContactError::Integral`].
    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError>;

    /// The interval of a quantity at a place, or without a quantity that of the distance of the
    /// mean planes \[m\]; `None` for a model that knows none.
    fn interval_at(&self, quantity: Option<Quantity>, at: At) -> Option<Interval> {
        let _ = (quantity, at);
        None
    }

    /// Force \[N\] and tangent -dF/dd \[N/m\] in one pass: for codes that step in time.
    ///
    /// # Errors
    /// The errors of [`evaluate_at`](Self::evaluate_at).
    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        let of = |quantity| self.evaluate_at(quantity, at);
        Ok((of(Quantity::Force)?, of(Quantity::Tangent)?))
    }

    /// Fills plain columns, one for each quantity, with the values at many separations \[σ_z from
    /// the mean of the asperity heights\], and returns one bound for all: for inner loops over
    /// arrays. There are no warnings, and values that underflow read 0.
    ///
    /// # Errors
    /// Those of [`evaluate_at`](Self::evaluate_at), for the first row that is refused; the columns
    /// are then unspecified. [`ContactError::OutOfRange`] for columns of another number or length.
    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        let one = |quantity, at| self.evaluate_at(quantity, at);
        fill::fill((|_, _: &[f64], _: &mut [f64]| None, one), quantities, separations, columns)
    }

    /// All separations at which the force is `load` \[N\], ascending, each with its unit and plane
    /// (for models of asperities in σ_z from the mean of the asperity heights): one for a model
    /// whose force falls all the way, possibly several for others (AT as printed rises and falls).
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a load that is not positive (models with adhesion carry
    /// tensions, as negative loads, at two separations and more), [`ContactError::OutOfReach`] for
    /// one that the model cannot carry, and [`ContactError::Unsupported`] for a model without
    /// separations.
    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let _ = load;
        Err(self.unsupported("separations at a load"))
    }

    /// Where the load is first met: on approach at the largest of these separations; for a tension,
    /// pulled from contact, at the smallest, where the contact is stable (-dF/dd above 0).
    ///
    /// # Errors
    /// The errors of [`separations_at`](Self::separations_at).
    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        let found = self.separations_at(load)?;
        let first = if load < 0.0 { found.first() } else { found.last() };
        first.copied().ok_or_else(|| self.unsupported("separations at a load"))
    }

    /// The separation of the least force, at which the largest tension is held; the force must be
    /// among the compiled quantities. `None` if no negative force is within the range of f64.
    ///
    /// # Errors
    /// The errors of [`separations_at`](Self::separations_at).
    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Err(self.unsupported("a pull-off"))
    }

    /// The share of every part of the law in a quantity (in the force, for the tangent).
    ///
    /// # Errors
    /// The errors of [`evaluate_at`](Self::evaluate_at), and [`ContactError::Unsupported`].
    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        let _ = (quantity, at);
        Err(self.unsupported("shares of regimes"))
    }

    /// The shares of the force at a place that asperities with interferences beyond these multiples
    /// of w_c carry, for a model of asperities of different radii, each with its own w_c; `None`
    /// for others.
    ///
    /// # Errors
    /// [`ContactError::Missing`] without a hardness, and the errors of
    /// [`evaluate_at`](Self::evaluate_at).
    fn shares_beyond(&self, at: At, multiples: &[f64]) -> Result<Option<Vec<f64>>, ContactError> {
        let _ = (at, multiples);
        Ok(None)
    }

    /// The plan for a request: integrals, terms and samples.
    ///
    /// # Errors
    /// The errors of [`evaluate_at`](Self::evaluate_at), and [`ContactError::Unsupported`].
    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        let _ = request;
        Err(self.unsupported("a plan"))
    }

    /// The same laws on another surface or with other heights: the tables of a law are shared, so
    /// that a study of roughness or density builds them once.
    ///
    /// # Errors
    /// [`ContactError::OtherAsperity`] if the interface or the asperity radius differ, on which the
    /// law depends, the errors of the scene, and [`ContactError::Unsupported`].
    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        let _ = scene;
        Err(self.unsupported("moving to another scene"))
    }

    /// Answers a request for the quantities of this contact, row by row.
    fn respond(&self, request: &Request) -> Response {
        let columns = |places: &[At]| -> Vec<Vec<Answered>> {
            let at = |q: Quantity, at: &At| self.evaluate_at(q, *at).map_err(Box::new);
            let of = |q: &Quantity| places.iter().map(|place| at(*q, place)).collect();
            request.quantities.iter().map(of).collect()
        };
        let answered = |places: &[At]| parallel::columns(places, parallel::MANY, columns);
        let mut response = respond(self, request, answered, |_, _| None);
        response.warnings.extend(self.notes(&request.at));
        response
    }

    /// Checks that a quantity was requested and is `known`: for models that have only a few.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`], and [`ContactError::Unsupported`] with the known ones.
    fn check_asked(
        &self,
        quantity: Quantity,
        known: fn(Quantity) -> bool,
    ) -> Result<(), ContactError> {
        if !self.quantities().contains(&quantity) {
            return Err(ContactError::NotRequested { quantity });
        }
        if known(quantity) {
            return Ok(());
        }
        if quantity == Quantity::Leak {
            return Err(self.unsupported(LEAK));
        }
        let known = Quantity::ALL.into_iter().filter(|quantity| known(*quantity));
        let known: Vec<String> = known.map(|quantity| format!("{quantity}")).collect();
        Err(self.unsupported(&format!("{quantity} (available: {})", known.join(", "))))
    }

    /// The error for something that this model does not have.
    fn unsupported(&self, what: &str) -> ContactError {
        ContactError::Unsupported { model: self.model().into(), what: what.into() }
    }
}

/// Rows that are held before they join their columns.
const ROWS_PER_BLOCK: usize = 8192;

/// Puts columns of runs of rows together, with their findings. `answered` may return one column
/// more than there are quantities: the separations, in σ_z from the mean of the asperity heights.
/// `behind` returns the value whose sign a logarithm or share hides, where it may be negative.
pub(crate) fn respond(
    contact: &(impl ContactEngine + ?Sized),
    request: &Request,
    answered: impl Fn(&[At]) -> Vec<Vec<Answered>>,
    behind: impl Fn(Quantity, At) -> Option<f64>,
) -> Response {
    let (quantities, at) = (&request.quantities, &request.at);
    let new = |_| Vec::with_capacity(at.len());
    let mut columns: Vec<Vec<Answered>> = (0..=quantities.len()).map(new).collect();
    for places in at.chunks(ROWS_PER_BLOCK) {
        for (column, rows) in columns.iter_mut().zip(answered(places)) {
            column.extend(rows);
        }
    }
    let mut known = columns.pop().into_iter().flatten();
    let carried = |at: At| contact.separation_at(at.load(contact.scene()).unwrap_or(f64::NAN));
    let separation = |&at: &At| match (at, known.next()) {
        (At::Separation(given), _) => Ok(given),
        (_, Some(found)) => found.map(|found| Separation::sigmas(found.value())),
        (at, None) => carried(at).map_err(Box::new),
    };
    let separations = at.iter().map(separation).collect();
    let column = |(&quantity, rows)| Column { quantity, rows };
    let columns: Vec<Column> = quantities.iter().zip(columns).map(column).collect();
    let mut seen = RowCheck::new(contact.is_adhesive());
    for column in &columns {
        let quantity = column.quantity;
        for (row, &at) in column.rows.iter().zip(at) {
            let row = row.as_ref().map_err(|error| &**error);
            seen.check(quantity, row, at, contact.scene(), |of| behind(of, at));
        }
    }
    let (model, warnings) = (contact.model().to_string(), seen.finish(contact.model()));
    Response { model, at: at.clone(), separations, columns, warnings }
}

/// Separations \[σ_z\] so dense that every range with an integral of its own holds one: a unit
/// below 0, a fifth of the distance from -4.5 above. Below -64 each value is integrated anew.
fn ranges(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let next = move |s: &f64| (*s < to).then(|| (s + 0.5f64.max(0.1 * (s + 4.5))).min(to));
    std::iter::successors(Some(from.clamp(-64.0, to.max(-64.0))), next)
}

impl dyn Contact + '_ {
    /// Integrates all that later calls at separations from `from` to `to` \[σ_z from the mean of
    /// the asperity heights\] need, above -64: they then take no longer than any other, of
    /// compiled scenes with Gaussian heights. A search for a load begins at 0.
    ///
    /// # Errors
    /// Those of [`evaluate_at`](ContactEngine::evaluate_at), but for quantities without a value
    /// where nothing touches; [`ContactError::OutOfRange`] unless `from` and `to` ascend.
    pub fn prepare(&self, from: f64, to: f64) -> Result<(), ContactError> {
        require(from <= to && to.is_finite(), "to", to, "a finite separation, from or above,")?;
        let separations: Vec<f64> = ranges(from, to).collect();
        for &quantity in self.quantities() {
            for &s in &separations {
                match self.evaluate(quantity, s) {
                    Ok(_) | Err(ContactError::NoValue { .. }) => {}
                    Err(error) => return Err(error),
                }
            }
            // Arrays have tables of their own; what refuses them was reported above.
            let mut column = vec![0.0; separations.len()];
            let _ = self.fill(&[quantity], &separations, &mut [&mut column]);
        }
        Ok(())
    }

    /// [`evaluate_at`](ContactEngine::evaluate_at); a plain number is a multiple of σ_z.
    ///
    /// # Errors
    /// The errors of [`evaluate_at`](ContactEngine::evaluate_at).
    #[inline]
    pub fn evaluate(
        &self,
        quantity: Quantity,
        at: impl Into<At>,
    ) -> Result<Evaluation, ContactError> {
        self.evaluate_at(quantity, at.into())
    }

    /// The interval of a quantity at a place, beside the bound on the numerical error that its
    /// evaluation has; `None` for a model that knows none.
    pub fn interval(&self, quantity: Quantity, at: impl Into<At>) -> Option<Interval> {
        self.interval_at(Some(quantity), at.into())
    }

    /// [`force_and_tangent_at`](ContactEngine::force_and_tangent_at).
    ///
    /// # Errors
    /// The errors of [`evaluate_at`](ContactEngine::evaluate_at).
    #[inline]
    pub fn force_and_tangent(
        &self,
        at: impl Into<At>,
    ) -> Result<(Evaluation, Evaluation), ContactError> {
        self.force_and_tangent_at(at.into())
    }

    /// The separation of a place: of a load, the largest that carries it.
    ///
    /// # Errors
    /// The errors of [`separation_at`](ContactEngine::separation_at).
    pub fn separation(&self, at: impl Into<At>) -> Result<Separation, ContactError> {
        match at.into() {
            At::Separation(separation) => Ok(separation),
            at => self.separation_at(at.load(self.scene()).unwrap_or(f64::NAN)),
        }
    }

    /// The `separation` of a place in this unit, from this plane, on the scene of
    /// this contact: for models of pairs, σ and the mean planes of both surfaces.
    ///
    /// # Errors
    /// The errors of `separation` and [`Separation::measured_in`].
    pub fn separation_in(
        &self,
        unit: SeparationUnit,
        from: Datum,
        at: impl Into<At>,
    ) -> Result<f64, ContactError> {
        Ok(self.separation(at)?.measured_in(unit, from, self.scene())?.value)
    }

    /// [`shares_at`](ContactEngine::shares_at).
    ///
    /// # Errors
    /// The errors of [`shares_at`](ContactEngine::shares_at).
    pub fn shares(
        &self,
        quantity: Quantity,
        at: impl Into<At>,
    ) -> Result<Vec<Share>, ContactError> {
        self.shares_at(quantity, at.into())
    }
}
