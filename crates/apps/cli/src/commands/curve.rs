//! `asperity curve`: quantities against separation or load, their plan, and the largest tension.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asperity::bem::Bem;
use asperity::{At, ContactModel, Quantity, Request, SeparationUnit, linspace};
use asperity_answer::{
    AnswerError, Beside, Inquiry, Sheet, at_values, best_and_nearest, models, one_model, patch,
    with_ranges,
};
use asperity_scene::{SceneFile, column_of};
use clap::Args;

use crate::commands::pull_off::pull_off;
use crate::input::args::{DrawnArgs, ModelArgs, file_ending, model_id};
use crate::input::varied::Varied;
use crate::input::{refuse, usage_error};
use crate::interrupt::Terminal;
use crate::output::plot::Plot;
use crate::output::table::csv;
use crate::output::{print_results, show, write, write_text};
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

/// How patches are written.
const PATCH: &str = "the patch is written as csv, and drawn as svg";
/// The column that tells scenes apart.
const SCENE: &str = "scene";

/// Tabulate or plot quantities against separation, load or pressure
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/curve.txt"))]
pub struct Curve {
    #[command(flatten)]
    asked: ModelArgs,
    /// Repeat the rows for each value of a number of the scene, in a column of its own: KEY=A:B:N,
    /// KEY=A:B:N:log or KEY=v,v, with or without units, for example hardness=1GPa:4GPa:4
    #[arg(long, value_name = "KEY=A:B:N|v,v", conflicts_with_all = ["plan", "pull_off", "profile"])]
    vary: Option<Varied>,
    /// Solve the scan of the scene at these loads by boundary elements: best answers with that
    #[arg(long, requires = "given", conflicts_with_all = ["vary", "plan", "pull_off"])]
    solve: bool,
    /// Add the columns film_m and lambda also at loads and separations
    #[arg(long, conflicts_with_all = ["plan", "pull_off"])]
    film_columns: bool,
    /// Add each stiffness over the nominal area (N/m3) beside it, as solvers and ultrasound have it
    #[arg(long, conflicts_with_all = ["plan", "pull_off"])]
    per_area: bool,
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
    /// Also write the patch of curved bodies, of one model at one load: as csv pressures,
    /// separations, area fractions and the tangential flexibility of the layer, as svg a picture
    #[arg(long, value_name = "FILE.csv|svg", requires = "given")]
    #[arg(value_parser = file_ending(&["csv", "svg"], PATCH))]
    profile: Option<PathBuf>,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Curve {
    pub fn run(self) -> Result<()> {
        let ids = &self.asked.models;
        let [first, others @ ..] = &self.asked.scenes[..] else { return Ok(()) };
        let is_of_one = self.plan || self.pull_off || self.profile.is_some();
        let needed = "bem solves a contact for each place: give --load, --pressure or --separation";
        let alone = "--plan, --pull-off and --profile take one scene";
        let is_bem_nowhere = self.asked.is_nowhere() && ids.iter().any(|id| id == Bem::ID);
        refuse([(is_bem_nowhere, needed), (is_of_one && !others.is_empty(), alone)]);
        if self.plan {
            return self.print_plan(first);
        }
        if self.pull_off {
            return pull_off(&self.asked, first, &self.output.output);
        }
        let (mut sheet, mut drawn) = (Sheet::default(), None);
        for path in &self.asked.scenes {
            let name = path.display().to_string();
            if !others.is_empty() {
                // Above the messages about it.
                print_results(&[format!("{name}:")]);
            }
            let scene = LoadedScene::load(path, ids)?;
            let plane = scene.file.plane();
            let (request, part) = self.rows(scene)?;
            match others {
                [] => sheet = part,
                _ => sheet.append(part, SCENE, &name.as_str().into()),
            }
            let known = drawn.map_or(plane, |(_, known)| known);
            drawn = Some((request, if known == plane { plane } else { "the plane of each scene" }));
        }
        let Some((request, plane)) = drawn else { return Ok(()) };
        self.output.write(&sheet, || self.picture(&sheet, &request, plane))
    }

    /// What is asked of one scene, and its rows.
    fn rows(&self, mut scene: LoadedScene) -> Result<(Request, Sheet)> {
        let is_curved = scene.file.shape().is_some();
        self.asked.check_places(is_curved);
        let usual = if is_curved { &OF_BODIES[..] } else { &USUAL };
        let mut request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), usual);
        if is_curved && matches!(request.at.first(), Some(At::Separation(_))) {
            // The place of the row.
            request.quantities.retain(|quantity| *quantity != Quantity::Approach);
        }
        if self.solve {
            scene.solve(&request.at)?;
        }
        let ids = match &self.asked.models[..] {
            [] => best_and_nearest(&scene.file, &request)?,
            named => named.to_vec(),
        };
        let fill = |file: &_, sheet: &mut _| self.answer(file, (&ids, &request), sheet);
        let (sheet, ()) = scene.answer(|sheet, _| match &self.vary {
            Some(Varied { name, values }) => at_values(&scene.file, (name, values), sheet, fill),
            None => with_ranges(&scene.file, sheet, fill),
        })?;
        if let Some(path) = &self.profile {
            self.write_profile(&scene, &request, path)?;
        }
        Ok((request, sheet))
    }

    /// The patch of one model at one load.
    fn write_profile(&self, scene: &LoadedScene, request: &Request, path: &Path) -> Result<()> {
        let ([id], [At::Load(load)], Some(_)) =
            (&self.asked.models[..], &request.at[..], scene.file.shape())
        else {
            usage_error("--profile is of one --model at one --load, of a scene with [curvature]");
        };
        let (file, note) = scene.file.taken_at("middle")?;
        let note = note.into_iter().map(|note| note.from_origin("--profile"));
        show(&file.accepted(note.collect()));
        let of_patch = patch(&file, id, *load, request.tolerance);
        let [all, axes] = of_patch.with_context(|| scene.name.clone())?;
        if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("svg")) {
            let plot = Plot::new(&["contact"], "distance_m", &["pressure_Pa", "area_fraction"]);
            let plot = Plot { is_linear: true, ..plot };
            return write_text(Some(path), &plot.svg(&axes)?);
        }
        write(Some(path), |out| csv(&all, out))
    }

    /// The quantities against the places.
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
        let columns: Vec<&str> = drawn.iter().map(String::as_str).collect();
        let varied = self.vary.as_ref().map(|varied| column_of(&varied.name));
        let mut curves = vec!["model", SCENE];
        match &varied {
            Some(varied) if request.at.len() == 1 => x = varied,
            varied => curves.extend(varied.as_deref()),
        }
        Plot::new(&curves, x, &columns).from(from).svg(sheet)
    }

    fn answer(
        &self,
        file: &SceneFile,
        (ids, request): (&[String], &Request),
        sheet: &mut Sheet,
    ) -> Result<(), AnswerError> {
        let reference = self.reference.as_deref();
        let reference = reference.map(|id| one_model(file, Some(id))).transpose()?;
        let models = models(file, ids, SceneFile::models, &request.quantities, sheet)?;
        let beside = match reference {
            Some(reference) => Beside::Deviations(reference),
            None if self.errors => Beside::Errors,
            None => Beside::Nothing,
        };
        let (all, at_defaults, request) = (self.all, self.asked.is_nowhere(), request.clone());
        let films = self.film_columns || self.asked.is_of_film();
        let inquiry =
            Inquiry { beside, all, at_defaults, films, ..Inquiry::new(file, models, request) };
        inquiry.answer(sheet, &Terminal::default())?;
        if self.per_area {
            sheet.add_per_area(file.scene.nominal_area);
        }
        Ok(())
    }

    fn print_plan(&self, path: &Path) -> Result<()> {
        let scene = LoadedScene::load(path, &[])?;
        let request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), &USUAL);
        let find = |sheet: &mut _, _: &_| {
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
