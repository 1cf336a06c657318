//! The list of figures: for each a table of numbers and the description of its picture.

mod angles;
mod joints;
mod laws;
pub mod measured;
mod metals;
pub(crate) mod models;
pub(crate) mod paper;
mod readings;
pub mod report_csv;
mod shares;
mod slip;
pub mod truth;
pub mod truth_ranges;
mod unloading;

use anyhow::Result;
use asperity::Evidence;
use asperity::Quantity::{Area, Force, Stiffness};

pub use laws::some as some_laws;

use crate::table::Table;
use asperity_plot::Figure;
use truth::Shown;

/// One figure.
pub struct FigureSpec {
    /// Name of its files.
    pub name: &'static str,
    /// Computes its numbers.
    pub table: fn() -> Result<Table>,
    /// Describes the picture from the text of the csv, without physics.
    pub style: fn(&str) -> Result<Figure>,
}

/// All figures: those of the paper first.
pub const FIGURES: [FigureSpec; 19] = [
    FigureSpec {
        name: "fig04-force-roughness",
        table: || paper::roughness(Force),
        style: |_| paper::roughness_figure("Contact force against separation, AT model", Force),
    },
    FigureSpec {
        name: "fig05-force-models",
        table: || paper::nine_models(Force),
        style: |_| paper::models_figure("Contact force against separation, nine models", Force),
    },
    FigureSpec {
        name: "fig06-area-roughness",
        table: || paper::roughness(Area),
        style: |_| paper::roughness_figure("Real contact area against separation, AT model", Area),
    },
    FigureSpec {
        name: "fig07-area-models",
        table: || paper::nine_models(Area),
        style: |_| paper::models_figure("Real contact area against separation, nine models", Area),
    },
    FigureSpec {
        name: "fig08-stiffness-roughness",
        table: || paper::roughness(Stiffness),
        style: |_| {
            paper::roughness_figure("Contact stiffness against separation, AT model", Stiffness)
        },
    },
    FigureSpec {
        name: "fig09-stiffness-models",
        table: || paper::nine_models(Stiffness),
        style: |_| {
            paper::models_figure("Contact stiffness against separation, nine models", Stiffness)
        },
    },
    FigureSpec {
        name: "fig10-area-kucharski",
        table: paper::kucharski,
        style: paper::kucharski_figure,
    },
    FigureSpec { name: "laws-single-asperity", table: laws::table, style: laws::style },
    FigureSpec { name: "angle-density", table: angles::table, style: angles::style },
    FigureSpec { name: "at-regime-shares", table: shares::table, style: shares::style },
    FigureSpec { name: "at-readings", table: readings::table, style: readings::style },
    FigureSpec { name: "unloading-models", table: unloading::table, style: unloading::style },
    FigureSpec { name: "slip-loops", table: slip::table, style: slip::style },
    FigureSpec {
        name: "stiffness-kinds",
        table: joints::stiffness,
        style: joints::stiffness_figure,
    },
    FigureSpec {
        name: "conductance-models",
        table: joints::conductance,
        style: joints::conductance_figure,
    },
    FigureSpec { name: "conductance-metals", table: metals::table, style: metals::figure },
    FigureSpec {
        name: "truth-area",
        table: || truth::table(Evidence::CSV, Shown::Area),
        style: |csv| truth::style(csv, Shown::Area),
    },
    FigureSpec {
        name: "truth-stiffness",
        table: || truth::table(Evidence::CSV, Shown::Stiffness),
        style: |csv| truth::style(csv, Shown::Stiffness),
    },
    FigureSpec {
        name: "truth-unloading",
        table: || truth::table(Evidence::CSV, Shown::Unloading),
        style: |csv| truth::style(csv, Shown::Unloading),
    },
];
