#![doc = include_str!("../README.md")]

use std::f64::consts::PI;
use std::ops::Range;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Power, Provenance,
    Tolerance, Validity, require,
};
use serde::{Deserialize, Serialize};

/// The model of Zhao, Maietta and Chang.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ZhaoMaiettaChang;

const SOURCE: Citation = Citation {
    id: "zmc",
    name: "ZMC",
    authors: "Zhao, Maietta & Chang",
    year: 2000,
    title: "An asperity microcontact model incorporating the transition from elastic deformation to fully plastic flow",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Zhao, Y. and Maietta, D. M. and Chang, L."),
        ("journal", "Journal of Tribology"),
        ("volume", "122"),
        ("number", "1"),
        ("pages", "86--93"),
        ("doi", "10.1115/1.555332"),
    ],
};

/// k: mean pressure over hardness at first yield. \[seen\]
const YIELD_PRESSURE: f64 = 0.4;
/// w₂/w₁. \[seen\]
const FULLY_PLASTIC: f64 = 54.0;

/// A/(π R w₁) = x (1 - 2t³ + 3t²) between w₁ and w₂, for x = w/w₁.
fn area(x: f64) -> f64 {
    let t = (x - 1.0) / (FULLY_PLASTIC - 1.0);
    x * (1.0 + t * t * (3.0 - 2.0 * t))
}

/// p/(k H) = [1 - (1-k) ln(w₂/w)/ln(w₂/w₁)]/k between w₁ and w₂, for x = w/w₁.
fn pressure(x: f64) -> f64 {
    let share = (FULLY_PLASTIC / x).ln() / FULLY_PLASTIC.ln();
    (1.0 - (1.0 - YIELD_PRESSURE) * share) / YIELD_PRESSURE
}

/// w₁ = (3π k H/(4E))² R \[m\].
fn first_yield(asperity: &Asperity) -> Result<f64, ContactError> {
    let value = asperity.hardness()?;
    let strain = 0.75 * PI * YIELD_PRESSURE * value / asperity.equivalent_modulus;
    let required =
        "a hardness below 4E/(3 pi 0.4), so that yield begins below an interference of one radius,";
    require(strain < 1.0, "hardness", value, required)?;
    Ok(strain * strain * asperity.radius)
}

impl Described for ZhaoMaiettaChang {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            valid_for: "w_1 < R; a smooth transition from elastic at w_1 to plastic at 54 w_1",
            ..Validity::default()
        }
    }
}

const BEYOND: Range<f64> = FULLY_PLASTIC..f64::INFINITY;

impl AsperityModel for ZhaoMaiettaChang {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let yield_at = first_yield(asperity)?;
        let unit = YIELD_PRESSURE * asperity.hardness()? * (PI * asperity.radius * yield_at);
        let between = Formula::function(|x| pressure(x) * area(x)).known_as("ZMC force", vec![]);
        // F/(k H π R w₁) = x^1.5, then p/(kH) A/(π R w₁), then 2x/k
        Ok(Law::in_units(yield_at, unit)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .elastic_plastic(1.0..FULLY_PLASTIC, between)
            .plastic(BEYOND, [Power::new(2.0 / YIELD_PRESSURE, 1.0)]))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let yield_at = first_yield(asperity)?;
        let between = Formula::function(area).known_as("ZMC area", vec![]);
        // A/(π R w₁) = x, then x (1 - 2t³ + 3t²), then 2x
        Ok(Law::in_units(yield_at, PI * asperity.radius * yield_at)
            .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
            .elastic_plastic(1.0..FULLY_PLASTIC, between)
            .plastic(BEYOND, [Power::new(2.0, 1.0)]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joins_hertz_and_the_plastic_law_without_a_jump() {
        assert!((area(1.0) - 1.0).abs() < 1e-15 && (pressure(1.0) - 1.0).abs() < 1e-15);
        assert!((area(54.0) - 108.0).abs() < 1e-12 && (pressure(54.0) - 2.5).abs() < 1e-15);
    }
}
