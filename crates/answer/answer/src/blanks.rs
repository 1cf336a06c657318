//! The reasons for blanks, each kind once; reasons are alike up to their numbers.

/// The reasons for blanks in rows of one model: what is blank, the first reason of each kind and
/// the number of its rows.
#[derive(Debug, Clone, Default)]
pub struct Blanks(Vec<(String, String, usize)>);

impl Blanks {
    /// Counts a row without this, such as a value at all or one quantity.
    pub fn count(&mut self, what: &str, reason: String) {
        // 1e30 leaves what 12 leaves.
        let words = |text: &str| {
            let is_word = |c: &char| c.is_alphabetic() && *c != 'e';
            text.chars().filter(is_word).collect::<String>()
        };
        let known = self.0.iter_mut().find(|(known, first, _)| {
            *known == what && (*first == reason || words(first) == words(&reason))
        });
        match known {
            Some((.., count)) => *count += 1,
            None => self.0.push((what.into(), reason, 1)),
        }
    }

    /// The reasons in sentences, of a model with so many rows.
    pub fn texts(self, rows: usize) -> impl Iterator<Item = String> {
        self.0.into_iter().map(move |(what, reason, count)| match rows {
            1 => reason,
            _ => format!("no {what} in {count} of {rows} rows, first: {reason}"),
        })
    }
}
