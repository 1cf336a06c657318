//! `asperity solve`: from loads to separations.

use anyhow::{Context, Result};
use asperity::{Quantity, Readout, Request};
use clap::Args;

use crate::args::{LoadArgs, OutputArgs, QuantityArgs, RequiredModelArgs, SceneArgs};
use crate::progress::Progress;
use crate::reading::{Words, columns, crossings, values};
use crate::scene::LoadedScene;
use crate::table::Table;

/// The separations that carry a load, and the quantities there
#[derive(Debug, Args)]
#[command(after_help = "Columns: model, load_n, separation_over_sigma, separation_m, then the
quantities as asked, in SI units.
A model whose force rises and falls (at) may have several separations for one
load: each is a row.

Examples:
  asperity solve scene.toml --model ke --load 100
  asperity solve scene.toml --model gw,ke --pressure 1e5,1e6,1e7 --quantity area-fraction,tangent")]
pub struct Solve {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    models: RequiredModelArgs,
    #[command(flatten)]
    loads: LoadArgs,
    #[command(flatten)]
    quantities: QuantityArgs,
    #[command(flatten)]
    output: OutputArgs,
}

impl Solve {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.scene.scene)?;
        let models = scene.models(&self.models.models)?;
        let outputs = self.quantities.outputs();
        let loads = self.loads.newtons(&scene);
        let request = Request::new([Quantity::Force]).within(self.quantities.tolerance);

        let progress = Progress::new("separations", models.len() * loads.len());
        let (mut table, mut words) = (Table::default(), Words::default());
        for (id, model) in &models {
            let context = || format!("{}: {id}", self.scene.scene.display());
            let readout = Readout::new(model, scene.scene(), &request, &outputs);
            let readout = readout.with_context(context)?;
            let (mut carried, mut separations) = (vec![], vec![]);
            for &load in &loads {
                let found = crossings(id, &readout, load, &mut words).with_context(context)?;
                carried.extend(found.iter().map(|_| Some(load)));
                separations.extend(found);
                progress.step();
            }
            let found = values(&readout, &outputs, &separations, &mut words);
            let mut part = Table::default();
            part.words("model", vec![id.clone(); separations.len()]);
            part.numbers("load_n", "N", carried);
            scene.found(&separations).columns(&mut part);
            columns(&mut part, &outputs, found.with_context(context)?);
            table.append(part);
        }
        drop(progress);
        words.say();
        self.output.write(&table)
    }
}
