//! `asperity curve`: quantities against separation or load, their plan, and the largest tension.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use asperity::bem::Bem;
use asperity::{
    At, ContactModel, Finding, Quantity, Request, SeparationUnit, linspace, shortest_digits,
};
use asperity_answer::{
    Beside, Cell, Inquiry, Sheet, best_and_nearest, models, one_model, patch, with_ranges,
};
use asperity_scene::{SceneFile, column_of, read_measurements};
use clap::Args;
use clap::error::ErrorKind;

use crate::commands::pull_off::pull_off;
use crate::input::args::{DrawnArgs, ModelArgs, PressArgs, model_id, patch_file};
use crate::input::usage_error;
use crate::input::varied::Varied;
use crate::interrupt::Terminal;
use crate::output::plot::{POINTS, Plot};
use crate::output::table::csv;
use crate::output::{write, write_text};
use crate::scene::LoadedScene;

/// The default quantities.
const USUAL: [Quantity; 3] = [Quantity::Force, Quantity::Area, Quantity::Tangent];

/// Those of curved bodies.
const OF_BODIES: [Quantity; 7] = [
    Quantity::Force,
    Quantity::Approach,
    Quantity::PeakPressure,
    Quantity::PeakPressureRatio,
    Quantity::AxisX,
    Quantity::AxisY,
    Quantity::Tangent,
];

/// Columns of places, in the order in which measured points are drawn against them.
const PLACES: [&str; 5] = ["load_N", "pressure_Pa", "film_m", "lambda", "separation_m"];

/// Tabulate or plot quantities against separation, load or pressure
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = include_str!("../help/curve.txt")
)]
pub struct Curve {
    #[command(flatten)]
    asked: ModelArgs,
    /// Repeat the rows for each value of a number of the scene, in a column of its own: KEY=A:B:N,
    /// KEY=A:B:N:log or KEY=v,v, with or without units, for example hardness=1GPa:4GPa:4
    #[arg(long, value_name = "KEY=A:B:N|v,v", conflicts_with_all = ["plan", "pull_off", "profile"])]
    vary: Option<Varied>,
    /// Give every separation that carries the load, instead of the largest alone
    #[arg(long, requires = "given")]
    all: bool,
    /// Add a column <quantity>_error with a bound on the relative error of each quantity (on the
    /// absolute error for logarithms and shares)
    #[arg(long)]
    errors: bool,
    /// Add a column <quantity>_deviation relative to this model
    #[arg(long, value_name = "M", value_parser = model_id)]
    #[arg(conflicts_with_all = ["errors", "all"])]
    reference: Option<String>,
    /// Print how the values are computed instead: the integrals, their number of terms, and the
    /// terms left out
    #[arg(long, conflicts_with_all = ["errors", "all", "reference", "plot", "format"])]
    plan: bool,
    /// Print the largest tension of models with adhesion instead (dmt and jkr-separation, if none
    /// is named), and its separation
    #[arg(long, conflicts_with_all = ["errors", "all", "reference", "plan", "given"])]
    #[arg(conflicts_with_all = ["separations", "films", "ratios", "quantities", "plot"])]
    pull_off: bool,
    /// Also draw the measured points of this file, whose columns have the names of this table: one
    /// for the places (load_N, pressure_Pa, separation_m, ..) and the quantities
    #[arg(long, value_name = "FILE.csv", requires = "plot")]
    data: Option<PathBuf>,
    /// Also write the patch of curved bodies, of one model at one load: as csv pressures,
    /// separations, area fractions and the tangential flexibility of the layer, as svg a picture
    #[arg(long, value_name = "FILE.csv|svg", value_parser = patch_file(), requires = "given")]
    profile: Option<PathBuf>,
    #[command(flatten)]
    press: PressArgs,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Curve {
    pub fn run(self) -> Result<()> {
        let named = [&self.asked.models[..], self.reference.as_slice()].concat();
        let press = self.press.of_models("curve", &named);
        if self.plan {
            return self.print_plan();
        }
        if self.pull_off {
            return pull_off(self.asked, &self.output.output);
        }
        let ids = &self.asked.models;
        if self.asked.is_nowhere() && ids.iter().any(|id| id == Bem::ID) {
            let text =
                "bem solves a contact for each place: give --load, --pressure or --separation";
            usage_error("curve", ErrorKind::MissingRequiredArgument, text);
        }
        let scene = LoadedScene::load_pressing(&self.asked.scene, ids, press)?;
        let is_curved = scene.file.spec.curvature.is_some();
        self.asked.check_places(is_curved);
        let usual = if is_curved { &OF_BODIES[..] } else { &USUAL };
        let mut request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), usual);
        if is_curved && matches!(request.at.first(), Some(At::Separation(_))) {
            // The place of the row.
            request.quantities.retain(|quantity| *quantity != Quantity::Approach);
        }
        let ids = match &self.asked.models[..] {
            [] if !is_curved => best_and_nearest(&scene.file, &request)?,
            named => named.to_vec(),
        };
        let fill = |file: &_, sheet: &mut _| self.answer(file, (&ids, &request), sheet);
        let (sheet, ()) = scene.answer(|sheet| match &self.vary {
            Some(varied) => self.each_value(&scene.file, varied, sheet, fill),
            None => with_ranges(&scene.file, sheet, fill),
        })?;
        if let Some(path) = &self.profile {
            self.write_profile(&scene, &request, path)?;
        }
        self.output.write(&sheet, || self.picture(&sheet, &request, scene.file.plane()))
    }

    /// The rows at each value of a number of the scene, which follows the model.
    fn each_value(
        &self,
        file: &SceneFile,
        Varied { name, values }: &Varied,
        sheet: &mut Sheet,
        fill: impl Fn(&SceneFile, &mut Sheet) -> Result<()> + Sync,
    ) -> Result<()> {
        let input = file.inputs([name.as_str()])?[0];
        for value in values {
            let place = || format!("{name} = {}", shortest_digits(*value));
            let varied = file.with_inputs([(input, *value)]).with_context(place)?;
            let mut part = Sheet::default();
            with_ranges(&varied, &mut part, &fill).with_context(place)?;
            part.heads.insert(1, column_of(name));
            part.rows.iter_mut().for_each(|row| row.insert(1, (*value).into()));
            ensure!(
                sheet.rows.is_empty() || sheet.heads == part.heads,
                "{}: its rows have other columns than those before, as a range begins or ends",
                place()
            );
            sheet.heads = part.heads;
            sheet.rows.extend(part.rows);
            sheet.results.extend(part.results);
            // One of each code and field: the first value's stands for all.
            for found in part.findings {
                let is_known = |one: &Finding| one.code == found.code && one.field == found.field;
                if !sheet.findings.iter().any(is_known) {
                    sheet.findings.push(found);
                }
            }
        }
        Ok(())
    }

    /// The patch of one model at one load.
    fn write_profile(&self, scene: &LoadedScene, request: &Request, path: &Path) -> Result<()> {
        let ([id], [At::Load(load)], Some(_)) =
            (&self.asked.models[..], &request.at[..], scene.file.spec.curvature)
        else {
            let text = "--profile is of one --model at one --load, of a scene with [curvature]";
            usage_error("curve", ErrorKind::ArgumentConflict, text);
        };
        let of_patch = patch(&scene.file, id, *load, request.tolerance);
        let [all, axes] = of_patch.with_context(|| scene.name.clone())?;
        if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("svg")) {
            let plot = Plot::new(&["contact"], "distance_m", &["pressure_Pa", "area_fraction"]);
            let plot = Plot { is_linear: true, ..plot };
            return write_text(Some(path), &plot.svg(&axes)?);
        }
        write(Some(path), |out| csv(&all, out))
    }

    /// The quantities against the places, with the measured points of a file.
    fn picture(&self, sheet: &Sheet, request: &Request, from: &'static str) -> Result<String> {
        let drawn: Vec<String> = request.quantities.iter().map(|one| one.column()).collect();
        let mut x = match request.at.first() {
            Some(At::Separation(_)) if sheet.column("approach_m").is_some() => "approach_m",
            Some(At::Load(_)) => "load_N",
            Some(At::Pressure(_)) => "pressure_Pa",
            Some(At::Separation(s)) if s.unit == SeparationUnit::SurfaceStd => "lambda",
            Some(At::Separation(_)) if sheet.column("film_m").is_some() => "film_m",
            Some(At::Separation(s)) if s.unit == SeparationUnit::Metres => "separation_m",
            _ => "separation_over_sigma",
        };
        let mut sheet = sheet.clone();
        if let Some(path) = &self.data {
            let columns = read_measurements(path)?.columns;
            let measured = |name: &str| columns.iter().find(|(head, _)| head == name);
            if measured(x).is_none() {
                let is_one =
                    |name: &&str| sheet.column(name).is_some() && !drawn.contains(&(*name).into());
                let known: Vec<&str> = PLACES.into_iter().filter(is_one).collect();
                let found = known.iter().find(|name| measured(name).is_some());
                x = found.with_context(|| {
                    format!("--data: the file has none of the columns {}", known.join(", "))
                })?;
            }
            ensure!(
                drawn.iter().any(|name| measured(name).is_some()),
                "--data: the file has none of the plotted columns: {}",
                drawn.join(", ")
            );
            for row in 0..measured(x).map_or(0, |(_, values)| values.len()) {
                let value = |head: &String| measured(head)?.1[row];
                let mut cells: Vec<Cell> =
                    sheet.heads.iter().map(|head| value(head).into()).collect();
                cells[0] = POINTS.into();
                sheet.rows.push(cells);
            }
        }
        let columns: Vec<&str> = drawn.iter().map(String::as_str).collect();
        let varied = self.vary.as_ref().map(|varied| column_of(&varied.name));
        match &varied {
            Some(varied) if request.at.len() == 1 => {
                Plot::new(&["model"], varied, &columns).from(from).svg(&sheet)
            }
            varied => {
                let curves = ["model"].into_iter().chain(varied.as_deref()).collect::<Vec<_>>();
                Plot::new(&curves, x, &columns).from(from).svg(&sheet)
            }
        }
    }

    fn answer(
        &self,
        file: &SceneFile,
        (ids, request): (&[String], &Request),
        sheet: &mut Sheet,
    ) -> Result<()> {
        let reference = self.reference.as_deref();
        let reference = reference.map(|id| one_model(file, Some(id))).transpose()?;
        let models = models(file, ids, SceneFile::models, &request.quantities, sheet)?;
        let beside = match reference {
            Some(reference) => Beside::Deviations(reference),
            None if self.errors => Beside::Errors,
            None => Beside::Nothing,
        };
        let (all, at_defaults, request) = (self.all, self.asked.is_nowhere(), request.clone());
        let films = self.asked.is_of_film();
        let inquiry =
            Inquiry { beside, all, at_defaults, films, ..Inquiry::new(file, models, request) };
        Ok(inquiry.answer(sheet, &Terminal::default())?)
    }

    fn print_plan(&self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene, &[])?;
        let request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), &USUAL);
        let find = |sheet: &mut _| {
            models(&scene.file, &self.asked.models, SceneFile::models, &request.quantities, sheet)
        };
        let mut plans = String::new();
        for model in scene.answer(find)?.1 {
            let plan = model.compile(&scene.file.scene, &request).and_then(|c| c.plan(&request));
            plans += &plan.with_context(|| format!("{}: {model}", scene.name))?.to_string();
        }
        self.output.output.write_text(&plans)
    }
}
