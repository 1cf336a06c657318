//! The reasons for blanks, each kind once; refusals are alike up to their numbers.

use std::mem::{Discriminant, discriminant};

use asperity::{ContactError, Evaluation, Quantity};

use crate::asked::Asked;

/// Names the model of opening where jkr pulls off.
const OPENING: &str = "; jkr-separation, which describes opening, may carry more";

/// The reasons for blanks of one model, each kind once; refusals are alike up to their numbers.
pub(crate) struct Blanks {
    adhesive: bool,
    rows: usize,
    kinds: Vec<(usize, Lacking)>,
}

/// A quantity without a value in a row with other values, and the reason.
pub(crate) type Lacking = (Option<Quantity>, ContactError);

impl Blanks {
    pub(crate) fn new(adhesive: bool) -> Self {
        Self { adhesive, rows: 0, kinds: vec![] }
    }

    /// Counts the first blank of a row that no other finding reports.
    pub(crate) fn count(
        &mut self,
        quantities: &[Quantity],
        asked: &Asked,
        values: &[Result<Evaluation, ContactError>],
    ) {
        self.rows += 1;
        let is_new = |e: &ContactError| match e {
            // Without contact there is a finding already.
            ContactError::NoValue { .. } => false,
            // Likewise of a tension without adhesion.
            ContactError::OutOfRange { field: "load" | "pressure", value, .. } => {
                self.adhesive || *value >= 0.0
            }
            _ => true,
        };
        let had = quantities.iter().zip(values).filter(|(quantity, _)| asked.has(**quantity));
        let mut failed =
            had.filter_map(|(quantity, value)| Some((*quantity, value.as_ref().err()?)));
        if let Some((quantity, reason)) = failed.find(|(_, reason)| is_new(reason)) {
            // Other quantities of the row may have a value.
            let partly = values.iter().any(Result::is_ok).then_some(quantity);
            count(&mut self.kinds, (partly, reason));
        }
    }

    /// The reasons as texts.
    pub(crate) fn texts(self, id: &str) -> impl Iterator<Item = String> {
        let rows = self.rows;
        self.kinds.into_iter().map(move |(count, (partly, reason))| {
            let hint = match reason {
                ContactError::OutOfReach { load, .. } if load < 0.0 && id == "jkr" => OPENING,
                _ => "",
            };
            match rows {
                1 => format!("{}{hint}", reason.marked()),
                _ => {
                    let what = partly.map_or("value".into(), |quantity| format!("`{quantity}`"));
                    let reason = reason.marked();
                    format!("no {what} in {count} of {rows} rows, first: {reason}{hint}")
                }
            }
        })
    }
}

/// Counts a reason for missing values.
pub(crate) fn count(
    kinds: &mut Vec<(usize, Lacking)>,
    (partly, reason): (Option<Quantity>, &ContactError),
) {
    let same = |known: &Lacking| known.0 == partly && kind(&known.1) == kind(reason);
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
