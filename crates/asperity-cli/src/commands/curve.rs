//! `asperity curve`: quantities against separation.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::Readout;
use clap::Args;
use clap::error::ErrorKind;

use crate::args::{ModelArgs, OutputArgs, QuantityArgs, SceneArgs, SeparationArgs};
use crate::progress::Progress;
use crate::reading::{Words, column_name};
use crate::scene::LoadedScene;
use crate::table::Table;
use crate::{output, plot};

/// Quantities against separation
#[derive(Debug, Args)]
#[command(
    after_help = "Columns: model, separation_over_sigma, separation_m, then the quantities as
asked, in SI units.

Examples:
  asperity curve scene.toml --format table --model gw,ke --separation -1:4:6
  asperity curve scene.toml --quantity mean-pressure --output curve.csv --plot curve.svg
  asperity curve scene.toml --model jg --separation 1e-6,2e-6 --separation-unit m --errors"
)]
pub struct Curve {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    models: ModelArgs,
    #[command(flatten)]
    quantities: QuantityArgs,
    #[command(flatten)]
    separations: SeparationArgs,
    /// Add a column <quantity>_error for each: a bound on the relative error (on the error itself
    /// for logarithms and shares)
    #[arg(long)]
    errors: bool,
    #[command(flatten)]
    output: OutputArgs,
    /// Draw the curves, one panel for each quantity
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

impl Curve {
    pub fn run(self) -> Result<()> {
        if self.plot.is_some()
            && output::is_standard(self.plot.as_deref())
            && self.output.is_standard()
        {
            let text = "--plot - leaves no place for the data: name a file with --output";
            crate::usage_error("curve", ErrorKind::ArgumentConflict, text);
        }
        let scene = LoadedScene::load(&self.scene.scene)?;
        let models = scene.models(&self.models.models)?;
        let outputs = self.quantities.outputs();
        let request = self.separations.request(&scene, self.quantities.tolerance);
        let (given, unit) = self.separations.given();
        let places = scene.places(&given, unit);

        let points = request.separations.len();
        let progress = Progress::new("curves", models.len() * outputs.len() * points);
        let (mut table, mut words) = (Table::default(), Words::default());
        for (id, model) in &models {
            let context = || format!("{}: {id}", self.scene.scene.display());
            let readout = Readout::new(model, scene.scene(), &request, &outputs);
            let readout = readout.with_context(context)?;
            let mut part = Table::default();
            part.words("model", vec![id.clone(); points]);
            places.columns(&mut part);
            let mut errors = vec![];
            for &output in &outputs {
                let column = readout.column(output, &request.separations, || progress.step());
                let column = column.with_context(context)?;
                let values = column.values.iter().map(|v| v.value).collect();
                part.numbers(&column_name(output), output.unit(), values);
                errors.push((column_name(output) + "_error", column.values));
                column.warnings.iter().for_each(|warning| words.add(warning.to_string()));
            }
            for (name, values) in errors.into_iter().filter(|_| self.errors) {
                part.numbers(&name, "", values.iter().map(|v| Some(v.error)).collect());
            }
            table.append(part);
        }
        drop(progress);
        words.say();
        if let Some(path) = &self.plot {
            let svg = plot::svg(&table, &outputs)?;
            output::write(Some(path), |out| out.write_all(svg.as_bytes()))?;
        }
        self.output.write(&table)
    }
}
