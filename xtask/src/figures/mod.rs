//! The list of figures: for each a table of numbers and the description of its picture.

mod angles;
pub mod captions;
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
use paper::{kucharski, kucharski_figure, models_figure, nine_models, roughness, roughness_figure};
use truth::SHOWN as TRUTH;

/// Describes a picture from the text of the csv, without physics.
pub type Style = fn(&str) -> Result<Figure>;

/// One figure.
pub struct FigureSpec {
    /// Name of its files.
    pub name: &'static str,
    /// Computes its numbers.
    pub table: fn() -> Result<Table>,
    /// Describes the picture.
    style: Style,
}

impl FigureSpec {
    /// The picture of a csv, with its title and caption.
    ///
    /// # Errors
    /// Another csv.
    pub fn picture(&self, csv: &str) -> Result<Figure> {
        captions::with_caption(self.name, (self.style)(csv)?)
    }
}

const fn of(name: &'static str, table: fn() -> Result<Table>, style: Style) -> FigureSpec {
    FigureSpec { name, table, style }
}

/// Models beside boundary elements.
fn truth_table(which: usize) -> Result<Table> {
    truth::table(Evidence::committed()?, &TRUTH[which])
}

/// All figures: those of the paper first.
pub const FIGURES: [FigureSpec; 19] = [
    of("fig04-force-roughness", || roughness(Force), |_| roughness_figure(Force)),
    of("fig05-force-models", || nine_models(Force), |_| models_figure(Force)),
    of("fig06-area-roughness", || roughness(Area), |_| roughness_figure(Area)),
    of("fig07-area-models", || nine_models(Area), |_| models_figure(Area)),
    of("fig08-stiffness-roughness", || roughness(Stiffness), |_| roughness_figure(Stiffness)),
    of("fig09-stiffness-models", || nine_models(Stiffness), |_| models_figure(Stiffness)),
    of("fig10-area-kucharski", kucharski, kucharski_figure),
    of("laws-single-asperity", laws::table, laws::style),
    of("angle-density", angles::table, angles::style),
    of("at-regime-shares", shares::table, shares::style),
    of("at-readings", readings::table, readings::style),
    of("unloading-models", unloading::table, unloading::style),
    of("slip-loops", slip::table, slip::style),
    of("stiffness-kinds", joints::stiffness, joints::stiffness_figure),
    of("conductance-models", joints::conductance, joints::conductance_figure),
    of("conductance-metals", metals::table, metals::style),
    of(TRUTH[0].0, || truth_table(0), |csv| truth::style(csv, &TRUTH[0])),
    of(TRUTH[1].0, || truth_table(1), |csv| truth::style(csv, &TRUTH[1])),
    of(TRUTH[2].0, || truth_table(2), |csv| truth::style(csv, &TRUTH[2])),
];
