//! What comes back.

use rayon::prelude::*;

use crate::{Compiled, ContactError, Evaluation, Quantity, Request, Share, Warning};

/// Fewer separations than this are evaluated on the calling thread: handing them out costs more.
const PARALLEL_FROM: usize = 2048;

/// The values of one quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// The quantity.
    pub quantity: Quantity,
    /// In SI units, in the order of the separations; 0 only below the smallest double.
    pub values: Vec<f64>,
    /// Logarithms of the absolute values, also where the values underflow.
    pub ln_values: Vec<f64>,
    /// Bounds on the relative errors, if they were asked for.
    pub bounds: Option<Vec<f64>>,
    /// Shares of the parts of the law, if they were asked for.
    pub shares: Option<Vec<Vec<Share>>>,
}

/// An answered request.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    /// The model's name.
    pub model: String,
    /// Separations d/σ_z, as asked.
    pub separations: Vec<f64>,
    /// σ_z \[m\].
    pub asperity_height_std: f64,
    /// The quantities, in the order of the request.
    pub columns: Vec<Column>,
    /// What deserves a word; the values stand.
    pub warnings: Vec<Warning>,
}

impl Response {
    /// The values of a quantity, in SI units.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`].
    pub fn values(&self, quantity: Quantity) -> Result<&[f64], ContactError> {
        Ok(&self.column(quantity)?.values)
    }

    /// Everything there is of a quantity.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`].
    pub fn column(&self, quantity: Quantity) -> Result<&Column, ContactError> {
        let column = self.columns.iter().find(|c| c.quantity == quantity);
        column.ok_or(ContactError::NotRequested { quantity })
    }
}

impl Compiled {
    /// Answers the request for the quantities this scene was compiled for.
    ///
    /// Long lists of separations are evaluated on all cores; the digits do not depend on it.
    ///
    /// # Errors
    /// Those of [`evaluate`](Compiled::evaluate).
    pub fn respond(&self, request: &Request) -> Result<Response, ContactError> {
        let mut warnings = self.warnings().to_vec();
        let mut columns = Vec::with_capacity(request.quantities.len());
        for &quantity in &request.quantities {
            let column = self.column(quantity, request)?;
            warnings.extend(self.negative(&column, &request.separations));
            columns.push(column);
        }
        Ok(Response {
            model: self.model().into(),
            separations: request.separations.clone(),
            asperity_height_std: self.asperity_height_std(),
            columns,
            warnings,
        })
    }

    fn column(&self, quantity: Quantity, request: &Request) -> Result<Column, ContactError> {
        let evaluate = |s: &f64| self.evaluate(quantity, *s);
        let separations = &request.separations;
        let evaluations: Vec<Evaluation> = if separations.len() < PARALLEL_FROM {
            separations.iter().map(evaluate).collect::<Result<_, _>>()?
        } else {
            separations.par_iter().with_min_len(512).map(evaluate).collect::<Result<_, _>>()?
        };
        let shares = if request.shares {
            let shares = separations.iter().map(|s| self.shares(quantity, *s));
            Some(shares.collect::<Result<Vec<_>, _>>()?)
        } else {
            None
        };
        Ok(Column {
            quantity,
            values: evaluations.iter().map(Evaluation::value).collect(),
            ln_values: evaluations.iter().map(Evaluation::ln_value).collect(),
            bounds: request
                .bounds
                .then(|| evaluations.iter().map(Evaluation::relative_error).collect()),
            shares,
        })
    }

    fn negative(&self, column: &Column, separations: &[f64]) -> Option<Warning> {
        let negative = column.values.iter().zip(separations).filter(|(value, _)| **value < 0.0);
        let (value, separation) = negative.clone().next()?;
        Some(Warning::Negative {
            model: self.model().into(),
            quantity: column.quantity,
            count: negative.count(),
            separation: *separation,
            value: *value,
        })
    }
}
