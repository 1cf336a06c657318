//! Evaluates models on a scene, row by row; each warning is printed once.

mod corrected;

use std::mem::{Discriminant, discriminant};

use anyhow::{Context, Result, bail};
use asperity::{
    At, Contact, ContactError, ContactModel, Evaluation, Findings, Model, Quantity, Request,
    Separation, SeparationUnit, Severity,
};

use crate::output::table::{Cell, Table};
use crate::output::{once, print_message, progress, report};
use crate::scene::{LoadedScene, NamedModel};

/// Rows evaluated at a time, which bounds the memory.
const ROWS_AT_A_TIME: usize = 8192;

/// A request to the models of a scene.
pub struct Question<'s> {
    scene: &'s LoadedScene,
    pub request: Request,
    /// Whether every separation that carries a load gets a row, instead of only the largest.
    pub all: bool,
    /// Whether the separations are the defaults of the command.
    pub at_defaults: bool,
    /// Ids of models without tension, where one is asked for.
    without_tension: Vec<String>,
    /// Ids of models, and what has no value there with the reason.
    lacking: Vec<(String, String)>,
    /// Findings of the results.
    found: Findings,
}

/// One row of a model's result.
pub struct Row {
    /// The cells under [`Question::head`].
    pub place: Vec<Cell>,
    /// One for each quantity; `None` where there is no value.
    pub values: Vec<Option<Evaluation>>,
}

impl<'s> Question<'s> {
    pub fn new(scene: &'s LoadedScene, request: Request) -> Self {
        Self {
            scene,
            request,
            all: false,
            at_defaults: false,
            without_tension: vec![],
            lacking: vec![],
            found: Findings::default(),
        }
    }

    /// The columns for the model and for the load or separation.
    pub fn head(&self) -> Table {
        let loads = match self.request.at.first() {
            None | Some(At::Separation(_)) => &[][..],
            // As a quantity, the pressure has that column.
            _ if self.request.quantities.contains(&Quantity::Pressure) => &["load_N"],
            _ => &["load_N", "pressure_Pa"],
        };
        Table::new(&[&["model"], loads, &["separation_over_sigma", "separation_m"]].concat())
    }

    /// Passes on the rows of one model: the cells under [`head`](Self::head) and one value per
    /// quantity, `None` if it has no value.
    pub fn ask(&mut self, (id, model): &NamedModel, mut deliver: impl FnMut(Row)) -> Result<()> {
        let _progress = progress(id);
        let (scene, from) = (&self.scene.file.scene, self.scene.file.separation_from);
        let adhesive = model.validity().adhesive;
        let compiled = self.compile(id, model);
        let (contact, had) = compiled.with_context(|| self.scene.name.clone())?;
        // At default separations, findings are reported for one typical separation only.
        let usual = [At::from(2.0)];
        let chosen = if self.at_defaults { &usual[..] } else { &self.request.at };
        self.found.extend(self.scene.file.findings_of(model, &*contact, chosen));
        if !model.validity().asperities {
            // How the scan is continued, for example.
            let notes = contact.notes().iter().filter(|note| note.severity == Severity::Note);
            report(&self.scene.file.accepted(notes.cloned().collect()));
        }
        let model = Cell::from(id.as_str());
        let loads = self.head().head.len() - 3;
        let (mut rows, mut reasons) = (0, vec![]);
        for block in self.request.at.chunks(ROWS_AT_A_TIME) {
            // As given, and as evaluated.
            let places: Vec<(At, At)> =
                block.iter().flat_map(|at| self.places(&*contact, *at)).collect();
            let request = Request::new(had.iter().copied()).within(self.request.tolerance);
            let response = contact.respond(&request.at(places.iter().map(|place| place.1)));
            rows += places.len();
            for (k, (given, at)) in places.into_iter().enumerate() {
                let values = || response.columns.iter().map(|column| column.rows[k].as_ref());
                // A warning already reports the absence of contact.
                let is_new = |e: &&Box<_>| match &***e {
                    ContactError::NoValue { .. } => false,
                    // A warning already reports a tension without adhesion.
                    ContactError::OutOfRange { field: "load" | "pressure", value, .. } => {
                        adhesive || *value >= 0.0
                    }
                    _ => true,
                };
                let mut failed = had.iter().zip(values()).filter_map(|(q, v)| Some((*q, v.err()?)));
                if let Some((quantity, reason)) = failed.find(|(_, e)| is_new(e)) {
                    // Other quantities of the row may have a value.
                    let partly = values().any(|value| value.is_ok()).then_some(quantity);
                    count(&mut reasons, (partly, &**reason));
                }
                let separation = contact.separation(at);
                let length = |unit| {
                    Some(separation.as_ref().ok()?.measured_in(unit, from, scene).ok()?.value)
                };
                let lengths = [SeparationUnit::Sigma, SeparationUnit::Metres].map(length);
                let given = [given.load(scene), given.pressure(scene)];
                let mut place = vec![model.clone()];
                place.extend(given.into_iter().take(loads).chain(lengths).map(Cell::Number));
                let values: Vec<_> = values().map(|value| value.ok().copied()).collect();
                let of = |q: &Quantity| *values.get(had.iter().position(|h| h == q)?)?;
                deliver(Row { place, values: self.request.quantities.iter().map(of).collect() });
            }
            self.found.extend(response.warnings);
        }
        let tension = |at: &At| at.load(scene).is_some_and(|load| load < 0.0);
        if self.request.at.iter().any(tension) && !adhesive {
            self.without_tension.push(id.clone());
        }
        self.lacking.extend(reasons.into_iter().map(|(count, (partly, reason))| {
            let hint = match reason {
                ContactError::OutOfReach { load, .. } if load < 0.0 && id == "jkr" => {
                    "; jkr-separation, which describes opening, may carry more"
                }
                _ => "",
            };
            let text = match rows {
                1 => format!("{reason}{hint}"),
                _ => {
                    let what = partly.map_or("value".into(), |quantity| quantity.to_string());
                    format!("no {what} in {count} of {rows} rows, first: {reason}{hint}")
                }
            };
            (id.clone(), text)
        }));
        Ok(())
    }

    /// The model's contact and the quantities that the model has; the others are blank, with a
    /// warning.
    fn compile(
        &mut self,
        id: &str,
        model: &Model,
    ) -> Result<(Box<dyn Contact>, Vec<Quantity>), ContactError> {
        let whole = match self.contact(model, &self.request) {
            Ok(contact) => return Ok((contact, self.request.quantities.clone())),
            Err(whole) => whole,
        };
        let compile = |quantities: &[Quantity]| {
            let request = Request::new(quantities.iter().copied()).within(self.request.tolerance);
            self.contact(model, &request.at(self.request.at.iter().copied()))
        };
        let mut given = vec![];
        // One message for all quantities with the same reason.
        let mut refused: Vec<(String, Vec<String>)> = vec![];
        for quantity in &self.request.quantities {
            match compile(&[*quantity]) {
                Ok(_) => given.push(*quantity),
                Err(reason) => {
                    let (reason, name) = (reason.to_string(), quantity.to_string());
                    match refused.iter_mut().find(|(known, _)| *known == reason) {
                        Some((_, names)) => names.push(name),
                        None => refused.push((reason, vec![name])),
                    }
                }
            }
        }
        // Without any quantity, the separations are still in the table.
        let contact = compile(if given.is_empty() { &[Quantity::Force] } else { &given });
        let contact = contact.map_err(|_| whole)?;
        let message = |(reason, names): (String, Vec<String>)| {
            (id.to_string(), format!("no {}: {reason}", names.join(", ")))
        };
        self.lacking.extend(refused.into_iter().map(message));
        Ok((contact, given))
    }

    /// The contact for this request, with what it is judged by: where each load has one row, few
    /// loads need no tables.
    fn contact(&self, model: &Model, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let mut request = request.clone();
        // The law of an area that is not asked for is made for it: of inclined contacts, it takes
        // longer than to judge without tables. Boundary elements count no contacts.
        let (asperities, angles) = (model.validity().asperities, model.validity().angles);
        let free = |q: &Quantity| asperities && (*q != Quantity::Area || !angles);
        request.quantities.extend(Quantity::JUDGED.into_iter().filter(free));
        let scene = &self.scene.file.scene;
        if self.all { model.compile(scene, &request) } else { model.contact(scene, &request) }
    }

    /// A load or separation as given and as evaluated; with `all`, each separation of a load.
    fn places(&self, contact: &dyn Contact, at: At) -> Vec<(At, At)> {
        let (scene, from) = (contact.scene(), self.scene.file.separation_from);
        let counted = |s: Separation| s.measured_in(SeparationUnit::Sigma, from, scene);
        let load = at.load(scene).filter(|_| self.all);
        match load.map(|load| contact.separations_at(load)) {
            Some(Ok(found)) => {
                found.into_iter().map(|s| (at, counted(s).unwrap_or(s).into())).collect()
            }
            _ => vec![(at, at)],
        }
    }

    /// The results of all models in one table, with error bounds on request.
    pub fn table(&mut self, models: &[NamedModel], errors: bool) -> Result<Table> {
        let quantities = self.request.quantities.clone();
        let (mut table, mut answered) = (self.head(), false);
        table.head.extend(quantities.iter().map(|quantity| quantity.column()));
        let bounded = if errors { &quantities[..] } else { &[] };
        table.head.extend(bounded.iter().map(|quantity| column_beside(*quantity, "error")));
        for model in models {
            self.ask(model, |Row { mut place, values }| {
                answered |= values.iter().any(Option::is_some);
                place.reserve_exact(values.len() + bounded.len());
                place.extend(values.iter().map(|v| Cell::Number(v.map(|v| v.value()))));
                let bounds = values.iter().zip(bounded).map(|(v, q)| Some((*v)?.bound(*q)));
                place.extend(bounds.map(Cell::Number));
                table.rows.push(place);
            })?;
        }
        self.finish(answered)?;
        Ok(table)
    }

    /// Prints the warnings; an error if there is no value at all.
    pub fn finish(&self, answered: bool) -> Result<()> {
        let mut lacking: Vec<(&str, Vec<&str>)> = vec![];
        for (id, reason) in &self.lacking {
            match lacking.iter_mut().find(|(known, _)| known == reason) {
                Some((_, ids)) if ids.contains(&id.as_str()) => {}
                Some((_, ids)) => ids.push(id),
                None => lacking.push((reason, vec![id])),
            }
        }
        for (reason, ids) in lacking {
            print_message("warning", &format!("{}: {reason}", ids.join(", ")));
        }
        if !self.without_tension.is_empty() {
            let ids = once(&self.without_tension);
            let verb = if ids.len() == 1 { "carries" } else { "carry" };
            let text =
                format!("{} {verb} no tension; use dmt, jkr or jkr-separation", ids.join(", "));
            print_message("warning", &text);
        }
        self.scene.report(self.found.clone());
        if !answered {
            bail!("{}: no row has a value", self.scene.name);
        }
        Ok(())
    }
}

/// A quantity without a value in a row with other values, and the reason.
type Lacking<E> = (Option<Quantity>, E);

/// Counts the reasons for missing values, each kind once; refusals are alike up to their numbers.
fn count(
    kinds: &mut Vec<(usize, Lacking<ContactError>)>,
    (partly, reason): Lacking<&ContactError>,
) {
    let same = |known: &Lacking<ContactError>| known.0 == partly && kind(&known.1) == kind(reason);
    match kinds.iter_mut().find(|(_, known)| same(known)) {
        Some((count, _)) => *count += 1,
        None => kinds.push((1, (partly, reason.clone()))),
    }
}

fn kind(reason: &ContactError) -> (Discriminant<ContactError>, &str) {
    let words = match reason {
        ContactError::Refused { reason, .. } => reason.split(|c: char| c.is_ascii_digit()).next(),
        _ => None,
    };
    (discriminant(reason), words.unwrap_or_default())
}

/// The name of a column beside that of a quantity: `mean_pressure_error`.
pub fn column_beside(quantity: Quantity, what: &str) -> String {
    format!("{quantity}_{what}").replace('-', "_")
}
