//! Errors of a figure's description or of its csv.

use plotters::drawing::DrawingAreaErrorKind;

/// A picture that cannot be drawn.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A text that is not a csv table.
    #[error("the csv cannot be read: {0}")]
    Csv(#[from] csv::Error),
    /// A column that the description names.
    #[error("column `{column}` is missing from the csv, which has: {has}")]
    MissingColumn {
        /// The missing name.
        column: String,
        /// The names in the csv.
        has: String,
    },
    /// A curve that the description names.
    #[error("curve `{curve}` is not in column `{column}` of the csv")]
    MissingCurve {
        /// The missing name.
        curve: String,
        /// The column that names the curve of a row.
        column: String,
    },
    /// A curve of the csv that no panel draws.
    #[error("curve `{curve}` of column `{column}` is drawn by no panel")]
    Undrawn {
        /// The curve.
        curve: String,
        /// The column that names the curve of a row.
        column: String,
    },
    /// A cell that is not a number.
    #[error("line {line} of the csv: `{text}` is not a number, as column `{column}` requires")]
    NotANumber {
        /// The line, counted from 1 at the head.
        line: u64,
        /// The column.
        column: String,
        /// The text of the cell.
        text: String,
    },
    /// An unusable range or factor.
    #[error("axis `{axis}` from {low} to {high}: {required} was required")]
    Range {
        /// The axis by its label.
        axis: String,
        /// Its low end.
        low: f64,
        /// Its high end.
        high: f64,
        /// What was required.
        required: &'static str,
    },
    /// Two curves that cannot be the edges of an area.
    #[error(
        "curve `{curve}` cannot be an edge of an area: one piece without gaps and with the x of the other edge was required"
    )]
    Area {
        /// The curve.
        curve: String,
    },
    /// Curves stacked on a logarithmic axis, which has no 0.
    #[error("curve `{curve}` is stacked on others: a linear vertical axis was required")]
    Stacked {
        /// The first of them.
        curve: String,
    },
    /// A map with an unsuitable number of cells.
    #[error("the number of cells differs from {rows} rows of {columns} columns, or is 0")]
    Cells {
        /// Names of rows.
        rows: usize,
        /// Names of columns.
        columns: usize,
    },
    /// The drawing library failed.
    #[error("drawing failed: {0}")]
    Drawing(String),
}

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for PlotError {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        Self::Drawing(error.to_string())
    }
}
