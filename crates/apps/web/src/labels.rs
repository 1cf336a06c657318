//! Labels of keys and quantities, names of models as legends have them, Greek symbols, and findings
//! with these.

use asperity::recommended::YIELDING;
use asperity::{Advice, Code, Described, Finding, Findings, Model, Quantity};
use serde_json::{Value, json};

/// Labels of keys whose words do not give them.
const LABELS: [(&str, &str); 4] = [
    ("youngs_modulus", "Young's modulus"),
    ("poissons_ratio", "Poisson's ratio"),
    ("asperity_height_std", "height std σ_z"),
    ("surface_height_std", "height std of the surface"),
];

/// Latin names of Greek letters, with these.
const SYMBOLS: &str = "alpha α, beta β, eta η, theta θ, pi π, psi ψ, sigma σ, sqrt √, nu ν";

/// What describes yielding where contacts merge.
const WITHOUT_ASPERITIES: &str = "boundary elements or persson-plastic";

/// The label of a key or the name of a quantity.
pub(crate) fn term(term: &str) -> String {
    term.parse().map_or_else(|_| label(term), quantity_name)
}

/// The name of a model, for a variant its id, as legends have it: `KE`, `persson-fudge`.
fn model_name(model: &Model) -> &str {
    if model.id().contains('-') { model.id() } else { model.name() }
}

/// Name, authors and year of a model: `KE: Kogut & Etsion (2002)`.
fn source(model: &Model) -> String {
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

/// The name of a quantity in tables and sentences; the tangent stiffness is that on first loading.
pub(crate) fn quantity_name(quantity: Quantity) -> String {
    match quantity {
        Quantity::Tangent => format!("{} (first loading)", quantity.label()),
        _ => quantity.label().into(),
    }
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
    let is_symbol = symbols(key) != key || key.split('_').any(|part| part.len() < 2);
    match known {
        Some((_, label)) => (*label).into(),
        None if is_symbol => key.into(),
        None => key.replace('_', " "),
    }
}

/// Latin names of Greek letters as these, and squares and cubes as raised digits. `psi` behind a
/// number is the unit.
pub(crate) fn symbols(text: &str) -> String {
    let ends = [' ', '(', ')', '/', '^', ',', ';', ':'];
    let mut made = String::new();
    for piece in text.split_inclusive(ends) {
        let word = piece.trim_end_matches(ends);
        let (letter, index) = word.split_once('_').map_or((word, ""), |(a, b)| (a, b));
        let number = made.strip_suffix(' ').unwrap_or(&made);
        let is_unit = word == "psi" && number.ends_with(|c: char| c.is_ascii_digit());
        let mut letters = SYMBOLS.split(", ").filter_map(|pair| pair.split_once(' '));
        let greek = letters.find(|(latin, _)| *latin == letter && index.len() < 2 && !is_unit);
        match (greek, word) {
            (Some((latin, greek)), _) => made += &word.replacen(latin, greek, 1),
            (None, "2" | "3") if made.ends_with('^') => {
                made.pop();
                made.push(if word == "2" { '²' } else { '³' });
            }
            _ => made += word,
        }
        made += &piece[word.len()..];
    }
    made
}

/// A finding in the words of the page; where contacts `merge`, no model of asperities is advised.
pub(crate) fn message(found: &Finding, merge: bool) -> String {
    let words = |advice: Advice| match advice {
        Advice::UseModels(YIELDING) if merge => format!("use {WITHOUT_ASPERITIES}"),
        Advice::CompareCutOffs => "see the picture of slopes and curvatures".into(),
        Advice::Despike => "\"Replace outliers\" in \"More about the scan\" replaces them".into(),
        other => other.to_string(),
    };
    symbols(&found.worded(&term(&found.field), words))
}

/// A finding as the page shows it, with the path of its field of the form or the name of another
/// number.
pub(crate) fn finding(found: &Finding, merge: bool) -> Value {
    let Finding { code, severity, field, quantity, .. } = found;
    json!({
        "code": code, "severity": severity, "field": field, "quantity": quantity,
        "message": message(found, merge),
    })
}

/// All findings as shown.
pub(crate) fn findings(all: &Findings) -> Value {
    let merge = all.iter().any(|found| found.code == Code::Crowded);
    all.iter().map(|found| finding(found, merge)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_labels_and_letters_are_greek() {
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
        for (text, wanted) in [
            ("psi = sqrt(sigma_z/w_c), by Chang", "ψ = √(σ_z/w_c), by Chang"),
            ("w_c = (pi S H/(2 E))^2 R", "w_c = (π S H/(2 E))² R"),
            ("theta = E sigma_z^1.5/(w_a sqrt(R))", "θ = E σ_z^1.5/(w_a √(R))"),
            ("30e6 psi is 206.8 GPa, psi 2, 2 pi", "30e6 psi is 206.8 GPa, ψ 2, 2 π"),
            ("my_scan.x3p of alpha.txt is empty", "my_scan.x3p of alpha.txt is empty"),
        ] {
            assert_eq!(symbols(text), wanted);
        }
    }
}
