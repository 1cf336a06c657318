//! `[surface]`: the asperities, in exactly one of five ways, of one rough surface or of two.

use asperity::{Finding, Interface, ProfileMoments, Scene, Surface};

use crate::bandwidth::{GRADIENT, MEAN_SLOPE, ROUGH, is_of_bandwidth, too_steep};
use crate::document::Document;
use crate::heights::HeightsKey;
use crate::keys::{COUNTERFACE, KEYS, Of};
use crate::likely::{Given, OddNumber, likely_angle};
use crate::measured::{Asked, measured};
use crate::{Roughness, SceneError, SceneFile};

/// The five ways; `asperity_height_std` belongs to two of them.
const WAYS: [&[&str]; 5] = [
    &["asperity_radius", "asperity_density", STD],
    &["plasticity_index", "roughness_parameter", STD],
    &["m0", "m2", "m4"],
    &["sq", "spd", "spc"],
    &["file", "files"],
];
/// Index of the way by parameters of ISO 25178.
const ISO: usize = 3;
/// Index of the way by measured files.
const MEASURED: usize = WAYS.len() - 1;
const STD: &str = "asperity_height_std";
/// The alternative to `STD` with radius and density.
const SURFACE_STD: &str = "surface_height_std";
/// The numbers with each alternative key.
const SURFACE_STDS: [&str; 3] = ["asperity_radius", "asperity_density", SURFACE_STD];
const SLOPES: [&str; 3] = [SURFACE_STD, MEAN_SLOPE, "asperity_density"];
const GRADIENTS: [&str; 3] = ["sq", "spd", GRADIENT];

/// A surface described by numbers.
struct Numbers {
    surface: Surface,
    /// The numbers from which the asperities follow, if they are not given directly.
    roughness: Option<Roughness>,
    follows_from: &'static [&'static str],
    /// A warning of a slope or a curvature in another unit.
    unit: Option<Finding>,
    /// The number that explains findings about the asperities.
    odd: Option<Finding>,
}

impl Numbers {
    fn moments(&self) -> ProfileMoments {
        let given = self.roughness.and_then(|roughness| roughness.moments().ok());
        given.unwrap_or_else(|| self.surface.moments())
    }

    /// Whether the moments follow from other numbers.
    fn assumes_gaussian(&self) -> bool {
        !matches!(self.roughness, Some(Roughness::Moments(_)))
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
    let of = |section, std| numbers(document, section, &pair.interface, std);
    let first = of("surface", measured_std)?;
    let is_pair = document.has(COUNTERFACE);
    let second = if is_pair { of(COUNTERFACE, None)? } else { None };
    if let (Some((_, key)), HeightsKey::Measured) = (&first, heights) {
        let needed = "a measured file, from which the heights are taken,";
        return Err(document.conflict("surface.heights", &format!("surface.{key}"), needed));
    }
    let [first, second] = [first, second].map(|numbers| numbers.map(|(numbers, _)| numbers));
    let sections = [("surface", &first), (COUNTERFACE, &second)];
    let assumed = sections
        .into_iter()
        .filter(|(_, numbers)| is_pair && numbers.as_ref().is_some_and(Numbers::assumes_gaussian));
    let note = |(section, _)| {
        Finding::note("gaussian-moments", section, f64::NAN)
            .fact("m0, m2 and m4 are those of an isotropic Gaussian surface with these numbers")
            .advice("m0 = sq^2, m4 = 9 pi spc^2/64 and m2 = m4/(6 sqrt(3) pi spd), with 1/asperity_radius as spc and asperity_density as spd; use a scan where this is in doubt")
            .from_origin(document.place(section).to_string())
    };
    let units = [&first, &second].into_iter().flatten().filter_map(|n| n.unit.clone());
    let notes: Vec<Finding> = units.chain(assumed.map(note)).collect();
    let numbers = match (first, second) {
        (Some(first), Some(second)) => {
            let odd = first.odd.clone().or_else(|| second.odd.clone());
            let ProfileMoments { m0, m2, m4 } = first.moments().plus(&second.moments());
            let roughness = Roughness::Moments([m0, m2, m4]);
            let surface = roughness.surface().map_err(document.refused("surface"))?;
            let follows_from = roughness.keys();
            Numbers { surface, follows_from, roughness: Some(roughness), unit: None, odd }
        }
        (Some(only), None) if !is_pair => only,
        (first, second) => {
            let moments = first.or(second).map(|numbers| numbers.moments());
            let (file, of_scan) = measured(document, heights, asked, pair, moments)?;
            return Ok((file, [of_scan, notes].concat()));
        }
    };
    let mut file = SceneFile::from(pair);
    file.scene.surface = numbers.surface;
    file.follows_from = numbers.follows_from;
    file.roughness = numbers.roughness;
    file.odd_number = numbers.odd;
    Ok((file, notes))
}

/// The numbers of `section`, with the key that decides how they describe the surface; `None` for a
/// measured one.
fn numbers(
    document: &Document<'_>,
    section: &str,
    interface: &Interface,
    measured_std: Option<f64>,
) -> Result<Option<(Numbers, &'static str)>, SceneError> {
    let at = |key: &str| format!("{section}.{key}");
    let has = |key: &&&str| document.has(&at(key));
    let conflict =
        |one: &str, other: &str, needed: &str| Err(document.conflict(&at(one), &at(other), needed));
    let ways = WAYS.map(|keys| keys.join(", ")).join("; or ");
    let one_way = format!("exactly one way to describe the surface: {ways}");
    let own = |way: &&'static [&str]| way.iter().find(|key| **key != STD && has(key)).copied();
    let mut given = WAYS.iter().zip(0..).filter_map(|(way, k)| Some((k, own(way)?)));
    let Some((way, key)) = given.next() else { return Err(document.missing(section, one_way)) };
    if let Some((_, other)) = given.next() {
        return conflict(key, other, &one_way);
    }
    let of_files = KEYS.iter().find(|key| key.of == Of::Scan && has(&&key.name));
    if let Some(of_files) = of_files.filter(|_| way != MEASURED) {
        return conflict(of_files.name, key, "a measured file");
    }
    if has(&&SURFACE_STD) && way > 0 {
        return conflict(SURFACE_STD, key, "asperity_radius and asperity_density with it");
    }
    if has(&&MEAN_SLOPE) && (way > 0 || key == "asperity_radius") {
        return conflict(MEAN_SLOPE, key, "asperity_density and surface_height_std with it");
    }
    if has(&&GRADIENT) && (way != ISO || has(&&"spc")) {
        let other = if way == ISO { "spc" } else { key };
        return conflict(GRADIENT, other, "sq and spd with it");
    }
    if has(&&SURFACE_STD) && has(&&STD) {
        return conflict(SURFACE_STD, STD, "one of the two, which determines the other,");
    }
    let together = WAYS[way].join(", ");
    if way > 1 && has(&&STD) {
        let needed = format!("either {together} or {STD}, which follows from them,");
        return conflict(STD, key, &needed);
    }
    let alternatives = [(MEAN_SLOPE, SLOPES), (SURFACE_STD, SURFACE_STDS), (GRADIENT, GRADIENTS)];
    let other = alternatives.into_iter().find(|(key, _)| has(&key));
    let keys = match (other, WAYS[way]) {
        (Some((_, keys)), _) => keys,
        (None, [a, b, c]) => [*a, *b, *c],
        (None, _) => return Ok(None),
    };
    let mut values = [0.0; 3];
    for (key, value) in keys.iter().zip(&mut values) {
        let by_table = || measured_std.filter(|_| *key == STD);
        *value = document.number(&at(key))?.or_else(by_table).ok_or_else(|| {
            let how = match way {
                ISO => "sq and spd go with spc or sdq".into(),
                0 if keys == SLOPES => format!("{} go together", SLOPES.join(", ")),
                _ => format!("{together} go together"),
            };
            document.missing(&at(key), how)
        })?;
    }
    let roughness = Roughness::of(keys, values);
    let refused = document.refused(section);
    let made = |[a, b, c]: [f64; 3]| match (roughness, way) {
        (Some(roughness), _) => roughness.with([a, b, c]).surface(),
        (None, 0) => Ok(Surface::new(a, b, c)),
        _ => Surface::from_plasticity_index(a, b, c, interface),
    };
    let stated = keys.map(|key| document.stated.contains(&at(key)));
    let given = Given { keys, numbers: values, stated, surface: &|n| made(n).ok() };
    let mut pairs = keys.into_iter().zip(values);
    let slope = pairs.find(|(key, _)| [GRADIENT, MEAN_SLOPE].contains(key));
    let unit = slope.and_then(|(key, value)| likely_angle(key, value));
    // Asperities without any unit are described by their own findings.
    let is_plain = roughness.is_none() && way == 0 && stated == [false; 3];
    let odd = if is_plain || unit.is_some() { None } else { given.odd_number() };
    // Of two surfaces, each warning has its place.
    let is_pair = document.has(COUNTERFACE);
    let unit = unit.map(|found| match is_pair {
        true => {
            let place = document.place(&at(&found.field)).to_string();
            found.within(section).from_origin(place)
        }
        false => found,
    });
    let surface = made(values).map_err(|error| {
        let steep = roughness.as_ref().and_then(too_steep).filter(|_| is_of_bandwidth(&error));
        let unit = odd.as_ref().map(|odd| (odd.key, odd.value, odd.reason.clone()));
        let is_rough = |(_, slope, _): &(_, f64, _)| *slope > ROUGH;
        match steep.clone().filter(is_rough).or(unit).or(steep) {
            Some((key, value, hint)) => {
                let (at, found) = (document.place(&at(key)), asperity::short(value));
                SceneError::Notation { at, found, hint }
            }
            None => refused(error),
        }
    })?;
    surface.check().map_err(&refused)?;
    let odd = odd.map(|OddNumber { key, value, reason }| {
        let fact = format!("{} = {} {reason}", document.place(&at(key)), asperity::short(value));
        Finding::error("unusual-size", key, value).fact(fact)
    });
    let follows_from = match (&roughness, way) {
        (Some(roughness), _) => roughness.keys(),
        (None, 0) => &[][..],
        _ => WAYS[way],
    };
    Ok(Some((Numbers { surface, roughness, follows_from, unit, odd }, key)))
}
