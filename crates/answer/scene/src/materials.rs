//! Materials by name, each with the source of its numbers.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use asperity::Body;
use serde::Serialize;

use crate::keys::BODY;
use crate::quantity::quantity_of;

/// A material of the list: typical numbers at room temperature, for orientation.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Material {
    /// The name in scene files: `steel-100cr6`.
    pub id: String,
    /// The name in text, with its condition.
    pub name: String,
    /// Its numbers. The hardness is that of the hardened metal, and laws that take a yield strength
    /// take the one that follows from it.
    #[serde(flatten)]
    pub body: Body,
    /// The strength at which the metal begins to yield \[Pa\], before it hardens.
    #[serde(skip)]
    pub yield_strength: Option<f64>,
    /// Where the numbers were read.
    pub source: String,
    /// Other names in scene files: European ones, `C45`.
    #[serde(skip)]
    also: Vec<String>,
}

/// The hardness over the yield strength of nine of ten materials of the list.
pub(crate) const METALS_HARDNESS_OVER_YIELD: [f64; 2] = [3.3, 7.8];

/// All materials, metals first.
#[must_use]
pub fn materials() -> &'static [Material] {
    static ALL: LazyLock<Vec<Material>> = LazyLock::new(|| {
        let sources = rows(include_str!("sources.csv"));
        let sources = sources.iter().filter_map(|row| Some((row.get("word")?, row.get("source")?)));
        let sources: Record =
            sources.map(|(word, source)| (word.clone(), source.clone())).collect();
        rows(include_str!("materials.csv"))
            .iter()
            .filter_map(|row| material(row, &sources))
            .collect()
    });
    &ALL
}

/// The cells of a row by the head of their column.
type Record = BTreeMap<String, String>;

fn rows(text: &str) -> Vec<Record> {
    csv::Reader::from_reader(text.as_bytes()).into_deserialize().filter_map(Result::ok).collect()
}

/// A material, whose numbers are named as the keys of a body.
fn material(row: &Record, sources: &Record) -> Option<Material> {
    let number = |name: &str| {
        let cell = row.get(name).filter(|cell| !cell.is_empty())?;
        quantity_of(name, cell).ok()
    };
    let mut body = Body::elastic(number("youngs_modulus")?, number("poissons_ratio")?);
    for field in BODY {
        if let Some(number) = number(field.name) {
            (field.set)(&mut body, number);
        }
    }
    let yield_strength = body.yield_strength.take();
    let words = row.get("sources")?.split(' ').map(|word| sources.get(word).map(String::as_str));
    let source = words.collect::<Option<Vec<_>>>()?.join("; ");
    let [id, name] = ["id", "name"].map(|name| row.get(name).cloned().unwrap_or_default());
    let also = row.get("also")?.split_whitespace().map(String::from).collect();
    Some(Material { id, name, body, yield_strength, source, also })
}

/// The material of an id or another name.
pub(crate) fn named(id: &str) -> Option<&'static Material> {
    let is_also =
        |material: &&Material| material.also.iter().any(|name| name.eq_ignore_ascii_case(id));
    let by_id = materials().iter().find(|material| material.id == id);
    by_id.or_else(|| materials().iter().find(is_also))
}

/// The ids and other names of all materials.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    materials().iter().flat_map(|one| one.also.iter().chain([&one.id])).map(String::as_str)
}

/// The materials whose id or name contains a word: `steel`, `6082`.
#[must_use]
pub fn materials_like(word: &str) -> Vec<&'static Material> {
    let word = word.trim().to_lowercase();
    let contains = |material: &&Material| {
        let names = material.also.iter().chain([&material.id, &material.name]);
        let is_named = |part: &str| names.clone().any(|name| name.to_lowercase().contains(part));
        word.split([' ', '-', '/']).filter(|part| !part.is_empty()).all(is_named)
    };
    materials().iter().filter(contains).collect()
}

#[cfg(test)]
mod tests {
    use asperity::Interface;

    use super::*;

    #[test]
    fn words_find_materials() {
        let ids = |word| -> Vec<&str> {
            materials_like(word).iter().map(|material| &*material.id).collect()
        };
        assert!(ids("steel").len() > 8 && ids("steel").contains(&"stainless-304"));
        assert_eq!(ids("silicon"), ["silicon"]);
        // Words in any order, of which the list has others between them.
        assert_eq!(ids("alu 6082"), ["aluminium-6082-t6"]);
        assert_eq!(ids("steel-42CrMo4"), ["steel-42crmo4-qt"]);
        assert!(ids("unobtainium").is_empty());
    }

    #[test]
    fn european_names_are_those_of_materials() {
        for name in [
            "42CrMo4",
            "C45",
            "S355",
            "6082",
            "X5CrNi18-10",
            "GJL-250",
            "16MnCr5",
            "CuZn39Pb3",
            "R260",
            "er7",
        ] {
            assert!(named(name).is_some_and(|one| one.body.hardness.is_some()), "{name}");
        }
        let mut names: Vec<String> =
            materials().iter().flat_map(|one| one.also.iter().chain([&one.id])).cloned().collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
    }

    /// From 5 to 95 per cent of the materials that have both; soft aluminium lies inside.
    #[test]
    fn hardness_over_yield_is_that_of_the_list() {
        let ratio = |one: &Material| Some(one.body.hardness? / one.yield_strength?);
        let mut ratios: Vec<f64> = materials().iter().filter_map(ratio).collect();
        ratios.sort_by(f64::total_cmp);
        for (share, wanted) in [0.05, 0.95].into_iter().zip(METALS_HARDNESS_OVER_YIELD) {
            let place = share * (ratios.len() - 1) as f64;
            let (below, part) = (place as usize, place.fract());
            let found = ratios[below] + part * (ratios[below + 1] - ratios[below]);
            assert!((found / wanted - 1.0).abs() < 0.02, "{found}");
        }
        let [from, to] = METALS_HARDNESS_OVER_YIELD.map(|ratio| 250e6 * ratio);
        assert!((from..to).contains(&asperity::hardness_of_vickers(107.0)));
    }

    #[test]
    fn every_line_is_a_material_with_a_source_and_plausible_numbers() {
        let lines = include_str!("materials.csv").lines().count() - 1;
        assert!(materials().len() == lines && lines >= 25, "{lines} {}", materials().len());
        let mut ids: Vec<&str> = materials().iter().map(|material| &*material.id).collect();
        for Material { id, body, source, .. } in materials() {
            assert!(!source.is_empty(), "{id}");
            Interface::against_rigid(body).unwrap();
            let found = asperity::Plausible::findings(body);
            assert!(!found.are_implausible(), "{id}: {found:?}");
            assert!(body.hardness.is_some() || id == "rubber", "{id}");
        }
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), lines);
        for word in rows(include_str!("sources.csv")).iter().map(|row| &row["word"]) {
            let used = |line: &str| {
                line.rsplit(',').next().is_some_and(|s| s.split(' ').any(|s| s == word))
            };
            assert!(include_str!("materials.csv").lines().any(used), "{word} is not used");
        }
    }
}
