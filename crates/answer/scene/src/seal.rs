//! What is between the surfaces: the sections `[gap]` and `[seal]`.

use std::f64::consts::PI;

use asperity::bem::{self, Fluid, Rarefaction};
use asperity::{ATOMIC_DISTANCE, ContactError, short};
use serde::{Deserialize, Serialize};

/// A gas or liquid in the gap between the surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gas {
    /// Its thermal conductivity \[W/(m K)\], above 0.
    pub gas_conductivity: f64,
    /// Its temperature-jump distance \[m\], 0 for a liquid.
    pub gas_parameter: f64,
}

/// A gas of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SealGas {
    /// Dry.
    Air,
    /// N₂.
    Nitrogen,
    /// H₂.
    Hydrogen,
    /// He.
    Helium,
    /// Ar.
    Argon,
    /// CH₄.
    Methane,
}

/// The keys of `[seal]`, in SI units.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Seal {
    /// Across the flow; beside a perimeter along it.
    pub width: Option<f64>,
    /// Along the flow.
    pub length: Option<f64>,
    /// Of a ring.
    pub perimeter: Option<f64>,
    /// Absolute.
    pub upstream_pressure: Option<f64>,
    /// Absolute.
    pub downstream_pressure: Option<f64>,
    /// Of the fluid, instead of that of the gas.
    pub viscosity: Option<f64>,
    /// Of a liquid.
    pub density: Option<f64>,
    /// Of a gas, instead of that of the list.
    pub molar_mass: Option<f64>,
    /// Of a gas; 293.15 K without one.
    pub temperature: Option<f64>,
    /// A gas of the list.
    pub gas: Option<SealGas>,
}

/// The temperature \[K\] of a gas that has none: 20 °C.
const ROOM: f64 = 293.15;
/// How much an own viscosity of a listed gas may differ from that of the list, as a factor.
const OWN: f64 = 3.0;
/// The normal state (DIN 1343): 0 °C \[K\] and 1.01325 bar \[Pa\].
const NORMAL: [f64; 2] = [273.15, 101_325.0];
/// The temperatures \[K\] at which the viscosities of [`SealGas::numbers`] are within 1 %.
const TEMPERATURES: [f64; 2] = [220.0, 450.0];

impl SealGas {
    /// Molar mass \[kg/mol\] and viscosity \[Pa s\] at 293.15 K, with the power of the temperature
    /// with which it grows: CoolProp 7 at 1 bar \[seen\]. The kinetic diameter of its molecules
    /// \[m\]: Breck 1974 \[recalled\].
    fn numbers(self) -> [f64; 4] {
        match self {
            Self::Air => [28.965e-3, 1.8205e-5, 0.777, 0.36e-9],
            Self::Nitrogen => [28.0135e-3, 1.7573e-5, 0.770, 0.364e-9],
            Self::Hydrogen => [2.01588e-3, 8.797e-6, 0.692, 0.289e-9],
            Self::Helium => [4.002_602e-3, 1.9618e-5, 0.684, 0.26e-9],
            Self::Argon => [39.948e-3, 2.2306e-5, 0.831, 0.34e-9],
            Self::Methane => [16.0428e-3, 1.1037e-5, 0.842, 0.38e-9],
        }
    }
}

/// What is needed of the outline.
const OUTLINE: &str = "set width and length of the seal, or perimeter and width of a ring";
/// What is needed of the pressures.
const PRESSURES: &str = "set the absolute pressures on both sides (10 bar and 1 bar)";
/// What is needed of the fluid.
const FLUID: &str = "set the viscosity of a liquid, a gas of the list (gas = \"helium\"), or viscosity and molar_mass of another gas";

/// The value of a key that is needed.
fn needed(field: &'static str, value: Option<f64>, reason: &str) -> Result<f64, ContactError> {
    value.ok_or_else(|| ContactError::Missing { field, reason: reason.into() })
}

/// Refuses a value where `is_wrong`.
fn refuse(
    is_wrong: bool,
    field: &'static str,
    value: Option<f64>,
    required: &'static str,
) -> Result<(), ContactError> {
    let wrong = value.filter(|_| is_wrong);
    wrong.map_or(Ok(()), |value| Err(ContactError::OutOfRange { field, value, required }))
}

impl Seal {
    /// The area of its faces \[m²\], if its outline is given.
    pub(crate) fn area(&self) -> Option<f64> {
        Some(self.width? * self.perimeter.or(self.length)?)
    }

    /// Its outline, pressures and fluid.
    ///
    /// # Errors
    /// [`ContactError::Missing`] and [`ContactError::OutOfRange`] at a key.
    pub fn resolved(&self) -> Result<bem::Seal, ContactError> {
        let is_ring = self.perimeter.is_some();
        let required = "no length beside perimeter (the flow crosses the width of a ring)";
        refuse(is_ring, "length", self.length, required)?;
        let width = needed("width", self.width, OUTLINE)?;
        let required = "below perimeter/pi, the diameter of the ring";
        let is_wide = self.perimeter.is_some_and(|perimeter| width >= perimeter / PI);
        refuse(is_wide, "width", Some(width), required)?;
        let width_over_length = match self.perimeter {
            Some(perimeter) => perimeter / width,
            None => width / needed("length", self.length, OUTLINE)?,
        };
        let from = needed("upstream_pressure", self.upstream_pressure, PRESSURES)?;
        let to = needed("downstream_pressure", self.downstream_pressure, PRESSURES)?;
        let required = "an absolute pressure from 0 to below upstream_pressure";
        refuse(!(0.0..from).contains(&to), "downstream_pressure", Some(to), required)?;
        let (fluid, molecule) = self.fluid()?;
        Ok(bem::Seal { width_over_length, pressures: [from, to], fluid, molecule })
    }

    /// The fluid, and the size of its molecules \[m\].
    fn fluid(&self) -> Result<(Fluid, f64), ContactError> {
        let listed = self.gas.map(SealGas::numbers);
        let Some(molar_mass) = self.molar_mass.or(listed.map(|[mass, ..]| mass)) else {
            let required = "no temperature of a liquid, whose viscosity is given";
            refuse(true, "temperature", self.temperature, required)?;
            let viscosity = needed("viscosity", self.viscosity, FLUID)?;
            return Ok((Fluid::Liquid(viscosity), ATOMIC_DISTANCE));
        };
        let required = "no density of a gas, which follows from its pressure";
        refuse(true, "density", self.density, required)?;
        let temperature = self.temperature.unwrap_or(ROOM);
        let viscosity = match (self.viscosity, listed) {
            (None, Some([_, viscosity, power, _])) => {
                let is_known = (TEMPERATURES[0]..=TEMPERATURES[1]).contains(&temperature);
                let required = "220 K to 450 K without a viscosity (that of the list holds there)";
                refuse(!is_known, "temperature", Some(temperature), required)?;
                viscosity * (temperature / ROOM).powf(power)
            }
            (viscosity, listed) => {
                let viscosity = needed("viscosity", viscosity, FLUID)?;
                let is_other = |[_, of, power, _]: [f64; 4]| {
                    let of = of * (temperature / ROOM).powf(power);
                    !(of / OWN..=of * OWN).contains(&viscosity)
                };
                let required =
                    "at most 3 times that of the gas, and at least a third (a liquid has no gas)";
                refuse(listed.is_some_and(is_other), "viscosity", Some(viscosity), required)?;
                viscosity
            }
        };
        let gas = bem::Gas::new(viscosity, molar_mass, temperature, Rarefaction::Transition);
        let reason = |error: bem::BemError| error.to_string();
        let gas =
            gas.map_err(|error| ContactError::Missing { field: "gas", reason: reason(error) });
        Ok((Fluid::Gas(gas?), listed.map_or(ATOMIC_DISTANCE, |[.., size]| size)))
    }

    /// The ends of the columns of its flow, each with its size in the unit of the flow: of a gas
    /// in kg/s, of a liquid in m³/s.
    #[must_use]
    pub fn units(&self, seal: &bem::Seal) -> Vec<(&'static str, f64)> {
        const GRAMS_PER_HOUR: f64 = 3.6e6;
        match (&seal.fluid, self.density) {
            (Fluid::Liquid(_), None) => vec![("m3_per_s", 1.0)],
            (Fluid::Liquid(_), Some(density)) => {
                let grams = GRAMS_PER_HOUR * density;
                vec![("kg_per_s", density), ("g_per_h", grams), ("m3_per_s", 1.0)]
            }
            (Fluid::Gas(gas), _) => {
                let (work, [celsius, bar]) = (gas.pressure_over_density(), NORMAL);
                let normal = work * celsius / (self.temperature.unwrap_or(ROOM) * bar);
                vec![
                    ("kg_per_s", 1.0),
                    ("g_per_h", GRAMS_PER_HOUR),
                    ("mbar_l_per_s", 10.0 * work),
                    ("normal_m3_per_s", normal),
                ]
            }
        }
    }

    /// What its numbers mean, in a sentence.
    #[must_use]
    pub fn summary(&self, seal: &bem::Seal) -> String {
        let [from, to] = seal.pressures.map(|pressure| short(1e-5 * pressure));
        match &seal.fluid {
            Fluid::Liquid(viscosity) => {
                format!("leak of a liquid of {} Pa s from {from} to {to} bar", short(*viscosity))
            }
            Fluid::Gas(_) => format!(
                "leak of {} from {from} to {to} bar (absolute) at {} K; mbar l/s are at that temperature, normal m3 at 0 °C and 1.01325 bar (DIN 1343)",
                self.gas.map_or("a gas".into(), |gas| format!("{gas:?}").to_lowercase()),
                self.temperature.unwrap_or(ROOM)
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::{SceneError, SceneFile, parse, template};

    const SIDES: &str = "upstream_pressure = \"10 bar\"\ndownstream_pressure = 1e5\n";

    fn with(seal: &str) -> Result<SceneFile, SceneError> {
        let template = template().replace("nominal_area = 1e-4", "nominal_area = 2e-4");
        parse(&format!("{template}\n[seal]\n{seal}"), Path::new("."))
    }

    #[test]
    fn a_seal_is_read_written_and_refused_at_its_keys() {
        let helium = format!("width = 0.1\nlength = \"2 mm\"\n{SIDES}gas = \"helium\"\n");
        let ring = format!("perimeter = 0.1\nwidth = \"2 mm\"\n{SIDES}viscosity = 1e-3\n");
        for text in [&helium, &ring] {
            let file = with(text).unwrap();
            let seal = file.spec.seal.unwrap().resolved().unwrap();
            assert!((seal.width_over_length / 50.0 - 1.0).abs() < 1e-12);
            let [high, low] = seal.pressures;
            assert!((high / 1e6 - 1.0).abs() < 1e-12 && (low / 1e5 - 1.0).abs() < 1e-12);
            let again = parse(&file.to_toml().unwrap(), Path::new(".")).unwrap();
            assert_eq!(again.spec.seal, file.spec.seal);
        }
        for (text, key) in [
            (format!("{helium}perimeter = 0.1"), "seal.length"),
            (format!("{helium}density = 1"), "seal.density"),
            (format!("{helium}temperature = 600"), "seal.temperature"),
            (format!("{ring}temperature = 300"), "seal.temperature"),
            (format!("{ring}density = -1"), "seal.density"),
            (helium.replace("width", "# width"), "seal.width"),
            (helium.replace("gas", "# gas"), "seal.viscosity"),
            (helium.replace("gas", "molar_mass = 4e-3 #"), "seal.viscosity"),
            (helium.replace("1e5", "1e6"), "seal.downstream_pressure"),
            (helium.replace("1e5", "-1"), "seal.downstream_pressure"),
            (helium.replace("helium", "neon"), "seal.gas"),
        ] {
            let error = with(&text).unwrap_err();
            assert_eq!(error.place().unwrap().field, key, "{error}");
        }
        let file = with(&helium).unwrap();
        assert!(file.findings().iter().all(|found| !found.field.starts_with("seal")));
        let bare = with(&helium.replace("\"10 bar\"", "10").replace("1e5", "1")).unwrap();
        let found: Vec<_> = bare.findings().into_iter().map(|one| one.field.to_string()).collect();
        assert_eq!(found, ["seal.upstream_pressure"]);
    }

    #[test]
    fn the_nominal_area_is_that_of_the_seal() {
        let fields = |text: &str| {
            let found = parse(text, Path::new(".")).unwrap();
            let fields: Vec<String> =
                found.findings().iter().map(|f| f.field.to_string()).collect();
            (found.scene.nominal_area, fields)
        };
        let ring = format!("[seal]\nperimeter = 0.1\nwidth = \"2 mm\"\n{SIDES}gas = \"air\"\n");
        let both = format!("{}\n{ring}", template());
        assert_eq!(fields(&both), (1e-4, vec!["nominal_area".into()]));
        let (area, found) = fields(&both.replace("nominal_area = 1e-4", ""));
        assert!((area / 2e-4 - 1.0).abs() < 1e-12 && found.is_empty(), "{found:?}");
        // A ring is wider than its width.
        let wide = parse(&both.replace("2 mm", "40 mm"), Path::new(".")).unwrap_err();
        assert_eq!(wide.place().unwrap().field, "seal.width");
        let long = both.replace("perimeter = 0.1", "perimeter = 100");
        assert_eq!(fields(&long).1, ["seal.perimeter", "nominal_area"]);
        let open = both.replace("nominal_area = 1e-4", "").replace("width = \"2 mm\"", "");
        let missing = parse(&open, Path::new(".")).unwrap_err();
        assert_eq!(missing.place().unwrap().field, "seal.width");
        // Numbers of a seal may be ranges and are replaced, and its area follows.
        let range = both.replace("nominal_area = 1e-4", "").replace("\"2 mm\"", "[1e-3, 4e-3]");
        let points = parse(&range, Path::new(".")).unwrap().points().unwrap();
        let areas = [0, 1].map(|k| points.all[k].scene.nominal_area);
        assert!(areas.iter().zip([1e-4, 4e-4]).all(|(a, b)| (a / b - 1.0).abs() < 1e-12));
    }

    #[test]
    fn units_are_those_of_the_normal_state_and_of_the_temperature() {
        let seal = |text: &str| {
            let file = with(&format!("width = 0.1\nlength = 0.1\n{SIDES}{text}")).unwrap();
            let keys = file.spec.seal.unwrap();
            keys.units(&keys.resolved().unwrap())
        };
        // 1e-9 kg/s of helium at 20 °C, and of water.
        let close = |found: Vec<(&str, f64)>, right: &[(&str, f64)]| {
            assert_eq!(found.len(), right.len());
            for ((name, size), (wanted, right)) in found.iter().zip(right) {
                assert!(name == wanted && (size / right - 1.0).abs() < 2e-5, "{name} {size}");
            }
        };
        let mass = [("kg_per_s", 1.0), ("g_per_h", 3.6e6)];
        let [kilograms, grams] = mass;
        let gas = [kilograms, grams, ("mbar_l_per_s", 6.0895e6), ("normal_m3_per_s", 5.5998)];
        close(seal("gas = \"helium\""), &gas);
        let water = [("kg_per_s", 1e3), ("g_per_h", 3.6e9), ("m3_per_s", 1.0)];
        close(seal("viscosity = 1e-3\ndensity = \"1 g/cm3\""), &water);
        close(seal("viscosity = 1e-3"), &water[2..]);
        // The viscosity of helium at 100 °C, by CoolProp.
        let hot = Seal { temperature: Some(373.15), gas: Some(SealGas::Helium), ..Seal::default() };
        let known = bem::Gas::new(2.315_36e-5, 4.002_602e-3, 373.15, Rarefaction::Transition);
        let (Fluid::Gas(found), _) = hot.fluid().unwrap() else { panic!("a gas") };
        let [found, known] = [found, known.unwrap()].map(|gas| gas.inverse_knudsen(1e-6, 1e5));
        assert!((found / known - 1.0).abs() < 5e-3, "{found} {known}");
    }
}
