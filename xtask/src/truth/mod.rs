//! `cargo xtask truth`: every model compared with boundary elements on reproducible surfaces.
//!
//! Isotropic random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are solved
//! elastically and with several hardnesses. The results are in `crates/asperity/data/truth.csv`,
//! which `asperity::Evidence` reads; the figures and the table of the README follow from that text
//! alone.

pub mod cases;
mod markdown;
mod picture;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use asperity::bem::RandomSurface;
use asperity::{
    At, Contact, ContactError, ContactModel, ContactState, Evidence, Model, Quantity, Request,
    Scene, Truth, compare_with_bem,
};
use indicatif::{ProgressBar, ProgressStyle};

pub use cases::{FULL, SMALL, Scope, models};
pub use markdown::table as markdown;
pub use picture::{Shown, style, table};

use crate::folder::{figures_folder, save};
use crate::table::{Field, Table};
use cases::{GRADIENT, MODULUS};

/// The committed evidence, in the crate that includes it.
#[must_use]
pub fn evidence_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("crates/asperity/data/truth.csv")
}

/// Solves all cases, and writes the evidence and its figures; returns the paths.
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
/// Those of [`write()`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    let folder = figures_folder().with_file_name("tests").join("reference");
    save(&folder, [("truth_small.csv".to_owned(), solve(&SMALL)?)])
}

/// Evaluates the models of the committed evidence anew, keeps its boundary elements, and draws it.
///
/// # Errors
/// Evidence that is missing or cannot be read.
pub fn update_models(figures: &Path) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let mut paths = save(folder, [("truth.csv".to_owned(), asked_anew(&committed()?, &FULL)?)])?;
    paths.extend(draw(figures)?);
    Ok(paths)
}

fn committed() -> Result<String> {
    let path = evidence_file();
    std::fs::read_to_string(&path).with_context(|| path.display().to_string())
}

fn draw(figures: &Path) -> Result<Vec<PathBuf>> {
    let text = committed()?;
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

/// The models on a scene.
struct Asked {
    models: Vec<(Model, Box<dyn Contact>)>,
    /// The unit of stiffnesses \[N/m\].
    unit: f64,
}

impl Asked {
    /// All models that the scene allows.
    fn new(scene: &Scene, rms_height: f64) -> Self {
        let compiled = |model: Model| {
            let all = Request::new([Quantity::AreaFraction, Quantity::Tangent]);
            let contact = model.compile(scene, &all.at([At::Pressure(1.0)])).ok()?;
            Some((model, contact))
        };
        let models = models().into_iter().filter_map(compiled).collect();
        Self { models, unit: MODULUS * scene.nominal_area / rms_height }
    }

    /// Their rows at a load.
    fn push(&self, table: &mut Table, place: &[Field], load: f64) -> Result<()> {
        let at = At::Pressure(load * MODULUS * GRADIENT);
        for (model, contact) in &self.models {
            let area = contact.evaluate(Quantity::AreaFraction, at);
            let area = area.with_context(|| format!("{model} at p/(E g) = {load}"))?.value();
            let stiffness = match contact.evaluate(Quantity::Tangent, at) {
                Ok(stiffness) => Field::Number(stiffness.value() / self.unit),
                // Gao and AT miss their tolerance at one load, where most of the surface is in
                // contact.
                Err(ContactError::Integral { .. }) => Field::Gap,
                Err(error) => bail!("{model} at p/(E g) = {load}: {error}"),
            };
            let gaps = [Field::Gap; 2];
            let (model, area) = ([Field::Word(model.id())], [Field::Number(area)]);
            table.push(&[place, &model, &area, &gaps, &[stiffness], &gaps].concat())?;
        }
        Ok(())
    }
}

/// The same evidence with the models evaluated anew and its boundary elements unchanged.
///
/// # Errors
/// A text that is not the evidence of these surfaces.
pub fn asked_anew(text: &str, scope: &Scope) -> Result<String> {
    let mut table = Table::new(&Evidence::COLUMNS);
    let mut last: Option<([u64; 2], Asked)> = None;
    for case in Evidence::parse(text)?.cases() {
        let key = [case.alpha, case.plasticity_index].map(f64::to_bits);
        let asked = match last.take() {
            Some((known, asked)) if known == key => asked,
            _ => {
                let surfaces = scope.waves.iter().map(|waves| cases::surface(scope, *waves));
                let surfaces = surfaces.collect::<Result<Vec<_>>>()?;
                let same = |surface: &&RandomSurface| {
                    (surface.moments().bandwidth() / case.alpha - 1.0).abs() < 1e-6
                };
                let surface = surfaces.iter().find(same).context("a surface of another scope")?;
                let scene = cases::scene(surface, case.plasticity_index)?;
                Asked::new(&scene, surface.moments().m0.sqrt())
            }
        };
        let place = [case.alpha, case.plasticity_index, case.load].map(Field::Number);
        let numbers = |mean: Option<f64>, span: Option<[f64; 2]>| -> Result<[Field<'_>; 3]> {
            let (mean, [low, high]) = mean.zip(span).context("a row of bem without numbers")?;
            Ok([mean, low, high].map(Field::Number))
        };
        let area = numbers(case.bem.area_fraction, case.bem.area_span)?;
        let stiffness = numbers(case.bem.stiffness, case.bem.stiffness_span)?;
        table.push(&[&place[..], &[Field::Word("bem")], &area, &stiffness].concat())?;
        asked.push(&mut table, &place, case.load)?;
        last = Some((key, asked));
    }
    Ok(table.into_text())
}

/// The evidence of a scope, as csv.
///
/// # Errors
/// A case that cannot be solved.
pub fn solve(scope: &Scope) -> Result<String> {
    let mut table = Table::new(&Evidence::COLUMNS);
    let count = scope.waves.len() * scope.indices.len() * scope.seeds as usize;
    let bar = ProgressBar::new(count as u64);
    bar.set_style(ProgressStyle::with_template("{wide_bar} {pos}/{len} {msg}")?);
    for waves in scope.waves {
        let surface = cases::surface(scope, *waves)?;
        let moments = surface.moments();
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
                let bem = cases::bem(scope, surface, seed)?;
                let found =
                    compare_with_bem(&scene, &bem, &pressures, &[], |_| ControlFlow::Continue(()))?;
                seeds.push(found.into_iter().collect::<Result<_, _>>()?);
                bar.inc(1);
            }
            let asked = Asked::new(&scene, moments.m0.sqrt());
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
                let stiffness = of(|state| state.stiffness)?.map(|k| Field::Number(k / asked.unit));
                table.push(&[&place[..], &[Field::Word("bem")], &area, &stiffness].concat())?;
                asked.push(&mut table, &place, *load)?;
            }
        }
    }
    bar.finish_and_clear();
    Ok(table.into_text())
}
