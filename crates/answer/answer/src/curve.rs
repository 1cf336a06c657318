//! The rows of `curve`: models, quantities and places that are asked of a scene, and their columns.

use asperity::recommended::JKR;
use asperity::{
    At, Best, Code, ContactError, Datum, Described, Findings, Model, Quantity, Request, Separation,
    SeparationUnit,
};
use asperity_scene::SceneFile;

use crate::blanks::{Blanks, kind};
use crate::compiled::{Asked, Line};
use crate::models::{grouped, once, reason_alone};
use crate::sheet::warning;
use crate::{AnswerError, Cell, Sheet, Watch};

/// Rows evaluated at a time, which bounds the memory.
const ROWS_AT_A_TIME: usize = 8192;

/// What is asked of a scene.
#[derive(Debug, Clone)]
pub struct Inquiry<'s> {
    /// The scene.
    pub file: &'s SceneFile,
    /// The models, in the order of the rows.
    pub models: Vec<Model>,
    /// Quantities, separations or loads, tolerance.
    pub request: Request,
    /// The columns beside each quantity.
    pub beside: Beside,
    /// Whether every separation that carries a load has a row, instead of the largest alone.
    pub all: bool,
    /// Whether the separations are films, which have columns of their own.
    pub films: bool,
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
    Deviations(Model),
}

impl<'s> Inquiry<'s> {
    /// An inquiry without further columns.
    #[must_use]
    pub fn new(file: &'s SceneFile, models: Vec<Model>, request: Request) -> Self {
        let beside = Beside::Nothing;
        let (all, films, at_defaults) = (false, false, false);
        Self { file, models, request, beside, all, films, at_defaults }
    }

    /// Fills a sheet: model, load and pressure at loads, separation, and the quantities, with the
    /// ends of the intervals that `best` knows. Values that do not exist are blank; findings give
    /// the reasons.
    ///
    /// # Errors
    /// The reason why the scene refuses a model, and an error if all rows are blank; the sheet has
    /// the findings until then.
    pub fn answer(&self, sheet: &mut Sheet, watch: &dyn Watch) -> Result<(), AnswerError> {
        sheet.heads = self.heads();
        if self.has_intervals() {
            let quantities = self.request.quantities.iter().map(|quantity| quantity.column());
            sheet.with_ends = quantities.chain(["separation_m".into()]).collect();
        }
        let (mut found, mut wanted) = (Found::default(), vec![]);
        let reference = match &self.beside {
            Beside::Deviations(reference) => Some(reference),
            _ => None,
        };
        let models = self.models.iter().chain(reference);
        sheet.extend(self.file.accepted(self.file.other_joint(models).into_iter().collect()));
        let reference = reference.map(|model| self.prepare(model, watch)).transpose()?;
        if let Some(reference) = &reference {
            self.ask(reference, &mut found, sheet, |_, _, line| wanted.push(line));
            found.answered = false;
        }
        for model in &self.models {
            let first = sheet.rows.len();
            let own;
            let asked = match &reference {
                Some(reference) if reference.model().id() == model.id() => reference,
                _ => {
                    own = self.prepare(model, watch)?;
                    &own
                }
            };
            self.ask(asked, &mut found, sheet, |sheet, place, line| {
                let wanted = wanted.get(sheet.rows.len() - first);
                sheet.rows.push(self.row(place, &line, wanted));
            });
        }
        // All models of one place together.
        let places = wanted.len();
        if places > 0 {
            let rows = (0..sheet.rows.len()).map(|k| {
                let (place, model) = (k / self.models.len(), k % self.models.len());
                std::mem::take(&mut sheet.rows[model * places + place])
            });
            sheet.rows = rows.collect();
        }
        found.report(self.file, sheet);
        if found.answered { Ok(()) } else { Err("no row has a value".into()) }
    }

    /// Whether the bodies are curved: rows have a load or an approach.
    fn is_of_bodies(&self) -> bool {
        self.file.shape().is_some()
    }

    /// The columns for the model and for the load or separation.
    fn place_heads(&self) -> Vec<&'static str> {
        if self.is_of_bodies() {
            let at_loads = matches!(self.request.at.first(), Some(At::Load(_)));
            return if at_loads { vec!["model", "load_N"] } else { vec!["model", "approach_m"] };
        }
        let loads = match self.request.at.first() {
            None | Some(At::Separation(_)) => &[][..],
            // As a quantity, the pressure has that column.
            _ if self.request.quantities.contains(&Quantity::Pressure) => &["load_N"],
            _ => &["load_N", "pressure_Pa"],
        };
        let films: &[&str] = if self.films { &FILMS } else { &[] };
        [&["model"], loads, films, &["separation_over_sigma", "separation_m"]].concat()
    }

    fn heads(&self) -> Vec<String> {
        let mut heads: Vec<String> = self.place_heads().into_iter().map(String::from).collect();
        let quantities = &self.request.quantities;
        for quantity in quantities {
            heads.push(quantity.column());
            if matches!(self.beside, Beside::Deviations(_)) {
                heads.push(column_beside(*quantity, "deviation"));
            }
        }
        if matches!(self.beside, Beside::Errors) {
            heads.extend(quantities.iter().map(|q| column_beside(*q, "error")));
        }
        heads
    }

    /// Whether one of the models knows intervals.
    fn has_intervals(&self) -> bool {
        !self.is_of_bodies() && self.models.iter().any(|model| model.id() == Best::<Model>::ID)
    }

    /// A row with the cells of its place; `wanted` has the values of the reference.
    fn row(&self, mut row: Vec<Cell>, line: &Line, wanted: Option<&Line>) -> Vec<Cell> {
        let quantities = &self.request.quantities;
        for (k, (value, &quantity)) in line.values.iter().zip(quantities).enumerate() {
            row.push(match (value, &line.intervals[k]) {
                (Ok(value), Some(of)) => {
                    Cell::Between(value.value(), [of.lower, of.upper].map(Some))
                }
                (Ok(value), None) => value.value().into(),
                (Err(reason), _) => Cell::Blank(Some(reason.clone().into())),
            });
            if let Some(wanted) = wanted {
                let both = value.as_ref().ok().zip(wanted.values[k].as_ref().ok());
                row.push(both.and_then(|(a, b)| a.deviation(b, quantity)).into());
            }
        }
        if matches!(self.beside, Beside::Errors) {
            let values = line.values.iter().zip(quantities);
            row.extend(values.map(|(v, q)| Cell::from(v.as_ref().ok().map(|v| v.bound(*q)))));
        }
        row
    }

    /// Compiles a model for what is asked.
    fn prepare(&self, model: &Model, watch: &dyn Watch) -> Result<Asked, AnswerError> {
        watch.progress(model.id());
        Asked::new(self.file, model, &self.request, self.all)
    }

    /// Passes on the lines of one model, each with the cells of its place.
    fn ask(
        &self,
        asked: &Asked,
        found: &mut Found,
        sheet: &mut Sheet,
        mut deliver: impl FnMut(&mut Sheet, Vec<Cell>, Line),
    ) {
        let (model, id) = (asked.model(), asked.model().id());
        found.lacking.extend(asked.refusals().into_iter().map(|reason| (reason, id.into())));
        // At default separations, findings are reported for one typical separation only.
        let usual = [At::from(2.0)];
        let [of_places, notes] =
            asked.findings(self.file, if self.at_defaults { &usual } else { &self.request.at });
        found.of_places.extend(of_places);
        sheet.extend(notes);
        let adhesive = model.validity().adhesive;
        let is_new = |reason: &&ContactError| match reason {
            // Without contact there is a finding already.
            ContactError::NoValue { .. } => false,
            // Likewise of a tension without adhesion.
            ContactError::OutOfRange { field: "load" | "pressure", value, .. } => {
                adhesive || *value >= 0.0
            }
            _ => true,
        };
        let (mut blanks, mut rows) = (Blanks::default(), 0);
        for block in self.request.at.chunks(ROWS_AT_A_TIME) {
            let (lines, warnings) = asked.lines(self.file, block);
            for line in lines {
                let answered = line.values.iter().any(Result::is_ok);
                found.answered |= answered;
                rows += 1;
                // The first blank of a row that no other finding reports.
                let had = self.request.quantities.iter().zip(&line.values);
                let mut had = had.filter(|(quantity, _)| asked.has(**quantity));
                let failed = had.find_map(|(quantity, value)| {
                    Some((quantity, value.as_ref().err().filter(is_new)?))
                });
                if let Some((quantity, reason)) = failed {
                    let what = if answered { quantity.to_string() } else { "value".into() };
                    let opens =
                        |e| matches!(e, &ContactError::OutOfReach { load, .. } if load < 0.0);
                    let opening = if id == JKR && opens(reason) { OPENING } else { "" };
                    blanks.count(&what, kind(reason), reason_alone(model.id(), reason) + opening);
                }
                // Other models say so where they have none at all.
                if let Err(reason) = &line.separation[1]
                    && answered
                    && id == Best::<Model>::ID
                {
                    blanks.count("separation", kind(reason), reason_alone(model.id(), reason));
                }
                deliver(sheet, self.place(id, &line), line);
            }
            found.of_places.extend(warnings);
        }
        let tension = |at: &At| at.load(&self.file.scene).is_some_and(|load| load < 0.0);
        if self.request.at.iter().any(tension) && !adhesive {
            found.without_tension.push(id.into());
        }
        found.lacking.extend(blanks.texts(rows).map(|text| (text, id.into())));
    }

    /// The cells of a line's place.
    fn place(&self, id: &str, line: &Line) -> Vec<Cell> {
        if self.is_of_bodies() {
            // Approaches count from the mean of the asperities, whatever the plane of the scene.
            let metres = |s: Separation| {
                s.measured_in(SeparationUnit::Metres, Datum::AsperityMean, &self.file.scene)
            };
            let place = match line.given {
                At::Load(load) => Some(load),
                At::Separation(s) => metres(s).ok().map(|s| -s.value),
                _ => None,
            };
            return vec![Cell::from(id), place.into()];
        }
        let films = if self.films { &line.film[..] } else { &[] };
        let [sigma, metres] = line.separation.each_ref().map(|at| at.as_ref().ok().copied());
        let metres = match (metres, line.between) {
            (Some(metres), Some(ends)) => Cell::Between(metres, ends.map(Some)),
            (Some(metres), None) => metres.into(),
            (None, _) => Cell::Blank(line.separation[1].clone().err().map(Into::into)),
        };
        let places = self.loads_at(line.given).chain(films.iter().copied()).chain([sigma]);
        let places = places.map(Cell::from).chain([metres]);
        [Cell::from(id)].into_iter().chain(places).collect()
    }

    /// Load and pressure, as far as the sheet has columns for them.
    fn loads_at(&self, at: At) -> impl Iterator<Item = Option<f64>> {
        let scene = &self.file.scene;
        let films = if self.films { FILMS.len() } else { 0 };
        let loads = self.place_heads().len() - 3 - films;
        [at.load(scene), at.pressure(scene)].into_iter().take(loads)
    }
}

/// The film and its ratio to the standard deviation of the surface heights.
const FILMS: [&str; 2] = ["film_m", "lambda"];

/// The name of a column beside a quantity: `mean_pressure_error`.
#[must_use]
pub(crate) fn column_beside(quantity: Quantity, what: &str) -> String {
    format!("{quantity}_{what}").replace('-', "_")
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
            sheet.findings.push(warning(Code::NoValue, reason).of_model(ids.join(", ")));
        }
        if !self.without_tension.is_empty() {
            let ids = once(&self.without_tension);
            let verb = if ids.len() == 1 { "carries" } else { "carry" };
            let text = format!("{} {verb} no tension; use {ADHESIVE}", ids.join(", "));
            sheet.warn(Code::NoTension, text);
        }
        let of_places = file.accepted(std::mem::take(&mut self.of_places));
        sheet.extend(of_places.at_least(asperity::Severity::Warning));
    }
}

/// Names the model of opening where jkr pulls off.
pub const OPENING: &str = "; jkr-separation, which describes opening, may carry more";
/// The models that carry tension.
pub const ADHESIVE: &str = "dmt, jkr or jkr-separation";
