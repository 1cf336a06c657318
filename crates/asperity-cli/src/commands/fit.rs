//! `asperity fit`: numbers of a scene from measurements.

use std::ops::ControlFlow;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::bem::Bem;
use asperity::fit::{Data, FitError, Fitted, MeasuredTable, Progress, Role, rank};
use asperity_inputs::{Free, SceneError, read_measurements};
use clap::error::ErrorKind;
use clap::{ArgGroup, Args};

use crate::input::args::{DrawnArgs, model_id};
use crate::input::numbers::{load, pressure};
use crate::input::target::{metres, target};
use crate::input::usage_error;
use crate::interrupt;
use crate::output::fit_report::Report;
use crate::output::table::Format;
use crate::output::{self, print_message, progress};
use crate::scene::{LoadedScene, NamedModel};
use asperity_answer::rounded;

/// Fit numbers of the scene to measurements, with intervals, and rank models
#[derive(Debug, Args)]
#[command(
    group(ArgGroup::new("source").required(true)),
    group(ArgGroup::new("place")),
    override_usage = "asperity fit [OPTIONS] --free <KEY[=A:B]> <SCENE> <DATA>
       asperity fit [OPTIONS] --free <KEY[=A:B]> --target <Q=V> --load <P> <SCENE>",
    after_help = "DATA is a csv with the columns of `asperity curve`: load_N, pressure_Pa or
separation_m, and any of area_m2, area_fraction, tangent_N_per_m,
unloading_stiffness_N_per_m (ultrasound, modal tests), thermal_conductance_W_per_K and so
on, each with <column>_std if known. Cells may be empty. Numbers may have decimal commas
where semicolons or tabs separate the columns. Without standard deviations the
residuals are ln(fitted/measured). A separation beside a load is compared by the load at
that separation, unless it has a standard deviation.

Free parameters are numbers of the scene by their keys (hardness, asperity_height_std,
body1_youngs_modulus, plasticity_index), and what a rig adds: separation_offset (linear,
reading minus separation) and series_compliance (of the rig, in m/N: a stiffness K reads
1/(1/K + c), a separation d reads d + offset - c F). Parameters start at the values of
the scene; default bounds are a factor 30 either way.

Columns: model, parameter, value, lower and upper (the 95 % interval; blank where the data
do not fix that end within the bounds), unit, rms (relative) and bic. Models are ordered by
BIC, lowest first, or by rms where one of them has no BIC. json also has correlation,
condition, undetermined combinations, limits at which parameters stop, residuals,
unreachable data, an outlier and another stiffness that fits. If no model describes the
data, or none reaches the target, the exit code is 1.
With --target instead of DATA, the scene in which a quantity has a value at one load.

Examples:
  asperity curve scene.toml --model ke --pressure 1e5:1e7:8:log --quantity area,unloading-stiffness --output data.csv
  asperity fit scene.toml data.csv --free asperity_height_std=0.1um:5um,hardness --model ke,jg
  asperity fit scene.toml data.csv --free asperity_height_std,series_compliance --plot fit.svg
  asperity fit scene.toml --free asperity_height_std --target area_fraction=0.4% --pressure 5MPa"
)]
pub struct FitCommand {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Measurements, a csv
    #[arg(value_name = "DATA", group = "source")]
    data: Option<PathBuf>,
    /// Free parameters, at least one, each with bounds if these are given
    #[arg(long, value_name = "KEY[=A:B]", value_delimiter = ',')]
    free: Vec<Free>,
    /// Models by id, as listed by `asperity list models` [default: ke; gw without a hardness]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    models: Vec<String>,
    /// The value wanted of a quantity, instead of DATA, for example area_fraction=2%
    #[arg(long, value_name = "Q=V", value_delimiter = ',', value_parser = target)]
    #[arg(group = "source", requires = "place")]
    target: Vec<(String, f64)>,
    /// Load of the target, in N, or with a unit, for example 2kN
    #[arg(long, value_name = "P", value_parser = load, group = "place", conflicts_with = "data")]
    load: Option<f64>,
    /// Load of the target as a pressure on the nominal area, in Pa, or with a unit
    #[arg(long, value_name = "P", value_parser = pressure, group = "place", conflicts_with = "data")]
    pressure: Option<f64>,
    /// Separation of the target, with its unit, for example 2um
    #[arg(long, value_name = "D", value_parser = metres, group = "place", conflicts_with = "data")]
    separation: Option<f64>,
    #[command(flatten)]
    output: DrawnArgs,
}

impl FitCommand {
    pub fn run(self) -> Result<()> {
        self.output.check("fit");
        let scene = LoadedScene::load(&self.scene, &[])?;
        if output::has_error() {
            bail!("{}: fits need a scene without errors; correct it first", scene.name);
        }
        if self.free.is_empty() {
            let keys = scene.file.all_inputs().into_iter();
            let keys = keys.filter(|(_, input)| scene.file.value_of(*input).is_some());
            let keys: Vec<String> = keys.map(|(name, _)| name).collect();
            let text = format!(
                "--free is missing; name the numbers to fit, for example --free asperity_height_std (of {}: {}; of the rig: {})",
                scene.name,
                keys.join(", "),
                Role::RIG.join(", ")
            );
            usage_error("fit", ErrorKind::MissingRequiredArgument, &text);
        }
        let data = self.data(&scene)?;
        if self.models.iter().any(|id| id == Bem::ID) {
            bail!(
                "bem: boundary elements are not fitted; `asperity list models` lists other models"
            );
        }
        let models: Vec<NamedModel> = match &self.models[..] {
            [] => vec![scene.default_model()?],
            ids => {
                output::once(ids).iter().map(|id| scene.model(id)).collect::<Result<Vec<_>>>()?
            }
        };
        let (fitted, interrupted) = self.fit(&scene, &data, &models)?;
        let done = fitted.len();
        let ranking = rank(fitted);
        if done > 0 {
            self.write(&Report { scene: &scene, data: &data, models: &models, ranking: &ranking })?;
        }
        if interrupted {
            interrupt::end_with(&format!("{done} of {} models are fitted", models.len()));
        }
        match &ranking.models[..] {
            [first, ..] if ranking.models.iter().all(|one| one.misfit().is_some()) => {
                let reason = first.misfit().unwrap_or_default();
                bail!("{}: {}: {reason}", self.data_name(&scene), first.model)
            }
            all if !self.target.is_empty() && all.iter().all(Fitted::has_unreachable) => {
                bail!("{}: no model reaches the target; the values are the nearest", scene.name)
            }
            _ => Ok(()),
        }
    }

    /// The fitted models, and whether Ctrl-C ended the list.
    fn fit(
        &self,
        scene: &LoadedScene,
        data: &Data,
        models: &[NamedModel],
    ) -> Result<(Vec<Fitted>, bool)> {
        interrupt::listen()?;
        let mut fitted = vec![];
        for (id, model) in models {
            let bar = progress(id);
            let mut watch = |state: &Progress| {
                let (starts, evaluations) = (state.starts.max(1), state.evaluations);
                bar.set_message(format!("{id}: start {starts}, {evaluations} evaluations"));
                match interrupt::requested() {
                    true => ControlFlow::Break(()),
                    false => ControlFlow::Continue(()),
                }
            };
            match scene.file.fit(model, data, &self.free, &mut watch) {
                Ok(mut found) => {
                    // The name in the result, where options of the scene give the model another.
                    found.model.clone_from(id);
                    fitted.push(found);
                }
                Err(SceneError::Fit(FitError::Interrupted)) => return Ok((fitted, true)),
                Err(error @ SceneError::Fit(FitError::NoStart { .. })) if models.len() > 1 => {
                    print_message("warning", &format!("left out: {error}"));
                }
                Err(error) => {
                    // Errors of columns and lines are those of the data.
                    let place = match &error {
                        SceneError::Fit(
                            FitError::Data(_) | FitError::Column { .. } | FitError::NoStart { .. },
                        ) => self.data_name(scene),
                        SceneError::Fit(FitError::Parameter { .. }) => "--free".into(),
                        _ => scene.name.clone(),
                    };
                    return Err(error).context(place);
                }
            }
        }
        if fitted.is_empty() {
            bail!("{}: no model has values for the data", self.data_name(scene));
        }
        Ok((fitted, false))
    }

    fn write(&self, report: &Report<'_>) -> Result<()> {
        report.print_notes(&self.free);
        report.print_findings()?;
        self.output.draw(|| report.svg())?;
        let output = &self.output.output;
        match output.format {
            Format::Json => {
                output.write_text(&(serde_json::to_string_pretty(report.ranking)? + "\n"))
            }
            _ => output.write(&report.table()),
        }
    }

    /// The file of the data, or of the scene where a target is given.
    fn data_name(&self, scene: &LoadedScene) -> String {
        self.data.as_ref().map_or(scene.name.clone(), |path| path.display().to_string())
    }

    fn data(&self, scene: &LoadedScene) -> Result<Data> {
        if let Some(path) = &self.data {
            output::keep(path);
            let table = read_measurements(path)?;
            return scene.file.data(&table).with_context(|| path.display().to_string());
        }
        let (area, targets) = (scene.file.scene.nominal_area, &self.target);
        let is_given = self.free.iter().all(|one| one.name != "nominal_area");
        let largest = targets.iter().find(|(name, value)| name == "area_m2" && *value > area);
        if let Some((_, value)) = largest.filter(|_| is_given) {
            let [value, area] = [*value, area].map(rounded);
            bail!("--target: area is {value} m2, above the nominal area of {area} m2")
        }
        let places = [
            ("load_N", self.load),
            ("pressure_Pa", self.pressure),
            ("separation_m", self.separation),
        ];
        let places =
            places.into_iter().filter_map(|(name, value)| Some((name.to_string(), value?)));
        let columns = places.chain(targets.iter().cloned());
        let columns = columns.map(|(name, value)| (name, vec![Some(value)])).collect();
        scene.file.data(&MeasuredTable { columns, lines: vec![] }).context("--target")
    }
}
