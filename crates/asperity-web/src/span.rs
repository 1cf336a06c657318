//! The loads of the slider and of the pictures.

use asperity::{At, Scene};
use asperity_scene::quantity;

use crate::message::{LoadKeys, LoadShown};
use crate::refusal::Refusal;
use crate::shown::typed;

/// Pressures of a curve.
const POINTS: u32 = 120;
/// Decades of the slider.
const DECADES: f64 = 5.0;
/// The upper end of the slider over E g or over the hardness: 40 % of an elastic surface touches at
/// 0.2 E g.
const HIGHEST: f64 = 0.3;

/// A range of mean pressures.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    /// The highest \[Pa\].
    high: f64,
}

impl Span {
    /// The range for a scene, up to the smaller of the pressure that brings most of an elastic
    /// surface into contact and a share of the hardness.
    pub(crate) fn of(scene: &Scene) -> Self {
        let slope = (2.0 * scene.surface.moments().m2).sqrt();
        let elastic = scene.interface.equivalent_modulus * slope;
        let hardness = scene.interface.check().ok().and_then(|(hardness, ..)| hardness);
        let high = HIGHEST * elastic.min(hardness.unwrap_or(f64::INFINITY));
        let one_digit = format!("{high:.0e}").parse().unwrap_or(high);
        Self { high: if high.is_finite() && high > 0.0 { one_digit } else { 1e8 } }
    }

    /// The pressure at a place of the slider from 0 to 1.
    pub(crate) fn pressure(self, position: f64) -> f64 {
        self.high * 10f64.powf(DECADES * (position.clamp(0.0, 1.0) - 1.0))
    }

    fn position(self, pressure: f64) -> f64 {
        (1.0 + (pressure / self.high).log10() / DECADES).clamp(0.0, 1.0)
    }

    /// The pressures of a curve.
    pub(crate) fn pressures(self) -> Vec<f64> {
        (0..=POINTS).map(|k| self.pressure(f64::from(k) / f64::from(POINTS))).collect()
    }

    /// The pressures for boundary elements, each four times the one before, from the lightest that
    /// the pixels of a scan resolve.
    pub(crate) fn solved(self) -> Vec<f64> {
        (3..=8).map(|k| self.pressure(f64::from(k) / 8.0)).collect()
    }
}

/// A load as typed or slid to, on a scene.
pub(crate) fn load(keys: &LoadKeys, scene: &Scene) -> Result<(At, LoadShown), Refusal> {
    let (span, area) = (Span::of(scene), scene.nominal_area);
    let text = match keys.position {
        Some(position) if keys.unit == "Pa" => typed(span.pressure(position), "Pa"),
        Some(position) => typed(span.pressure(position) * area, "N"),
        None => keys.text.clone(),
    };
    let wrong = |reason: String| Refusal::at("load", format!("load: {reason}"));
    let at = match (quantity(&text, "N"), quantity(&text, "Pa")) {
        // A plain number has the unit beside it.
        (Ok(_), Ok(pressure)) if keys.unit == "Pa" => At::Pressure(pressure),
        (Ok(load), _) => At::Load(load),
        (Err(_), Ok(pressure)) => At::Pressure(pressure),
        (Err(reason), Err(_)) => {
            return Err(wrong(format!("{reason}, or a pressure such as 5MPa")));
        }
    };
    let (newtons, pascals) = match at {
        At::Load(load) => (load, load / area),
        At::Pressure(pressure) => (pressure * area, pressure),
        At::Separation(_) => return Err(wrong("a load or a pressure was required".into())),
        _ => return Err(wrong("a load or a pressure was required".into())),
    };
    if !newtons.is_finite() || !pascals.is_finite() {
        return Err(wrong(format!("{text:?}: a finite number was required")));
    }
    let other = match at {
        At::Load(_) => crate::shown::shown(pascals, "Pa"),
        _ => crate::shown::shown(newtons, "N"),
    };
    let position = if pascals > 0.0 { span.position(pascals) } else { 0.0 };
    Ok((at, LoadShown { text, newtons, pascals, other, position }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let file = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        file.unwrap().scene
    }

    #[test]
    fn loads_are_typed_with_a_unit_or_slid_to() {
        let scene = scene();
        let keys = |text: &str, position, unit: &str| LoadKeys {
            text: text.into(),
            position,
            unit: unit.into(),
        };
        let of = |keys: &LoadKeys| load(keys, &scene).unwrap();
        assert_eq!(of(&keys("2 kN", None, "N")).0, At::Load(2000.0));
        assert_eq!(of(&keys("2 MPa", None, "N")).0, At::Pressure(2e6));
        assert_eq!(of(&keys("2e6", None, "Pa")).0, At::Pressure(2e6));
        assert_eq!(of(&keys("2 kN", None, "Pa")).0, At::Load(2000.0));
        for unit in ["N", "Pa"] {
            let (_, slid) = of(&keys("", Some(0.4), unit));
            assert!((slid.position - 0.4).abs() < 1e-3, "{slid:?}");
            let (_, again) = of(&keys(&slid.text, None, unit));
            assert!((again.pascals / slid.pascals - 1.0).abs() < 1e-15);
        }
        let refused = load(&keys("2 kg", None, "N"), &scene).unwrap_err();
        assert!(refused.message.contains("2kN, for example"), "{}", refused.message);
        assert!(load(&keys("1e999", None, "N"), &scene).is_err());
    }

    #[test]
    fn the_range_spans_decades_below_the_hardness() {
        let span = Span::of(&scene());
        let pressures = span.pressures();
        assert_eq!(pressures.len(), 121);
        assert!(pressures[120] <= 1e9 && pressures[120] / pressures[0] > 9e4, "{pressures:?}");
        assert_eq!(span.solved().len(), 6);
    }
}
