//! `asperity recommend`: the model nearest to boundary elements on similar surfaces, or the
//! simplest valid one near a reference.

use anyhow::Result;
use asperity::{Quantity, linspace};
use asperity_answer::with_ranges;
use clap::Args;

use crate::input::args::{ModelArgs, OutputArgs, model_id};
use crate::input::numbers::share_above_0;
use crate::input::valid;
use crate::output::progress;
use crate::scene::LoadedScene;

/// Recommend a model: the nearest to boundary elements, or the simplest near a reference
#[derive(Debug, Args)]
#[command(mut_arg("tolerance", |arg| arg.default_value("1e-4")), after_help = HELP)]
pub struct Recommend {
    #[command(flatten)]
    asked: ModelArgs,
    /// Reference model [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    reference: Option<String>,
    /// Largest deviation from the reference, for example 5% or 0.05
    #[arg(long, value_name = "X", value_parser = share_above_0, default_value = "5%")]
    within: f64,
    #[command(flatten)]
    output: OutputArgs,
}

/// The help. The range of the solved cases stands here, so that the evidence is not read for it.
const HELP: &str = include_str!("../help/recommend.txt");

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
        valid("recommend", asked.check());
        let working = progress("comparing models");
        let fill = |file: &_, sheet: &mut _| asked.answer(file, sheet);
        let (sheet, _) = scene.answer(|sheet| with_ranges(&scene.file, sheet, fill))?;
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
        let help: Vec<&str> = HELP.split_whitespace().collect();
        assert!(help.join(" ").contains(&format!("surfaces ({solved}),")), "{solved}");
    }
}
