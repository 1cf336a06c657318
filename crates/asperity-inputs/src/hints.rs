//! Suggestions for refused keys and values.

use asperity::nearest_name;
use toml::de::Error;

use crate::document::{Document, shorten};
use crate::error::{Needed, SceneError};
use crate::notation::{notation_hint, with_decimal_point};
use crate::slopes::{gradient, is_angle};
use crate::template::{joined, key};

impl Document<'_> {
    /// Converts an error of serde: the place, the value found and a similar name.
    pub(crate) fn explain(&self, error: &Error) -> SceneError {
        let message = error.message();
        let span = error.span().unwrap_or(0..self.text.len());
        // Keys inside the span come first; the smallest range around it is the key itself.
        let around =
            self.keys.iter().filter(|(_, key)| key.start <= span.start && span.end <= key.end);
        let path = around.min_by_key(|(_, range)| range.len()).map_or("", |(path, _)| path);
        let missing = message.strip_prefix("missing field `");
        let path = joined(path, missing.map_or("", |name| name.trim_end_matches('`')));
        let (section, name) = section_and_name(&path);
        let meaning = key(section, name).map_or("", |key| key.meaning);
        if missing.is_some() {
            return self.missing(&path, meaning);
        }
        let needed = message.rsplit_once(", expected ").map_or(message, |(_, needed)| needed);
        if message.starts_with("unknown field `") {
            let keys: Vec<&str> = needed.split('`').skip(1).step_by(2).collect();
            return self.unknown(&path, &keys);
        }
        let found = shorten(self.text.get(span).unwrap_or_default()).replace(char::is_control, " ");
        let length = in_quotes(&found).filter(|_| needed.starts_with("a length "));
        if let Some(hint) = length.and_then(notation_hint) {
            return SceneError::Notation { at: self.place(&path), found, hint };
        }
        let without_quotes = plain_number(name, &found).filter(|_| needed == "f64");
        let needed: Needed = match needed {
            _ if without_quotes.is_some() => without_quotes.unwrap_or_default().into(),
            "f64" => Needed::Number(meaning),
            "a boolean" => "true or false".into(),
            "a sequence" if path == "body" => {
                format!("a list ({meaning}), each written [[body]],").into()
            }
            "a sequence" => format!("a list ({meaning})").into(),
            "path string" => format!("the path of a file, in quotes ({meaning}),").into(),
            other if other.starts_with("wanted ") => "a name in quotes".into(),
            "floating-point number overflowed" => "a number of at most 1.8e308".into(),
            names => names.replace('`', "\"").into(),
        };
        let allowed = needed.to_string();
        // A number in quotes is an example, not a name.
        let names = allowed.split('"').skip(1).step_by(2);
        let names = names.filter(|name| !name.starts_with(|c: char| c.is_ascii_digit()));
        let near = nearest_name(found.trim_matches('"'), names);
        let near = near.map(Into::into).or_else(|| near_table(&found, &allowed));
        SceneError::Value { at: self.place(&path), found, near, needed }
    }

    /// The error for an unknown key of a section.
    pub(crate) fn unknown(&self, path: &str, keys: &[&str]) -> SceneError {
        let (section, name) = section_and_name(path);
        let mut allowed = format!("the keys here are {}", keys.join(", "));
        let mut elsewhere = key(section, name);
        let mut near = match elsewhere {
            None => nearest_name(name, keys.iter().copied()),
            Some(_) => None,
        };
        if let Some((other, difference)) = synonym(name) {
            near = Some(other);
            // A single body has no work of adhesion.
            elsewhere = key("", other).filter(|_| !keys.contains(&other));
            allowed = format!("{difference}{allowed}");
        }
        if let Some(key) = elsewhere {
            let top = "the top of the file, above every [section]";
            let home = if key.section.is_empty() { top } else { key.section };
            allowed = format!("it belongs to {home}; {allowed}");
        }
        SceneError::UnknownKey { at: self.place(path), near: near.map(Into::into), allowed }
    }
}

/// The text in quotes.
fn in_quotes(found: &str) -> Option<&str> {
    found.strip_prefix('"')?.strip_suffix('"')
}

/// The number needed instead of a text, of a key without a unit.
fn plain_number(name: &str, found: &str) -> Option<String> {
    let text = in_quotes(found)?;
    let slope = gradient(text).filter(|_| ["sdq", "mean_slope"].contains(&name));
    if let Some(slope) = slope.map(asperity::short) {
        let given = with_decimal_point(text).unwrap_or(text.into());
        return Some(format!("the number {slope} without quotes, as {given} is {slope},"));
    }
    if is_angle(text) && ["sdq", "mean_slope"].contains(&name) {
        return Some("a gradient, or an angle between 0 and 90 deg,".into());
    }
    let number = with_decimal_point(text).unwrap_or(text.into());
    number
        .parse::<f64>()
        .is_ok_and(f64::is_finite)
        .then(|| format!("the number {number} without quotes"))
}

/// The section of a path and its last key, without numbers of bodies.
fn section_and_name(path: &str) -> (&str, &str) {
    let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
    let bare = |name: &'_ str| name.find('[').unwrap_or(name.len());
    (&section[..bare(section)], &name[..bare(name)])
}

/// The key for a synonym, and how it differs.
pub(crate) fn synonym(name: &str) -> Option<(&'static str, &'static str)> {
    let inverse = "it is 1/conductivity, in ohm m; ";
    Some(match name.to_lowercase().as_str() {
        "electrical_conductivity" | "electric_conductivity" => ("electrical_resistivity", inverse),
        "resistivity" | "electric_resistivity" => ("electrical_resistivity", ""),
        "conductivity" | "heat_conductivity" => ("thermal_conductivity", ""),
        "h" | "vickers" | "brinell" => ("hardness", ""),
        "r" | "radius" | "tip_radius" => ("asperity_radius", ""),
        "eta" | "density" => ("asperity_density", ""),
        "sigma" | "sigma_z" => (
            "asperity_height_std",
            "it is the std of the asperity heights, and that of the surface is surface_height_std; ",
        ),
        "psi" => ("plasticity_index", ""),
        "a_n" | "area" => ("nominal_area", ""),
        "yield_stress" | "yield" | "sy" | "rp02" => ("yield_strength", ""),
        "e" | "young_modulus" | "elastic_modulus" => ("youngs_modulus", ""),
        "nu" | "poisson_ratio" | "poisson" => ("poissons_ratio", ""),
        "rdq" | "rms_slope" | "rms_gradient" => ("sdq", "it is the rms gradient of the surface; "),
        "ra" | "rq" | "sa" | "rms" | "roughness" => (
            "surface_height_std",
            "it is Sq, which for Gaussian heights is 1.25 Sa; Ra or Rq alone does not describe a surface; ",
        ),
        "adhesion" | "adhesion_energy" | "surface_energy" | "energy_of_adhesion" | "gamma" => {
            ("work_of_adhesion", "it is gamma1 + gamma2 - gamma12 of the pair, in J/m^2; ")
        }
        _ => return None,
    })
}

/// The first key of the allowed tables, such as `{ skewness = -0.5 }`, that begins like the key
/// found or is similar to it.
fn near_table(found: &str, needed: &str) -> Option<String> {
    let key = |text: &str| Some(text.split_once('=')?.0.trim().to_string());
    let given = key(found.trim_start().strip_prefix('{')?)?;
    let keys: Vec<String> = needed.split('{').skip(1).filter_map(key).collect();
    let begun = keys.iter().find(|keys| given.len() > 2 && keys.starts_with(&given));
    let near = || nearest_name(&given, keys.iter().map(String::as_str));
    let near = begun.map(String::as_str).or_else(near);
    near.filter(|near| *near != given).map(Into::into)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_tables_are_found_by_prefix_or_similarity() {
        let needed = "\"gaussian\" or { skewness = -0.5 } or { file = \"pdf.csv\" }";
        for (found, wanted) in [
            ("{ skew = -0.6 }", Some("skewness")),
            ("{ skewnes = -0.6 }", Some("skewness")),
            ("{ flie = \"a\" }", Some("file")),
            ("{ skewness = \"a\" }", None),
            ("{ kurtosis = 3 }", None),
            ("{}", None),
        ] {
            assert_eq!(near_table(found, needed).as_deref(), wanted, "{found}");
        }
    }

    #[test]
    fn a_path_has_a_section_and_a_name() {
        for (path, wanted) in [
            ("body[2].hardness", ("body", "hardness")),
            ("body[2]", ("", "body")),
            ("surface.m0", ("surface", "m0")),
            ("", ("", "")),
        ] {
            assert_eq!(section_and_name(path), wanted);
        }
    }
}
