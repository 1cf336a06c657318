//! The reasons for blanks, each kind once; refusals are alike up to their numbers.

use std::mem::discriminant;

use asperity::ContactError;

/// Names the model of opening where jkr pulls off.
const OPENING: &str = "; jkr-separation, which describes opening, may carry more";

/// The reasons for blanks of one model: what is blank, the first reason of each kind and the number
/// of its rows.
#[derive(Default)]
pub(crate) struct Blanks(Vec<(String, ContactError, usize)>);

impl Blanks {
    /// Counts a row that lacks a value, or this quantity alone.
    pub(crate) fn count(&mut self, what: String, reason: &ContactError) {
        let is_same = |(known, first, _): &&mut (String, ContactError, usize)| {
            *known == what && is_alike(first, reason)
        };
        match self.0.iter_mut().find(is_same) {
            Some((.., count)) => *count += 1,
            None => self.0.push((what, reason.clone(), 1)),
        }
    }

    /// The reasons as texts, of a model with so many rows.
    pub(crate) fn texts(self, id: &str, rows: usize) -> impl Iterator<Item = String> {
        self.0.into_iter().map(move |(what, reason, count)| {
            let advice = match reason {
                ContactError::OutOfReach { load, .. } if load < 0.0 && id == "jkr" => OPENING,
                _ => "",
            };
            let reason = reason.marked();
            // The id stands in front of every message.
            let reason = reason.split_once("-corrected`: ").map_or(&*reason, |(_, rest)| rest);
            match rows {
                1 => format!("{reason}{advice}"),
                _ => format!("no {what} in {count} of {rows} rows, first: {reason}{advice}"),
            }
        })
    }
}

fn is_alike(one: &ContactError, other: &ContactError) -> bool {
    let words = |reason: &ContactError| match reason {
        ContactError::Refused { reason, .. } => {
            reason.split(|c: char| c.is_ascii_digit()).next().map(String::from)
        }
        _ => None,
    };
    discriminant(one) == discriminant(other) && words(one) == words(other)
}
