//! Models divided by their expected ratio to boundary elements, with the interval, beside the
//! models as they are.

use asperity::{Code, Compared, ContactError, Quantity, Separation, SeparationUnit};

use crate::asked::Asked;
use crate::blanks::{Blanks, kind};
use crate::inquiry::{Found, Inquiry};
use crate::models::reason_alone;
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
        let (rows, places) = (self.request.at.len(), self.place_heads().len());
        let corrected = asked.corrected(self.file);
        let (mut blanks, mut lighter, mut least) = (Blanks::default(), vec![], 0);
        let length = |separation: Option<Separation>, unit| {
            Cell::from(separation.and_then(|s| measured(self.file, &self.file.scene, s, unit).ok()))
        };
        let words = |reason: &ContactError| reason_alone(&id, reason);
        for (k, &at) in self.request.at.iter().enumerate() {
            let row = corrected.as_ref().map_err(Clone::clone);
            let row = row.and_then(|corrected| corrected.at(at));
            let separation = match &row {
                Ok(row) => {
                    lighter.extend(row.is_extrapolated().then(|| row.basis()));
                    least += usize::from(row.is_least_area());
                    let separation = row.separation();
                    // Where the model itself has none, it has its reason there.
                    let has_own = sheet.rows[first + k][places - 1].number().is_some();
                    if let Some(reason) = separation.as_ref().err().filter(|_| has_own) {
                        blanks.count("separation", kind(reason), words(reason));
                    }
                    separation.ok()
                }
                Err(reason) => {
                    blanks.count("value", kind(reason), words(reason));
                    None
                }
            };
            let middle = separation.map(|separation| separation.value);
            let mut cells = vec![Cell::from(&*id)];
            cells.extend(self.loads_at(at).map(Cell::from));
            cells.extend(
                [SeparationUnit::Sigma, SeparationUnit::Metres].map(|unit| length(middle, unit)),
            );
            for (q, &quantity) in self.request.quantities.iter().enumerate() {
                cells.extend(match row.as_ref().map(|row| row.value(quantity)) {
                    Ok(Ok(found)) => [found.value, found.lower, found.upper].map(Cell::Number),
                    Ok(Err(reason)) => {
                        // What the model itself lacks has its reason there.
                        if sheet.rows[first + k][places + 3 * q].number().is_some() {
                            blanks.count(&quantity.to_string(), kind(&reason), words(&reason));
                        }
                        [Cell::Blank(Some(reason.into())), Cell::BLANK, Cell::BLANK]
                    }
                    Err(_) => [Cell::BLANK; 3],
                });
            }
            let ends = [separation.map(|found| found.lower), separation.map(|found| found.upper)];
            cells.extend(ends.map(|end| length(end, SeparationUnit::Metres)));
            sheet.rows.push(cells);
        }
        let loads = |count: usize| match rows {
            1 => String::new(),
            _ => format!("at {count} of {rows} loads "),
        };
        if let Some(basis) = lighter.first() {
            let (loads, basis) = (loads(lighter.len()), format!("whose ratios are used ({basis})"));
            let text = format!("{id}: {loads}the load is below the lightest solved one, {basis}");
            sheet.note(Code::Extrapolated, text);
        }
        let of_area = |q: &Quantity| matches!(Compared::behind(*q), Some((Compared::Area, _)));
        if least > 0 && self.request.quantities.iter().any(of_area) {
            let text = "the area is F/H, the least that carries the load, and its interval extends above only";
            sheet.result(format!("{id}: {}{text}", loads(least)));
        }
        found.lacking.extend(blanks.texts(rows).map(|text| (text, id.clone())));
    }
}
