//! Likely units of parameters of ISO 25178 that are given without one.

use asperity::{Diagnostic, Surface};

use crate::document::Document;

/// The units, SI first, in which instruments report ISO 25178 parameters.
const ISO_UNITS: [(&str, [(&str, f64); 3]); 3] = [
    ("sq", [("m", 1.0), ("um", 1e-6), ("nm", 1e-9)]),
    ("spd", [("1/m2", 1.0), ("1/mm2", 1e6), ("1/um2", 1e12)]),
    ("spc", [("1/m", 1.0), ("1/mm", 1e3), ("1/um", 1e6)]),
];

/// The units in which ISO 25178 parameters that were given without one describe a usual surface.
pub(crate) fn likely_units(
    document: &Document<'_>,
    section: &str,
    given: [f64; 3],
) -> Option<String> {
    // Indices of units; one of them is tried for a number without a unit only.
    let triples = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9]);
    let si = |[a, b, c]: &[usize; 3]| [*a, *b, *c].iter().filter(|k| **k == 0).count();
    let converted = |units: &[usize; 3], k: usize| {
        let (key, known) = ISO_UNITS.get(k)?;
        let (index, value) = (*units.get(k)?, *given.get(k)?);
        let (unit, factor) = known.get(index)?;
        let stated = document.stated.contains(&format!("{section}.{key}"));
        (index == 0 || !stated).then_some((*key, value, *unit, value * factor))
    };
    let [from, to] = Surface::USUAL_ASPERITY_ROUGHNESS;
    let usual = |units: &[usize; 3]| {
        let number = |k| converted(units, k).map(|(.., meant)| meant);
        let numbers = number(0).zip(number(1)).zip(number(2));
        let surface = numbers.map(|((sq, spd), spc)| Surface::from_iso25178(sq, spd, spc));
        surface.and_then(Result::ok).is_some_and(|surface| {
            surface.findings().is_empty() && (from..=to).contains(&surface.roughness_parameter())
        })
    };
    let units = triples.filter(usual).max_by_key(si)?;
    let changed = (0..3).filter(|k| units.get(*k).is_some_and(|index| *index > 0));
    let hint = |(key, value, unit, meant): (&str, f64, &str, f64)| {
        let [value, meant] = [value, meant].map(asperity::short);
        format!("{key} = {value} looks like {unit}; {value} {unit} is {meant} in SI units")
    };
    let hints: Vec<String> = changed.filter_map(|k| converted(&units, k)).map(hint).collect();
    Some(hints.join("; "))
}

/// The rms gradient above which Sdq is probably in degrees or per cent: 45 degrees.
const STEEP: f64 = 1.0;

/// A warning for an rms gradient that is probably in degrees or per cent.
pub(crate) fn likely_angle(sdq: f64) -> Option<Diagnostic> {
    (sdq > STEEP && sdq < 90.0).then(|| {
        let [given, slope, share] = [sdq, sdq.to_radians().tan(), 0.01 * sdq].map(asperity::short);
        Diagnostic::warning("unit", "sdq", sdq)
            .fact(format!("sdq is {given}, an rms gradient of more than 45 degrees"))
            .advice(format!(
                "{given} looks like degrees or per cent; {given} deg is {slope}, {given} % is {share}"
            ))
    })
}

/// The rms gradient that a text states in per cent or degrees.
pub(crate) fn gradient(text: &str) -> Option<f64> {
    let number = |end: &str| text.trim().strip_suffix(end)?.trim().parse::<f64>().ok();
    let angle = || number("deg").or_else(|| number("\u{b0}")).map(|deg| deg.to_radians().tan());
    number("%").map(|percent| 0.01 * percent).or_else(angle).filter(|found| found.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_above_one_look_like_degrees_or_per_cent() {
        let text = "sdq is 12, an rms gradient of more than 45 degrees: 12 looks like degrees or per cent; 12 deg is 0.2126, 12 % is 0.12";
        assert_eq!(likely_angle(12.0).unwrap().to_string(), text);
        assert_eq!((likely_angle(0.4), likely_angle(200.0)), (None, None));
    }

    #[test]
    fn texts_with_per_cent_or_degrees_are_gradients() {
        for (text, wanted) in [("6 %", 0.06), ("12deg", 0.2126), ("45\u{b0}", 1.0)] {
            assert!((gradient(text).unwrap() - wanted).abs() < 5e-5, "{text}");
        }
        assert!(gradient("6").is_none() && gradient("6 um").is_none() && gradient("%").is_none());
    }
}
