//! `[surface]`: the asperities, in exactly one way, of one rough surface or of two.

use asperity::{Code, Finding, nearest_name, unusual};
use toml::Value;

use crate::document::Document;
use crate::error::SceneError;
use crate::finish::{Drawing, FINISH};
use crate::keys::{COUNTERFACE, KEYS, Subject, joined};
use crate::resolve::Fault;
use crate::roughness::{Roughness, Way};
use crate::scans::{Asked, scans};
use crate::spec::{Bodies, Description, HeightsSpec, SAME, SMOOTH, SceneSpec, SurfaceSpec};
use crate::text_file::shorten;

/// What a counterface may be instead of a surface of its own.
const WORDS: [&str; 2] = [SMOOTH, SAME];
/// The file of a measured surface.
const FILE: [&str; 1] = ["file"];
const STD: &str = "asperity_height_std";

/// What a section needs, with all ways.
fn one_way() -> String {
    let ways: Vec<String> = Way::all().map(|way| way.keys().join(", ")).collect();
    format!(
        "exactly one way to describe the surface: ra, finish; or {}; or file",
        ways.join("; or ")
    )
}

/// The way by which a section describes its surface, and its first key; refuses keys that no way
/// has together.
fn way(
    document: &Document<'_>,
    section: &str,
) -> Result<(&'static [&'static str], &'static str), SceneError> {
    let at = |key: &str| format!("{section}.{key}");
    let is_given = |key: &&'static str| document.has(&at(key));
    let keys_of = |subject: Subject| {
        KEYS.iter().filter(move |key| key.subject == subject).map(|key| key.name)
    };
    let given: Vec<_> = keys_of(Subject::Roughness).chain(FILE).filter(is_given).collect();
    let Some(key) = given.first().copied() else {
        return Err(document.missing(section, one_way()));
    };
    let fits = |keys: &[&'static str]| {
        let ways = || Way::all().map(|way| &way.keys()[..]).chain([FINISH, &FILE[..]]);
        ways().find(|way| keys.iter().all(|key| way.contains(key)))
    };
    let Some(way) = fits(&given) else {
        let pairs = given.iter().flat_map(|one| given.iter().map(move |other| [*one, *other]));
        let [one, other] = { pairs }.find(|pair| fits(pair).is_none()).unwrap_or([key; 2]);
        return Err(document.conflict(&at(one), &at(other), &one_way()));
    };
    match keys_of(Subject::Scan).find(is_given).filter(|_| way != FILE) {
        Some(odd) => Err(document.conflict(&at(key), &at(odd), "a measured file")),
        None => Ok((way, key)),
    }
}

/// A scene between these bodies with what was written of the surfaces; the standard deviation of a
/// table of heights is the default of `asperity_height_std`.
pub(crate) fn surfaces(
    document: &Document<'_>,
    bodies: Bodies,
    nominal_area: f64,
    heights: &HeightsSpec,
    asked: Asked,
) -> Result<SceneSpec, SceneError> {
    let table_std = heights.table.as_ref().map(|table| table.standard_deviation());
    let first = described(document, "surface", table_std)?;
    let word = document.value(COUNTERFACE).and_then(Value::as_str);
    let known = word.and_then(|word| WORDS.into_iter().find(|known| *known == word));
    if let Some(word) = word.filter(|_| known.is_none()) {
        let needed = "\"smooth\", \"same\" or the keys of the second surface";
        let (at, found) = (document.place(COUNTERFACE), format!("{:?}", shorten(word)));
        return Err(SceneError::of_names(at, &found, nearest_name(word, WORDS), needed));
    }
    let is_same = known == Some(SAME);
    let is_pair = document.has(COUNTERFACE) && word.is_none();
    let second = if is_pair { described(document, COUNTERFACE, None)? } else { None };
    if let (Some((_, key)), true) = (&first, heights.is_measured) {
        let needed = "a measured file, from which the heights are taken,";
        return Err(document.conflict("surface.heights", &format!("surface.{key}"), needed));
    }
    let has_scan = first.is_none() || is_pair && second.is_none();
    let is_drawn = |(by, _): &&(Description, _)| matches!(by, Description::Drawing(_));
    if has_scan && first.iter().chain(&second).any(|one| is_drawn(&one)) {
        let at = document.place(if first.is_some() { "surface" } else { COUNTERFACE });
        let reason = "the ranges of a finish do not add to the moments of a scan: describe this surface by a scan or by m0, m2 and m4, or both by ra and finish";
        return Err(SceneError::refused(at, reason));
    }
    let beside_numbers = first.is_some() || second.is_some();
    let (each, pressed) = match has_scan {
        true => scans(document, heights.is_measured, asked, beside_numbers)?,
        false => (vec![], None),
    };
    let mut each = each.into_iter();
    let mut of = |section: &'static str, by: Option<(Description, &str)>| {
        let Some(by) = by.map(|(by, _)| by).or_else(|| each.next().map(Description::Scan)) else {
            return Ok::<_, SceneError>(None);
        };
        Ok(Some(SurfaceSpec {
            by,
            mean_plane_offset: document.get(&joined(section, "mean_plane_offset"))?,
            peklenik_number: document.get(&joined(section, "peklenik_number"))?,
        }))
    };
    let first = of("surface", first)?.ok_or_else(|| document.missing("surface", one_way()))?;
    let counterface = match is_same {
        true if first.scan().is_some() => {
            let at = document.place(COUNTERFACE);
            let reason = "\"same\" is of a surface by numbers; name a file in each section";
            return Err(SceneError::refused(at, reason));
        }
        true => Some(first.clone()),
        false => of(COUNTERFACE, second)?,
    };
    let one = SceneSpec::new(bodies, first, nominal_area);
    Ok(SceneSpec { counterface, counterface_word: known, pressed, ..one })
}

/// How a section describes its surface, with the key that decides it; `None` by a scan.
fn described(
    document: &Document<'_>,
    section: &'static str,
    table_std: Option<f64>,
) -> Result<Option<(Description, &'static str)>, SceneError> {
    let at = |key: &str| format!("{section}.{key}");
    let (names, key) = way(document, section)?;
    if names == FINISH {
        let drawing = Drawing::read(document, section)?;
        return Ok(Some((Description::Drawing(drawing.into()), key)));
    }
    let Some(way) = Way::of(names) else { return Ok(None) };
    let mut numbers = [0.0; 3];
    for (key, value) in names.iter().zip(&mut numbers) {
        let by_table = || table_std.filter(|_| *key == STD);
        *value = document.get(&at(key))?.or_else(by_table).ok_or_else(|| {
            document.missing(&at(key), format!("{} go together", names.join(", ")))
        })?;
    }
    Ok(Some((Description::Numbers(Roughness { way, numbers }), key)))
}

/// An error of a number at its place, or the unit in which a number without one would be usual.
pub(crate) fn refused(
    document: &Document<'_>,
    spec: &SceneSpec,
    Fault { section, source }: Fault,
) -> SceneError {
    let numbers = spec.one(&section).map_or(vec![], SurfaceSpec::numbers);
    let is_positive = numbers.iter().all(|(_, value)| *value > 0.0);
    let mut odd = numbers.into_iter().filter(|_| is_positive);
    let odd = odd.find_map(|(key, value)| document.likely_unit(&section, unusual(key, value)));
    odd.unwrap_or_else(|| document.refused(&section)(source))
}

/// A warning of a single finish whose counterface is not named.
pub(crate) fn smooth_counterface(spec: &SceneSpec) -> Option<Finding> {
    let is_open = spec.surface.drawing().is_some_and(Drawing::is_open);
    let found = Finding::warning(Code::SmoothCounterface, "counterface", f64::NAN)
        .fact("the other surface is taken as smooth (by models of pairs as rough as this one)")
        .advice("give counterface = \"smooth\" or \"same\", or describe it");
    (is_open && spec.counterface.is_none() && spec.counterface_word.is_none()).then_some(found)
}
