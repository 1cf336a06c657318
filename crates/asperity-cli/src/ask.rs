//! Asks models of a scene, row by row; what deserves a word is said once.

use std::mem::discriminant;

use anyhow::{Context, Result, bail};
use asperity::{
    At, Contact, ContactError, ContactModel, Evaluation, Finding, Model, Quantity, Request,
    Separation, SeparationUnit, Severity, Warning, Warnings,
};

use crate::output::table::{Cell, Table};
use crate::output::{once, progress, say};
use crate::scene::{LoadedScene, NamedModel, tell};

/// Rows that are asked for at a time.
const TOGETHER: usize = 8192;

/// A question to the models of a scene.
pub struct Question<'s> {
    scene: &'s LoadedScene,
    pub request: Request,
    /// Every separation that carries a load is a row, and not the largest alone.
    pub all: bool,
    /// The places are those where nothing was asked for.
    pub unasked: bool,
    words: Vec<String>,
    /// What is unusual about the answers of each model.
    findings: Vec<(String, Finding)>,
}

/// One row of a model's answer.
pub struct Row {
    /// The cells under [`Question::head`].
    pub place: Vec<Cell>,
    /// One for each quantity; `None` where there is no value.
    pub values: Vec<Option<Evaluation>>,
}

impl<'s> Question<'s> {
    pub fn new(scene: &'s LoadedScene, request: Request) -> Self {
        Self { scene, request, all: false, unasked: false, words: vec![], findings: vec![] }
    }

    /// Names of the columns that say which model is asked, and where.
    pub fn head(&self) -> Table {
        let loads = match self.request.at.first() {
            None | Some(At::Separation(_)) => &[][..],
            // As a quantity, the pressure has that column.
            _ if self.request.quantities.contains(&Quantity::Pressure) => &["load_N"],
            _ => &["load_N", "pressure_Pa"],
        };
        Table::new(&[&["model"], loads, &["separation_over_sigma", "separation_m"]].concat())
    }

    /// Delivers the rows of one model: the cells under [`head`](Self::head), and one value for each
    /// quantity, `None` where there is none.
    pub fn ask(&mut self, (id, model): &NamedModel, mut deliver: impl FnMut(Row)) -> Result<()> {
        let _progress = progress(id);
        let (scene, from) = (&self.scene.file.scene, self.scene.file.separation_from);
        // Of places that nobody chose, a usual one has to do.
        let usual = [At::from(2.0)];
        let chosen = if self.unasked { &usual[..] } else { &self.request.at };
        let found = self.scene.file.findings_at(model, chosen);
        let found = found.into_iter().filter(|finding| finding.severity < Severity::Note);
        let crowded = found.clone().any(|finding| finding.code == "crowded");
        self.findings.extend(found.map(|finding| (id.clone(), finding)));
        let adhesive = model.validity().adhesive;
        let compiled = self.compile(id, model);
        let (contact, had) = compiled.with_context(|| format!("{}: {id}", self.scene.name))?;
        let (asked, model) = (model, Cell::from(id.as_str()));
        let loads = self.head().head.len() - 3;
        let (mut rows, mut warnings, mut reasons) = (0, Warnings::default(), vec![]);
        for block in self.request.at.chunks(TOGETHER) {
            // What was given, and where that is.
            let places: Vec<(At, At)> =
                block.iter().flat_map(|at| self.places(&*contact, *at)).collect();
            let request = Request::new(had.iter().copied()).within(self.request.tolerance);
            let response = contact.respond(&request.at(places.iter().map(|place| place.1)));
            rows += places.len();
            for (k, (given, at)) in places.into_iter().enumerate() {
                let values = || response.columns.iter().map(|column| column.rows[k].as_ref());
                // That nothing touches is among the warnings.
                let is_new = |e: &&Box<_>| match &***e {
                    ContactError::NoValue { .. } => false,
                    // Nor that there are no tensions without adhesion.
                    ContactError::OutOfRange { field: "load" | "pressure", value, .. } => {
                        adhesive || *value >= 0.0
                    }
                    _ => true,
                };
                if let Some(reason) = values().filter_map(Result::err).find(is_new) {
                    count(&mut reasons, reason);
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
            warnings.append(response.warnings);
        }
        let tension = |at: &At| at.load(scene).is_some_and(|load| load < 0.0);
        if self.request.at.iter().any(tension) && !adhesive {
            self.words.push(format!("{id} holds no tensions: dmt, jkr and jkr-separation do"));
        }
        let (small, warnings): (Vec<_>, Vec<_>) =
            warnings.into_vec().into_iter().partition(|w| matches!(w, Warning::Underflow { .. }));
        let touching = |at| {
            let counted = Request::new([Quantity::Contacts]);
            let contact = asked.compile(scene, &counted)?;
            Ok(contact.evaluate(Quantity::Contacts, contact.separation(at)?)?.value())
        };
        self.words.extend(underflown(&small, touching));
        let warnings = warnings.into_iter();
        // That is what the findings say.
        let new =
            |warning: &Warning| !(crowded && matches!(warning, Warning::AreaAboveNominal { .. }));
        self.words.extend(warnings.filter(new).map(|warning| warning.to_string()));
        self.words.extend(reasons.into_iter().map(|(count, reason)| {
            let hint = match reason {
                ContactError::OutOfReach { load, .. } if load < 0.0 && id == "jkr" => {
                    ": jkr-separation follows surfaces as they part, and may hold more"
                }
                _ => "",
            };
            match rows {
                1 => format!("{id}: {reason}{hint}"),
                _ => format!(
                    "{id}: no value in {count} of {rows} rows, in the first because {reason}{hint}"
                ),
            }
        }));
        Ok(())
    }

    /// The model's contact, with those of the quantities that it gives: the others are blank, and why
    /// is said.
    fn compile(
        &mut self,
        id: &str,
        model: &Model,
    ) -> Result<(Box<dyn Contact>, Vec<Quantity>), ContactError> {
        let scene = &self.scene.file.scene;
        let whole = match model.compile(scene, &self.request) {
            Ok(contact) => return Ok((contact, self.request.quantities.clone())),
            Err(whole) => whole,
        };
        let of = |quantities: &[Quantity]| {
            let request = Request::new(quantities.iter().copied()).within(self.request.tolerance);
            model.compile(scene, &request.at(self.request.at.iter().copied()))
        };
        let mut given = vec![];
        // What is refused for the same reason is told at once.
        let mut refused: Vec<(String, Vec<String>)> = vec![];
        for quantity in &self.request.quantities {
            match of(&[*quantity]) {
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
        // Without any, its places are still told.
        let contact = of(if given.is_empty() { &[Quantity::Force] } else { &given });
        let contact = contact.map_err(|_| whole)?;
        let told = |(reason, names): (String, Vec<String>)| {
            format!("{id}: no {}: {reason}", names.join(", "))
        };
        self.words.extend(refused.into_iter().map(told));
        Ok((contact, given))
    }

    /// A place as given, and where that is: everywhere that a load is carried, if all is asked.
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

    /// Every model's answer in one table, with bounds on the errors if they are asked for.
    pub fn table(&mut self, models: &[NamedModel], errors: bool) -> Result<Table> {
        let quantities = self.request.quantities.clone();
        let (mut table, mut answered) = (self.head(), false);
        table.head.extend(quantities.iter().map(|quantity| quantity.column()));
        let bounded = if errors { &quantities[..] } else { &[] };
        table.head.extend(bounded.iter().map(|quantity| named(*quantity, "error")));
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

    /// Says what deserves a word; that nothing at all was answered is an error.
    pub fn finish(&self, answered: bool) -> Result<()> {
        once(&self.words).iter().for_each(|text| say("warning", text));
        tell(&self.findings);
        if !answered {
            bail!("{}: no row has a value", self.scene.name);
        }
        Ok(())
    }
}

/// What quantities of a model deserve that read 0: what all of them mean, once.
fn underflown(
    warnings: &[Warning],
    touching: impl FnOnce(At) -> Result<f64, ContactError>,
) -> Option<String> {
    let mut told = vec![];
    let mut first = None::<(&str, At, usize)>;
    for warning in warnings {
        let Warning::Underflow { model, quantity, count, at, ln_value } = warning else { continue };
        told.push(format!("{quantity} (natural logarithm {ln_value:.6})"));
        // Of several, the one that does so in most rows.
        if first.is_none_or(|(.., most)| *count > most) {
            first = Some((model, *at, *count));
        }
    }
    let (model, at, count) = first?;
    let rows = if count == 1 { "row" } else { "rows" };
    let few = match touching(at) {
        Ok(few) if few < 1.0 => "; fewer than one asperity touches on average",
        _ => "",
    };
    Some(format!(
        "{model}: too small for a double in {count} {rows}, first at {at}, and reads 0 there: {}{few}",
        told.join(", ")
    ))
}

/// Counts why rows have no value, each kind of reason once.
fn count(kinds: &mut Vec<(usize, ContactError)>, reason: &ContactError) {
    match kinds.iter_mut().find(|(_, known)| discriminant(known) == discriminant(reason)) {
        Some((count, _)) => *count += 1,
        None => kinds.push((1, reason.clone())),
    }
}

/// The name of a column that says something about a quantity: `mean_pressure_error`.
pub fn named(quantity: Quantity, what: &str) -> String {
    format!("{quantity}_{what}").replace('-', "_")
}
