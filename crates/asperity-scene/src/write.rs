//! Scene files to begin with: the template, and scenes written down.

use std::fmt::Write;

use asperity::{HeightDistribution, Scene};

use crate::ModelOptions;

/// A commented scene file with every key there is: steel on steel, machined.
#[must_use]
pub fn template() -> &'static str {
    include_str!("template.toml")
}

/// A scene file of this scene, which reads back exactly; `comments` go to its head, one a line.
///
/// Heights that are neither Gaussian nor exponential stand in a file of their own: `heights_file`
/// names it, as a path relative to the scene file.
#[must_use]
pub fn write(
    scene: &Scene,
    options: &ModelOptions,
    heights_file: Option<&str>,
    comments: &[&str],
) -> String {
    let mut text = String::new();
    for line in comments.iter().flat_map(|comment| comment.lines()) {
        line_of(&mut text, &format!("# {}", line.replace(|c: char| c.is_control(), " ")));
    }
    let number = |text: &mut String, key: &str, value: Option<f64>, unit: &str| {
        if let Some(value) = value {
            line_of(text, &format!("{key} = {value:e}{unit}"));
        }
    };
    let (interface, surface) = (&scene.interface, &scene.surface);
    number(&mut text, "nominal_area", Some(scene.nominal_area), "  # m^2");
    text.push_str("\n[interface]\n");
    for (key, value, unit) in [
        ("equivalent_modulus", Some(interface.equivalent_modulus), "  # Pa"),
        ("equivalent_shear_modulus", interface.equivalent_shear_modulus, "  # Pa"),
        ("poissons_ratio", Some(interface.poissons_ratio), "  # of the softer body"),
        ("hardness", interface.hardness, "  # Pa, of the softer body"),
        ("yield_strength", interface.yield_strength, "  # Pa, of the softer body"),
        ("pressure_factor", interface.pressure_factor, ""),
    ] {
        number(&mut text, key, value, unit);
    }
    text.push_str("\n[surface]\n");
    number(&mut text, "asperity_radius", Some(surface.asperity_radius), "  # m");
    number(&mut text, "asperity_density", Some(surface.asperity_density), "  # 1/m^2");
    number(&mut text, "asperity_height_std", Some(surface.asperity_height_std), "  # m");
    match (heights_file, &scene.heights) {
        (Some(file), _) => {
            let file = toml::Value::String(file.into());
            line_of(&mut text, &format!("heights = {{ file = {file} }}"));
        }
        (None, HeightDistribution::Exponential) => line_of(&mut text, "heights = \"exponential\""),
        (None, _) => {}
    }
    let changed = options.changed();
    if !changed.is_empty() {
        text.push_str("\n[options]\n");
        for (name, value) in changed {
            line_of(&mut text, &format!("{name} = {value}"));
        }
    }
    text
}

fn line_of(text: &mut String, line: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{line}");
}
