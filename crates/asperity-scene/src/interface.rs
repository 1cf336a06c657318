//! `[interface]`, or the bodies it follows from.

use asperity::{Body, Interface};

use crate::SceneError;
use crate::document::Section;

const EITHER: &str = "either [interface] with the equivalent properties, or the two bodies as [[body]] (one with rigid_counterface = true),";

/// The interface of a scene, and where it stands.
pub(crate) fn interface<'a>(top: &Section<'a>) -> Result<(Interface, Section<'a>), SceneError> {
    let rigid = top.entry("rigid_counterface").map(|entry| entry.boolean()).transpose()?;
    match (top.section("interface")?, top.entry("body")) {
        (Some(_), Some(_)) => Err(top.conflict("interface", "body", EITHER)),
        (Some(section), None) => {
            if rigid.is_some() {
                let needed = "rigid_counterface with one [[body]] only";
                return Err(top.conflict("rigid_counterface", "interface", needed));
            }
            Ok((equivalent(&section)?, section))
        }
        (None, None) => Err(top.missing("interface", EITHER.trim_end_matches(','))),
        (None, Some(entry)) => {
            let mut sections = entry.sections("body")?.into_iter();
            let (first, second) = (sections.next(), sections.next());
            let (Some(first), None) = (first, sections.next()) else {
                return Err(
                    entry.wrong("two tables [[body]], or one with rigid_counterface = true,")
                );
            };
            let body = checked_body(&first)?;
            match (second, rigid.unwrap_or(false)) {
                (Some(_), true) => {
                    let needed = "one [[body]] with rigid_counterface = true, or two without it,";
                    Err(top.conflict("rigid_counterface", "body", needed))
                }
                (None, false) => {
                    let needed =
                        "a second [[body]], or rigid_counterface = true at the top of the file";
                    Err(top.missing("body[2]", needed))
                }
                (None, true) => {
                    Ok((Interface::against_rigid(&body).map_err(first.refused())?, first))
                }
                (Some(second), false) => {
                    let other = checked_body(&second)?;
                    let interface = Interface::between(&body, &other).map_err(first.refused())?;
                    Ok((interface, first))
                }
            }
        }
    }
}

fn equivalent(section: &Section<'_>) -> Result<Interface, SceneError> {
    let interface = Interface {
        equivalent_modulus: section
            .required("equivalent_modulus", "1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2 in Pa")?,
        equivalent_shear_modulus: section.number("equivalent_shear_modulus")?,
        poissons_ratio: section.required("poissons_ratio", "that of the softer body")?,
        hardness: section.number("hardness")?,
        yield_strength: section.number("yield_strength")?,
        pressure_factor: section.number("pressure_factor")?,
    };
    interface.check().map_err(section.refused())?;
    Ok(interface)
}

fn checked_body(section: &Section<'_>) -> Result<Body, SceneError> {
    let body = Body {
        youngs_modulus: section.required("youngs_modulus", "that of this body, in Pa")?,
        poissons_ratio: section.required("poissons_ratio", "that of this body")?,
        hardness: section.number("hardness")?,
        yield_strength: section.number("yield_strength")?,
    };
    // Checked alone, so that the error can say which of the bodies it is.
    Interface::against_rigid(&body).map_err(section.refused())?;
    Ok(body)
}
