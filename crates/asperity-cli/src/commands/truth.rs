//! `asperity truth`: comparison of models with boundary elements on the scan of a scene.

use std::mem::discriminant;
use std::path::PathBuf;

use anyhow::{Result, bail};
use asperity::bem::{Bem, BemError};
use asperity::{
    AsWritten, ContactError, ContactState, Described, Dialect, Model, Truth, compare_with_bem,
    summary,
};
use clap::{ArgAction, Args};

use crate::commands::bem::Way;
use crate::input::args::{OutputArgs, listed_model_id};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{load, pressure};
use crate::interrupt;
use crate::output::table::{Cell, Table};
use crate::output::{once, print_message, progress};
use crate::scene::{LoadedScene, by_reason};

/// Compare models with boundary elements on the scan of a scene
#[derive(Debug, Args)]
#[command(
    after_help = "The scene names a scan: [surface] file = \"scan.txt\". It is solved as by `asperity bem`,
and the models use the asperities of the same scan.
Deviations are relative to bem; of the mean gap, over the rms height of the scan.
A model that needs more than the nominal area, or a mean pressure above 1.5 times the
hardness, has no result. Rows and values without a result are blank; the reason is printed.
Where contacts yield, the stiffness of bem is the chord between pressures up to 5 % to
either side.

Examples:
  asperity truth scan.toml --pressure 1e7,1e8,1e9
  asperity truth scan.toml --pressure 1e8 --refine
  asperity truth scan.toml --load 1000 --elastic --model gw,ke --format csv"
)]
pub struct TruthCommand {
    /// Scene file that names a scan
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Models [default: all that the scene allows, with random asperities and Persson]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = listed_model_id)]
    models: Vec<String>,
    #[command(flatten)]
    loads: Loads,
    #[command(flatten)]
    way: Way,
    /// Add the results on every second pixel as row bem-half-grid, to show their dependence on the
    /// grid
    #[arg(long)]
    refine: bool,
    #[command(flatten)]
    output: OutputArgs,
}

#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Loads {
    /// Pressures on the nominal area, in Pa: N from A to B, in equal steps or (log) ratios, or
    /// v,v,...
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = all(pressure))]
    #[arg(action = ArgAction::Append)]
    pressures: Vec<Numbers>,
    /// Loads on the nominal area, in N
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = all(load))]
    #[arg(action = ArgAction::Append)]
    loads: Vec<Numbers>,
}

impl TruthCommand {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load_any(&self.scene, self.way.periodic())?;
        let bem = self.way.bem(&scene)?;
        let models = |sheet: &mut _| {
            Ok(asperity_answer::models_beside_bem(&scene.file, &self.models, &[], sheet)?)
        };
        let (_, models) = scene.answer(models)?;
        let area = scene.file.scene.nominal_area;
        let numbers =
            |lists: &[Numbers]| lists.iter().flat_map(|l| l.0.clone()).collect::<Vec<_>>();
        let mut pressures = numbers(&self.loads.pressures);
        pressures.extend(numbers(&self.loads.loads).into_iter().map(|load| load / area));

        let bar = progress("truth");
        let solve = |bem: &Bem, models: &[Model]| -> Result<_> {
            let watch = interrupt::watch(|progress| {
                let all = 3 * pressures.len();
                bar.set_message(format!("truth: contact {} of {all}", progress.done + 1));
            })?;
            Ok(compare_with_bem(&scene.file.scene, bem, &pressures, models, watch)?)
        };
        let found = solve(&bem, &models)?;
        let half = match self.refine && !interrupt::requested() {
            true => solve(&bem.half_grid()?, &[])?.into_iter().map(Result::ok).collect(),
            false => vec![],
        };
        drop(bar);
        let errors: Vec<String> = found
            .iter()
            .filter_map(|one| one.as_ref().err().filter(|e| !matches!(e, BemError::Cancelled)))
            .map(ToString::to_string)
            .collect();
        once(&errors).iter().for_each(|text| print_message("warning", text));
        let half: Vec<Option<Truth>> =
            found.iter().zip(half).filter(|(one, _)| one.is_ok()).map(|(_, half)| half).collect();
        let found: Vec<Truth> = found.into_iter().flatten().collect();
        if found.is_empty() {
            if interrupt::requested() {
                interrupt::end(0, pressures.len());
            }
            bail!("{}: no load was solved", scene.name);
        }
        let of_truth = |truth: &Truth| {
            let refused = truth.refused.iter().map(|(_, why)| why.clone());
            truth.notes.iter().cloned().chain(refused).collect::<Vec<_>>()
        };
        scene.report(found.iter().flat_map(of_truth).collect());
        // One reason per model and kind: others differ only in the load.
        let mut missing: Vec<(String, ContactError)> = vec![];
        for (model, why) in found.iter().flat_map(|truth| &truth.missing) {
            let same = |(id, known): &(String, ContactError)| {
                id == model.id() && discriminant(known) == discriminant(why)
            };
            if !missing.iter().any(same) {
                missing.push((model.id().into(), why.clone()));
            }
        }
        for text in by_reason(&missing) {
            print_message("warning", &AsWritten.say(&text));
        }
        print_message("note", &summary(&found));
        scene.file.beside_table(&found).iter().for_each(|line| print_message("note", line));
        let mut table = table(&found, &half, area);
        table.head.push("boundary".into());
        table.rows.iter_mut().for_each(|row| row.push(bem.continuation().name().into()));
        self.output.write(&table)?;
        let mut states = found.iter().flat_map(|truth| &truth.models).map(|(_, state)| *state);
        if !models.is_empty() && states.all(|state| state == ContactState::default()) {
            bail!("{}: no model has a result", scene.name);
        }
        if interrupt::requested() {
            interrupt::end(found.len(), pressures.len());
        }
        Ok(())
    }
}

fn table(found: &[Truth], half: &[Option<Truth>], area: f64) -> Table {
    let mut table = Table::new(&[
        "load_N",
        "pressure_Pa",
        "model",
        "area_fraction",
        "area_deviation",
        "mean_gap_m",
        "mean_gap_deviation_over_sq",
        "stiffness_N_per_m",
        "stiffness_deviation",
    ]);
    for (k, truth) in found.iter().enumerate() {
        let models = truth.models.iter().map(|(model, state)| (model.id(), state));
        let half = half.get(k).and_then(Option::as_ref).map(|half| ("bem-half-grid", &half.bem));
        for (id, state) in [("bem", &truth.bem)].into_iter().chain(half).chain(models) {
            let deviation = truth.deviation(state);
            let numbers = |s: &ContactState| [s.area_fraction, s.mean_gap, s.stiffness];
            let both = numbers(state).into_iter().zip(numbers(&deviation));
            let place = [Some(truth.pressure * area), Some(truth.pressure)].map(Cell::Number);
            let mut row = place.to_vec();
            row.push(id.into());
            row.extend(both.flat_map(|(value, deviation)| [value, deviation]).map(Cell::Number));
            table.rows.push(row);
        }
    }
    table
}
