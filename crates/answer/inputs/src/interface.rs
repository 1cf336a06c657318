//! `[interface]`, or the bodies from which it follows.

use asperity::{Body, Interface};
use toml::Value;

use crate::document::Document;
use crate::keys::{BODY, INTERFACE};
use crate::materials::{named, suggestion};
use crate::text_file::shorten;
use crate::{SceneError, interface_of};

const EITHER: &str = "either [interface] with the equivalent properties, or the two bodies as [[body]] (one with rigid_counterface = true)";

/// The interface of a scene, its section, and its bodies.
pub(crate) fn interface(
    document: &Document<'_>,
) -> Result<(Interface, &'static str, Vec<Body>), SceneError> {
    let count = document.get::<Vec<Value>>("body")?.map_or(0, |bodies| bodies.len());
    let bodies = (1..=count).map(|k| body(document, &format!("body[{k}]")));
    let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
    let (mut found, section) = from_section_or_bodies(document, &bodies)?;
    if let Some(adhesion) = document.number("work_of_adhesion")? {
        if document.has("interface") {
            let needed = "work_of_adhesion in [interface], or above the bodies,";
            return Err(document.conflict("work_of_adhesion", "interface", needed));
        }
        // The work of adhesion is a property of the pair.
        found.work_of_adhesion = Some(adhesion);
        found.check().map_err(document.refused(""))?;
    }
    Ok((found, section, bodies))
}

/// A body, with the numbers of its material unless it has its own.
fn body(document: &Document<'_>, section: &str) -> Result<Body, SceneError> {
    let path = |name: &str| format!("{section}.{name}");
    let mut body = match document.get::<String>(&path("material"))? {
        Some(id) => {
            let mechanical = ["youngs_modulus", "poissons_ratio", "hardness", "yield_strength"];
            if let Some(name) = mechanical.into_iter().find(|name| document.has(&path(name))) {
                let needed = "the material alone, or instead of it its numbers in the list of materials, changed as needed,";
                return Err(document.conflict(&path("material"), &path(name), needed));
            }
            named(&id).map(|material| material.body).ok_or_else(|| {
                let (near, needed) = suggestion(&id);
                SceneError::Value {
                    at: document.place(&path("material")),
                    found: format!("{:?}", shorten(&id)),
                    near: near.map(Into::into),
                    needed,
                }
            })?
        }
        None => {
            let modulus = document.needed_number(&path("youngs_modulus"))?;
            Body::elastic(modulus, document.needed_number(&path("poissons_ratio"))?)
        }
    };
    document.read_numbers(section, BODY, &mut body)?;
    Ok(body)
}

/// The properties in `[interface]`.
fn equivalent(document: &Document<'_>) -> Result<Option<Interface>, SceneError> {
    if document.value("interface").is_none() {
        return Ok(None);
    }
    let modulus = document.needed_number("interface.equivalent_modulus")?;
    let ratio = document.needed_number("interface.poissons_ratio")?;
    let mut interface = Interface::elastic(modulus, ratio);
    document.read_numbers("interface", INTERFACE, &mut interface)?;
    interface.check().map_err(document.refused("interface"))?;
    Ok(Some(interface))
}

fn from_section_or_bodies(
    document: &Document<'_>,
    bodies: &[Body],
) -> Result<(Interface, &'static str), SceneError> {
    if let Some(interface) = equivalent(document)? {
        return match ["body", "rigid_counterface"].into_iter().find(|key| document.has(key)) {
            Some(other) => Err(document.conflict("interface", other, EITHER)),
            None => Ok((interface, "interface")),
        };
    }
    // Each body is checked alone, so that the error names the body.
    for (body, k) in bodies.iter().zip(1..) {
        Interface::against_rigid(body).map_err(document.refused(&format!("body[{k}]")))?;
    }
    let is_rigid = document.get("rigid_counterface")? == Some(true);
    let interface = match (bodies, is_rigid) {
        ([], _) => return Err(document.missing("interface", EITHER)),
        ([_], false) => {
            let needed = "a second [[body]], or rigid_counterface = true at the top of the file";
            return Err(document.missing("body[2]", needed));
        }
        ([_], true) | ([_, _], false) => interface_of(bodies).map_err(document.refused("body"))?,
        (more, _) => {
            let found = format_args!("a list of {}", more.len());
            let needed = "two tables [[body]] alone, or one with rigid_counterface = true";
            return Err(SceneError::value(document.place("body"), found, needed));
        }
    };
    Ok((interface, "body[1]"))
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
}
