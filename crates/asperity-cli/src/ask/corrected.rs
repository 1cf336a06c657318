//! Models divided by their expected ratio to boundary elements, with the interval.

use anyhow::{Result, bail};
use asperity::{At, ContactError, Corrected, CorrectedRow, CorrectedValue, SeparationUnit};

use crate::ask::{Lacking, Question, column_beside, count};
use crate::output::table::{Cell, Table};
use crate::output::{print_message, progress};
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
            let id = format!("{id}-corrected");
            let without_id = |reason: ContactError| {
                let text = reason.to_string();
                text.strip_prefix(&format!("{id}: ")).map_or(text.clone(), Into::into)
            };
            let corrected = match compiled {
                Ok(corrected) => corrected,
                Err(reason) => {
                    self.lacking.push((id.clone(), without_id(reason)));
                    continue;
                }
            };
            let (mut reasons, mut lighter) = (vec![], vec![]);
            for &at in &self.request.at {
                let row = corrected.at(at);
                let extrapolated = row.iter().filter(|row| row.is_extrapolated());
                lighter.extend(extrapolated.map(CorrectedRow::basis));
                let (cells, any) = self.corrected_row(&corrected, at, &row, &mut reasons);
                answered |= any;
                table.rows.push(cells);
            }
            let rows = self.request.at.len();
            if let Some(basis) = lighter.first() {
                let count = lighter.len();
                let text = format!(
                    "{id}: {count} of {rows} loads are below the lightest solved one, whose ratios are used ({basis})"
                );
                print_message("note", &text);
            }
            self.lacking.extend(reasons.into_iter().map(|(count, (partly, reason))| {
                let reason = without_id(reason);
                let what = partly.map_or("value".into(), |quantity| quantity.to_string());
                let text = match rows {
                    1 => format!("no {what}: {reason}"),
                    _ => format!("no {what} in {count} of {rows} rows, first: {reason}"),
                };
                (id.clone(), text)
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
        row: &Result<CorrectedRow<'_>, ContactError>,
        reasons: &mut Vec<(usize, Lacking<ContactError>)>,
    ) -> (Vec<Cell>, bool) {
        let (scene, from) = (&self.scene.file.scene, self.scene.file.separation_from);
        if let Err(reason) = row {
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
