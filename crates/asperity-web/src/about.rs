//! What a model is, in a sentence.

use asperity::{Described, Model};

use crate::names::with_ids;

/// What tells variants from the model before the dash.
const VARIANTS: [(&str, &str); 6] = [
    ("additive", "every contact counts once in the sums"),
    ("cosine", "the hardness falls with the cosine of a/R, as in later papers"),
    ("fudge", "the variance of the pressure is smaller at small areas"),
    (
        "overlap",
        "the elastic law holds to w = 6 w_c, less the share of the plastic one, which begins at w_c",
    ),
    ("random", "averaged over asperities whose heights and radii differ, as on a random surface"),
    ("separation", "surfaces that move apart after contact"),
];

/// Name, source and range of a model, and what tells a variant from its base.
pub(crate) fn about(model: &Model) -> String {
    let (citation, validity) = (model.citation(), model.validity());
    let name = with_ids(model.name());
    let mut sentence = format!("{name}: {} ({})", citation.authors, citation.year);
    let variant = |part: &str| VARIANTS.iter().find(|(name, _)| *name == part);
    for (_, difference) in model.id().split('-').skip(1).filter_map(variant) {
        sentence += &format!("; {difference}");
    }
    if !validity.valid_for.is_empty() {
        sentence += &format!("; range: {}", validity.valid_for);
    }
    sentence
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_variant_has_its_own_sentence() {
        for model in Model::named() {
            for part in model.id().split('-').skip(1) {
                let known = VARIANTS.iter().find(|(name, _)| *name == part);
                let (_, difference) = known.unwrap_or_else(|| panic!("{part}"));
                assert!(about(&model).contains(difference), "{}", about(&model));
            }
        }
        let ke = about(&"ke".parse().unwrap());
        assert!(ke.starts_with("KE: Kogut & Etsion (2002); range: "), "{ke}");
        assert!(VARIANTS.iter().all(|(_, difference)| !ke.contains(difference)));
    }
}
