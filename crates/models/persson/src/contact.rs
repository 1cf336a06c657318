//! Persson's theory applied to a scene.

use asperity_core::{
    At, ContactEngine, ContactError, Datum, Described, Evaluation, Quantity, Scene, Separation,
    SeparationUnit, integral_failed, positive, require, short,
};

use crate::gap::{self, Gap, LN_PRESSURES};
use crate::inverse::{Found, Inverse};
use crate::{Persson, Spectrum, plastic};

/// Bound on the relative error of areas, which is rounding.
const ERROR: f64 = 1e-14;

#[derive(Debug)]
pub(crate) struct OnScene {
    pub(crate) model: Persson,
    pub(crate) scene: Scene,
    pub(crate) quantities: Vec<Quantity>,
    /// H \[Pa\], if it limits the pressure.
    pub(crate) limit: Option<f64>,
    /// √V \[Pa\], the standard deviation of the pressure at full contact.
    pub(crate) pressure_std: f64,
    /// The spectrum for mean gaps and stiffnesses, or the error that names the missing input.
    pub(crate) spectrum: Result<std::sync::Arc<Spectrum>, ContactError>,
    /// Mean gaps computed so far.
    pub(crate) inverse: Inverse,
}

impl OnScene {
    fn gap(&self) -> Result<Gap<'_>, ContactError> {
        if self.limit.is_some() {
            return Err(self.no_gap());
        }
        let spectrum = self.spectrum.as_deref().map_err(Clone::clone)?;
        Ok(Gap { spectrum, gamma: self.model.variance.gamma() })
    }

    /// The error of a mean gap where pressures end at the hardness.
    fn no_gap(&self) -> ContactError {
        self.unsupported(
            "mean gaps and stiffnesses: how far yielding closes the gap is not derived",
        )
    }

    /// A/A_n and its plastic part.
    fn areas(&self, pressure: f64) -> Result<[f64; 2], ContactError> {
        let Some(limit) = self.limit else {
            return Ok([self.model.variance.area_fraction(pressure / self.pressure_std), 0.0]);
        };
        if pressure >= limit {
            let [pressure, limit] = [pressure, limit].map(short);
            let reason = format!(
                "the mean pressure is {pressure} Pa, and contact is full at the hardness ({limit} Pa): check the units of load and nominal area"
            );
            return Err(ContactError::Refused { model: self.model().into(), reason });
        }
        let full = std::f64::consts::SQRT_2 * self.pressure_std / limit;
        Ok(plastic::areas(pressure / limit, full))
    }

    /// b = p/√(2 V).
    fn reduced(&self, pressure: f64) -> f64 {
        pressure / self.pressure_std / std::f64::consts::SQRT_2
    }

    /// The pressure at a mean gap, and a bound on its relative error.
    fn pressure_at(&self, separation: Separation) -> Result<(f64, f64), ContactError> {
        let (unit, from) = (SeparationUnit::Metres, Datum::SurfaceMean);
        let wanted = separation.measured_in(unit, from, &self.scene)?.value;
        let field = "separation in m from the mean plane of the surface";
        let (gap, at) = (self.gap()?, At::Separation(separation));
        // A logarithm follows.
        let wanted = positive(field, wanted)?;
        let failed = integral_failed(Quantity::Pressure, &at);
        let required = match self.inverse.find(&gap, wanted.ln()).map_err(failed)? {
            Found::At(ln_b, slope) => {
                let pressure = ln_b.exp() * std::f64::consts::SQRT_2 * self.pressure_std;
                return Ok((pressure, gap::ERROR * (1.0 - 1.0 / slope)));
            }
            Found::Above => "a mean gap that is reached at a pressure below 17 E g",
            Found::Below => "a mean gap that is reached at a pressure above 1e-300 E g",
        };
        Err(ContactError::OutOfRange { field, value: wanted, required })
    }
}

fn is_slope(quantity: Quantity) -> bool {
    matches!(quantity, Quantity::Stiffness | Quantity::Tangent)
}

/// The slopes of the mean gap, and what follows from force and area.
fn is_known(quantity: Quantity) -> bool {
    is_slope(quantity) || quantity.follows_from_totals()
}

/// What follows from force and area of a surface that yields, and the shares of the force.
fn is_known_plastic(quantity: Quantity) -> bool {
    matches!(quantity, Quantity::ElasticShare | Quantity::PlasticShare)
        || quantity.follows_from_totals()
}

impl ContactEngine for OnScene {
    fn model(&self) -> &str {
        self.model.id()
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        let known = match self.limit {
            // Of a yielding surface the reason is known.
            Some(_) if is_slope(quantity) => return Err(self.no_gap()),
            Some(_) => is_known_plastic,
            None => is_known,
        };
        self.check_asked(quantity, known)?;
        let nominal = self.scene.nominal_area;
        let (pressure, error) = match at {
            At::Pressure(pressure) => (positive("pressure", pressure)?, ERROR),
            At::Load(load) => (positive("load", load)? / nominal, ERROR),
            At::Separation(separation) => self.pressure_at(separation)?,
            _ => return Err(self.unsupported(&format!("an answer at {at}"))),
        };
        let found = if is_slope(quantity) {
            let (fall, ln_scale) =
                self.gap()?.fall(self.reduced(pressure)).map_err(integral_failed(quantity, &at))?;
            // dF/du = A p/(du/d ln p); the exponent has the error of b².
            let stiffness = pressure * nominal / fall * (-ln_scale).exp();
            let error = gap::ERROR + error * (2.0 - 2.0 * ln_scale);
            Some(Evaluation::new(stiffness, error))
        } else {
            let [fraction, plastic] = self.areas(pressure)?;
            let totals = (pressure * nominal, fraction * nominal);
            let limit = self.limit.unwrap_or(0.0);
            // The plastic area carries H; it takes on the rounding of p/H.
            let plastic = plastic * limit / pressure;
            let rounded = error * (1.0 + limit / self.pressure_std);
            match quantity {
                Quantity::PlasticShare => Some(Evaluation::absolute(plastic, rounded)),
                Quantity::ElasticShare => Some(Evaluation::absolute(1.0 - plastic, rounded)),
                // At full plasticity, rounding leaves the ratio of the totals above the hardness.
                Quantity::MeanPressure if limit > 0.0 => {
                    Some(Evaluation::new((pressure / fraction).min(limit), 2.0 * error))
                }
                _ => Evaluation::of_totals(quantity, totals, nominal, error),
            }
        };
        match found {
            Some(found) if found.scaled.is_finite() => Ok(found),
            Some(found) => Err(ContactError::Scale { quantity, scale: found.scaled }),
            None => Err(ContactError::NoValue { quantity, at }),
        }
    }

    /// The mean gap, from the mean plane of the surface.
    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let b = self.reduced(positive("load", load)? / self.scene.nominal_area);
        let (gap, at) = (self.gap()?, At::Load(load));
        let required = "at most 17 E g on the nominal area, where the mean gap vanishes,";
        require(b.ln() <= LN_PRESSURES[1], "load", load, required)?;
        let gap = gap.mean_gap(b).map_err(integral_failed(Quantity::Force, &at))?;
        Ok(vec![Separation::metres(gap).from_surface_mean()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PerssonVariance;
    use asperity_core::ContactModel;
    use asperity_core::{
        Contact, HeightDistribution, Interface, ProfileMoments, Request, Separation, Surface,
    };

    const MOMENTS: ProfileMoments = ProfileMoments { m0: 1e-12, m2: 2e-4, m4: 3.2e5 };

    fn scene() -> Scene {
        let surface = Surface::from_moments(&MOMENTS).unwrap();
        Scene::new(Interface::elastic(2e6, 0.5), surface, 3e-5)
    }

    fn on(scene: &Scene, variance: PerssonVariance) -> Result<Box<dyn Contact>, ContactError> {
        Persson { variance, ..Persson::default() }.compile(scene, &Request::new(Quantity::ALL))
    }

    #[test]
    fn the_m2_of_the_moments_given_sets_the_area() {
        // g = √(2 m₂) = 0.02: the published value at p/(E g) = 0.1 is at 4 kPa.
        let contact = on(&scene(), PerssonVariance::Fudge).unwrap();
        let of = |quantity, at: At| contact.evaluate(quantity, at).unwrap();
        for at in [At::Pressure(4e3), At::Load(4e3 * 3e-5)] {
            let fraction = of(Quantity::AreaFraction, at).value();
            assert!((fraction / 0.209_753_318_605 - 1.0).abs() < 5e-12, "{fraction}");
            let area = of(Quantity::Area, at).value();
            assert!((area / (fraction * 3e-5) - 1.0).abs() < 1e-15);
            assert!((of(Quantity::Force, at).value() / 0.12 - 1.0).abs() < 1e-15);
            assert!((of(Quantity::Pressure, at).value() / 4e3 - 1.0).abs() < 1e-15);
            assert!((of(Quantity::MeanPressure, at).value() / (0.12 / area) - 1.0).abs() < 1e-14);
            let ln = of(Quantity::LnArea, at);
            assert!((ln.value() - area.ln()).abs() <= ln.bound(Quantity::LnArea));
            assert!((of(Quantity::LnForce, at).value() - 0.12f64.ln()).abs() < 1e-14);
        }
    }

    #[test]
    fn missing_inputs_and_unsupported_quantities_are_named() {
        let contact = on(&scene(), PerssonVariance::Full).unwrap();
        let refused = |q, at: At| contact.evaluate(q, at).unwrap_err().to_string();
        let contacts = contact.evaluate(Quantity::Contacts, At::Load(1.0));
        assert!(matches!(contacts, Err(ContactError::Unsupported { .. })), "{contacts:?}");
        let gap = At::Separation(Separation::sigmas(1.0));
        for text in [refused(Quantity::Tangent, At::Load(1.0)), refused(Quantity::Area, gap)] {
            assert!(text.starts_with("hurst_exponent is missing"), "{text}");
        }
        assert!(contact.separation(At::Load(1.0)).is_err());
        let wild = Persson { hurst_exponent: Some(1.2), ..Persson::default() };
        let text = wild.compile(&scene(), &Request::new(Quantity::ALL)).unwrap_err().to_string();
        assert!(text.starts_with("hurst_exponent is 1.2"), "{text}");
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(refused(Quantity::Area, At::Load(bad)).starts_with("load is"));
            assert!(refused(Quantity::Area, At::Pressure(bad)).starts_with("pressure is"));
        }
        let mut exponential = scene();
        exponential.heights = HeightDistribution::Exponential;
        let text = on(&exponential, PerssonVariance::Fudge).unwrap_err().to_string();
        assert!(text.contains("persson-fudge") && text.contains("exponential"), "{text}");
        let points = [(-2e-6, 0.0), (0.0, 1e6), (1e-6, 0.0)];
        let mut table = scene();
        let skewed = asperity_core::TabulatedHeights::new("skewed", &points).unwrap();
        table.heights = HeightDistribution::other(skewed);
        let waves = [(1e4, 1e-12), (2e4, 1e-13)];
        let spectrum = Some(Ok(std::sync::Arc::new(Spectrum::of_waves(waves).unwrap())));
        let beside = Persson { spectrum, ..Persson::default() };
        let of_law = Persson { hurst_exponent: Some(0.8), ..beside.clone() };
        let all = Request::new(Quantity::ALL);
        for refused in [Persson::default().compile(&table, &all), of_law.compile(&table, &all)] {
            assert!(matches!(refused, Err(ContactError::Unsupported { .. })));
        }
        assert!(beside.compile(&table, &all).is_ok());
        let mut bad = scene();
        bad.surface.asperity_density = -1.0;
        assert!(
            on(&bad, PerssonVariance::Full).unwrap_err().to_string().contains("asperity_density")
        );
    }

    #[test]
    fn a_yielding_surface_has_areas_and_shares_and_no_gaps() {
        let mut scene = scene();
        let missing = on(&scene, PerssonVariance::Plastic).unwrap_err().to_string();
        assert!(missing.starts_with("hardness is missing"), "{missing}");
        // E g/H = 0.5.
        scene.interface.hardness = Some(8e4);
        let contact = on(&scene, PerssonVariance::Plastic).unwrap();
        let of = |quantity, at: At| contact.evaluate(quantity, at);
        let at = At::Pressure(0.2 * 8e4);
        let value = |quantity| of(quantity, at).unwrap().value();
        let [area, plastic] = plastic::areas(0.2, 0.5 / std::f64::consts::SQRT_2);
        assert!((value(Quantity::AreaFraction) / area - 1.0).abs() < 1e-15);
        assert!((value(Quantity::MeanPressure) / (0.2 * 8e4 / area) - 1.0).abs() < 1e-14);
        // The plastic area carries the hardness, and together the shares are the force.
        assert!((value(Quantity::PlasticShare) / (plastic / 0.2) - 1.0).abs() < 1e-14);
        let shares = value(Quantity::PlasticShare) + value(Quantity::ElasticShare);
        assert!((shares - 1.0).abs() < 1e-15, "{shares}");
        for quantity in [Quantity::Stiffness, Quantity::Tangent] {
            assert!(matches!(of(quantity, at), Err(ContactError::Unsupported { .. })));
        }
        let gap = Separation::sigmas(1.0);
        let refused =
            [contact.separation(at).unwrap_err(), of(Quantity::Area, gap.into()).unwrap_err()];
        assert!(refused.iter().all(|error| matches!(error, ContactError::Unsupported { .. })));
        let contacts = of(Quantity::Contacts, at).unwrap_err().to_string();
        assert!(contacts.ends_with("elastic-share, plastic-share)"), "{contacts}");
        // Nearly all of a soft surface is at its hardness, which no mean pressure exceeds.
        scene.interface.hardness = Some(70.3);
        let soft = on(&scene, PerssonVariance::Plastic).unwrap();
        for k in 1..1000 {
            let at = At::Pressure(70.3 * f64::from(k) / 1000.0);
            let mean = soft.evaluate(Quantity::MeanPressure, at).unwrap().value();
            assert!(mean <= 70.3 && mean > 70.2, "{k}: {mean:e}");
        }
        for at in [At::Pressure(8e4), At::Load(9e4 * 3e-5)] {
            let text = of(Quantity::Area, at).unwrap_err().to_string();
            assert!(text.contains("(80000 Pa)"), "{text}");
        }
    }

    #[test]
    fn closed_gaps_are_refused_in_both_directions() {
        let persson = Persson { hurst_exponent: Some(0.8), ..Persson::default() };
        let scene = scene();
        let contact = persson.compile(&scene, &Request::new(Quantity::ALL)).unwrap();
        let gap = |metres| At::Separation(Separation::metres(metres).from_surface_mean());
        let refused =
            |metres| contact.evaluate(Quantity::Force, gap(metres)).unwrap_err().to_string();
        let (small, large) = (refused(1e-290), refused(1.0));
        assert!(small.contains("below 17 E g"), "{small}");
        assert!(large.contains("above 1e-300 E g"), "{large}");
        // g = 0.02, E = 2e6 Pa.
        let load = |over: f64| over * 4e4 * scene.nominal_area;
        let closed = contact.separation(At::Load(load(20.0))).unwrap_err().to_string();
        assert!(closed.starts_with("load is 24"), "{closed}");
        // The load follows back from the gap.
        let last = contact.separation(At::Load(load(17.0))).unwrap();
        let force = contact.evaluate(Quantity::Force, last).unwrap().value();
        assert!((force / load(17.0) - 1.0).abs() < 1e-8, "{force}");
    }

    #[test]
    fn the_reason_why_a_scan_has_no_spectrum_is_reported() {
        let spectrum = Some(Err("a gap".to_string()));
        let persson = Persson { spectrum, ..Persson::default() };
        let contact = persson.compile(&scene(), &Request::new(Quantity::ALL)).unwrap();
        let message = contact.evaluate(Quantity::Tangent, At::Load(1.0)).unwrap_err().to_string();
        assert!(message.ends_with("a gap)"), "{message}");
    }
}
