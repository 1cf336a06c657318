//! `[surface]`: the asperities, in exactly one way, of one rough surface or of two.

use asperity::{Code, ContactError, Finding, Interface, ProfileMoments, Scene, short};

use crate::document::Document;
use crate::finish::{FINISH, face};
use crate::heights::HeightsKey;
use crate::keys::{COUNTERFACE, KEYS, Key, Subject};
use crate::likely::{in_other_unit, likely_angle, other_unit, too_steep};
use crate::measured::{Asked, measured};
use crate::numbers::{WAYS, Written};
use crate::unknowns::{Face, middle};
use crate::{SceneError, SceneFile, Way};

/// The files of measured surfaces.
const FILES: [&str; 2] = ["file", "files"];
const STD: &str = "asperity_height_std";
/// The alternative to `STD` with radius and density.
const SURFACE_STD: &str = "surface_height_std";
/// Keys that describe a surface only beside others.
const BESIDE: [&str; 4] = [STD, SURFACE_STD, "mean_slope", "sdq"];
/// The slope above which a surface that is too steep is rather that than given in another unit.
const ROUGH: f64 = 0.3;
/// The field of an error for moments that no isotropic Gaussian surface has.
const BANDWIDTH: &str = "bandwidth (m0 m4/m2^2)";

/// What a section needs, with all ways.
fn one_way() -> String {
    let ways: Vec<String> = WAYS.iter().map(|way| way.join(", ")).collect();
    format!(
        "exactly one way to describe the surface: ra, finish; or {}; or file, files",
        ways.join("; or ")
    )
}

/// The way by which a section describes its surface, and the key that decides it; refuses keys of
/// other ways.
fn way(
    document: &Document<'_>,
    section: &str,
) -> Result<(&'static [&'static str], &'static str), SceneError> {
    let at = |key: &str| format!("{section}.{key}");
    let has = |key: &&&str| document.has(&at(key));
    let ways = || WAYS.iter().map(|way| &way[..]).chain([FINISH, &FILES[..]]);
    let decides = |key: &&&str| !BESIDE.contains(*key) && has(key);
    let Some(key) = ways().flatten().find(decides).copied() else {
        return Err(document.missing(section, one_way()));
    };
    // Of ways with this key that with most of its keys, or else the first.
    let with_key = ways().rev().filter(|way| way.contains(&key));
    let way = with_key.max_by_key(|way| way.iter().filter(has).count()).unwrap_or_default();
    let is_scan = |key: &Key| key.subject == Subject::Scan;
    let describes = |key: &&Key| is_scan(key) || key.subject == Subject::Roughness;
    let odd = KEYS
        .iter()
        .filter(describes)
        .find(|key| !way.contains(&key.name) && has(&&key.name) && !(is_scan(key) && way == FILES));
    let Some(odd) = odd else { return Ok((way, key)) };
    let conflict = |one, other, needed| Err(document.conflict(&at(one), &at(other), needed));
    match odd.name {
        STD | SURFACE_STD if has(&&STD) && has(&&SURFACE_STD) => {
            conflict(SURFACE_STD, STD, "one of the two, which determines the other,")
        }
        name if is_scan(odd) && !FILES.contains(&name) => conflict(name, key, "a measured file"),
        name => {
            let own = || ways().filter(|way| way.contains(&name));
            let together = |other: &&&str| own().any(|way| way.contains(other));
            let other = way.iter().filter(has).find(|other| !together(other)).unwrap_or(&key);
            if !BESIDE.contains(&name) {
                return conflict(other, name, &one_way());
            }
            let others = own().next().unwrap_or_default().iter().copied();
            let others: Vec<&str> = others.filter(|other| *other != name).collect();
            conflict(name, other, &format!("{} with it", others.join(" and ")))
        }
    }
}

/// A surface described by numbers.
struct Numbers {
    described: Described,
    moments: ProfileMoments,
    /// The number that explains findings about the asperities.
    odd: Option<Finding>,
}

enum Described {
    Known(Written),
    Within(Box<Face>),
}

impl Numbers {
    /// As a surface with ranges, which these numbers may have none of.
    fn face(&self, section: &'static str) -> Face {
        match &self.described {
            Described::Known(_) => Face::known(section, &self.moments),
            Described::Within(face) => (**face).clone(),
        }
    }

    fn written(&self) -> Option<Written> {
        match self.described {
            Described::Known(written) => Some(written),
            Described::Within(_) => None,
        }
    }
}

/// The scene with its surface and what is to be said about it. `pair` has any surface;
/// `measured_std` is the standard deviation of a table of heights, the
/// default of `asperity_height_std`.
pub(crate) fn surface(
    document: &Document<'_>,
    heights: &HeightsKey,
    pair: Scene,
    measured_std: Option<f64>,
    asked: Asked,
) -> Result<(SceneFile, Vec<Finding>), SceneError> {
    let mut notes = vec![];
    let mut of = |section, std| numbers(document, section, &pair.interface, std, &mut notes);
    let first = of("surface", measured_std)?;
    let is_pair = document.has(COUNTERFACE);
    let second = if is_pair { of(COUNTERFACE, None)? } else { None };
    if let (Some((_, key)), HeightsKey::Measured) = (&first, heights) {
        let needed = "a measured file, from which the heights are taken,";
        return Err(document.conflict("surface.heights", &format!("surface.{key}"), needed));
    }
    let first_is_numbers = first.is_some();
    let is_measured = first.is_none() || is_pair && second.is_none();
    let of_numbers = first.into_iter().chain(second).map(|(numbers, _)| numbers);
    let of_numbers: Vec<Numbers> = of_numbers.collect();
    let has_ranges = of_numbers.iter().any(|numbers| numbers.written().is_none());
    if is_measured && has_ranges {
        let at = document.place(if first_is_numbers { "surface" } else { COUNTERFACE });
        let reason = "the ranges of a finish do not add to the moments of a scan: describe this surface by a scan or by m0, m2 and m4, or both by ra and finish";
        return Err(SceneError::Refused { at, reason: reason.into() });
    }
    if is_measured {
        let moments = of_numbers.first().map(|numbers| numbers.moments);
        let (file, of_scan) = measured(document, heights, asked, pair, moments)?;
        return Ok((file, [of_scan, notes].concat()));
    }
    let mut file = SceneFile::from(pair);
    let refused = document.refused("surface");
    if has_ranges {
        let sections = ["surface", COUNTERFACE];
        file.faces = of_numbers.iter().zip(sections).map(|(one, at)| one.face(at)).collect();
        (file.scene.surface, file.scene.pair) = middle(&file.faces).map_err(refused)?;
        file.follows_from = &FINISH[..1];
    } else {
        let written = of_numbers.iter().filter_map(Numbers::written).collect();
        file.describe(written).map_err(refused)?;
    }
    file.odd_number = of_numbers.into_iter().find_map(|numbers| numbers.odd);
    Ok((file, notes))
}

/// The numbers of `section`, with the key that decides how they describe the surface; `None` for a
/// measured one.
fn numbers(
    document: &Document<'_>,
    section: &'static str,
    interface: &Interface,
    measured_std: Option<f64>,
    notes: &mut Vec<Finding>,
) -> Result<Option<(Numbers, &'static str)>, SceneError> {
    let at = |key: &str| format!("{section}.{key}");
    let (way, key) = way(document, section)?;
    if way == FINISH {
        let (face, odd, found) = face(document, section)?;
        notes.extend(found);
        let (surface, _) =
            middle(std::slice::from_ref(&face)).map_err(document.refused(section))?;
        let moments = surface.moments();
        return Ok(Some((
            Numbers { described: Described::Within(Box::new(face)), moments, odd },
            key,
        )));
    }
    let Ok(keys) = <&[&str; 3]>::try_from(way) else { return Ok(None) };
    let is_asperities = keys == &WAYS[0];
    let mut values = [0.0; 3];
    for (key, value) in keys.iter().zip(&mut values) {
        let by_table = || measured_std.filter(|_| *key == STD);
        *value = document.number(&at(key))?.or_else(by_table).ok_or_else(|| {
            let how = match keys {
                ["sq", ..] => "sq and spd go with spc or sdq".into(),
                _ => format!("{} go together", keys.join(", ")),
            };
            document.missing(&at(key), how)
        })?;
    }
    let written = Written { keys, numbers: values };
    let roughness = written.roughness();
    let given = keys.iter().copied().zip(values);
    let slope = given.clone().find_map(|(key, value)| {
        likely_angle(key, value).filter(|_| ["sdq", "mean_slope"].contains(&key))
    });
    // Asperities are described by their own findings.
    let is_plain = is_asperities || slope.is_some() || values.iter().any(|value| *value <= 0.0);
    let odd = other_unit(document, section, given.filter(|_| !is_plain));
    let moments = written.moments(interface).map_err(|error| {
        let is_steep = matches!(error, ContactError::OutOfRange { field: BANDWIDTH, .. });
        let steep = roughness.as_ref().and_then(too_steep).filter(|_| is_steep);
        let is_rough = |(_, slope, _): &(_, f64, _)| *slope > ROUGH;
        match steep.clone().filter(is_rough).or(odd.clone()).or(steep) {
            Some((key, value, hint)) => {
                SceneError::Notation { at: document.place(&at(key)), found: short(value), hint }
            }
            None => document.refused(section)(error),
        }
    })?;
    let odd = odd.map(|odd| in_other_unit(document, section, odd));
    // Of two surfaces, each finding has its place.
    if document.has(COUNTERFACE) {
        let place = |path: &str| document.place(path).to_string();
        notes.extend(slope.map(|found| {
            let place = place(&at(&found.field));
            found.within(section).from_origin(place)
        }));
        if roughness.is_none_or(|roughness| roughness.way != Way::Moments) {
            notes.push(gaussian_moments(section, &moments).from_origin(place(section)));
        }
    } else {
        notes.extend(slope);
    }
    Ok(Some((Numbers { described: Described::Known(written), moments, odd }, key)))
}

/// The note on moments that follow from other numbers.
fn gaussian_moments(section: &'static str, moments: &ProfileMoments) -> Finding {
    let [m0, m2, m4] = [moments.m0, moments.m2, moments.m4].map(short);
    Finding::note(Code::GaussianMoments, section, f64::NAN)
        .fact(format!(
            "m0 = {m0} m^2, m2 = {m2} and m4 = {m4} 1/m^2 are those of an isotropic Gaussian surface with these numbers"
        ))
        .advice("use a scan where this is in doubt")
}
