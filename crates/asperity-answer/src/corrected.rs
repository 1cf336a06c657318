//! Models divided by their expected ratio to boundary elements, with the interval, beside the
//! models as they are.

use asperity::{Compared, ContactError, CorrectedRow, Quantity, Separation, SeparationUnit};

use crate::asked::Asked;
use crate::blanks::{Lacking, count};
use crate::inquiry::{Found, Inquiry};
use crate::subject::measured;
use crate::{Cell, Sheet};

impl Inquiry<'_> {
    /// Adds the corrected rows of one model, whose rows as they are begin at `first`.
    pub(crate) fn add_corrected(
        &self,
        own: &str,
        asked: &Asked,
        first: usize,
        sheet: &mut Sheet,
        found: &mut Found,
    ) {
        let id = format!("{own}-corrected");
        let rows = self.request.at.len();
        let corrected = match asked.corrected(self.file, own) {
            Ok(corrected) => corrected,
            Err(reason) => {
                found.lacking.push((lacks(rows, rows, own, "value", &reason), id.clone()));
                let blank = self.request.at.iter().map(|&at| {
                    let place = self.loads_at(at).map(Cell::from);
                    let mut row: Vec<Cell> = [Cell::from(&*id)].into_iter().chain(place).collect();
                    row.resize(sheet.heads.len(), Cell::BLANK);
                    row
                });
                sheet.rows.extend(blank);
                return;
            }
        };
        let (mut reasons, mut lighter, mut apart, mut least) = (vec![], vec![], vec![], 0);
        for (k, &at) in self.request.at.iter().enumerate() {
            let row = corrected.at(at);
            let extrapolated = row.iter().filter(|row| row.is_extrapolated());
            lighter.extend(extrapolated.map(CorrectedRow::basis));
            apart.extend(row.iter().filter_map(|row| row.separation().err()));
            least += row.iter().filter(|row| row.is_least_area()).count();
            if let Err(reason) = &row {
                count(&mut reasons, (None, reason));
            }
            let mut cells = vec![Cell::from(&*id)];
            cells.extend(self.loads_at(at).map(Cell::from));
            let row = row.as_ref().ok();
            // What the model itself lacks has its reason there.
            let places = self.place_heads().len();
            let had = |q: usize| sheet.rows[first + k][places + 3 * q].number().is_some();
            let had = (0..self.request.quantities.len()).map(had).collect();
            cells.extend(self.corrected_cells(row, had, &mut reasons));
            sheet.rows.push(cells);
        }
        if let Some(basis) = lighter.first() {
            let loads = match (lighter.len(), rows) {
                (1, 1) => "the load is".into(),
                (1, rows) => format!("1 of {rows} loads is"),
                (count, rows) => format!("{count} of {rows} loads are"),
            };
            let text = format!(
                "{id}: {loads} below the lightest solved one, whose ratios are used ({basis})"
            );
            sheet.note("extrapolated", text);
        }
        let of_area = |q: &Quantity| matches!(Compared::behind(*q), Some((Compared::Area, _)));
        if least > 0 && self.request.quantities.iter().any(of_area) {
            let at = match rows {
                1 => String::new(),
                _ => format!("at {least} of {rows} loads "),
            };
            let text = format!(
                "{id}: {at}the area is F/H, the least that carries the load, and its interval extends above only"
            );
            sheet.note("least-area", text);
        }
        let lacks = |count, what: &str, reason| (lacks(count, rows, own, what, reason), id.clone());
        found.lacking.extend(apart.first().map(|reason| lacks(apart.len(), "separation", reason)));
        found.lacking.extend(reasons.iter().map(|(count, (partly, reason))| {
            let what = partly.map_or("value".into(), |quantity| quantity.to_string());
            lacks(*count, &what, reason)
        }));
    }

    /// The cells behind those of the load: separation, quantities with their intervals, and the
    /// interval of the separation.
    fn corrected_cells(
        &self,
        row: Option<&CorrectedRow<'_>>,
        had: Vec<bool>,
        reasons: &mut Vec<(usize, Lacking)>,
    ) -> Vec<Cell> {
        let separation = row.and_then(|row| row.separation().ok());
        let length = |separation: Option<Separation>, unit| {
            Cell::from(separation.and_then(|s| measured(self.file, s, unit).ok()))
        };
        let metres = |separation| length(separation, SeparationUnit::Metres);
        let middle = separation.map(|separation| separation.value);
        let mut cells = vec![length(middle, SeparationUnit::Sigma), metres(middle)];
        for (&quantity, had) in self.request.quantities.iter().zip(had) {
            cells.extend(match row.map(|row| row.value(quantity)) {
                Some(Ok(found)) => [found.value, found.lower, found.upper].map(Cell::Number),
                Some(Err(reason)) => {
                    let blank = Cell::Blank(Some(reason.marked().into()));
                    if had {
                        count(reasons, (Some(quantity), &reason));
                    }
                    [blank, Cell::BLANK, Cell::BLANK]
                }
                None => [Cell::BLANK; 3],
            });
        }
        cells.extend([
            metres(separation.map(|found| found.lower)),
            metres(separation.map(|found| found.upper)),
        ]);
        cells
    }
}

/// The reason for values that a corrected model lacks, with what to do.
fn lacks(count: usize, rows: usize, own: &str, what: &str, reason: &ContactError) -> String {
    let counted = match rows {
        1 => String::new(),
        _ => format!(" in {count} of {rows} rows, first"),
    };
    let advice = match count == rows {
        true => format!("; leave --corrected out, or use the rows of {own}"),
        false => String::new(),
    };
    // The id stands in front of every message.
    let reason = match reason {
        ContactError::Refused { model, reason } if model.ends_with("-corrected") => reason.clone(),
        other => other.marked(),
    };
    format!("no {what}{counted}: {reason}{advice}")
}
