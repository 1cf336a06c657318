//! Scenes written down.

use asperity::{HeightDistribution, Scene};
use toml::{Table, Value};

use crate::ModelOptions;
use crate::template::key;

/// A scene file of this scene, which reads back exactly; `comments` go to its head, one a line.
///
/// Heights that are neither Gaussian nor exponential nor skewed stand in a file of their own: `heights_file`
/// names it, as a path relative to the scene file.
#[must_use]
pub fn write(
    scene: &Scene,
    options: &ModelOptions,
    heights_file: Option<&str>,
    comments: &[&str],
) -> String {
    let note = |line: &str| format!("# {}\n", line.replace(|c: char| c.is_control(), " "));
    let mut text: String = comments.iter().flat_map(|c| c.lines()).map(note).collect();
    // Structs of numbers: each of them is a table.
    let [interface, mut surface] =
        [Table::try_from(scene.interface), Table::try_from(scene.surface)]
            .map(Result::unwrap_or_default);
    let heights = match (heights_file, &scene.heights) {
        (Some(file), _) => Some(Value::from(Table::from_iter([("file".into(), file.into())]))),
        (None, HeightDistribution::Exponential) => Some("exponential".into()),
        (None, HeightDistribution::Weibull(heights)) => {
            Some(Value::from(Table::from_iter([("skewness".into(), heights.skewness().into())])))
        }
        (None, _) => None,
    };
    surface.extend(heights.map(|heights| ("heights".into(), heights)));
    let options = Table::try_from(options.changed()).unwrap_or_default();
    let top = Table::from_iter([("nominal_area".into(), scene.nominal_area.into())]);
    for (header, table) in
        [("", top), ("[interface]", interface), ("[surface]", surface), ("[options]", options)]
    {
        if !header.is_empty() && !table.is_empty() {
            text += &format!("\n{header}\n");
        }
        for (name, value) in table {
            let (value, meaning) = match value {
                Value::Float(number) => {
                    let key = key(header.trim_matches(['[', ']']), &name);
                    (format!("{number:e}"), key.map_or("", |key| key.meaning))
                }
                other => (other.to_string(), ""),
            };
            let gap = if meaning.is_empty() { "" } else { "  # " };
            text += &format!("{name} = {value}{gap}{meaning}\n");
        }
    }
    text
}
