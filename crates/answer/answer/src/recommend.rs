//! The model nearest to boundary elements, or the simplest valid one near a reference, and how far
//! each is.

use asperity::{
    Asperities, At, Code, Compared, Comparison, Model, Quantity, Recommendation, Request, Tolerance,
};
use asperity_scene::SceneFile;

use crate::inquiry::column_beside;
use crate::models::{by_reason, models, one_model};
use crate::{AnswerError, Cell, Sheet};

/// What the sheet of a recommendation is about.
#[derive(Debug, Clone)]
pub struct Recommend<'a> {
    /// Names of models, or none for all that can be compared with boundary elements.
    pub models: &'a [String],
    /// The name of the reference, if it is not the usual one.
    pub reference: Option<&'a str>,
    /// The largest deviation from the reference.
    pub within: f64,
    /// Quantities, separations or loads, tolerance.
    pub request: Request,
    /// Whether nobody has chosen the separations: findings are about a typical one then.
    pub at_defaults: bool,
}

/// The largest deviation from the reference unless another is given.
const WITHIN: f64 = 0.05;
/// The tolerance of compared values unless another is given.
const TOLERANCE: f64 = 1e-4;

/// The compared quantities of a row, and the names of their columns.
const OFF: [(Compared, &str); 3] = [
    (Compared::Area, "area_off_bem"),
    (Compared::Stiffness, "stiffness_off_bem"),
    (Compared::UnloadingStiffness, "unloading_stiffness_off_bem"),
];

impl Recommend<'_> {
    /// Refuses what is compared on no scene.
    ///
    /// # Errors
    /// A force at loads alone, and boundary elements among the models.
    pub fn check(&self) -> Result<(), AnswerError> {
        let request = &self.request;
        let given = |at: &At| !matches!(at, At::Separation(_));
        if request.quantities.contains(&Quantity::Force) && request.at.iter().all(given) {
            return Err("force is given at a load; compare area, tangent or others".into());
        }
        let mut ids = self.models.iter().map(String::as_str).chain(self.reference);
        if ids.any(|id| id == asperity::bem::Bem::ID) {
            return Err("bem: models are compared with boundary elements; name others".into());
        }
        Ok(())
    }

    /// What `asperity recommend` asks at loads by default: all models, in the area.
    #[must_use]
    pub fn at(loads: impl IntoIterator<Item = At>) -> Self {
        let request = Request::new([Quantity::Area])
            .at(loads)
            .within(Tolerance::new(TOLERANCE).unwrap_or_default());
        Self { models: &[], reference: None, within: WITHIN, request, at_defaults: false }
    }

    /// Fills a sheet with a row for each model, from simplest to most complex, and returns what it
    /// shows; the verdict and the evidence are findings.
    ///
    /// # Errors
    /// The errors of [`check`](Self::check), of the reference, and of the models named.
    pub fn answer(
        &self,
        file: &SceneFile,
        sheet: &mut Sheet,
    ) -> Result<Recommendation, AnswerError> {
        self.check()?;
        let reference = one_model(file, self.reference)?;
        // Persson's theory has evidence, too.
        let allowed = SceneFile::models_beside_bem;
        let models = models(file, self.models, allowed, &self.request.quantities, sheet)?;
        self.answer_of(file, models, reference, sheet)
    }

    /// Fills a sheet likewise, for models and a reference that are not named by ids.
    ///
    /// # Errors
    /// The errors of the reference, and of the models that are compared with it.
    pub fn answer_of(
        &self,
        file: &SceneFile,
        models: Vec<Model>,
        reference: Model,
        sheet: &mut Sheet,
    ) -> Result<Recommendation, AnswerError> {
        let Self { request, within, .. } = self;
        let other = file.other_joint(models.iter().chain([&reference]));
        sheet.extend(file.accepted(other.into_iter().collect()));
        let advice =
            file.recommend_among(models, request, &reference, *within).map_err(|error| {
                AnswerError::from(error).of_model(&format!("the reference {reference}"))
            })?;

        let unloading = advice.compared.contains(&Compared::UnloadingStiffness);
        let off = if unloading { &OFF[..] } else { &OFF[..2] };
        sheet.heads = ["model", "asperities"].map(String::from).into();
        sheet.heads.extend(request.quantities.iter().map(|q| column_beside(*q, "deviation")));
        sheet.heads.push("simplest".into());
        sheet
            .heads
            .extend(off.iter().flat_map(|(_, name)| [(*name).into(), format!("{name}_spread")]));
        let mut lacking = vec![];
        for found in &advice.comparisons {
            sheet.rows.push(row(found, &advice, &request.quantities, off));
            let lacks = found.lacking.iter().map(|(_, error)| error);
            let whole = found.deviations.as_ref().err().filter(|_| found.lacking.is_empty());
            let id = found.model.id();
            lacking.extend(lacks.chain(whole).map(|error| (id, error)));
        }
        for text in by_reason(lacking) {
            sheet.note(Code::NoValue, format!("no value: {text}"));
        }
        self.report(file, &advice, sheet);
        Ok(advice)
    }

    /// Adds the findings about the models and the evidence.
    fn report(&self, file: &SceneFile, advice: &Recommendation, sheet: &mut Sheet) {
        let places = match self.at_defaults {
            true => vec![At::from(2.0)],
            false => self.request.at.clone(),
        };
        let is_named = |found: &&Comparison| {
            found.outside.is_some() || advice.nearest.iter().any(|(id, _)| id == found.model.id())
        };
        let outside = advice.comparisons.iter().filter(is_named);
        let checked = [&advice.reference].into_iter().chain(&advice.simplest);
        let mut models: Vec<&Model> = vec![];
        for model in checked.chain(outside.map(|found| &found.model)) {
            if models.iter().all(|known| known.id() != model.id()) {
                models.push(model);
            }
        }
        let found = models.iter().flat_map(|model| file.findings_at(*model, &places));
        sheet.report(file, found.collect());
        sheet.result(advice.verdict());
        if self.reference.is_some() {
            sheet.result(advice.simplest_sentence());
        }
        let (compared, all) = (advice.evidence.len(), places.len());
        if compared < all {
            sheet.result(format!("there is evidence for {compared} of {all} separations or loads"));
        }
        let evidence = [advice.summary(), advice.expectations()].concat();
        evidence.into_iter().for_each(|text| sheet.result(text));
    }
}

/// The row of a model.
fn row(
    found: &Comparison,
    advice: &Recommendation,
    quantities: &[Quantity],
    off: &[(Compared, &str)],
) -> Vec<Cell> {
    let validity = found.model.validity();
    let asperities = match (validity.asperities, validity.angles) {
        (false, _) => "none",
        (true, true) => "at angles",
        (true, false) => match found.model.asperities() {
            Asperities::Random => "random",
            Asperities::Pairs => "pairs",
            _ => "upright",
        },
    };
    let mut row = vec![found.model.id().into(), asperities.into()];
    let known = |quantity: &Quantity| {
        let mut known = found.deviations.iter().flatten();
        known.find(|(known, _)| known == quantity).map(|(_, deviation)| *deviation)
    };
    row.extend(quantities.iter().map(|q| Cell::from(known(q).filter(|d| d.is_finite()))));
    let is_simplest = advice.simplest.as_ref().is_some_and(|model| model.id() == found.model.id());
    row.push(match &found.deviations {
        Err(_) => "no value".into(),
        Ok(_) if !found.lacking.is_empty() => "no: a value is missing".into(),
        Ok(_) if is_simplest && advice.merging.is_some() => "yes but contacts merge".into(),
        Ok(_) if is_simplest => "yes".into(),
        Ok(_) if found.outside.is_some() => "no: not valid here".into(),
        Ok(_) if found.largest() <= advice.within => "no: a simpler one is as near".into(),
        Ok(_) => (&*format!("no: too far from {}", advice.reference.id())).into(),
    });
    for (quantity, _) in off {
        match found.off(*quantity) {
            Some(off) => row.extend(off.map(Cell::Number)),
            None => row.extend([Cell::BLANK; 2]),
        }
    }
    row
}
