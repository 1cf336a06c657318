//! `[interface]`, or the bodies from which it follows.

use asperity::{Body, Interface};
use serde::Deserialize;

use crate::SceneError;
use crate::document::{Document, shorten};
use crate::materials::{named, suggestion};
use crate::template::key;

/// The keys of the bodies in contact.
#[derive(Deserialize)]
pub(crate) struct InterfaceKeys {
    rigid_counterface: Option<bool>,
    work_of_adhesion: Option<f64>,
    interface: Option<Interface>,
    #[serde(default)]
    body: Vec<BodyKeys>,
}

/// The keys of `[[body]]`: a material of the list, or its numbers.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BodyKeys {
    material: Option<String>,
    youngs_modulus: Option<f64>,
    poissons_ratio: Option<f64>,
    hardness: Option<f64>,
    yield_strength: Option<f64>,
    tangent_modulus: Option<f64>,
    thermal_conductivity: Option<f64>,
    electrical_resistivity: Option<f64>,
}

impl BodyKeys {
    /// The body, with the numbers of its material unless it has its own.
    fn body(&self, document: &Document<'_>, section: &str) -> Result<Body, SceneError> {
        let path = |name: &str| format!("{section}.{name}");
        let mut body = match &self.material {
            Some(id) => {
                let given = [
                    ("youngs_modulus", self.youngs_modulus),
                    ("poissons_ratio", self.poissons_ratio),
                    ("hardness", self.hardness),
                    ("yield_strength", self.yield_strength),
                ];
                if let Some((name, _)) = given.into_iter().find(|(_, value)| value.is_some()) {
                    let needed = "the material alone, or instead of it the numbers that `asperity materials` lists, changed as needed,";
                    return Err(document.conflict(&path("material"), &path(name), needed));
                }
                named(id).map(|material| material.body).ok_or_else(|| {
                    let (near, needed) = suggestion(id);
                    SceneError::Value {
                        at: document.place(&path("material")),
                        found: format!("{:?}", shorten(id)),
                        near: near.map(Into::into),
                        needed: needed.into(),
                    }
                })?
            }
            None => {
                let required = |name: &str, value: Option<f64>| {
                    let meaning = || key("body", name).map_or("", |key| key.meaning);
                    value.ok_or_else(|| document.missing(&path(name), meaning()))
                };
                let modulus = required("youngs_modulus", self.youngs_modulus)?;
                Body::elastic(modulus, required("poissons_ratio", self.poissons_ratio)?)
            }
        };
        body.hardness = self.hardness.or(body.hardness);
        body.yield_strength = self.yield_strength.or(body.yield_strength);
        body.tangent_modulus = self.tangent_modulus;
        body.thermal_conductivity = self.thermal_conductivity.or(body.thermal_conductivity);
        body.electrical_resistivity = self.electrical_resistivity.or(body.electrical_resistivity);
        Ok(body)
    }
}

const EITHER: &str = "either [interface] with the equivalent properties, or the two bodies as [[body]] (one with rigid_counterface = true)";

/// The interface of a scene, its section, and its bodies.
pub(crate) fn interface(
    document: &Document<'_>,
    keys: &InterfaceKeys,
) -> Result<(Interface, &'static str, Vec<Body>), SceneError> {
    let bodies = keys.body.iter().zip(1..);
    let bodies: Result<Vec<Body>, _> =
        bodies.map(|(body, k)| body.body(document, &format!("body[{k}]"))).collect();
    let bodies = bodies?;
    let (mut found, section) = from_section_or_bodies(document, keys, &bodies)?;
    if keys.work_of_adhesion.is_some() {
        if keys.interface.is_some() {
            let needed = "work_of_adhesion in [interface], or above the bodies,";
            return Err(document.conflict("work_of_adhesion", "interface", needed));
        }
        // The work of adhesion is a property of the pair.
        found.work_of_adhesion = keys.work_of_adhesion;
        found.check().map_err(document.refused(""))?;
    }
    Ok((found, section, bodies))
}

fn from_section_or_bodies(
    document: &Document<'_>,
    keys: &InterfaceKeys,
    bodies: &[Body],
) -> Result<(Interface, &'static str), SceneError> {
    let conflict = |one, other, needed| Err(document.conflict(one, other, needed));
    // Each body is checked alone, so that the error names the body.
    let alone = |body, section| Interface::against_rigid(body).map_err(document.refused(section));
    match (&keys.interface, bodies, keys.rigid_counterface) {
        (Some(_), [_, ..], _) => conflict("interface", "body", EITHER),
        (Some(_), [], Some(_)) => {
            conflict("rigid_counterface", "interface", "rigid_counterface with one [[body]] only")
        }
        (Some(interface), [], None) => {
            interface.check().map_err(document.refused("interface"))?;
            Ok((*interface, "interface"))
        }
        (None, [], _) => Err(document.missing("interface", EITHER)),
        (None, [body], Some(true)) => Ok((alone(body, "body[1]")?, "body[1]")),
        (None, [_], _) => {
            let needed = "a second [[body]], or rigid_counterface = true at the top of the file";
            Err(document.missing("body[2]", needed))
        }
        (None, [_, _], Some(true)) => {
            let needed = "one [[body]] with rigid_counterface = true, or two without it,";
            conflict("rigid_counterface", "body", needed)
        }
        (None, [first, second], _) => {
            alone(first, "body[1]")?;
            alone(second, "body[2]")?;
            let interface = Interface::between(first, second).map_err(document.refused("body"))?;
            Ok((interface, "body[1]"))
        }
        (None, more, _) => {
            let needed = "two tables [[body]], or one with rigid_counterface = true";
            Err(SceneError::value(
                document.place("body"),
                format_args!("a list of {}", more.len()),
                needed,
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{materials, parse, template};

    fn with(body: &str) -> Result<crate::SceneFile, String> {
        let rest = template().split_once("[surface]").map_or("", |(_, rest)| rest);
        let text = format!(
            "nominal_area = 1e-4\nrigid_counterface = true\n[[body]]\n{body}\n[surface]{rest}"
        );
        parse(&text, std::path::Path::new(".")).map_err(|error| error.to_string())
    }

    #[test]
    fn a_material_stands_for_its_numbers() {
        let steel = with("material = \"steel-100cr6\"\nthermal_conductivity = 40").unwrap();
        let listed = materials().iter().find(|material| material.id == "steel-100cr6").unwrap();
        assert_eq!(steel.bodies[0].hardness, listed.body.hardness);
        assert_eq!(steel.bodies[0].thermal_conductivity, Some(40.0));
        assert!(steel.to_toml(&[]).unwrap().contains("material = \"steel-100cr6\""));
    }

    #[test]
    fn a_material_beside_numbers_or_unknown_is_refused_with_both_names() {
        for (key, value) in [("hardness", "2e9"), ("youngs_modulus", "2e11")] {
            let refused =
                with(&format!("material = \"brass-naval\"\n{key} = {value}")).unwrap_err();
            let wanted = format!(
                "line 4: body[1].material and body[1].{key} (line 5) exclude each other: the material alone, or instead of it the numbers that `asperity materials` lists, changed as needed, was required"
            );
            assert_eq!(refused, wanted);
        }
        let refused = with("material = \"steel-100cr5\"").unwrap_err();
        assert!(refused.contains("the nearest is \"steel-100cr6\""), "{refused}");
        let refused = with("poissons_ratio = 0.3").unwrap_err();
        assert_eq!(refused, "line 3: body[1].youngs_modulus is missing: Pa");
    }
}
