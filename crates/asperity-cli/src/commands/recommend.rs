//! `asperity recommend`: the simplest valid model within a tolerance, and the deviations of models
//! from boundary elements on similar surfaces.

use anyhow::Result;
use asperity::{Quantity, linspace};
use clap::Args;

use crate::input::args::{ModelArgs, OutputArgs, model_id};
use crate::input::numbers::share;
use crate::output::progress;
use crate::scene::LoadedScene;

/// Recommend the simplest valid model near a reference, with evidence from boundary elements
#[derive(Debug, Args)]
#[command(after_help = HELP)]
pub struct Recommend {
    #[command(flatten)]
    asked: ModelArgs,
    /// Reference model [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    reference: Option<String>,
    /// Largest deviation from the reference, for example 5% or 0.05
    #[arg(long, value_name = "X", value_parser = share, default_value = "5%")]
    within: f64,
    #[command(flatten)]
    output: OutputArgs,
}

/// The help. The range of the solved cases is that of the evidence, which is not read for it.
const HELP: &str =
    "Models are listed from simplest to most complex: asperities of one radius with upright
contacts, random asperities, no asperities (Persson), inclined contacts. The recommended
model is the first that is near enough to the reference and valid for the scene (an elastic
model is not valid where yielding asperities carry more than 10 % of the load). Deviations
are the largest over the separations or loads, as those of `asperity curve --reference`.
Agreement with the reference is no proof of accuracy: columns .._off_bem have the expected
deviation of a model from boundary elements at the loads, interpolated between solved random
surfaces (alpha 3.1, 7.5, 29.5, 76.9, elastic and psi 0.7, 1, 2, 4, 8, p/(E g) from 0.00001 to 0.3),
the largest over the separations or loads that have one; .._spread is half the width of the
interval that holds nine of ten surfaces. `asperity bem --compare` solves the scan of the scene
itself, and `asperity curve --corrected` divides by the expected ratios.
Default: force and area at the separations of `asperity curve`.

Examples:
  asperity recommend scene.toml
  asperity recommend scene.toml --load 1:1000:20:log --quantity area,tangent
  asperity recommend scene.toml --reference gao --within 20% --quantity force --separation 0:3:7";

impl Recommend {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene, &[])?;
        let separations = linspace(0.0, 4.0, 401);
        let usual = [Quantity::Force, Quantity::Area];
        let asked = asperity_answer::Recommend {
            models: &self.asked.models,
            reference: self.reference.as_deref(),
            within: self.within,
            request: self.asked.request(&scene.file, &separations, &usual),
            at_defaults: self.asked.is_nowhere(),
        };
        let working = progress("comparing models");
        let (sheet, ()) = scene.answer(|sheet| asked.answer(&scene.file, sheet))?;
        drop(working);
        self.output.write(&sheet)
    }
}

#[cfg(test)]
mod tests {
    use asperity::Evidence;

    use super::HELP;

    #[test]
    fn the_help_has_the_range_of_the_evidence() {
        let solved = Evidence::committed().unwrap().solved();
        assert!(HELP.contains(&format!("surfaces ({solved}),")), "{solved}");
    }
}
