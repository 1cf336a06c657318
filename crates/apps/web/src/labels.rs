//! Labels of keys and quantities, names of models as legends have them, and findings with these.

use asperity::{Advice, Described, Finding, Model, Quantity};
use serde_json::{Value, json};

/// Labels of keys whose words do not give them.
const LABELS: [(&str, &str); 4] = [
    ("youngs_modulus", "Young's modulus"),
    ("poissons_ratio", "Poisson's ratio"),
    ("asperity_height_std", "height std σ_z"),
    ("surface_height_std", "height std of the surface"),
];

/// The label of a key, or the name of a quantity in tables and sentences; the tangent stiffness is
/// that on first loading.
pub(crate) fn term(term: &str) -> String {
    match term.parse() {
        Ok(of @ Quantity::Tangent) => format!("{} (first loading)", of.label()),
        Ok(of) => of.label().into(),
        Err(_) => label(term),
    }
}

/// Name, for a variant the id, authors and year, the differences of a variant, and range of a
/// model.
pub(crate) fn model_sentence(model: &Model) -> String {
    let (id, citation) = (model.id(), model.citation());
    let name = if id.contains('-') { id } else { model.name() };
    let source = format!("{name}: {} ({})", citation.authors, citation.year);
    let range = model.validity().valid_for;
    let range = (!range.is_empty()).then(|| format!("range: {range}"));
    let differences = model.variant().into_iter().map(String::from);
    [source].into_iter().chain(differences).chain(range).collect::<Vec<_>>().join("; ")
}

/// The label of a key of scene files, without its section but with the number of a body; other
/// terms as they are.
fn label(term: &str) -> String {
    if let Some((body, key)) = term.strip_prefix("body[").and_then(|rest| rest.split_once(']')) {
        return match key.strip_prefix('.') {
            Some(key) => format!("{} of body {body}", label(key)),
            None => format!("body {body}"),
        };
    }
    let key = term.strip_prefix("surface.").unwrap_or(term);
    let known = LABELS.iter().find(|(known, _)| *known == key);
    let is_symbol = key.split('_').any(|part| part.len() < 2);
    match known {
        Some((_, label)) => (*label).into(),
        None if is_symbol => key.into(),
        None => key.replace('_', " "),
    }
}

/// Squares and cubes as raised digits.
pub(crate) fn raised(text: &str) -> String {
    text.replace("^2", "²").replace("^3", "³")
}

/// A finding in the words of the page.
pub(crate) fn message(found: &Finding) -> String {
    let words = |advice: Advice| match advice {
        Advice::CompareCutOffs => "see the picture of slopes and curvatures".into(),
        Advice::Despike => "\"Replace outliers\" in \"More about the scan\" replaces them".into(),
        other => other.to_string(),
    };
    raised(&found.worded(&term(&found.field), words))
}

/// A finding as the page shows it, with the path of its field of the form or the name of another
/// number.
pub(crate) fn finding(found: &Finding) -> Value {
    let Finding { code, severity, field, quantity, .. } = found;
    json!({
        "code": code, "severity": severity, "field": field, "quantity": quantity,
        "message": message(found),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_labels_and_powers_are_raised() {
        for (key, wanted) in [
            ("area_fraction", "real over nominal area"),
            ("unloading-stiffness", "unloading stiffness"),
            ("asperity_height_std", "height std σ_z"),
            ("body[1].youngs_modulus", "Young's modulus of body 1"),
            ("body[2]", "body 2"),
            ("surface.pixel_size", "pixel size"),
            ("plasticity_index", "plasticity index"),
        ] {
            assert_eq!(term(key), wanted);
        }
        assert_eq!(raised("w_c = (pi S H/(2 E))^2 R"), "w_c = (pi S H/(2 E))² R");
    }
}
