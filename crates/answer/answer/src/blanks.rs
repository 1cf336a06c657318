//! The reasons for blanks, each kind once.

use std::mem::{Discriminant, discriminant};

use asperity::ContactError;

/// The kind of an error, up to its numbers: its variant, and the field or property that it is
/// about.
pub(crate) type Kind = (Discriminant<ContactError>, &'static str);

/// The reasons for blanks in rows of one model: what is blank, the kind of the error, the first
/// reason of that kind and the number of its rows.
#[derive(Debug, Clone)]
pub struct Blanks<K>(Vec<(String, K, String, usize)>);

impl<K> Default for Blanks<K> {
    fn default() -> Self {
        Self(vec![])
    }
}

pub(crate) fn kind(error: &ContactError) -> Kind {
    let about = match error {
        ContactError::OutOfRange { field, .. } | ContactError::Missing { field, .. } => field,
        ContactError::NoEvidence { property, .. } => property,
        _ => "",
    };
    (discriminant(error), about)
}

impl<K: PartialEq> Blanks<K> {
    /// Counts a row without this, such as a value at all or one quantity, by the kind of the error
    /// and its reason in words.
    pub fn count(&mut self, what: &str, kind: K, reason: String) {
        let same =
            |(known, other, ..): &&mut (String, K, String, usize)| *known == what && *other == kind;
        match self.0.iter_mut().find(same) {
            Some((.., count)) => *count += 1,
            None => self.0.push((what.into(), kind, reason, 1)),
        }
    }

    /// The reasons in sentences, of a model with so many rows.
    pub fn texts(self, rows: usize) -> impl Iterator<Item = String> {
        self.0.into_iter().map(move |(what, _, reason, count)| match rows {
            1 => reason,
            _ => format!("no {what} in {count} of {rows} rows, first: {reason}"),
        })
    }
}
