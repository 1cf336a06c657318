//! `asperity recommend`: the simplest model that will do.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{Comparison, Output, Quantity, Request, Tolerance, recommend_among};
use clap::Args;

use crate::args::{SceneArgs, SeparationArgs, model_id, once};
use crate::numbers::positive_number;
use crate::output;
use crate::progress::Progress;
use crate::scene::LoadedScene;
use crate::table::{Format, Table};

/// The simplest model that stays near a reference model
#[derive(Debug, Args)]
#[command(
    after_help = "Deviations are the largest over the separations, relative to the reference.

Examples:
  asperity recommend scene.toml
  asperity recommend scene.toml --reference gao --within 0.2 --quantity force --separation 0:3:7"
)]
pub struct Recommend {
    #[command(flatten)]
    scene: SceneArgs,
    /// The model that the others are compared with
    #[arg(long, value_name = "M", value_parser = model_id, default_value = "ke")]
    reference: String,
    /// Largest relative deviation
    #[arg(long, value_name = "X", value_parser = positive_number, default_value = "0.05")]
    within: f64,
    /// Quantities: force, area, stiffness, tangent
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',', value_parser = quantity)]
    #[arg(default_value = "force,area")]
    quantities: Vec<Quantity>,
    #[command(flatten)]
    separations: SeparationArgs,
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "table")]
    format: Format,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

fn quantity(name: &str) -> Result<Quantity, String> {
    let output: Output = name.parse().map_err(|e: asperity::UnknownOutput| e.to_string())?;
    let same = |quantity: &Quantity| quantity.to_string() == output.to_string();
    let found = Quantity::ALL.into_iter().find(same);
    found.ok_or_else(|| format!("{output}: force, area, stiffness or tangent was expected"))
}

impl Recommend {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.scene.scene)?;
        let models = scene.models(&[])?;
        let (_, reference) = scene.model(&self.reference)?;
        let request = self.separations.request(&scene, Tolerance::default());
        let request = Request { quantities: once(&self.quantities), ..request };
        let progress = Progress::new("models", 0);
        let models = models.into_iter().map(|(_, model)| model).collect();
        let advice = recommend_among(models, scene.scene(), &request, &reference, self.within)
            .with_context(|| {
                format!("{}: the reference {}", self.scene.scene.display(), self.reference)
            })?;
        drop(progress);

        let all = &advice.comparisons;
        let mut table = Table::default();
        // To the eye, what is below the tolerance is rounding and nothing else.
        let eye = self.format == Format::Table;
        let noise = if eye { request.tolerance.relative() } else { 0.0 };
        table.words("model", all.iter().map(|c| c.model.id().into()).collect());
        for (k, quantity) in request.quantities.iter().enumerate() {
            let deviation = |c: &Comparison| {
                let found = c.deviations.as_ref().ok()?.get(k)?.1;
                found.is_finite().then_some(if found < noise { 0.0 } else { found })
            };
            let values = all.iter().map(deviation).collect();
            table.numbers(&format!("{quantity}_deviation"), "", values);
        }
        let verdict = |c: &Comparison| match &c.deviations {
            Err(error) => error.to_string(),
            Ok(_) if c.model.id() == advice.simplest.id() => "recommended".into(),
            Ok(_) if c.largest() <= advice.within => "near enough".into(),
            Ok(_) => "too far".into(),
        };
        table.words("verdict", all.iter().map(verdict).collect());
        output::write(self.output.as_deref(), |out| {
            if self.format == Format::Table {
                writeln!(
                    out,
                    "{} is the simplest model within {} of {}\n",
                    advice.simplest.id(),
                    advice.within,
                    advice.reference.id()
                )?;
            }
            table.write(self.format, out)
        })
    }
}
