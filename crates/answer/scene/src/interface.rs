//! `[interface]`, or the bodies from which it follows.

use asperity::{Body, Interface, nearest_name};
use toml::{Table, Value};

use crate::document::Document;
use crate::error::SceneError;
use crate::keys::{BODY, MECHANICAL, keys_of};
use crate::materials::{Material, materials_like, named, names};
use crate::spec::Bodies;
use crate::text_file::shorten;

const EITHER: &str = "either [interface] with the equivalent properties, or the two bodies as [[body]] (one with rigid_counterface = true)";

/// The bodies of a scene, or their interface.
pub(crate) fn bodies(document: &Document<'_>) -> Result<Bodies, SceneError> {
    if document.has("interface") {
        return equivalent(document).map(Bodies::Interface);
    }
    let count = document.get::<Vec<Value>>("body")?.map_or(0, |bodies| bodies.len());
    let each = (1..=count).map(|k| body(document, &format!("body[{k}]")));
    let each = each.collect::<Result<Vec<_>, _>>()?;
    let work_of_adhesion = document.get("work_of_adhesion")?;
    let is_rigid = document.get("rigid_counterface")? == Some(true);
    let materials = [0, 1].map(|k| each.get(k).and_then(|(_, material)| *material));
    let bodies: Vec<Body> = each.into_iter().map(|(body, _)| body).collect();
    match (&bodies[..], is_rigid) {
        ([], _) => Err(document.missing("interface", EITHER)),
        ([_], false) => {
            let needed = "a second [[body]], or rigid_counterface = true at the top of the file";
            Err(document.missing("body[2]", needed))
        }
        ([_], true) | ([_, _], false) => Ok(Bodies::Each { bodies, materials, work_of_adhesion }),
        (more, _) => {
            let found = format_args!("a list of {}", more.len());
            let needed = "two tables [[body]] alone, or one with rigid_counterface = true";
            Err(SceneError::value(document.place("body"), found, needed))
        }
    }
}

/// A body, with its material, if it has the numbers of one.
type Made = (Body, Option<&'static Material>);

/// A body, with the numbers of its material unless it has its own.
fn body(document: &Document<'_>, section: &str) -> Result<Made, SceneError> {
    let path = |name: &str| format!("{section}.{name}");
    let (body, material) = match document.get::<String>(&path("material"))? {
        Some(id) => {
            if let Some(name) = MECHANICAL.into_iter().find(|name| document.has(&path(name))) {
                let needed = "the material alone, or instead of it its numbers in the list of materials, changed as needed,";
                return Err(document.conflict(&path("material"), &path(name), needed));
            }
            named(&id).map(|material| (material.body, Some(material))).ok_or_else(|| {
                let like: Vec<&str> = materials_like(&id).iter().map(|one| &*one.id).collect();
                let needed = match like[..] {
                    [] => "a material of the list".into(),
                    _ => format!("one of {}", like.join(", ")),
                };
                let found = format!("{:?}", shorten(&id));
                let needed = format!("{needed} (`asperity list materials`)");
                let at = document.place(&path("material"));
                SceneError::of_names(at, &found, nearest_name(&id, names()), &needed)
            })?
        }
        None => {
            let modulus = document.needed_number(&path("youngs_modulus"))?;
            let ratio = document.needed_number(&path("poissons_ratio"))?;
            (Body::elastic(modulus, ratio), None)
        }
    };
    let names: Vec<&str> = BODY.iter().map(|field| field.name).collect();
    let keys = Table::try_from(body).unwrap_or_default();
    Ok((document.read_over(section, &names, keys)?, material))
}

/// The properties in `[interface]`, beside which there are no bodies.
fn equivalent(document: &Document<'_>) -> Result<Interface, SceneError> {
    for (other, needed) in [
        ("body", EITHER),
        ("rigid_counterface", EITHER),
        ("work_of_adhesion", "work_of_adhesion in [interface], or above the bodies,"),
    ] {
        if document.has(other) {
            return Err(document.conflict("interface", other, needed));
        }
    }
    let modulus = document.needed_number("interface.equivalent_modulus")?;
    let ratio = document.needed_number("interface.poissons_ratio")?;
    let keys = Table::try_from(Interface::elastic(modulus, ratio)).unwrap_or_default();
    document.read_over("interface", &keys_of("interface"), keys)
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
        assert_eq!(steel.bodies()[0].hardness, listed.body.hardness);
        assert_eq!(steel.bodies()[0].thermal_conductivity, Some(40.0));
        assert!(steel.to_toml().unwrap().contains("material = \"steel-100cr6\""));
    }
}
