//! Models divided by their expected ratio to boundary elements, with the interval.

use anyhow::{Context, Result, bail};
use asperity::{At, ContactError, Corrected, CorrectedValue, SeparationUnit};

use crate::ask::{Lacking, Question, column_beside, count};
use crate::output::progress;
use crate::output::table::{Cell, Table};
use crate::scene::NamedModel;

/// A quantity and the ends of its interval.
const ENDS: [&str; 2] = ["lower", "upper"];

impl Question<'_> {
    /// The corrected results of all models in one table, each quantity with its interval.
    pub fn corrected(&mut self, models: &[NamedModel]) -> Result<Table> {
        if self.request.at.iter().any(|at| matches!(at, At::Separation(_))) {
            bail!(
                "--corrected needs --load or --pressure: models are compared with boundary elements at equal loads"
            );
        }
        let (mut table, mut answered) = (self.head(), false);
        for quantity in &self.request.quantities {
            table.head.push(quantity.column());
            table.head.extend(ENDS.map(|end| column_beside(*quantity, end)));
        }
        for (id, model) in models {
            let _progress = progress(id);
            self.found.extend(self.scene.file.findings_at(model, &self.request.at));
            let (scene, shape) = (&self.scene.file.scene, self.scene.file.surface_shape());
            let compiled =
                shape.and_then(|shape| Corrected::new(model, scene, shape, &self.request));
            let corrected = compiled.with_context(|| format!("{}: {id}", self.scene.name))?;
            let mut reasons = vec![];
            for &at in &self.request.at {
                let (cells, any) = self.corrected_row(&corrected, at, &mut reasons);
                answered |= any;
                table.rows.push(cells);
            }
            let rows = self.request.at.len();
            let id = corrected.id();
            self.lacking.extend(reasons.into_iter().map(|(count, (partly, reason))| {
                let text = reason.to_string();
                let reason = text.strip_prefix(&format!("{id}: ")).unwrap_or(&text);
                let what = partly.map_or("value".into(), |quantity| quantity.to_string());
                let text = match rows {
                    1 => format!("no {what}: {reason}"),
                    _ => format!("no {what} in {count} of {rows} rows, first: {reason}"),
                };
                (id.to_string(), text)
            }));
        }
        self.finish(answered)?;
        Ok(table)
    }

    /// A row and whether it has a value.
    fn corrected_row(
        &self,
        corrected: &Corrected,
        at: At,
        reasons: &mut Vec<(usize, Lacking<ContactError>)>,
    ) -> (Vec<Cell>, bool) {
        let (scene, from) = (&self.scene.file.scene, self.scene.file.separation_from);
        let row = corrected.at(at);
        if let Err(reason) = &row {
            count(reasons, (None, reason));
        }
        let row = row.as_ref().ok();
        let separation = row.and_then(|row| row.separation().ok());
        let lengths = [SeparationUnit::Sigma, SeparationUnit::Metres]
            .map(|unit| Some(separation?.measured_in(unit, from, scene).ok()?.value));
        let loads = self.head().head.len() - 3;
        let given = [at.load(scene), at.pressure(scene)];
        let mut cells = vec![Cell::from(corrected.id())];
        cells.extend(given.into_iter().take(loads).chain(lengths).map(Cell::Number));
        let mut any = false;
        for &quantity in &self.request.quantities {
            let found = row.and_then(|row| match row.value(quantity) {
                Ok(found) => Some(found),
                Err(reason) => {
                    count(reasons, (Some(quantity), &reason));
                    None
                }
            });
            any |= found.is_some();
            let numbers = |CorrectedValue { value, lower, upper, .. }| [value, lower, upper];
            let numbers = found.map(numbers).map_or([None; 3], |all| all.map(Some));
            cells.extend(numbers.map(Cell::Number));
        }
        (cells, any)
    }
}
