//! The list of figures: for each a table of numbers, and how it is drawn.

mod angles;
mod laws;
pub(crate) mod models;
mod paper;
mod readings;
mod shares;

use anyhow::Result;

use crate::draw::Figure;
use crate::table::Table;

/// One figure.
pub struct FigureSpec {
    /// Name of its files.
    pub name: &'static str,
    /// Computes its numbers.
    pub table: fn() -> Result<Table>,
    /// Describes the picture; sees the csv's text, and no physics.
    pub style: fn(&str) -> Result<Figure>,
}

/// All figures: the paper's, then those beyond it.
pub const FIGURES: [FigureSpec; 11] = [
    FigureSpec { name: "fig04-force-roughness", table: paper::table_04, style: paper::style_04 },
    FigureSpec { name: "fig05-force-models", table: paper::table_05, style: paper::style_05 },
    FigureSpec { name: "fig06-area-roughness", table: paper::table_06, style: paper::style_06 },
    FigureSpec { name: "fig07-area-models", table: paper::table_07, style: paper::style_07 },
    FigureSpec {
        name: "fig08-stiffness-roughness",
        table: paper::table_08,
        style: paper::style_08,
    },
    FigureSpec { name: "fig09-stiffness-models", table: paper::table_09, style: paper::style_09 },
    FigureSpec { name: "fig10-area-kucharski", table: paper::table_10, style: paper::style_10 },
    FigureSpec { name: "laws-single-asperity", table: laws::table, style: laws::style },
    FigureSpec { name: "angle-density", table: angles::table, style: angles::style },
    FigureSpec { name: "at-regime-shares", table: shares::table, style: shares::style },
    FigureSpec { name: "at-readings", table: readings::table, style: readings::style },
];
