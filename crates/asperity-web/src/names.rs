//! Messages with the names of the tables and fields of the page, in place of the keys of scene
//! files, the options of the program and Greek letters in Latin.

use std::sync::LazyLock;

use asperity::recommended::YIELDING;
use asperity::{Described, Finding, Findings, Model, Quantity, Severity};
use asperity_inputs::SceneFile;
use serde::Serialize;

/// Names of keys whose words do not give them.
const KEYS: [(&str, &str); 4] = [
    ("youngs_modulus", "Young's modulus"),
    ("poissons_ratio", "Poisson's ratio"),
    ("asperity_height_std", "height std σ_z"),
    ("surface_height_std", "height std of the surface"),
];

const GREEK: [(&str, &str); 9] = [
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

/// What the program advises, and what the page has instead.
const PROGRAM: [(&str, &str); 6] = [
    ("use bem", "use boundary elements"),
    ("use `asperity truth`", "solve the scan by boundary elements"),
    (" (asperity materials)", ""),
    ("the numbers that `asperity materials` lists", "its numbers (own values)"),
    ("with `asperity surface --scales`", "in the table of slopes and curvatures"),
    (" (--despike)", ""),
];

/// Names and ids of the variants of models, the longest first.
static NAMES_AND_IDS: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    let names = |model: &Model| (model.name().to_string(), model.id().to_string());
    let mut all: Vec<_> = Model::named().iter().map(names).collect();
    all.retain(|(_, id)| id.contains('-'));
    all.sort_by_key(|(name, _)| std::cmp::Reverse(name.len()));
    all
});

/// A finding as the page shows it.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct FindingShown {
    pub(crate) code: &'static str,
    pub(crate) severity: Severity,
    /// The path of the field of the form, or the name of another number.
    pub(crate) field: String,
    pub(crate) message: String,
}

impl From<&Finding> for FindingShown {
    fn from(found: &Finding) -> Self {
        let (code, severity, field) = (found.code, found.severity, found.field.to_string());
        Self { code, severity, field, message: readable(&found.message()) }
    }
}

/// All findings as shown, with the models that the scene has: of random asperities those for them.
/// Where contacts merge, no model of asperities is advised.
pub(crate) fn findings(all: &Findings, file: &SceneFile) -> Vec<FindingShown> {
    let of_scene = |id: &str| file.model(id).map_or(id.to_string(), |model| model.id().into());
    let yielding = YIELDING.split(" or ").map(of_scene).collect::<Vec<_>>().join(" or ");
    let merged = all.into_iter().any(|found| found.code == "crowded");
    let (advice, own) = (format!("; use {YIELDING}"), format!("; use {yielding}"));
    let own = if merged { "" } else { own.as_str() };
    let shown = |found: &Finding| {
        let found = FindingShown::from(found);
        let message = found.message.replace(&advice, own).replace(YIELDING, &yielding);
        FindingShown { message, ..found }
    };
    all.into_iter().map(shown).collect()
}

/// The name of a quantity in tables and sentences; the tangent stiffness is that on first loading.
pub(crate) fn quantity_name(quantity: Quantity) -> String {
    match quantity {
        Quantity::Tangent => format!("{} (first loading)", quantity.label()),
        _ => quantity.label().into(),
    }
}

/// A message without commands of the program, with models as legends have them; keys stay.
pub(crate) fn without_commands(message: &str) -> String {
    let text = PROGRAM.iter().fold(message.to_string(), |text, (from, to)| text.replace(from, to));
    with_ids(&text)
}

/// A text with variants of models by their ids, as legends have them: `persson-fudge`.
pub(crate) fn with_ids(text: &str) -> String {
    NAMES_AND_IDS.iter().fold(text.to_string(), |text, (name, id)| text.replace(name, id))
}

/// A message with names in place of keys and Greek letters; a key that is assigned stays.
pub(crate) fn readable(message: &str) -> String {
    let text = without_commands(message);
    let part = |c: char| c.is_ascii_alphanumeric() || "_-[].".contains(c);
    let (mut made, mut rest) = (String::new(), &text[..]);
    while let Some(first) = rest.chars().next() {
        if let Some(length) = literal(rest) {
            made += &rest[..length];
            rest = &rest[length..];
            continue;
        }
        let end = rest.find(|c| !part(c)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(if end == 0 { first.len_utf8() } else { end });
        let bare = word.trim_end_matches(['.', '-', ']']);
        // Behind a colon it is a number of the scene, and no key to set.
        let assigned = after.starts_with(" = ") && !made.ends_with(": ");
        let kept = assigned || after.starts_with('`');
        // Behind a number it is the unit of a separation.
        let is_unit = bare == "asperity_height_std"
            && made.ends_with(' ')
            && made.trim_end().ends_with(|c: char| c.is_ascii_digit());
        made += &match (kept, is_unit) {
            (_, true) => "σ_z".into(),
            (true, _) => greek(bare),
            _ => name(bare),
        };
        made += &word[bare.len()..];
        rest = after;
    }
    squared(&made)
}

/// The length of a quoted text, a path or the name of a file that a message begins with.
fn literal(text: &str) -> Option<usize> {
    if let Some(quoted) = text.strip_prefix('"') {
        return quoted.find('"').map(|end| end + 2);
    }
    let word = text.split(|c: char| c.is_whitespace() || "`\"(),;:".contains(c)).next()?;
    let word = word.trim_end_matches('.');
    let is_file_name = word.rsplit_once('.').is_some_and(|(stem, extension)| {
        let sections = ["surface", "body", "heights"];
        let is_key = sections.contains(&stem) || stem.ends_with(']');
        !is_key && stem.contains('_') && extension.starts_with(|c: char| c.is_ascii_alphabetic())
    });
    let is_path = word.contains('/') && word.starts_with(['/', '.', '~']);
    (is_path || is_file_name).then_some(word.len())
}

/// The name of a key, or the word itself.
fn name(word: &str) -> String {
    // body[1].hardness
    if let Some((section, key)) = word.split_once("].").filter(|(start, _)| start.contains('[')) {
        let (section, number) = section.split_once('[').unwrap_or((section, ""));
        return format!("{} of {section} {number}", name(key));
    }
    let key = word.rsplit_once('.').filter(|(section, _)| *section == "surface");
    let key = key.map_or(word, |(_, key)| key);
    let known = KEYS.iter().find(|(known, _)| *known == key);
    let quantity = key.replace('_', "-").parse::<Quantity>().ok();
    match (known, quantity.filter(|_| key.contains(['_', '-']))) {
        (Some((_, name)), _) => (*name).into(),
        (None, Some(quantity)) => quantity_name(quantity),
        // Symbols have a letter before their index: w_c.
        _ if key.split('_').all(|part| part.len() > 1) && greek(key) == key => {
            key.replace('_', " ")
        }
        _ => greek(key),
    }
}

/// A symbol in Greek: `sigma_z` as σ_z.
fn greek(word: &str) -> String {
    let (letter, index) = word.split_once('_').map_or((word, None), |(a, b)| (a, Some(b)));
    let known = GREEK.iter().find(|(latin, _)| *latin == letter);
    match (known, index) {
        (Some((_, greek)), None) => (*greek).into(),
        (Some((_, greek)), Some(index)) if index.len() == 1 => format!("{greek}_{index}"),
        _ => word.into(),
    }
}

/// Squares and cubes as raised digits.
fn squared(text: &str) -> String {
    let mut made = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('^') {
        made += before;
        let digits = after.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(after.len());
        let raised = match after.get(..digits) {
            Some("2") => Some("²"),
            Some("3") => Some("³"),
            _ => None,
        };
        made += raised.unwrap_or("^");
        rest = if raised.is_some() { &after[1..] } else { after };
    }
    made + rest
}

#[cfg(test)]
mod tests {
    use asperity::At;
    use asperity_inputs::{HandedFiles, parse_handed};

    use super::*;
    use crate::surface_keys::with_scan;

    #[test]
    fn messages_have_names_of_tables_and_no_keys() {
        for (message, wanted) in [
            (
                "area_fraction is 0.2 at a load of 1 N",
                "real over nominal area is 0.2 at a load of 1 N",
            ),
            ("gao has no law for unloading-stiffness", "gao has no law for unloading stiffness"),
            ("interference_over_critical is 9.", "interference over critical is 9."),
            ("asperity_height_std is 2", "height std σ_z is 2"),
            ("a separation of -3 asperity_height_std", "a separation of -3 σ_z"),
            ("body[1].youngs_modulus is 210 Pa", "Young's modulus of body 1 is 210 Pa"),
            ("psi = sqrt(sigma_z/w_c), by Chang", "ψ = √(σ_z/w_c), by Chang"),
            ("w_c = (pi S H/(2 E))^2 R", "w_c = (π S H/(2 E))² R"),
            ("theta = E sigma_z^1.5/(w_a sqrt(R))", "θ = E σ_z^1.5/(w_a √(R))"),
            ("set max_missing = 0.5, or", "set max_missing = 0.5, or"),
            ("use jkr-separation or ke-random", "use jkr-separation or ke-random"),
            ("surface.file is µm long – é", "file is µm long – é"),
            ("my_scan.x3p is empty", "my_scan.x3p is empty"),
            ("in ./my_scans/of_steel: no", "in ./my_scans/of_steel: no"),
            ("channel \"yield_strength\" is", "channel \"yield_strength\" is"),
            ("body[1].hardness or yield_strength.", "hardness of body 1 or yield strength."),
            ("is close: plasticity_index = 14.5", "is close: plasticity index = 14.5"),
            ("(alpha 8, psi 2)", "(α 8, ψ 2)"),
            (
                "(likewise Persson fudge, JG cosine random)",
                "(likewise persson-fudge, jg-cosine-random)",
            ),
        ] {
            assert_eq!(readable(message), wanted);
        }
    }

    #[test]
    fn findings_name_models_that_the_scene_has() {
        let text = include_str!("../../asperity-inputs/examples/ground-steel.toml");
        let file = asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        let model = file.model("persson-fudge").unwrap();
        let found = file.findings_at(&model, &[asperity::At::Pressure(1e9)]);
        let shown = findings(&found, &file);
        assert!(shown.iter().any(|found| found.message.ends_with("use ke-random or jg-random")));
    }

    #[test]
    fn where_contacts_merge_no_model_of_asperities_is_advised() {
        let file = asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new("."));
        let file = file.unwrap();
        let messages = |pressure: f64| {
            let found = |id: &str| {
                let at = [asperity::At::Pressure(pressure)];
                file.findings_at(&file.model(id).unwrap(), &at).into_iter()
            };
            let all = ["gw", "ke"].into_iter().flat_map(found).collect();
            findings(&all, &file).into_iter().map(|found| found.message).collect::<String>()
        };
        assert!(messages(1e7).contains("use ke or jg"), "{}", messages(1e7));
        let merged = messages(5e8);
        assert!(merged.contains("GW ignores yielding") && merged.contains("contacts merge"));
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
        let text = with_scan(asperity_inputs::template(), "scan.txt").unwrap();
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
        let merged = file.findings_at(&ke, &[At::Pressure(1e11)]);
        let messages = [
            merged.iter().map(Finding::to_string).collect(),
            file.surface_shape().unwrap_err().to_string(),
            refused("material = \"unobtainium\""),
            refused("material = \"steel-a36\"\nhardness = 2e9"),
            check.findings.iter().map(Finding::to_string).collect(),
            file.warnings.iter().map(Finding::to_string).collect(),
        ];
        assert_eq!(messages.len(), PROGRAM.len());
        for (message, (advice, instead)) in messages.iter().zip(PROGRAM) {
            let (before, after) = message.split_once(advice).unwrap_or_else(|| panic!("{message}"));
            let shown = without_commands(message);
            let before = without_commands(before);
            let rest = shown.strip_prefix(&format!("{before}{instead}")).unwrap_or_default();
            assert_eq!(rest, without_commands(after), "{shown}");
            assert!(!shown.contains("`asperity") && !shown.contains("--"), "{shown}");
        }
    }
}
