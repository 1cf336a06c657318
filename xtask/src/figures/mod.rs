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
use asperity_plot::Figure;

pub use laws::some as some_laws;

use crate::table::Table;
use truth::SHOWN as TRUTH;

/// One figure.
pub struct FigureSpec {
    /// Name of its files.
    pub name: &'static str,
    /// Computes its numbers.
    pub table: fn() -> Result<Table>,
    /// Describes the picture from the text of the csv, without physics.
    pub style: fn(&str) -> Result<Figure>,
}

const fn of(
    name: &'static str,
    table: fn() -> Result<Table>,
    style: fn(&str) -> Result<Figure>,
) -> FigureSpec {
    FigureSpec { name, table, style }
}

/// All figures: those of the paper first.
pub const FIGURES: [FigureSpec; 19] = [
    of("fig04-force-roughness", || paper::roughness(Force), |_| paper::roughness_figure(Force)),
    of("fig05-force-models", || paper::nine_models(Force), |_| paper::models_figure(Force)),
    of("fig06-area-roughness", || paper::roughness(Area), |_| paper::roughness_figure(Area)),
    of("fig07-area-models", || paper::nine_models(Area), |_| paper::models_figure(Area)),
    of(
        "fig08-stiffness-roughness",
        || paper::roughness(Stiffness),
        |_| paper::roughness_figure(Stiffness),
    ),
    of(
        "fig09-stiffness-models",
        || paper::nine_models(Stiffness),
        |_| paper::models_figure(Stiffness),
    ),
    of("fig10-area-kucharski", paper::kucharski, paper::kucharski_figure),
    of("laws-single-asperity", laws::table, laws::style),
    of("angle-density", angles::table, angles::style),
    of("at-regime-shares", shares::table, shares::style),
    of("at-readings", readings::table, readings::style),
    of("unloading-models", unloading::table, unloading::style),
    of("slip-loops", slip::table, slip::style),
    of("stiffness-kinds", joints::stiffness, joints::stiffness_figure),
    of("conductance-models", joints::conductance, joints::conductance_figure),
    of("conductance-metals", metals::table, metals::style),
    of(
        TRUTH[0].name,
        || truth::table(Evidence::CSV, &TRUTH[0]),
        |csv| truth::style(csv, &TRUTH[0]),
    ),
    of(
        TRUTH[1].name,
        || truth::table(Evidence::CSV, &TRUTH[1]),
        |csv| truth::style(csv, &TRUTH[1]),
    ),
    of(
        TRUTH[2].name,
        || truth::table(Evidence::CSV, &TRUTH[2]),
        |csv| truth::style(csv, &TRUTH[2]),
    ),
];
