//! The list of figures: for each a table of numbers and the description of its picture.

mod angles;
mod at;
pub mod captions;
pub mod compared;
pub mod curved;
mod cycles;
mod joints;
mod laws;
pub mod measured;
pub mod models;
mod pairs;
pub(crate) mod paper;
pub mod report_csv;
pub mod truth;
pub mod world;

use anyhow::Result;
use asperity::Evidence;
use asperity::Quantity::{Area, Force, Stiffness};
use asperity_plot::Figure;

use crate::table::Table;
use models::{kucharski, scene};
use paper::{ROUGHNESS, all_models, models_figure, roughness, roughness_figure};
use truth::SHOWN as TRUTH;

/// One figure: the name of its files, what computes its numbers, and what describes its picture
/// from the text of the csv, without physics.
pub type FigureSpec = (&'static str, fn() -> Result<Table>, fn(&str) -> Result<Figure>);

/// Models beside boundary elements.
fn truth_table(which: usize) -> Result<Table> {
    truth::table(&Evidence::with_models()?, &TRUTH[which])
}

/// All figures: the paper's first.
pub const FIGURES: [FigureSpec; 25] = [
    ("fig04-force-roughness", || roughness(Force), |_| roughness_figure(Force)),
    ("fig05-force-models", || all_models(Force, scene(ROUGHNESS)), |_| models_figure(Force)),
    ("fig06-area-roughness", || roughness(Area), |_| roughness_figure(Area)),
    ("fig07-area-models", || all_models(Area, scene(ROUGHNESS)), |_| models_figure(Area)),
    ("fig08-stiffness-roughness", || roughness(Stiffness), |_| roughness_figure(Stiffness)),
    (
        "fig09-stiffness-models",
        || all_models(Stiffness, scene(ROUGHNESS)),
        |_| models_figure(Stiffness),
    ),
    ("fig10-area-kucharski", || all_models(Area, kucharski()), |_| models_figure(Area)),
    ("laws-single-asperity", laws::table, laws::style),
    ("angle-density", angles::table, angles::style),
    ("at-regime-shares", at::shares, at::shares_figure),
    ("at-readings", at::readings, at::readings_figure),
    ("unloading-models", cycles::unloading, cycles::unloading_figure),
    ("slip-loops", cycles::slip, cycles::slip_figure),
    ("stiffness-kinds", joints::stiffness, joints::stiffness_figure),
    ("conductance-models", joints::conductance, joints::conductance_figure),
    ("conductance-metals", joints::metals, joints::metals_figure),
    ("curved-bodies", || curved::committed("curved.csv", "ratio"), curved::style),
    ("rough-sphere", || curved::committed(curved::SOLVED, "value"), curved::sphere_style),
    ("pairs-fits", pairs::table, pairs::style),
    (TRUTH[0].0, || truth_table(0), |csv| truth::style(csv, &TRUTH[0])),
    (TRUTH[1].0, || truth_table(1), |csv| truth::style(csv, &TRUTH[1])),
    (TRUTH[2].0, || truth_table(2), |csv| truth::style(csv, &TRUTH[2])),
    ("world-sphere", world::sphere::table, world::sphere::style),
    ("world-elastic", world::gfmd::table, world::gfmd::style),
    ("world-closure", world::closure::table, world::closure::style),
];
