//! `asperity compare`: all models at one point.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{Model, Quantity, Readout, Request};
use clap::Args;

use crate::args::{ModelArgs, QuantityArgs, SceneArgs, SeparationUnit, model_id};
use crate::numbers::{number, positive_number};
use crate::output;
use crate::progress::Progress;
use crate::reading::{Values, Words, column_name, crossings, values};
use crate::scene::LoadedScene;
use crate::table::{Format, Table};

/// Models beside each other at one separation or load, with their deviation from a reference
#[derive(Debug, Args)]
#[command(after_help = "Deviations are relative to the reference (differences, for logarithms and
shares). At a load, each model is at its own separation.

Examples:
  asperity compare scene.toml
  asperity compare scene.toml --load 100 --reference jg --quantity area,mean-pressure
  asperity compare scene.toml --separation -0.5 --model gw,ke,gao --format csv")]
pub struct Compare {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    models: ModelArgs,
    /// The model that the others are compared with
    #[arg(long, value_name = "M", value_parser = model_id, default_value = "ke")]
    reference: String,
    /// Separation at which they are compared [default: 2 in sigma]
    #[arg(long, value_name = "D", value_parser = number)]
    #[arg(conflicts_with_all = ["load", "pressure"])]
    separation: Option<f64>,
    /// Unit of the separation
    #[arg(long = "separation-unit", value_name = "UNIT", default_value = "sigma")]
    unit: SeparationUnit,
    /// Load in N at which they are compared
    #[arg(long, value_name = "N", value_parser = positive_number)]
    load: Option<f64>,
    /// Load as pressure on the nominal area, in Pa
    #[arg(long, value_name = "PA", value_parser = positive_number)]
    #[arg(conflicts_with = "load")]
    pressure: Option<f64>,
    #[command(flatten)]
    quantities: QuantityArgs,
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "table")]
    format: Format,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Compare {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.scene.scene)?;
        let models = scene.models(&self.models.models)?;
        let outputs = self.quantities.outputs();
        let (_, reference) = scene.model(&self.reference)?;
        let load = self.load.or(self.pressure.map(|pressure| scene.load_at(pressure)));
        let (given, unit) = match self.separation {
            Some(separation) => (vec![separation], self.unit),
            None => (vec![2.0], SeparationUnit::Sigma),
        };
        let request = match load {
            Some(_) => Request::new([Quantity::Force]),
            None => scene.request(&given, unit),
        };
        let request = request.within(self.quantities.tolerance);

        let progress = Progress::new("models", models.len() + 1);
        let (mut table, mut words) = (Table::default(), Words::default());
        let mut read = |id: &str, model: &Model| -> Result<(Vec<f64>, Vec<Values>)> {
            let context = || format!("{}: {id}", self.scene.scene.display());
            let readout = Readout::new(model, scene.scene(), &request, &outputs);
            let readout = readout.with_context(context)?;
            let separations = match load {
                Some(load) => crossings(id, &readout, load, &mut words).with_context(context)?,
                None => request.separations.clone(),
            };
            let found = values(&readout, &outputs, &separations, &mut words);
            progress.step();
            Ok((separations, found.with_context(context)?))
        };
        let (at, wanted) = read(&self.reference, &reference)?;
        for (id, model) in &models {
            let (separations, columns) = read(id, model)?;
            let mut part = Table::default();
            part.words("model", vec![id.clone(); separations.len()]);
            match load {
                Some(_) => scene.found(&separations).columns(&mut part),
                None => scene.places(&given, unit).columns(&mut part),
            }
            for ((&output, values), wanted) in outputs.iter().zip(columns).zip(&wanted) {
                // Where the reference has several separations, the first on approach is meant.
                let wanted = wanted.last().copied().flatten();
                let deviation = |value: &Option<f64>| output.deviation((*value)?, wanted?);
                let deviations = values.iter().map(deviation).collect();
                part.numbers(&column_name(output), output.unit(), values);
                part.numbers(&(column_name(output) + "_deviation"), "", deviations);
            }
            table.append(part);
        }
        drop(progress);
        if at.len() > 1 {
            let reference = &self.reference;
            words.add(format!("the reference {reference} is taken at its largest separation"));
        }
        words.say();
        output::write(self.output.as_deref(), |out| table.write(self.format, out))
    }
}
