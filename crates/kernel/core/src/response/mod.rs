//! Answers to requests.

pub(crate) mod evaluation;
pub(crate) mod row_check;

use serde::Serialize;

use self::row_check::RowCheck;
use crate::{At, ContactEngine, ContactError, Evaluation, Finding, Quantity, Request, Separation};

/// The values of one quantity, in the order of the request's places.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Column {
    /// The quantity.
    pub quantity: Quantity,
    /// One for each row: a value, or the reason why it has none.
    pub rows: Vec<Result<Evaluation, Box<ContactError>>>,
}

impl Column {
    /// The values in SI units; 0 only below the smallest double.
    ///
    /// # Errors
    /// The first reason why a row has no value.
    pub fn values(&self) -> Result<Vec<f64>, ContactError> {
        self.each(Evaluation::value)
    }

    /// Bounds on the errors: relative, but differences for logarithms and shares.
    ///
    /// # Errors
    /// The first reason why a row has no value.
    pub fn bounds(&self) -> Result<Vec<f64>, ContactError> {
        self.each(|evaluation| evaluation.bound(self.quantity))
    }

    fn each(&self, f: impl Fn(&Evaluation) -> f64) -> Result<Vec<f64>, ContactError> {
        let of = |row: &Result<Evaluation, Box<ContactError>>| match row {
            Ok(evaluation) => Ok(f(evaluation)),
            Err(error) => Err((**error).clone()),
        };
        self.rows.iter().map(of).collect()
    }
}

/// An answered request.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Response {
    /// The model's name.
    pub model: String,
    /// The places of the rows, in the caller's units.
    pub at: Vec<At>,
    /// The separations of the rows: as given, or those that carry the loads, the largest where
    /// there are several (of a tension, the smallest).
    pub separations: Vec<Result<Separation, Box<ContactError>>>,
    /// The quantities, in the order of the request.
    pub columns: Vec<Column>,
    /// Findings of the rows; the values stand.
    pub warnings: Vec<Finding>,
}

impl Response {
    /// The values of a quantity, in SI units.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`], and the first reason why a row has no value.
    pub fn values(&self, quantity: Quantity) -> Result<Vec<f64>, ContactError> {
        self.column(quantity)?.values()
    }

    /// The column of a quantity.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`].
    pub fn column(&self, quantity: Quantity) -> Result<&Column, ContactError> {
        let column = self.columns.iter().find(|c| c.quantity == quantity);
        column.ok_or(ContactError::NotRequested { quantity })
    }
}

/// A value, or the reason why there is none.
pub(crate) type Answered = Result<Evaluation, Box<ContactError>>;

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
