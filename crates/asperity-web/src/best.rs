//! What is known at a load, from the best source: boundary elements on this scan, those on solved
//! surfaces like this one, or the recommended model.

use std::collections::BTreeMap;

use asperity::{
    At, ContactError, Corrected, CorrectedRow, Scene, Separation, SeparationUnit, usual_reference,
};
use asperity_answer::unranked;
use asperity_inputs::SceneFile;
use serde::Serialize;
use serde_json::Value;

use crate::answer::{SEPARATION, quantities};
use crate::dialect::said;
use crate::message::Solved;
use crate::span::Load;

/// Where a value comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Source {
    /// The recommended model, without evidence.
    Model,
    /// Boundary elements on solved surfaces like this one.
    Evidence,
    /// Boundary elements on this scan at this load.
    Solved,
}

/// A value with the ends of an interval that holds nine of ten surfaces.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    pub(crate) value: f64,
    pub(crate) ends: Option<[f64; 2]>,
    pub(crate) source: Source,
}

/// What is known at a load.
pub(crate) struct Best {
    /// By quantity.
    pub(crate) values: BTreeMap<String, Known>,
    /// The best source.
    pub(crate) source: Source,
    /// The recommended model.
    pub(crate) model: String,
    /// The source in a sentence.
    pub(crate) basis: String,
}

/// The model that is recommended where there is no evidence: of yielding, elastic or adhesive
/// asperities.
pub(crate) fn recommended(file: &SceneFile, at: At) -> &'static str {
    if file.scene.adhesion_parameter().is_none_or(|theta| theta >= Scene::HIDES_ADHESION) {
        return usual_reference(&file.scene);
    }
    let fits = |id: &&str| {
        let found = file.model(id).map(|model| file.findings_at(&model, &[at]));
        found.is_ok_and(|found| found.iter().all(|one| one.code != "tabor"))
    };
    ["dmt", "jkr"].into_iter().find(fits).unwrap_or("jkr")
}

impl Best {
    /// From the row of the recommended model, its correction by the evidence, and what was solved
    /// on this scan at this load.
    pub(crate) fn new(
        file: &SceneFile,
        row: &Value,
        corrected: &Result<Corrected, ContactError>,
        load: &Load,
        solved: Option<&Solved>,
    ) -> Self {
        let model = row["model"].as_str().unwrap_or_default().to_string();
        let (values, basis) = (BTreeMap::new(), String::new());
        let mut best = Self { values, source: Source::Model, model, basis };
        best.take(Source::Model, numbers(row).map(|(quantity, value)| (quantity, value, None)));
        match corrected.as_ref().map_err(Clone::clone).and_then(|of| of.at(load.at)) {
            Ok(row) => best.take_evidence(file, &row),
            Err(reason) => {
                let reason = reason.marked();
                let why = reason.rsplit_once("is close: ").or_else(|| reason.split_once(": "));
                let why = said(why.map_or(&reason, |(_, why)| why)).replace('_', " ");
                best.basis = format!("No evidence here ({why}): values by {}.", best.model);
            }
        }
        let Some(solved) = solved else { return best };
        let codes = solved.notes.iter().map(String::as_str).collect();
        best.basis = match unranked(&[codes]) {
            None => "Boundary elements on this scan at this load.".into(),
            Some(why) if best.source == Source::Model => {
                let (why, _) = why.split_once("; ").unwrap_or((why, ""));
                format!("Boundary elements on this scan at this load, uncertain: {why}.")
            }
            // The mean of many surfaces is better known than one with few contacts.
            Some(_) => return best,
        };
        let row = solved.row();
        best.take(Source::Solved, numbers(&row).map(|(quantity, value)| (quantity, value, None)));
        best
    }

    /// Values of a better source.
    fn take<'q>(
        &mut self,
        source: Source,
        values: impl IntoIterator<Item = (&'q str, f64, Option<[f64; 2]>)>,
    ) {
        self.source = source;
        let known = |(quantity, value, ends): (&str, _, _)| {
            (quantity.to_string(), Known { value, ends, source })
        };
        self.values.extend(values.into_iter().map(known));
    }

    fn take_evidence(&mut self, file: &SceneFile, row: &CorrectedRow) {
        for quantity in quantities(file) {
            let (found, name) = (row.value(quantity).ok(), quantity.to_string());
            let found = found.map(|of| (&*name, of.value, Some([of.lower, of.upper])));
            self.take(Source::Evidence, found);
        }
        let metres = |s: Separation| {
            let found = s.measured_in(SeparationUnit::Metres, file.separation_from, &file.scene);
            found.ok().map(|found| found.value)
        };
        let gap = row.separation().ok().and_then(|of| {
            Some((SEPARATION, metres(of.value)?, Some([metres(of.lower)?, metres(of.upper)?])))
        });
        self.take(Source::Evidence, gap);
        let lighter = match row.is_extrapolated() {
            true => "; the load is below the lightest solved one, whose ratios are used",
            false => "",
        };
        let basis = row.basis();
        let surfaces = basis.split("; ").last().unwrap_or_default();
        self.basis =
            format!("From {surfaces} like this one; 9 of 10 lie in the intervals{lighter}.");
    }

    /// A value of the best source.
    pub(crate) fn value(&self, quantity: &str) -> Option<&Known> {
        self.values.get(quantity).filter(|known| known.source == self.source)
    }
}

/// The numbers of a row by quantity.
pub(crate) fn numbers(row: &Value) -> impl Iterator<Item = (&str, f64)> {
    let cells = row["cells"].as_array().into_iter().flatten();
    cells.filter_map(|cell| {
        Some((cell["quantity"].as_str()?, cell["digits"].as_str()?.parse().ok()?))
    })
}
