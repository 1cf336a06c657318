//! One sentence about a model.

use asperity::{Described, Model};

use crate::dialect::model_name;

/// Name, authors and year of a model: `KE: Kogut & Etsion (2002)`.
pub(crate) fn source(model: &Model) -> String {
    let citation = model.citation();
    format!("{}: {} ({})", model_name(model), citation.authors, citation.year)
}

/// Name, source, the differences of a variant, and range of a model.
pub(crate) fn model_sentence(model: &Model) -> String {
    let range = model.validity().valid_for;
    let range = (!range.is_empty()).then(|| format!("range: {range}"));
    let differences = model.variant().into_iter().map(String::from);
    [source(model)].into_iter().chain(differences).chain(range).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variants_say_how_they_differ() {
        let sentence = |id: &str| model_sentence(&id.parse().unwrap());
        assert!(sentence("ke").starts_with("KE: Kogut & Etsion (2002); range: "));
        let cosine = sentence("jg-cosine-random");
        let wanted = "jg-cosine-random: Jackson & Green (2005); the hardness falls with ";
        assert!(cosine.starts_with(wanted), "{cosine}");
        assert!(cosine.contains("; averaged over asperities"), "{cosine}");
    }
}
