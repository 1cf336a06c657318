//! What is known at a load, from the best source: boundary elements on this scan, those on solved
//! surfaces like this one, or the recommended model.

use asperity::{
    At, ContactError, CorrectedRow, Scene, Separation, SeparationUnit, usual_reference,
};
use asperity_answer::unranked;
use asperity_inputs::SceneFile;

use crate::answer::{Column, Known, Row, Source, quantities};
use crate::dialect::said;
use crate::message::Solved;

/// What is known at a load.
pub(crate) struct Best {
    /// By column.
    pub(crate) values: Vec<Option<Known>>,
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
    /// From the row of the recommended model on a scene, its correction by the evidence, and what
    /// was solved on this scan at this load.
    pub(crate) fn new(
        (file, columns): (&SceneFile, &[Column]),
        row: &Row,
        corrected: Result<CorrectedRow, ContactError>,
        solved: Option<&Solved>,
    ) -> Self {
        let values = (0..columns.len()).map(|column| row.value(column).copied()).collect();
        let (model, basis) = (row.model.clone(), String::new());
        let mut best = Self { values, source: Source::Model, model, basis };
        let spreads = file.spreads();
        match corrected {
            _ if !spreads.is_empty() => {
                let spread = |(name, ratio)| format!("`{name}` within {ratio:.1}");
                let spreads = spreads.into_iter().map(spread).collect::<Vec<_>>().join(", ");
                best.basis = said(&format!(
                    "Ranges by {}, of a surface with {spreads}; Rdq, or Rz with RSm, or a scan narrows them.",
                    best.model
                ));
            }
            Ok(row) => best.take_evidence(file, &row),
            Err(reason) => {
                let why = match reason {
                    ContactError::NoEvidence { reason } | ContactError::Refused { reason, .. } => {
                        reason
                    }
                    other => other.marked(),
                };
                let why = said(&why).replace('_', " ");
                best.basis = format!("No evidence here ({why}): values by {}.", best.model);
            }
        }
        let Some(solved) = solved else { return best };
        let codes = solved.notes.iter().map(String::as_str).collect();
        best.basis = match unranked(&[codes]) {
            None => "Boundary elements on this scan at this load.".into(),
            Some([why, _]) if best.source == Source::Model => {
                format!("Boundary elements on this scan at this load, uncertain: {why}.")
            }
            // The mean of many surfaces is better known than one with few contacts.
            Some(_) => return best,
        };
        best.take(Source::Solved, solved.row(columns).cells.into_iter().map(Result::ok));
        best
    }

    /// Values of a better source.
    fn take(&mut self, source: Source, values: impl Iterator<Item = Option<Known>>) {
        self.source = source;
        for (known, better) in self.values.iter_mut().zip(values) {
            *known = better.or(*known);
        }
    }

    fn take_evidence(&mut self, file: &SceneFile, row: &CorrectedRow) {
        let known = |[value, lower, upper]: [f64; 3]| {
            Known::new(value, Some([lower, upper]), Source::Evidence)
        };
        let metres = |s: Separation| {
            let found = s.measured_in(SeparationUnit::Metres, file.separation_from, &file.scene);
            found.ok().map(|found| found.value)
        };
        let gap = row
            .separation()
            .ok()
            .and_then(|of| Some(known([metres(of.value)?, metres(of.lower)?, metres(of.upper)?])));
        let values = quantities(file).into_iter().map(|quantity| {
            row.value(quantity).ok().map(|of| known([of.value, of.lower, of.upper]))
        });
        self.take(Source::Evidence, [gap].into_iter().chain(values));
        let lighter = match row.is_extrapolated() {
            true => "; the load is below the lightest solved one, whose ratios are used",
            false => "",
        };
        let solved = row.solved();
        self.basis = format!("From {solved} like this one; 9 of 10 lie in the intervals{lighter}.");
    }

    /// A value of the best source.
    pub(crate) fn value(&self, column: usize) -> Option<&Known> {
        self.values.get(column)?.as_ref().filter(|known| known.source == self.source)
    }
}
