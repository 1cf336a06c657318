//! The loads of the slider and of the pictures.

use asperity::At;
use asperity_scene::{Hertz, NO_LOAD, SceneFile, Shape, notation_hint, quantity};
use serde::{Deserialize, Serialize};

use crate::refusal::Refusal;
use crate::shown::{EXACTLY, shown, typed};

/// The units of loads.
const NEWTON: &str = "N";
const PASCAL: &str = "Pa";
/// Steps between the pressures of a curve.
const POINTS: u32 = 199;
/// Decades of the slider.
const DECADES: f64 = 5.0;
/// The upper end of the slider over E g or over the hardness: 40 % of an elastic surface touches at
/// 0.2 E g.
const HIGHEST: f64 = 0.3;
/// Loads between those of a curve of curved bodies, each of which is a solution.
const SOLUTIONS: u32 = 20;
/// The highest approach of smooth curved bodies on the slider over σ_z.
const DEEPEST: f64 = 100.0;
/// Digits of a load of the slider.
const SLID: usize = 3;

/// A range of mean pressures; of curved bodies, which have no nominal area, of loads, as if that
/// were 1 m².
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    /// The highest \[Pa\].
    high: f64,
    is_flat: bool,
}

impl Span {
    /// The range for a scene, up to the smaller of the pressure that brings most of an elastic
    /// surface into contact and a share of the hardness.
    pub(crate) fn of(file: &SceneFile) -> Self {
        let scene = &file.scene;
        let slope = (2.0 * scene.surface.moments().m2).sqrt();
        let elastic = scene.interface.equivalent_modulus * slope;
        let hardness = scene.interface.softer_hardness();
        let high = HIGHEST * elastic.min(hardness.unwrap_or(f64::INFINITY));
        let high = file.shape().map_or(high, |shape| highest_load(file, shape, high));
        let one_digit = format!("{high:.0e}").parse().unwrap_or(high);
        let high = if high.is_finite() && high > 0.0 { one_digit } else { 1e8 };
        Self { high, is_flat: file.shape().is_none() }
    }

    /// The place of a pressure.
    pub(crate) fn at(self, pressure: f64) -> At {
        if self.is_flat { At::Pressure(pressure) } else { At::Load(pressure) }
    }

    /// Places to prepare models for: none of curved bodies, which are solved when they are asked.
    pub(crate) fn prepared(self) -> Vec<At> {
        if !self.is_flat {
            return vec![];
        }
        self.pressures().into_iter().map(At::Pressure).collect()
    }

    /// The pressure at a place of the slider from 0 to 1.
    pub(crate) fn pressure(self, position: f64) -> f64 {
        self.high * 10f64.powf(DECADES * (position.clamp(0.0, 1.0) - 1.0))
    }

    /// The pressures of a curve.
    pub(crate) fn pressures(self) -> Vec<f64> {
        let points = if self.is_flat { POINTS } else { SOLUTIONS };
        (0..=points).map(|k| self.pressure(f64::from(k) / f64::from(points))).collect()
    }

    /// The pressures for boundary elements, each four times the one before, from the lightest that
    /// the pixels of a scan resolve.
    pub(crate) fn solved(self) -> Vec<f64> {
        (3..=8).map(|k| self.pressure(f64::from(k) / 8.0)).collect()
    }
}

/// The load \[N\] at which the peak of smooth bodies is a pressure, or they approach by
/// [`DEEPEST`], whichever is less.
fn highest_load(file: &SceneFile, shape: Shape, pressure: f64) -> f64 {
    let (scene, load) = (&file.scene, 1.0);
    let hertz = Hertz::new(&shape, scene.interface.equivalent_modulus, load);
    let (power, approach) = match shape {
        Shape::Line { radius, .. } => (2.0, hertz.axes[0].powi(2) / radius),
        _ => (3.0, hertz.approach.unwrap_or(f64::NAN)),
    };
    let deepest = DEEPEST * scene.surface.asperity_height_std / approach;
    let deepest = if power > 2.0 { deepest.powf(1.5) } else { deepest };
    (pressure / hertz.peak_pressure).powf(power).min(deepest)
}

/// A load as typed, or as the place of the slider from 0 to 1.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub(crate) struct LoadKeys {
    pub(crate) text: String,
    pub(crate) position: Option<f64>,
    /// `N` or `Pa`, of a plain number and of the slider.
    pub(crate) unit: String,
    /// The unit in which the load is shown, if it is another one.
    pub(crate) show: Option<String>,
}

/// A load on the scene.
#[derive(Debug, Serialize)]
pub(crate) struct Load {
    #[serde(skip)]
    pub(crate) at: At,
    /// As it was typed, with its unit, so that it says the same without the unit beside it; or the
    /// text for the slider.
    pub(crate) text: String,
    /// `N` or `Pa`.
    pub(crate) unit: &'static str,
    pub(crate) newtons: f64,
    pub(crate) pascals: f64,
    /// The load in the other unit.
    other: String,
    /// The place of the slider.
    position: f64,
}

impl Load {
    /// A load as typed or slid to, on a scene.
    pub(crate) fn of(keys: &LoadKeys, file: &SceneFile) -> Result<Self, Refusal> {
        let (span, area) = (Span::of(file), file.scene.nominal_area);
        let known = |unit: &str| if unit == PASCAL && span.is_flat { PASCAL } else { NEWTON };
        let wrong = |reason: String| Refusal::at("load", format!("load: {reason}"));
        let beside = known(&keys.unit);
        let mut text = match keys.position.map(|position| span.pressure(position)) {
            None => keys.text.trim().to_string(),
            Some(slid) if beside == PASCAL => typed(slid, PASCAL, SLID),
            Some(slid) => typed(slid * area, NEWTON, SLID),
        };
        let (mut unit, given) = match (quantity(&text, NEWTON), quantity(&text, PASCAL)) {
            // A plain number has the unit beside it.
            (Ok(number), Ok(_)) => {
                text = format!("{text} {beside}");
                (beside, number)
            }
            (Ok(newtons), Err(_)) => (NEWTON, newtons),
            (Err(_), Ok(pascals)) if span.is_flat => (PASCAL, pascals),
            (Err(_), Ok(_)) => {
                let why = "is a pressure, and curved bodies have no nominal area: write a load";
                return Err(wrong(format!("{text:?} {why}, 50 N for example")));
            }
            (Err(_), Err(_)) => {
                let hint = notation_hint(&text).unwrap_or(
                    "is neither a load nor a pressure: write 2 kN or 5 MPa, for example",
                );
                return Err(wrong(format!("{text:?} {hint}")));
            }
        };
        let [newtons, pascals] =
            if unit == PASCAL { [given * area, given] } else { [given, given / area] };
        if !newtons.is_finite() || !pascals.is_finite() {
            return Err(wrong(format!("{text:?}: a finite number was required")));
        }
        if newtons == 0.0 {
            return Err(wrong(NO_LOAD.into()));
        }
        if let Some(show) = keys.show.as_deref().map(known).filter(|show| *show != unit) {
            unit = show;
            text = typed(if unit == PASCAL { pascals } else { newtons }, unit, EXACTLY);
        }
        let (at, other) = match unit {
            PASCAL => (At::Pressure(pascals), shown(newtons, NEWTON)),
            _ if span.is_flat => (At::Load(newtons), shown(pascals, PASCAL)),
            _ => (At::Load(newtons), "on curved bodies".into()),
        };
        let place = (1.0 + (pascals / span.high).log10() / DECADES).clamp(0.0, 1.0);
        let position = if pascals > 0.0 { place } else { 0.0 };
        Ok(Self { at, text, unit, newtons, pascals, other, position })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> SceneFile {
        asperity_scene::parse(asperity_scene::template(), std::path::Path::new(".")).unwrap()
    }

    #[test]
    fn loads_are_typed_with_a_unit_or_slid_to() {
        let scene = scene();
        let keys = |text: &str, position, unit: &str| LoadKeys {
            text: text.into(),
            position,
            unit: unit.into(),
            show: None,
        };
        let of = |keys: &LoadKeys| Load::of(keys, &scene).unwrap();
        assert_eq!(of(&keys("2 kN", None, "N")).at, At::Load(2000.0));
        assert_eq!(of(&keys("2 MPa", None, "N")).at, At::Pressure(2e6));
        assert_eq!(of(&keys("2e6", None, "Pa")).at, At::Pressure(2e6));
        assert_eq!(of(&keys("2 kN", None, "Pa")).at, At::Load(2000.0));
        for unit in ["N", "Pa"] {
            let slid = of(&keys("", Some(0.4), unit));
            assert!((slid.position - 0.4).abs() < 1e-3, "{slid:?}");
            let again = of(&keys(&slid.text, None, unit));
            assert!((again.pascals / slid.pascals - 1.0).abs() < 1e-15);
        }
        // The text of a plain number is shown with the unit beside it.
        assert_eq!(of(&keys("2e6", None, "Pa")).text, "2e6 Pa");
        assert_eq!(of(&keys("2e6 Pa", None, "N")).at, At::Pressure(2e6));
        for (text, pascals, other) in [
            ("5 kN/cm2", 50e6, "5 kN"),
            ("36 ksi", 248.211e6, "24.82 kN"),
            ("9 lbf", 400_340.0, "400.3 kPa"),
        ] {
            for unit in ["N", "Pa"] {
                let found = of(&keys(text, None, unit));
                assert!((found.pascals / pascals - 1.0).abs() < 3e-6, "{found:?}");
                assert_eq!((found.text.as_str(), found.other.as_str()), (text, other));
            }
        }
        for text in ["5 kg", "1 kip", "3 mm", "0,3 N", "1e999", "0"] {
            let refused = Load::of(&keys(text, None, "N"), &scene).unwrap_err();
            assert_eq!(refused.field.as_deref(), Some("load"), "{text}");
        }
    }

    #[test]
    fn another_unit_shows_the_same_load() {
        let scene = scene();
        for text in ["2 kN", "123.4 N", "0.7 mN", "1.7e-3 N"] {
            let keys = LoadKeys { text: text.into(), ..LoadKeys::default() };
            let first = Load::of(&keys, &scene).unwrap();
            let show = |text: &str, unit: &str| {
                let keys =
                    LoadKeys { text: text.into(), show: Some(unit.into()), ..LoadKeys::default() };
                Load::of(&keys, &scene).unwrap()
            };
            assert_eq!(show(text, "N").text, text);
            let other = show(text, "Pa");
            assert!(other.text.ends_with("Pa") && other.unit == "Pa", "{other:?}");
            let back = show(&other.text, "N");
            for (found, wanted) in [(other.newtons, first.newtons), (back.newtons, first.newtons)] {
                assert!((found / wanted - 1.0).abs() < 2e-15, "{found} {wanted}");
            }
        }
    }

    #[test]
    fn the_range_spans_decades_below_the_hardness() {
        let span = Span::of(&scene());
        let pressures = span.pressures();
        assert_eq!(pressures.len(), 200);
        assert!(pressures[199] <= 1e9 && pressures[199] / pressures[0] > 9e4, "{pressures:?}");
        assert_eq!(span.solved().len(), 6);
    }
}
