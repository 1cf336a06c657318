//! The reasons for blanks, each kind once.

use std::mem::{Discriminant, discriminant};

use asperity::ContactError;

/// The reasons for blanks in rows of one model: what is blank, the kind of the error, the first
/// reason of that kind and the number of its rows.
#[derive(Debug, Clone)]
pub struct Blanks<E = ContactError>(Vec<(String, Discriminant<E>, String, usize)>);

impl<E> Default for Blanks<E> {
    fn default() -> Self {
        Self(vec![])
    }
}

impl<E> Blanks<E> {
    /// Counts a row without this, such as a value at all or one quantity, by an error and its
    /// reason in words.
    pub fn count(&mut self, what: &str, error: &E, reason: String) {
        let kind = discriminant(error);
        let same = |(known, other, ..): &&mut (String, Discriminant<E>, String, usize)| {
            *known == what && *other == kind
        };
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
