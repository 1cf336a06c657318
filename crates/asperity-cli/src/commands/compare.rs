//! `asperity compare`: several models and their deviations from a reference.

use anyhow::Result;
use clap::Args;

use crate::ask::{Question, Row, column_beside};
use crate::commands::curve::USUAL;
use crate::input::args::{ModelArgs, OutputArgs, model_id};
use crate::output::table::Cell;
use crate::scene::LoadedScene;

/// Compare models at the same separations or loads, with deviations from a reference
#[derive(Debug, Args)]
#[command(
    after_help = "Deviations are relative to the reference (differences for logarithms and shares),
and 0 where two values differ by less than their error bounds. At a load, each
model has its own separation.
Default: force, area and tangent (at loads without the force) at a separation of
2 asperity_height_std.

Examples:
  asperity compare scene.toml
  asperity compare scene.toml --load 10,100 --reference jg --quantity area,mean-pressure
  asperity compare scene.toml --separation -0.5 --model gw,ke,gao --format csv"
)]
pub struct Compare {
    #[command(flatten)]
    asked: ModelArgs,
    /// Reference model [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    reference: Option<String>,
    #[command(flatten)]
    output: OutputArgs,
}

impl Compare {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene)?;
        let reference = scene.reference(self.reference.as_deref())?;
        let request = self.asked.request(&scene.file, &[2.0], &USUAL);
        let models = scene.models(&self.asked.models, &request.quantities)?;
        let mut question = Question::new(&scene, request);
        question.at_defaults = self.asked.is_nowhere();
        let quantities = question.request.quantities.clone();

        let mut table = question.head();
        let heads = quantities.iter().flat_map(|q| [q.column(), column_beside(*q, "deviation")]);
        table.head.extend(heads);
        let mut ask = |model| -> Result<Vec<Row>> {
            let mut rows = vec![];
            question.ask(model, |row| rows.push(row))?;
            Ok(rows)
        };
        let wanted = ask(&reference)?;
        let answers: Vec<_> = models.iter().map(ask).collect::<Result<_>>()?;
        let mut answered = false;
        for (k, wanted) in wanted.iter().enumerate() {
            for Row { place, values } in answers.iter().map(|rows| &rows[k]) {
                let mut row = place.clone();
                for ((found, wanted), q) in values.iter().zip(&wanted.values).zip(&quantities) {
                    answered |= found.is_some();
                    let deviation = found.zip(*wanted).and_then(|(a, b)| a.deviation(&b, *q));
                    row.push(Cell::Number(found.map(|found| found.value())));
                    row.push(Cell::Number(deviation));
                }
                table.rows.push(row);
            }
        }
        question.finish(answered)?;
        self.output.write(&table)
    }
}
