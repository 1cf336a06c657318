//! Why there is no table for a finite-element code.

use crate::ContactError;
use crate::tables::format::TableFormat;

/// Why there is no table.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// The model refused.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The code allows fewer nodes.
    #[error(
        "{nodes} nodes: {format} allows {most}; increase the error, narrow the range or give fewer nodes"
    )]
    TooMany {
        /// Nodes of the table.
        nodes: usize,
        /// Nodes that can be written.
        most: usize,
        /// The code.
        format: &'static str,
    },
    /// A table made by the caller is empty or does not fall.
    #[error("{nodes} nodes: two or more were required, at different pressures above 0")]
    TooFew {
        /// Nodes of the table.
        nodes: usize,
    },
    /// The format has no such table.
    #[error("{} has no {what}; use {known}", format.name())]
    NoSuchTable {
        /// The format.
        format: TableFormat,
        /// What it lacks.
        what: &'static str,
        /// Formats that have it.
        known: &'static str,
    },
    /// The range is empty.
    #[error("range is {first} to {last}: a first separation below the last was required")]
    Range {
        /// Smallest separation over σ_z.
        first: f64,
        /// Largest.
        last: f64,
    },
    /// A solver cannot use a pressure that does not fall as the surfaces part.
    #[error(
        "{model}: at a separation of {separation} asperity_height_std the pressure is {pressure:e} Pa and its stiffness {stiffness:e} Pa/m: both above 0 were required, at every separation of the range"
    )]
    NotFalling {
        /// The model.
        model: String,
        /// Separation over σ_z.
        separation: f64,
        /// Pressure \[Pa\].
        pressure: f64,
        /// Stiffness \[Pa/m\].
        stiffness: f64,
    },
    /// The cubic between two nodes would rise and fall.
    #[error(
        "{nodes} nodes are too few: the cubic between separations {from} and {to} is not monotone; more nodes were required"
    )]
    Overshoot {
        /// Number of nodes.
        nodes: usize,
        /// Separation of one node over σ_z.
        from: f64,
        /// Of the next.
        to: f64,
    },
    /// An error that cannot be met.
    #[error(
        "error is {error:e}, which 100000 nodes and the tolerance of the integrals cannot meet; give a larger error or a narrower range"
    )]
    TooFine {
        /// The relative error asked for.
        error: f64,
    },
}
