//! `cargo xtask truth`: every model beside boundary elements on surfaces that anybody can make again.
//!
//! Isotropic random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are pressed elastic and
//! with hardnesses. What is found goes to `crates/asperity/data/truth.csv`, which `asperity::Evidence`
//! reads; the figures and the table of the README are drawn from that text and from nothing else.

pub mod cases;
mod markdown;
mod picture;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asperity::{ContactState, Model, Truth, truth};
use indicatif::{ProgressBar, ProgressStyle};

pub use cases::{FULL, SMALL, Scope};
pub use markdown::table as markdown;
pub use picture::{Shown, style, table};

use crate::files::{figures_folder, save};
use crate::table::{Field, Table};
use cases::{GRADIENT, MODULUS};

/// Columns of the evidence; `low` and `high` are of the seeds, for `bem` alone. Stiffnesses
/// -dp/d(gap) are in units of E/√m₀.
const COLUMNS: [&str; 10] = [
    "alpha",
    "plasticity_index",
    "p_over_Eg",
    "model",
    "area_fraction",
    "area_low",
    "area_high",
    "stiffness",
    "stiffness_low",
    "stiffness_high",
];

/// Where the evidence is committed: in the crate that is built with it.
#[must_use]
pub fn evidence_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("crates/asperity/data/truth.csv")
}

/// Solves all cases, and writes the evidence and what is drawn from it; returns the paths.
///
/// # Errors
/// A case that cannot be solved, a file that cannot be written.
pub fn write(figures: &Path) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let text = solve(&FULL)?;
    let mut paths = save(folder, [("truth.csv".to_owned(), text)])?;
    paths.extend(draw(figures)?);
    Ok(paths)
}

/// Solves the small case for the tests; returns its path.
///
/// # Errors
/// Those of [`write`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    let folder = figures_folder().with_file_name("tests").join("reference");
    save(&folder, [("truth_small.csv".to_owned(), solve(&SMALL)?)])
}

/// Draws what is committed anew, without solving anything.
///
/// # Errors
/// Evidence that is missing or none.
pub fn draw(figures: &Path) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let mut drawn = vec![("truth.md".to_owned(), markdown(&text)?)];
    for shown in Shown::ALL {
        let csv = table(&text, shown)?.into_text();
        let svg = asperity_plot::draw(&style(&csv, shown)?, &csv)?;
        drawn.extend([
            (format!("{}.csv", shown.name()), csv),
            (format!("{}.svg", shown.name()), svg),
        ]);
    }
    save(figures, drawn)
}

/// Every model that stands beside boundary elements.
#[must_use]
pub fn models() -> Vec<Model> {
    [Model::all(), Model::all_random(), Model::whole_surface()].concat()
}

/// The evidence of a scope, as csv.
///
/// # Errors
/// A case that cannot be solved.
pub fn solve(scope: &Scope) -> Result<String> {
    let models = models();
    let mut table = Table::new(&COLUMNS);
    let count = scope.waves.len() * scope.indices.len() * scope.seeds as usize;
    let bar = ProgressBar::new(count as u64);
    bar.set_style(ProgressStyle::with_template("{wide_bar} {pos}/{len} {msg}")?);
    for waves in scope.waves {
        let surface = cases::surface(scope, *waves)?;
        let moments = cases::moments(&surface);
        for &index in scope.indices {
            let scene = cases::scene(&surface, index)?;
            let pressures: Vec<f64> = scope.loads.iter().map(|x| x * MODULUS * GRADIENT).collect();
            let mut seeds: Vec<Vec<Truth>> = vec![];
            for seed in 1..=scope.seeds {
                let case = format!("alpha {:.1}, psi {index}, seed {seed}", moments.bandwidth());
                if bar.is_hidden() {
                    eprintln!("{} of {count}: {case}", bar.position() + 1);
                }
                bar.set_message(case);
                // They answer alike on every seed.
                let asked = if seed == 1 { &models[..] } else { &[] };
                let bem = cases::bem(scope, surface, seed)?;
                let found = truth(&scene, &bem, &pressures, asked, |_| ControlFlow::Continue(()))?;
                seeds.push(found.into_iter().collect::<Result<_, _>>()?);
                bar.inc(1);
            }
            let unit = MODULUS * scene.nominal_area / moments.m0.sqrt();
            for (k, load) in scope.loads.iter().enumerate() {
                let place = [moments.bandwidth(), index, *load].map(Field::Number);
                let of = |value: fn(&ContactState) -> Option<f64>| -> Result<[f64; 3]> {
                    let all = seeds.iter().map(|seed| value(&seed[k].bem).context("no value"));
                    let all = all.collect::<Result<Vec<f64>>>()?;
                    let mean = all.iter().sum::<f64>() / all.len() as f64;
                    let [low, high] = [f64::min, f64::max].map(|of| all.iter().copied().reduce(of));
                    Ok([mean, low.unwrap_or(mean), high.unwrap_or(mean)])
                };
                let area = of(|state| state.area_fraction)?.map(Field::Number);
                let stiffness = of(|state| state.stiffness)?.map(|k| Field::Number(k / unit));
                table.push(&[&place[..], &[Field::Word("bem")], &area, &stiffness].concat())?;
                for (model, state) in &seeds[0][k].models {
                    let number = |value: Option<f64>| value.map_or(Field::Gap, Field::Number);
                    if state.area_fraction.is_none() {
                        continue;
                    }
                    let area = [number(state.area_fraction), Field::Gap, Field::Gap];
                    let stiffness = state.stiffness.map(|k| k / unit);
                    let stiffness = [number(stiffness), Field::Gap, Field::Gap];
                    let model = [Field::Word(model.id())];
                    table.push(&[&place[..], &model, &area, &stiffness].concat())?;
                }
            }
        }
    }
    bar.finish_and_clear();
    Ok(table.into_text())
}
