//! Materials by name, each with the source of its numbers.

use std::sync::LazyLock;

use asperity::Body;
use serde::Serialize;

/// Where numbers were read, by the word of the list.
const SOURCES: [(&str, &str); 16] = [
    ("aisi304", "AISI 304 data sheet, scribd.com/document/416534641"),
    (
        "callister",
        "Callister & Rethwisch, Fundamentals of Materials Science and Engineering, 3rd ed., tables B.2 and B.4",
    ),
    ("callister8", "Callister & Rethwisch, Materials Science and Engineering, 8th ed., table B.3"),
    ("ecourses", "Multimedia Engineering Mechanics, material properties, ecoursesbook.com"),
    (
        "gere",
        "Gere, Mechanics of Materials, 5th ed., elastic constants at ah-engr.com (middle of a range)",
    ),
    ("hibbeler", "table of material properties (Hibbeler, Mechanics of Materials, appendix)"),
    ("incropera", "thermal properties of metals at 300 K, Incropera table A.1"),
    ("jaluria", "Jaluria, Design and Optimization of Thermal Systems, table B.5"),
    ("lucefin", "Lucefin Group, technical card 100Cr6"),
    ("matweb-ti", "ASM data sheet Ti-6Al-4V annealed bar, asm.matweb.com MTP644"),
    ("mitchell", "Mitchell, An Introduction to Materials Engineering and Science, appendix 8"),
    ("polymers", "engineeringtoolbox.com, physical properties of polymers (Brinell hardness)"),
    ("toolbox", "engineeringtoolbox.com, Poisson's ratio (middle of a range)"),
    ("triton", "table of material constants, academics.triton.edu/faculty/fheitzman"),
    ("valley", "Valley Design, soda lime float glass"),
    ("xycera", "XY Ceramic, properties of zirconia Z-200"),
];

/// A material of the list: typical numbers at room temperature, for orientation.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Material {
    /// The name in scene files: `steel-100cr6`.
    pub id: String,
    /// The name in text, with its condition.
    pub name: String,
    /// Its numbers.
    #[serde(flatten)]
    pub body: Body,
    /// Where the numbers were read.
    pub source: String,
}

/// All materials, metals first.
#[must_use]
pub fn materials() -> &'static [Material] {
    static ALL: LazyLock<Vec<Material>> = LazyLock::new(|| {
        let mut reader = csv::Reader::from_reader(include_str!("materials.csv").as_bytes());
        reader.records().filter_map(|record| material(&record.ok()?)).collect()
    });
    &ALL
}

/// The material of an id.
pub(crate) fn named(id: &str) -> Option<&'static Material> {
    materials().iter().find(|material| material.id == id)
}

fn material(record: &csv::StringRecord) -> Option<Material> {
    let number = |k: usize| record.get(k).and_then(|text| text.parse::<f64>().ok());
    let mut body = Body::elastic(number(2)?, number(3)?);
    body.hardness = number(4);
    body.yield_strength = number(5);
    body.thermal_conductivity = number(6);
    body.electrical_resistivity = number(7);
    let source = |word: &str| SOURCES.iter().find(|(known, _)| *known == word).map(|(_, s)| *s);
    let source: Option<Vec<&str>> = record.get(8)?.split(' ').map(source).collect();
    let (id, name) = (record.get(0)?.into(), record.get(1)?.into());
    Some(Material { id, name, body, source: source?.join("; ") })
}

#[cfg(test)]
mod tests {
    use asperity::Interface;

    use super::*;

    #[test]
    fn every_line_is_a_material_with_a_source_and_plausible_numbers() {
        let lines = include_str!("materials.csv").lines().count() - 1;
        assert!(materials().len() == lines && lines >= 25, "{lines} {}", materials().len());
        let mut ids: Vec<&str> = materials().iter().map(|material| &*material.id).collect();
        for Material { id, body, source, .. } in materials() {
            assert!(!source.is_empty(), "{id}");
            Interface::against_rigid(body).unwrap();
            let found = body.findings();
            assert!(
                found.iter().all(|f| f.severity != asperity::Severity::Error),
                "{id}: {found:?}"
            );
            let yields = body.hardness.or(body.yield_strength).is_some();
            assert!(yields || id == "rubber", "{id} has neither hardness nor yield strength");
        }
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), lines);
        for (word, _) in SOURCES {
            let used = |line: &str| {
                line.rsplit(',').next().is_some_and(|s| s.split(' ').any(|s| s == word))
            };
            assert!(include_str!("materials.csv").lines().any(used), "{word} is not used");
        }
    }
}
