//! Answers to requests.

pub(crate) mod evaluation;
pub(crate) mod fill;
pub(crate) mod plan;
pub(crate) mod row_check;

use serde::Serialize;

use crate::{At, ContactError, Evaluation, Finding, Quantity, Separation};

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
        let found = self.rows.iter().map(|row| row.as_ref().map(Evaluation::value));
        found.collect::<Result<_, _>>().map_err(|error| (**error).clone())
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
