//! Labels of keys and quantities, names of models as legends have them, Greek symbols, and findings
//! with these.

use asperity::recommended::YIELDING;
use asperity::{Advice, Code, Described, Finding, Findings, Model, Quantity, Severity};
use serde_json::{Value, json};

/// Labels of keys whose words do not give them.
const LABELS: [(&str, &str); 4] = [
    ("youngs_modulus", "Young's modulus"),
    ("poissons_ratio", "Poisson's ratio"),
    ("asperity_height_std", "height std σ_z"),
    ("surface_height_std", "height std of the surface"),
];

const SYMBOLS: [(&str, &str); 9] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("eta", "η"),
    ("theta", "θ"),
    ("pi", "π"),
    ("psi", "ψ"),
    ("sigma", "σ"),
    ("sqrt", "√"),
    ("nu", "ν"),
];

/// What describes yielding where contacts merge.
const WITHOUT_ASPERITIES: &str = "boundary elements or persson-plastic";

/// The label of a key or the name of a quantity.
pub(crate) fn term(term: &str) -> String {
    term.parse().map_or_else(|_| label(term), quantity_name)
}

/// The name of a model, for a variant its id, as legends have it: `KE`, `persson-fudge`.
pub(crate) fn model_name(model: &Model) -> &str {
    if model.id().contains('-') { model.id() } else { model.name() }
}

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
        let greek = SYMBOLS.iter().find(|(latin, _)| *latin == letter && index.len() < 2);
        let greek = greek.filter(|_| !is_unit);
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
        Advice::CompareCutOffs => "see the table of slopes and curvatures".into(),
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

/// All findings as shown, with the numbers that were converted.
pub(crate) fn findings(all: &Findings, converted: &[(String, String)]) -> Value {
    let merge = all.iter().any(|found| found.code == Code::Crowded);
    let converted = converted.iter().map(|(key, text)| {
        let message = format!("{}: {text}", term(key));
        json!({ "code": "", "severity": Severity::Note, "field": key, "message": message })
    });
    all.iter().map(|found| finding(found, merge)).chain(converted).collect()
}

#[cfg(test)]
mod tests {
    use asperity::At;
    use asperity_scene::{HandedFiles, SceneFile, parse_handed};

    use super::*;
    use crate::surface_keys::with_scan;

    fn messages(all: &Findings) -> Vec<String> {
        let message = |found: &Value| found["message"].as_str().unwrap().to_string();
        findings(all, &[]).as_array().unwrap().iter().map(message).collect()
    }

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

    #[test]
    fn where_contacts_merge_no_model_of_asperities_is_advised() {
        let file = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        let file = file.unwrap();
        let at = |pressure: f64| {
            let found = |id: &str| {
                let at = [asperity::At::Pressure(pressure)];
                file.findings_at(&file.model(id).unwrap(), &at).into_iter()
            };
            let all = ["gw", "ke"].into_iter().flat_map(found).collect();
            messages(&all).concat()
        };
        assert!(at(1e7).contains("use ke or jg"), "{}", at(1e7));
        let merged = at(5e8);
        assert!(merged.contains("gw ignores yielding") && merged.contains("contacts merge"));
        assert!(!merged.contains("use ke or jg"), "{merged}");
    }

    /// The template on a scan of waves with one point far above the others.
    fn spiked() -> SceneFile {
        let height = |k: u32| {
            let (x, y) = (f64::from(k % 64), f64::from(k / 64));
            let waves = (0.9 * x + 0.3 * y).cos() + (0.8 * y - 0.4 * x).sin();
            let end = if k % 64 == 63 { '\n' } else { '\t' };
            format!("{:.4}{end}", waves + if k == 2080 { 60.0 } else { 0.0 })
        };
        let scan = (0..64 * 64).map(height).collect::<String>().into_bytes();
        let files = HandedFiles::from([("scan.txt".to_string(), scan)]);
        let text = with_scan(asperity_scene::template(), "scan.txt").unwrap();
        let keys = "file = \"scan.txt\"\nunit = \"nm\"\npixel_size = \"1 um\"";
        parse_handed(&text.replace("file = \"scan.txt\"", keys), &files).unwrap()
    }

    #[test]
    fn no_advice_names_a_command() {
        let refused = |body: &str| {
            let text = format!(
                "nominal_area = 1e-4\nrigid_counterface = true\n[[body]]\n{body}\n[surface]\n\
                 asperity_radius = 1e-4\nasperity_density = 1e9\nasperity_height_std = 1e-6\n"
            );
            parse_handed(&text, &HandedFiles::new()).unwrap_err().to_string()
        };
        let file = spiked();
        let ke = file.model("ke").unwrap();
        let check = file.check(Some((&ke, At::Load(1e-3)))).unwrap();
        let merged = file.findings_at(&ke, &[At::Pressure(1e9)]);
        let all = [&merged, &check.findings, &file.warnings].map(messages).concat();
        for offer in ["the table of slopes", "\"Replace outliers\"", "use boundary elements, "] {
            assert!(all.iter().any(|message| message.contains(offer)), "{offer}: {all:#?}");
        }
        let refusals = [
            file.surface_shape().unwrap_err().to_string(),
            refused("material = \"unobtainium\""),
            refused("material = \"steel-a36\"\nhardness = 2e9"),
        ];
        let no_command = |text: &String| !text.contains("asperity ") && !text.contains("--");
        assert!(all.iter().chain(&refusals).all(no_command), "{all:#?} {refusals:#?}");
    }

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
