//! What is asked of a scene: models, quantities and places, and how the answer is shown.

use asperity::{At, ContactError, Described, Evaluation, Finding, Findings, Quantity, Request};
use asperity_inputs::SceneFile;

use crate::asked::{Asked, Line};
use crate::blanks::Blanks;
use crate::models::{NamedModel, grouped, once};
use crate::{AnswerError, Cell, Sheet, Watch};

/// Rows evaluated at a time, which bounds the memory.
const ROWS_AT_A_TIME: usize = 8192;

/// What is asked of a scene.
#[derive(Debug, Clone)]
pub struct Inquiry<'s> {
    /// The scene.
    pub file: &'s SceneFile,
    /// The models, in the order of the rows.
    pub models: Vec<NamedModel>,
    /// Quantities, separations or loads, tolerance.
    pub request: Request,
    /// The columns beside each quantity.
    pub beside: Beside,
    /// Whether every separation that carries a load has a row, instead of the largest alone.
    pub all: bool,
    /// Whether nobody has chosen the separations: findings are about a typical one then.
    pub at_defaults: bool,
}

/// The columns beside each quantity.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub enum Beside {
    /// None.
    #[default]
    Nothing,
    /// A bound on its error: relative, but a difference for logarithms and shares.
    Errors,
    /// The deviation from this model, row by row in the order of places.
    Deviations(NamedModel),
    /// The ends of an interval, in rows that are corrected by solved surfaces.
    Intervals,
}

impl<'s> Inquiry<'s> {
    /// An inquiry without further columns.
    #[must_use]
    pub fn new(file: &'s SceneFile, models: Vec<NamedModel>, request: Request) -> Self {
        let beside = Beside::Nothing;
        Self { file, models, request, beside, all: false, at_defaults: false }
    }

    /// Fills a sheet: model, load and pressure at loads, separation, and the quantities. Values
    /// that do not exist are blank; findings give the reasons.
    ///
    /// # Errors
    /// The reason why the scene refuses a model, and an error if all rows are blank; the sheet has
    /// the findings until then.
    pub fn answer(&self, sheet: &mut Sheet, watch: &dyn Watch) -> Result<(), AnswerError> {
        sheet.heads = self.heads();
        let mut found = Found::default();
        match &self.beside {
            Beside::Deviations(reference) => {
                self.add_deviations(reference, sheet, &mut found, watch)?;
            }
            beside => {
                for model in &self.models {
                    let first = sheet.rows.len();
                    let asked =
                        self.ask(model, &mut found, sheet, watch, |sheet, place, line| {
                            sheet.rows.push(self.row(place, &line, beside));
                        })?;
                    if matches!(beside, Beside::Intervals) {
                        self.add_corrected(&model.0, &asked, first, sheet, &mut found);
                    }
                }
            }
        }
        found.report(self.file, sheet);
        if found.answered { Ok(()) } else { Err("no row has a value".into()) }
    }

    /// The number of columns for the model and for the load or separation.
    pub(crate) fn place_heads(&self) -> Vec<&'static str> {
        let loads = match self.request.at.first() {
            None | Some(At::Separation(_)) => &[][..],
            // As a quantity, the pressure has that column.
            _ if self.request.quantities.contains(&Quantity::Pressure) => &["load_N"],
            _ => &["load_N", "pressure_Pa"],
        };
        [&["model"], loads, &["separation_over_sigma", "separation_m"]].concat()
    }

    fn heads(&self) -> Vec<String> {
        let mut heads: Vec<String> = self.place_heads().into_iter().map(String::from).collect();
        let quantities = &self.request.quantities;
        let of = |q: &Quantity| q.column();
        let with = |ends: &'static [&'static str]| {
            quantities.iter().flat_map(move |q| {
                let ends = ends.iter().map(|end| column_beside(*q, end));
                [q.column()].into_iter().chain(ends).collect::<Vec<_>>()
            })
        };
        match self.beside {
            Beside::Nothing => heads.extend(quantities.iter().map(of)),
            Beside::Errors => {
                heads.extend(quantities.iter().map(of));
                heads.extend(quantities.iter().map(|q| column_beside(*q, "error")));
            }
            Beside::Deviations(_) => heads.extend(with(&["deviation"])),
            Beside::Intervals => {
                heads.extend(with(&ENDS));
                heads.extend(ENDS.map(|end| format!("separation_{end}_m")));
            }
        }
        heads
    }

    /// The cells of a line behind those of its place.
    fn row(&self, mut row: Vec<Cell>, line: &Line, beside: &Beside) -> Vec<Cell> {
        for value in &line.values {
            row.push(cell(value));
            if matches!(beside, Beside::Intervals) {
                row.extend([Cell::BLANK; 2]);
            }
        }
        match beside {
            Beside::Errors => {
                let values = line.values.iter().zip(&self.request.quantities);
                row.extend(values.map(|(v, q)| Cell::from(v.as_ref().ok().map(|v| v.bound(*q)))));
            }
            Beside::Intervals => row.extend([Cell::BLANK; 2]),
            _ => {}
        }
        row
    }

    /// Compares every model with the reference, all models of one place together.
    fn add_deviations(
        &self,
        reference: &NamedModel,
        sheet: &mut Sheet,
        found: &mut Found,
        watch: &dyn Watch,
    ) -> Result<(), AnswerError> {
        let mut lines = |model| -> Result<Vec<(Vec<Cell>, Line)>, AnswerError> {
            let mut lines = vec![];
            self.ask(model, found, sheet, watch, |_, place, line| lines.push((place, line)))?;
            Ok(lines)
        };
        let wanted = lines(reference)?;
        let mut answers = self
            .models
            .iter()
            .map(|model| Ok(lines(model)?.into_iter()))
            .collect::<Result<Vec<_>, AnswerError>>()?;
        found.answered = false;
        for (_, wanted) in &wanted {
            for (mut row, line) in answers.iter_mut().filter_map(Iterator::next) {
                let values = line.values.iter().zip(&wanted.values);
                for ((value, wanted), quantity) in values.zip(&self.request.quantities) {
                    let both = value.as_ref().ok().zip(wanted.as_ref().ok());
                    row.push(cell(value));
                    row.push(both.and_then(|(a, b)| a.deviation(b, *quantity)).into());
                }
                found.answered |= line.values.iter().any(Result::is_ok);
                sheet.rows.push(row);
            }
        }
        Ok(())
    }

    /// Passes on the lines of one model, each with the cells of its place.
    fn ask(
        &self,
        (id, model): &NamedModel,
        found: &mut Found,
        sheet: &mut Sheet,
        watch: &dyn Watch,
        mut deliver: impl FnMut(&mut Sheet, Vec<Cell>, Line),
    ) -> Result<Asked, AnswerError> {
        watch.progress(id);
        let corrected = matches!(self.beside, Beside::Intervals);
        let asked = Asked::new(self.file, model, &self.request, (self.all, corrected))?;
        let refusals = asked.refusals().into_iter();
        found.lacking.extend(refusals.map(|reason| (reason, id.clone())));
        // At default separations, findings are reported for one typical separation only.
        let usual = [At::from(2.0)];
        let [of_places, notes] =
            asked.findings(self.file, if self.at_defaults { &usual } else { &self.request.at });
        found.of_places.extend(of_places);
        sheet.extend(notes);
        let mut blanks = Blanks::new(model.validity().adhesive);
        for block in self.request.at.chunks(ROWS_AT_A_TIME) {
            let (lines, warnings) = asked.lines(self.file, block);
            for line in lines {
                found.answered |= line.values.iter().any(Result::is_ok);
                blanks.count(&self.request.quantities, &asked, &line.values);
                deliver(sheet, self.place(id, &line), line);
            }
            found.of_places.extend(warnings);
        }
        let tension = |at: &At| at.load(&self.file.scene).is_some_and(|load| load < 0.0);
        if self.request.at.iter().any(tension) && !model.validity().adhesive {
            found.without_tension.push(id.clone());
        }
        found.lacking.extend(blanks.texts(id).map(|text| (text, id.clone())));
        Ok(asked)
    }

    /// The cells of a line's place.
    pub(crate) fn place(&self, id: &str, line: &Line) -> Vec<Cell> {
        let loads = self.loads_at(line.given).chain(line.separation);
        [Cell::from(id)].into_iter().chain(loads.map(Cell::from)).collect()
    }

    /// Load and pressure, as far as the sheet has columns for them.
    pub(crate) fn loads_at(&self, at: At) -> impl Iterator<Item = Option<f64>> {
        let scene = &self.file.scene;
        let loads = self.place_heads().len() - 3;
        [at.load(scene), at.pressure(scene)].into_iter().take(loads)
    }
}

/// The ends of an interval.
pub(crate) const ENDS: [&str; 2] = ["lower", "upper"];

/// The name of a column beside that of a quantity: `mean_pressure_error`.
#[must_use]
pub fn column_beside(quantity: Quantity, what: &str) -> String {
    format!("{quantity}_{what}").replace('-', "_")
}

fn cell(value: &Result<Evaluation, ContactError>) -> Cell {
    match value {
        Ok(value) => Cell::Number(value.value()),
        Err(reason) => Cell::Blank(Some(reason.marked().into())),
    }
}

/// Findings about the answers of all models.
#[derive(Default)]
pub(crate) struct Found {
    /// Whether there is any value.
    answered: bool,
    /// What has no value with the reason, and the id of the model.
    pub(crate) lacking: Vec<(String, String)>,
    /// Ids of models without tension, where one is asked for.
    without_tension: Vec<String>,
    /// Findings of the places.
    of_places: Findings,
}

impl Found {
    /// Adds the findings to the sheet, one for each reason.
    fn report(&mut self, file: &SceneFile, sheet: &mut Sheet) {
        for (reason, ids) in grouped(self.lacking.drain(..)) {
            let found = Finding::warning("no-value", "", f64::NAN).fact(reason);
            sheet.findings.push(found.of_model(ids.join(", ")));
        }
        if !self.without_tension.is_empty() {
            let ids = once(&self.without_tension);
            let verb = if ids.len() == 1 { "carries" } else { "carry" };
            let text = format!("{} {verb} no tension; use {ADHESIVE}", ids.join(", "));
            sheet.warn("no-tension", text);
        }
        let of_places = file.accepted(std::mem::take(&mut self.of_places));
        sheet.extend(of_places.at_least(asperity::Severity::Warning));
    }
}

/// The models that carry tension.
const ADHESIVE: &str = "dmt, jkr or jkr-separation";
