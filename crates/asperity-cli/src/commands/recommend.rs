//! `asperity recommend`: the simplest valid model within a tolerance, and the deviations of models
//! from boundary elements on similar surfaces.

use anyhow::{Context, Result};
use asperity::{At, Compared, Described, Model, Quantity, linspace};
use clap::Args;

use crate::ask::column_beside;
use crate::input::args::{ModelArgs, OutputArgs, model_id};
use crate::input::numbers::share;
use crate::output::table::{Cell, Table};
use crate::output::{print_message, progress};
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
contacts, random asperities, no asperities (Persson), inclined contacts; among these,
force laws with fewer parts first, then older models first. The recommended model is the
first that is near enough to the reference and valid for the scene (an elastic model is
not valid where yielding asperities carry more than 10 % of the load). Deviations are the
largest over the separations or loads, relative to the reference (differences for
logarithms and shares).
Agreement with the reference is no proof of accuracy: columns .._off_bem have the expected
deviation of a model from boundary elements at the loads, interpolated between solved random
surfaces (alpha 3.1, 7.5, 29.5, 76.9, elastic and psi 0.7, 1, 2, 4, 8, p/(E g) from 0.00001 to 0.3),
the largest over the separations or loads that have one; .._spread is half the width of the
interval that holds nine of ten surfaces. Columns of the unloading stiffness are shown if it or a
conductance is requested, or no quantity that is compared with boundary elements; the mean gap is
in the notes, if a force is requested. Notes name the models nearest in the requested quantities,
the expected deviations of the reference and of the recommended model, and the loads without a
solved case nearby. `asperity truth` solves the scan of the scene itself, and
`asperity curve --corrected` divides by the expected ratios.
Default: force and area (at loads the area) at separations of 0:4:401 in units of
asperity_height_std.

Examples:
  asperity recommend scene.toml
  asperity recommend scene.toml --load 1:1000:20:log --quantity area,tangent
  asperity recommend scene.toml --reference gao --within 20% --quantity force --separation 0:3:7";

impl Recommend {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene)?;
        let (id, reference) = scene.reference(self.reference.as_deref())?;
        let separations = linspace(0.0, 4.0, 401);
        let usual = [Quantity::Force, Quantity::Area];
        let request = self.asked.request(&scene.file, &separations, &usual);
        // Persson's theory has evidence, too.
        let models = scene.models_beside_bem(&self.asked.models, &request.quantities)?;
        let working = progress("comparing models");
        let advice = scene.file.recommend_among(models, &request, &reference, self.within);
        let advice = advice.with_context(|| format!("{}: the reference {id}", scene.name))?;
        drop(working);

        let mut table = Table::new(&["model", "asperities", "parts"]);
        table.head.extend(request.quantities.iter().map(|q| column_beside(*q, "deviation")));
        table.head.extend(["simplest", "area_off_bem", "area_off_bem_spread"].map(Into::into));
        table.head.extend(["stiffness_off_bem", "stiffness_off_bem_spread"].map(Into::into));
        let unloading = advice.compared.contains(&Compared::UnloadingStiffness);
        if unloading {
            let head = ["unloading_stiffness_off_bem", "unloading_stiffness_off_bem_spread"];
            table.head.extend(head.map(Into::into));
        }
        let simplest = advice.simplest.as_ref().map(Described::id);
        let far = format!("no: too far from {}", advice.reference.id());
        let mut lacking = vec![];
        for found in &advice.comparisons {
            let validity = found.model.validity();
            let asperities = match (validity.asperities, validity.angles) {
                (false, _) => "none",
                (true, true) => "at angles",
                (true, false) if found.model.equal().id() != found.model.id() => "random",
                (true, false) => "upright",
            };
            let parts = Cell::Number(Some(found.regimes as f64));
            let mut row = vec![found.model.id().into(), asperities.into(), parts];
            let deviation = |quantity: &Quantity| {
                let mut known = found.deviations.iter().flatten();
                let (_, deviation) = known.find(|(known, _)| known == quantity)?;
                Some(*deviation).filter(|d| d.is_finite())
            };
            row.extend(request.quantities.iter().map(|q| Cell::Number(deviation(q))));
            for (_, error) in &found.lacking {
                lacking.push((found.model.id().to_string(), error.clone()));
            }
            row.push(match &found.deviations {
                Err(error) => {
                    if found.lacking.is_empty() {
                        lacking.push((found.model.id().to_string(), error.clone()));
                    }
                    "no value".into()
                }
                Ok(_) if !found.lacking.is_empty() => "no: a value is missing".into(),
                Ok(_) if simplest == Some(found.model.id()) => match &advice.merging {
                    Some(_) => "yes but contacts merge".into(),
                    None => "yes".into(),
                },
                Ok(_) if found.outside.is_some() => "no: not valid here".into(),
                Ok(_) if found.largest() <= advice.within => "no: a simpler one is as near".into(),
                Ok(_) => far.as_str().into(),
            });
            let off = found.off.unwrap_or_default();
            row.extend([off.area, off.area_spread].map(Cell::Number));
            row.extend([off.stiffness, off.stiffness_spread].map(Cell::Number));
            if unloading {
                let off = [off.unloading_stiffness, off.unloading_stiffness_spread];
                row.extend(off.map(Cell::Number));
            }
            table.rows.push(row);
        }
        for text in asperity_answer::by_reason(&lacking) {
            print_message("note", &format!("no value: {text}"));
        }
        let places = if self.asked.is_nowhere() { vec![At::from(2.0)] } else { request.at.clone() };
        let outside = advice.comparisons.iter().filter(|found| found.outside.is_some());
        let checked = [&advice.reference].into_iter().chain(&advice.simplest);
        let mut once: Vec<(String, Model)> = vec![];
        for model in checked.chain(outside.map(|found| &found.model)) {
            if !once.iter().any(|(id, _)| id == model.id()) {
                once.push((model.id().to_string(), model.clone()));
            }
        }
        scene.report_answers(&once.iter().collect::<Vec<_>>(), &places);
        let verdict = advice.verdict(|model| model.id().to_string());
        print_message(
            "note",
            &format!("{verdict}; models are listed from simplest to most complex"),
        );
        let (compared, all) = (advice.evidence.len(), places.len());
        if compared < all {
            let text = format!(
                "boundary elements are expected at {compared} of the {all} separations or loads, from the first to the last"
            );
            print_message("note", &text);
        }
        let notes = [advice.summary(), advice.expectations()].concat();
        notes.iter().for_each(|note| print_message("note", note));
        self.output.write(&table)
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
