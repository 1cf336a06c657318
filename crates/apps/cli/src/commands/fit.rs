//! `asperity fit`: numbers of a scene from measurements.

use asperity::Code;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::bem::Bem;
use asperity::fit::{Data, FitError, Fitted, Observation, Progress, rank};
use asperity::{Described, Model};
use asperity_answer::{Cell, Sheet, Watch};
use asperity_scene::{Free, SceneError, read_measurements};
use clap::Args;

use crate::input::args::{DrawnArgs, EndArgs, model_id};
use crate::input::usage_error;
use crate::interrupt::{self, Terminal};
use crate::output::plot::{PANEL, POINTS, Plot};
use crate::output::table::Format;
use crate::output::{self, show};
use crate::scene::LoadedScene;

/// Fit numbers of the scene to measurements, with intervals, and rank models
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/fit.txt"))]
pub struct FitCommand {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Measurements, a csv; one row gives the scene in which a quantity has a value
    #[arg(value_name = "DATA")]
    data: PathBuf,
    #[command(flatten)]
    end: EndArgs,
    /// Free parameters, at least one, each with bounds if these are given
    #[arg(long, value_name = "KEY[=A:B]", value_delimiter = ',', required = true)]
    free: Vec<Free>,
    /// Models by id, as listed by `asperity list models` [default: ke; gw without a hardness]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    models: Vec<String>,
    #[command(flatten)]
    output: DrawnArgs,
}

impl FitCommand {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.scene, &[])?.taken_at(&self.end)?;
        let name = self.data.display().to_string();
        let data = scene.file.data(&read_measurements(&self.data)?).context(name.clone())?;
        if self.models.iter().any(|id| id == Bem::ID) {
            usage_error(
                "--model bem: boundary elements are not fitted; `asperity list models` lists other models",
            );
        }
        let models: Vec<Model> = match &self.models[..] {
            [] => vec![scene.one_or_usual(None)?],
            ids => {
                output::once(ids).iter().map(|id| scene.model(Some(id))).collect::<Result<_>>()?
            }
        };
        let (fitted, interrupted) = self.fit(&scene, (&name, &data), &models)?;
        let done = fitted.len();
        if done > 0 {
            self.write(&scene, &data, &models, &rank(fitted))?;
        }
        if interrupted {
            interrupt::end_with(&format!("{done} of {} models are fitted", models.len()));
        }
        Ok(())
    }

    /// The fitted models, and whether Ctrl-C ended the list.
    fn fit(
        &self,
        scene: &LoadedScene,
        (name, data): (&str, &Data),
        models: &[Model],
    ) -> Result<(Vec<Fitted>, bool)> {
        interrupt::listen()?;
        let mut fitted = vec![];
        for model in models {
            let id = model.id();
            let terminal = Terminal::default();
            terminal.progress(id);
            let mut step = |state: &Progress| {
                let (starts, evaluations) = (state.starts.max(1), state.evaluations);
                terminal.step(&format!("{id}: start {starts}, {evaluations} evaluations"))
            };
            match scene.file.fit(model, data, &self.free, &mut step) {
                Ok(found) => fitted.push(found),
                Err(SceneError::Fit(FitError::Interrupted)) => return Ok((fitted, true)),
                Err(error @ SceneError::Fit(FitError::NoStart { .. })) if models.len() > 1 => {
                    output::warn(Code::LeftOut, format!("left out: {error}"));
                }
                Err(error) => {
                    let place = match &error {
                        SceneError::Input { .. } | SceneError::Fit(FitError::Parameter { .. }) => {
                            usage_error(&format!("--free: {error}"))
                        }
                        SceneError::Fit(_) => name.into(),
                        _ => scene.name.clone(),
                    };
                    return Err(error).context(place);
                }
            }
        }
        if fitted.is_empty() {
            bail!("{name}: no model has values for the data");
        }
        Ok((fitted, false))
    }

    fn write(
        &self,
        scene: &LoadedScene,
        data: &Data,
        models: &[Model],
        ranked: &[Fitted],
    ) -> Result<()> {
        show(&scene.file.findings_of_fits(ranked));
        let picture = self.output.picture(|| picture(scene, data, models, ranked))?;
        let output = &self.output.output;
        self.output.write_beside(picture, || match output.format() {
            Format::Json => output.write_text(&(serde_json::to_string_pretty(ranked)? + "\n")),
            _ => output.write(&table(ranked)),
        })
    }
}

/// One row for each model and parameter.
fn table(ranked: &[Fitted]) -> Sheet {
    let mut table =
        Sheet::new(&["model", "parameter", "value", "lower", "upper", "unit", "rms", "bic"]);
    for one in ranked {
        for found in &one.parameters {
            let [value, lower, upper] =
                [Some(found.value), found.lower, found.upper].map(Cell::from);
            let others =
                [value, lower, upper, (&*found.unit).into(), one.rms.into(), one.bic.into()];
            table.add(&[&one.model, &found.name], others);
        }
    }
    table
}

/// Points of a model's curve.
const CURVE: usize = 101;

/// The data and the fitted models: each measured column against each kind of place.
fn picture(
    scene: &LoadedScene,
    data: &Data,
    models: &[Model],
    ranked: &[Fitted],
) -> Result<String> {
    let pair = |one: &Observation| [one.place().0.to_string(), one.measured.column()];
    let mut plot = Plot::new(&["model"], "", &[]);
    plot.panels = output::once(&data.iter().map(pair).collect::<Vec<_>>());
    let mut sheet = Sheet::new(&["model", PANEL]);
    sheet.heads.extend(output::once(&plot.panels.concat()));
    let mut add = |name: &str, one: &Observation, value: Option<f64>| {
        let [place, measured] = pair(one);
        let cell = |head: &String| match head {
            head if *head == place => one.place().1.into(),
            head if *head == measured => value.into(),
            head if head == PANEL => (&*measured).into(),
            _ => Cell::BLANK,
        };
        let mut row: Vec<Cell> = sheet.heads.iter().map(cell).collect();
        row[0] = name.into();
        sheet.rows.push(row);
    };
    let between = data.between(CURVE);
    for fitted in ranked {
        let Some(model) = models.iter().find(|model| model.id() == fitted.model) else { continue };
        let values = scene.file.fitted_values(model, fitted, &between)?;
        between.iter().zip(values).for_each(|(one, value)| add(model.id(), one, value));
    }
    data.iter().for_each(|one| add(POINTS, one, Some(one.value)));
    plot.svg(&sheet)
}
