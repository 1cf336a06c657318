//! `[interface]`, or the bodies from which it follows.

use asperity::{Body, Interface};
use serde::Deserialize;

use crate::SceneError;
use crate::document::Document;

/// The keys of the bodies in contact.
#[derive(Deserialize)]
pub(crate) struct InterfaceKeys {
    rigid_counterface: Option<bool>,
    work_of_adhesion: Option<f64>,
    interface: Option<Interface>,
    #[serde(default)]
    pub(crate) body: Vec<Body>,
}

const EITHER: &str = "either [interface] with the equivalent properties, or the two bodies as [[body]] (one with rigid_counterface = true)";

/// The interface of a scene, and its section.
pub(crate) fn interface(
    document: &Document<'_>,
    keys: &InterfaceKeys,
) -> Result<(Interface, &'static str), SceneError> {
    let (mut found, section) = from_section_or_bodies(document, keys)?;
    if keys.work_of_adhesion.is_some() {
        if keys.interface.is_some() {
            let needed = "work_of_adhesion in [interface], or above the bodies,";
            return Err(document.conflict("work_of_adhesion", "interface", needed));
        }
        // The work of adhesion is a property of the pair.
        found.work_of_adhesion = keys.work_of_adhesion;
        found.check().map_err(document.refused(""))?;
    }
    Ok((found, section))
}

fn from_section_or_bodies(
    document: &Document<'_>,
    keys: &InterfaceKeys,
) -> Result<(Interface, &'static str), SceneError> {
    let conflict = |one, other, needed| Err(document.conflict(one, other, needed));
    // Each body is checked alone, so that the error names the body.
    let alone = |body, section| Interface::against_rigid(body).map_err(document.refused(section));
    match (&keys.interface, &keys.body[..], keys.rigid_counterface) {
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
