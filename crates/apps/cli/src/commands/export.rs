//! `asperity export`: contact tables for finite-element codes.

use std::path::PathBuf;

use anyhow::{Context, Error, Result};
use asperity::{At, Separation, Tolerance};
use asperity_answer::{AnswerError, Export, Nodes, Sheet, TableFormat, UnitSystem};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::input::args::{EndArgs, model_id};
use crate::input::distances::{Length, metre, warn_unit};
use crate::input::lists::{Span, range, range_or_list};
use crate::input::numbers::{load, number, pressure, share_above_0};
use crate::input::{refuse, valid};
use crate::interrupt::Terminal;
use crate::output;
use crate::scene::LoadedScene;

/// Pressure against clearance as a table for a finite-element code
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../help/export.txt")
)]
pub struct ExportCommand {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The model; `asperity list models` lists them
    #[arg(long, value_name = "M", value_parser = model_id)]
    model: String,
    /// Form of the table: for a solver, or csv
    #[arg(long = "as", value_name = "FORM", value_parser = form())]
    format: TableFormat,
    #[command(flatten)]
    end: EndArgs,
    #[command(flatten)]
    ends: Ends,
    /// Solve the scan of the scene at a list of loads by boundary elements: best has that
    #[arg(long, conflicts_with = "max_error")]
    solve: bool,
    /// Add nodes until the relative error of the interpolated pressure is below this bound, for
    /// example 0.01
    #[arg(long, value_name = "X", value_parser = share_above_0)]
    max_error: Option<f64>,
    /// For abaqus and calculix: add the thermal conductance against pressure
    #[arg(long)]
    conductance: bool,
    /// Units of the table: SI, or for models in mm mm-N-MPa (or mm-tonne-s, the same; powers
    /// in mW)
    #[arg(long, value_name = "SYSTEM", default_value = "SI")]
    units: UnitSystem,
    /// Write to this file, which is overwritten, instead of standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The range of the table, in one of these ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Ends {
    /// Range of separations with N nodes, in units of asperity_height_std (sigma), or with a unit,
    /// for example 0:3um
    #[arg(long, value_name = "A:B[:N]")]
    separation: Option<Length<Span>>,
    /// Range of films between the mean planes of the surfaces, in m, or with a unit
    #[arg(long, value_name = "A:B:N", value_parser = range(metre))]
    film: Option<Span>,
    /// Range of ratios of the film to the standard deviation of the surface heights
    #[arg(long, value_name = "A:B:N", value_parser = range(number))]
    lambda: Option<Span>,
    /// Range of loads, or a list of them as the nodes, in N, or with a unit, for example 2kN
    #[arg(long, value_name = "A:B[:N[:log]]|v,v", value_parser = range_or_list(load))]
    load: Option<(Span, Vec<f64>)>,
    /// The same as pressures on the nominal area, in Pa, or with a unit, for example 5MPa
    #[arg(long, value_name = "A:B[:N[:log]]|v,v", value_parser = range_or_list(pressure))]
    pressure: Option<(Span, Vec<f64>)>,
}

/// The forms of tables.
fn form() -> impl TypedValueParser<Value = TableFormat> {
    let help = [
        "Clearance, pressure and tangent, for cubics",
        "Pressure and overclosure, for straight lines",
        "Pressure and overclosure for CalculiX; overclosure is 0 at the first pressure",
        "Pressure, area fraction and flow factors against the film, for a Reynolds code",
    ];
    let named =
        |(form, help): (TableFormat, &'static str)| PossibleValue::new(form.name()).help(help);
    let values = TableFormat::ALL.into_iter().zip(help).map(named).collect::<Vec<_>>();
    PossibleValuesParser::new(values).try_map(|name| name.parse())
}

impl ExportCommand {
    pub fn run(self) -> Result<()> {
        let Ends { separation, film, lambda, load, pressure } = self.ends;
        let loads = load.as_ref().or(pressure.as_ref());
        let spans = [separation.map(|s| s.value), film, lambda, loads.map(|(span, _)| *span)];
        let span = spans.into_iter().find_map(|span| span).context("a range was required")?;
        let place = |value| if load.is_some() { At::Load(value) } else { At::Pressure(value) };
        let listed: Vec<At> = loads.iter().flat_map(|(_, list)| list).copied().map(place).collect();
        let (is_film, is_uncounted) = (self.format == TableFormat::Film, span.count.is_none());
        let needed = "A:B needs --max-error, or a number of nodes: A:B:N";
        refuse([
            (self.solve && listed.is_empty(), "--solve needs a list of loads or pressures: v,v"),
            (is_uncounted && is_film, "a table of films needs the number of its nodes: A:B:N"),
            (is_uncounted && self.max_error.is_none(), needed),
        ]);
        valid(self.format.check(self.conductance));
        let scene = LoadedScene::load(&self.scene, std::slice::from_ref(&self.model))?;
        let mut scene = scene.taken_at(&self.end)?;
        if self.solve {
            scene.solve(&listed)?;
        }
        let model = scene.model(Some(&self.model))?;
        if let Some(distances) = separation {
            let height_std = scene.file.scene.surface.asperity_height_std;
            let ends = [span.first, span.last];
            warn_unit("separation", &ends, distances.unit, height_std);
        }
        let ends = [span.first, span.last].map(|value| match separation {
            Some(s) => scene.file.separation(value, s.unit).into(),
            None if loads.is_some() => place(value),
            None if film.is_some() => Separation::metres(value).from_surface_mean().into(),
            None => Separation::film_ratio(value).into(),
        });
        scene.report(scene.file.judge(&model, None, &ends));
        let (count, log, max_error) = (span.count.unwrap_or(2), span.log, self.max_error);
        let nodes = match &listed[..] {
            [] => Nodes::Range { ends, count, log, max_error },
            listed => Nodes::Loads(listed),
        };
        let export = Export {
            subject: scene.subject(&model, Tolerance::default()),
            nodes,
            format: self.format,
            units: self.units,
            conductance: self.conductance,
        };
        let fill = |sheet: &mut Sheet, watch: &Terminal| match export.answer(sheet, watch) {
            // About the format, not about the scene.
            Err(AnswerError::Reason(reason)) => Err(Error::msg(reason)),
            answer => Ok(answer?),
        };
        let (_, found) = scene.answer(fill)?;
        output::write_text(self.output.as_deref(), &found.text)
    }
}
