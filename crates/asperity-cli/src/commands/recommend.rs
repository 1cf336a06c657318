//! `asperity recommend`: the simplest model that will do, and how far models were from boundary
//! elements on surfaces like this one.

use anyhow::{Context, Result};
use asperity::{At, Described, Evidence, Quantity, linspace};
use clap::Args;

use crate::ask::named;
use crate::input::args::{Asked, OutputArgs, model_id};
use crate::input::numbers::share;
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{progress, say};
use crate::scene::LoadedScene;

/// Models beside a reference, and what boundary elements say of them on surfaces like this one
#[derive(Debug, Args)]
#[command(after_help = help())]
pub struct Recommend {
    #[command(flatten)]
    asked: Asked,
    /// The model that the others are compared with [default: ke; gw where there is no hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    reference: Option<String>,
    /// Largest deviation from the reference: 5%, or 0.05
    #[arg(long, value_name = "X", value_parser = share, default_value = "5%")]
    within: f64,
    #[command(flatten)]
    output: OutputArgs,
}

/// What was solved is said by the evidence itself.
fn help() -> String {
    let solved = Evidence::committed().map_or_else(|e| e.to_string(), Evidence::solved);
    format!(
        "Simple is, in this order: upright asperities of one radius before random ones, none
(Persson) and asperities at all angles; a force law of few parts before one of many; an
older model before a newer one. The models are listed so, and the simplest is the first
that is near enough and made for the scene (a model without yielding is not, where
asperities yield). Deviations are the largest over the separations or
loads, relative to the reference (differences, for logarithms and shares).
Near the reference is not near the truth: columns .._off_bem hold how far a model
was from boundary elements in the nearest case that was solved (random surfaces of
{solved}),
the farthest of the places that have one; .._spread is what one such surface differs
from the next. Notes say it place by place, and where no case is near. `asperity truth` solves the scene's own scan.
Unless something is given: force and area (at loads, the area) at separations of
0:4:401 in sigma.

Examples:
  asperity recommend scene.toml
  asperity recommend scene.toml --load 1:1000:20:log --quantity area,tangent
  asperity recommend scene.toml --reference gao --within 20% --quantity force --separation 0:3:7"
    )
}

impl Recommend {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene)?;
        let (id, reference) = scene.reference(self.reference.as_deref())?;
        let separations = linspace(0.0, 4.0, 401);
        let usual = [Quantity::Force, Quantity::Area];
        let request = self.asked.request(&scene.file, &separations, &usual);
        // The evidence is of these as well.
        let mut models = scene.models_beside_bem(&self.asked.models, &request.quantities)?;
        if self.asked.models.is_empty() {
            models.extend(scene.file.adhesive_models());
        }
        let working = progress("comparing models");
        let advice = scene.file.recommend_among(models, &request, &reference, self.within);
        let advice = advice.with_context(|| format!("{}: the reference {id}", scene.name))?;
        drop(working);

        let mut table = Table::new(&["model", "asperities", "parts"]);
        table.head.extend(request.quantities.iter().map(|q| named(*q, "deviation")));
        table.head.extend(["simplest", "area_off_bem", "area_off_bem_spread"].map(Into::into));
        table.head.extend(["stiffness_off_bem", "stiffness_off_bem_spread"].map(Into::into));
        let simplest = advice.simplest.as_ref().map(Described::id);
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
            let deviations = match &found.deviations {
                Ok(all) => all.iter().map(|(_, d)| Some(*d).filter(|d| d.is_finite())).collect(),
                Err(_) => vec![None; request.quantities.len()],
            };
            row.extend(deviations.into_iter().map(Cell::Number));
            row.push(match &found.deviations {
                Err(error) => error.to_string().as_str().into(),
                Ok(_) if simplest == Some(found.model.id()) => "simplest".into(),
                Ok(_) if found.outside.is_some() => "does not hold".into(),
                Ok(_) if found.largest() <= advice.within => "near enough".into(),
                Ok(_) => "too far".into(),
            });
            let off = found.off.unwrap_or_default();
            let off = [off.area, off.area_spread, off.stiffness, off.stiffness_spread];
            row.extend(off.map(Cell::Number));
            table.rows.push(row);
        }
        let places = if self.asked.is_nowhere() { vec![At::from(2.0)] } else { request.at.clone() };
        let outside = advice.comparisons.iter().filter(|found| found.outside.is_some());
        let told = [&advice.reference].into_iter().chain(&advice.simplest);
        let told = told.chain(outside.map(|found| &found.model));
        let told: Vec<_> = told.map(|m| (m.id().to_string(), m.clone())).collect();
        scene.tell(&told.iter().collect::<Vec<_>>(), &places);
        let reference = advice.reference.id();
        let compared = |id: &&str| advice.comparisons.iter().any(|found| found.model.id() == *id);
        let within = rounded(100.0 * self.within);
        let chosen = match simplest.filter(compared) {
            Some(id) => {
                format!("{id} is the simplest model that holds, within {within} % of {reference}")
            }
            None => format!("none of these models holds within {within} % of {reference}"),
        };
        let order = "simplest first: upright asperities before random ones, none, and all angles, few parts of the force law before many, old before new";
        say("note", &format!("{chosen}; {order}"));
        advice.told().iter().for_each(|told| say("note", told));
        self.output.write(&table)
    }
}
