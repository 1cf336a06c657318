//! Several models on the same data.

use asperity_core::Finding;
use serde::Serialize;

use crate::doubt::list;
use crate::{Data, Fitted};

/// A difference of the criterion below which two models are hardly distinguished: a factor of 20
/// in their odds.
const STRONG: f64 = 6.0;

/// Residuals below this, relative, are errors of the values: they read 0 and rank no model.
pub(crate) const ACCURACY: f64 = 1e-12;

/// Fitted models, ordered by BIC, lowest first, or by rms where one of them has no BIC; those whose
/// law does not hold come last.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ranking {
    /// The fitted models.
    pub models: Vec<Fitted>,
    /// The meaning of their order, and its limits.
    pub summary: String,
}

impl Ranking {
    /// The models without those that are another one here.
    pub fn distinct(&self) -> impl Iterator<Item = &Fitted> {
        self.models.iter().filter(|one| one.same_as.is_none())
    }

    /// Doubts about the distinct models, one for each cause: a doubt that several models share is
    /// that of the first, with the names of the others.
    #[must_use]
    pub fn doubts(&self) -> Vec<Finding> {
        let mut found: Vec<Finding> = vec![];
        for new in self.distinct().flat_map(Fitted::findings) {
            // Another value, as of another limit, has another reason.
            let cause = |one: &Finding| (one.code, one.field.clone(), one.value.to_bits());
            let same = |one: &&mut Finding| cause(one) == cause(&new) && one.model != new.model;
            match found.iter_mut().find(same) {
                Some(known) => known.also.extend(new.model),
                None => found.push(new),
            }
        }
        found
    }
}

/// Orders models by BIC, lowest first, or by rms where one of them has no BIC. Behind these come
/// models that did not converge, and then those whose law does not hold where data were measured.
#[must_use]
pub fn rank(mut models: Vec<Fitted>) -> Ranking {
    let has_bic = models.iter().all(|fitted| fitted.bic.is_some());
    let key = |fitted: &Fitted| {
        let misfit = if has_bic { fitted.bic } else { fitted.rms };
        ((fitted.invalid().is_some(), !fitted.converged), misfit.unwrap_or(f64::INFINITY))
    };
    models.sort_by(|a, b| {
        let ((a, one), (b, other)) = (key(a), key(b));
        a.cmp(&b).then(one.total_cmp(&other))
    });
    let same_as: Vec<_> = models.iter().map(|one| same_as(one, &models)).collect();
    models.iter_mut().zip(same_as).for_each(|(one, same_as)| one.same_as = same_as);
    let mut ranking = Ranking { models, summary: String::new() };
    ranking.summary = ranking.summarise(has_bic);
    ranking
}

/// The model that stands for all with the values of this one, if it is another: an elastic one, or
/// the first.
fn same_as(one: &Fitted, models: &[Fitted]) -> Option<String> {
    let mut same = models.iter().filter(|other| other.equals(one));
    let first = same.clone().next();
    let stands = same.find(|other| other.is_elastic).or(first)?;
    (stands.model != one.model).then(|| stands.model.clone())
}

impl Ranking {
    fn summarise(&self, has_bic: bool) -> String {
        let distinct: Vec<&Fitted> = self.distinct().collect();
        let [first, others @ ..] = &distinct[..] else { return "no model was fitted".into() };
        let mut parts = self.same_models();
        match (first.bic, first.residuals.len()) {
            (Some(_), _) if has_bic && self.models.len() == 1 => parts.push(format!(
                "{} alone was fitted: its residuals do not say whether other models fit as well",
                first.model
            )),
            (Some(least), _) if has_bic && !others.is_empty() => {
                parts.push(order(first, least, others));
                parts.push("a low BIC does not say that a model is right, or that its numbers are those of the surface".into());
            }
            (Some(_), _) if has_bic => {}
            (_, 1) => parts.push("one measured value cannot choose between models".into()),
            _ => parts.push(
                "as many parameters as measured values leave nothing to rank models by".into(),
            ),
        }
        parts.join("; ")
    }

    /// Which models are another one here.
    fn same_models(&self) -> Vec<String> {
        let sentence = |stands: &Fitted| {
            let same = self.models.iter().filter(|one| one.same_as.as_ref() == Some(&stands.model));
            let same: Vec<&str> = same.map(|one| one.model.as_str()).collect();
            let verb = if same.len() == 1 { "is" } else { "are" };
            let why = if stands.is_elastic { "nothing yields" } else { "all values are the same" };
            let names = list(&same);
            (!same.is_empty()).then(|| format!("{why}: {names} {verb} {}", stands.model))
        };
        self.distinct().filter_map(sentence).collect()
    }
}

/// The first of several models beside the others.
fn order(first: &Fitted, least: f64, others: &[&Fitted]) -> String {
    let name = &first.model;
    if let Some(invalid) = first.invalid() {
        let code = invalid.code;
        return format!("{name} fits best by BIC, but no model of the list holds here ({code})");
    }
    let (valid, invalid): (Vec<&Fitted>, Vec<&Fitted>) =
        others.iter().partition(|other| other.invalid().is_none());
    let near = valid.iter().filter(|other| other.bic.is_some_and(|bic| bic - least < STRONG));
    let near: Vec<&str> = near.map(|other| other.model.as_str()).collect();
    let mut text = match &near[..] {
        _ if valid.is_empty() => format!("{name} is the only model of the list that holds here"),
        [] if invalid.is_empty() => format!("{name} fits best by BIC, clearly before the others"),
        [] => format!(
            "of the models that hold here, {name} fits best by BIC, clearly before the others"
        ),
        near => format!(
            "{name} fits best by BIC, but these data do not distinguish it from {} (BIC within {STRONG})",
            list(near)
        ),
    };
    let names: Vec<String> = invalid
        .iter()
        .map(|other| format!("{} ({})", other.model, other.invalid().map_or("", |one| one.code)))
        .collect();
    match &names[..] {
        [] => {}
        [one] => text += &format!("; {one} ranks last, as its law does not hold here"),
        all => text += &format!("; {} rank last, as their laws do not hold here", all.join(", ")),
    }
    text
}

/// The Bayesian information criterion, for normal residuals of known or unknown deviation.
pub(crate) fn bic(data: &Data, squares: f64, rank: usize) -> Option<f64> {
    let count = data.len() as f64;
    // One value ranks no model, also where no parameter changes it.
    if data.len() <= rank.max(1) {
        return None;
    }
    let misfit = match data.has_std() {
        true => squares,
        false => count * (squares / count).max(ACCURACY * ACCURACY).ln(),
    };
    Some(misfit + rank as f64 * count.ln())
}
