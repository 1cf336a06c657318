//! Models divided by their expected ratio to boundary elements, with the interval, beside the
//! models as they are.

use anyhow::{Result, bail};
use asperity::{At, Compared, ContactError, Corrected, CorrectedRow, Datum, Scene, SeparationUnit};

use crate::ask::{Lacking, Question, Row, column_beside, count};
use crate::output::table::{Cell, Table};
use crate::output::{print_message, progress};
use crate::scene::NamedModel;

/// A quantity and the ends of its interval.
const ENDS: [&str; 2] = ["lower", "upper"];

impl Question<'_> {
    /// The results of all models in one table, as they are and corrected, each corrected quantity
    /// with its interval.
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
        table.head.extend(ENDS.map(|end| format!("separation_{end}_m")));
        for model in models {
            let mut uncorrected = vec![];
            self.ask(model, |Row { mut place, values }| {
                uncorrected.push(values.iter().map(Option::is_some).collect::<Vec<_>>());
                answered |= values.iter().any(Option::is_some);
                let value = |value: &Option<asperity::Evaluation>| value.map(|found| found.value());
                let alone = |value| [value, None, None].map(Cell::Number);
                place.extend(values.iter().map(value).flat_map(alone));
                place.extend([const { Cell::Number(None) }; 2]);
                table.rows.push(place);
            })?;
            self.add_corrected(model, &uncorrected, &mut table);
        }
        self.finish(answered)?;
        Ok(table)
    }

    /// The corrected rows of one model, which has values or not by row and quantity.
    fn add_corrected(
        &mut self,
        (own, model): &NamedModel,
        uncorrected: &[Vec<bool>],
        table: &mut Table,
    ) {
        let _progress = progress(own);
        let (scene, shape) = (&self.scene.file.scene, self.scene.file.surface_shape());
        let id = format!("{own}-corrected");
        let compiled = shape
            .and_then(|shape| Ok(Corrected::new(model, scene, shape, &self.request)?.named(own)));
        // Stands in front of every message.
        let without_id = |reason: ContactError| match reason {
            ContactError::Refused { model, reason } if model.ends_with("-corrected") => reason,
            other => other.to_string(),
        };
        let rows = self.request.at.len();
        let lacks = |count: usize, what: &str, reason: ContactError| {
            let counted = match rows {
                1 => String::new(),
                _ => format!(" in {count} of {rows} rows, first"),
            };
            let advice = match count == rows {
                true => format!("; leave --corrected out, or use the rows of {own}"),
                false => String::new(),
            };
            (id.clone(), format!("no {what}{counted}: {}{advice}", without_id(reason)))
        };
        let corrected = match compiled {
            Ok(corrected) => corrected,
            Err(reason) => {
                self.lacking.push(lacks(rows, "value", reason));
                let blank = |at: &At| {
                    let mut row = vec![Cell::from(&*id)];
                    row.extend(self.loads_at(*at).map(Cell::Number));
                    row.resize_with(table.head.len(), || Cell::Number(None));
                    row
                };
                table.rows.extend(self.request.at.iter().map(blank).collect::<Vec<_>>());
                return;
            }
        };
        let (mut reasons, mut lighter, mut apart, mut least) = (vec![], vec![], vec![], 0);
        for (&at, had) in self.request.at.iter().zip(uncorrected) {
            let row = corrected.at(at);
            let extrapolated = row.iter().filter(|row| row.is_extrapolated());
            lighter.extend(extrapolated.map(CorrectedRow::basis));
            apart.extend(row.iter().filter_map(|row| row.separation().err()));
            least += row.iter().filter(|row| row.is_least_area()).count();
            table.rows.push(self.corrected_row(&id, (at, had), &row, &mut reasons));
        }
        if let Some(basis) = lighter.first() {
            let loads = match (lighter.len(), rows) {
                (1, 1) => "the load is".into(),
                (count, rows) => format!("{count} of {rows} loads are"),
            };
            let text = format!(
                "{id}: {loads} below the lightest solved one, whose ratios are used ({basis})"
            );
            print_message("note", &text);
        }
        let of_area =
            |q: &asperity::Quantity| matches!(Compared::behind(*q), Some((Compared::Area, _)));
        if least > 0 && self.request.quantities.iter().any(of_area) {
            let at = match rows {
                1 => String::new(),
                _ => format!("at {least} of {rows} loads "),
            };
            let text = format!(
                "{id}: {at}the area is F/H, the least that carries the load, and its interval extends above only"
            );
            print_message("note", &text);
        }
        let count = apart.len();
        let separation = apart.into_iter().next().map(|reason| lacks(count, "separation", reason));
        self.lacking.extend(separation);
        self.lacking.extend(reasons.into_iter().map(|(count, (partly, reason))| {
            let what = partly.map_or("value".into(), |quantity| quantity.to_string());
            lacks(count, &what, reason)
        }));
    }

    /// Load and pressure, as far as the table has columns for them.
    fn loads_at(&self, at: At) -> impl Iterator<Item = Option<f64>> {
        let scene = &self.scene.file.scene;
        let loads = self.head().head.len() - 3;
        [at.load(scene), at.pressure(scene)].into_iter().take(loads)
    }

    /// A row; values that the model does not `had` have no reason of their own.
    fn corrected_row(
        &self,
        id: &str,
        (at, had): (At, &[bool]),
        row: &Result<CorrectedRow<'_>, ContactError>,
        reasons: &mut Vec<(usize, Lacking<ContactError>)>,
    ) -> Vec<Cell> {
        let (scene, from) = (&self.scene.file.scene, self.scene.file.separation_from);
        if let Err(reason) = row {
            count(reasons, (None, reason));
        }
        let row = row.as_ref().ok();
        let separation = row.and_then(|row| row.separation().ok());
        let lengths = [SeparationUnit::Sigma, SeparationUnit::Metres]
            .map(|unit| Some(separation?.value.measured_in(unit, from, scene).ok()?.value));
        let mut cells = vec![Cell::from(id)];
        cells.extend(self.loads_at(at).chain(lengths).map(Cell::Number));
        for (&quantity, had) in self.request.quantities.iter().zip(had) {
            let found = row.and_then(|row| match row.value(quantity) {
                Ok(found) => Some([found.value, found.lower, found.upper]),
                Err(reason) => {
                    if *had {
                        count(reasons, (Some(quantity), &reason));
                    }
                    None
                }
            });
            cells.extend(found.map_or([None; 3], |all| all.map(Some)).map(Cell::Number));
        }
        let ends = separation.map_or([None; 2], |found| {
            [found.lower, found.upper].map(|end| metres(end, from, scene))
        });
        cells.extend(ends.map(Cell::Number));
        cells
    }
}

/// A separation in metres from this plane.
fn metres(separation: asperity::Separation, from: Datum, scene: &Scene) -> Option<f64> {
    Some(separation.measured_in(SeparationUnit::Metres, from, scene).ok()?.value)
}
