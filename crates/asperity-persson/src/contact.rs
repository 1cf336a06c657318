//! A scene under Persson's theory.

use asperity_core::{
    At, Contact, ContactError, ContactModel, Evaluation, Quantity, Scene, positive,
};

use crate::Persson;

/// Bound on the relative error of areas: rounding alone.
const ERROR: f64 = 1e-14;

/// What is known of a load.
const QUANTITIES: [Quantity; 7] = [
    Quantity::Force,
    Quantity::Pressure,
    Quantity::Area,
    Quantity::AreaFraction,
    Quantity::MeanPressure,
    Quantity::LnForce,
    Quantity::LnArea,
];

#[derive(Debug)]
pub(crate) struct OnScene {
    pub(crate) model: Persson,
    pub(crate) scene: Scene,
    pub(crate) quantities: Vec<Quantity>,
    /// √V \[Pa\], the standard deviation of the pressure at full contact.
    pub(crate) pressure_std: f64,
}

impl Contact for OnScene {
    fn model(&self) -> &str {
        self.model.name()
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        if !self.quantities.contains(&quantity) {
            return Err(ContactError::NotRequested { quantity });
        }
        if !QUANTITIES.contains(&quantity) {
            let known = QUANTITIES.map(|q| q.to_string()).join(", ");
            return Err(self.unsupported(&format!("{quantity} (it gives {known})")));
        }
        let nominal = self.scene.nominal_area;
        let pressure = match at {
            At::Pressure(pressure) => positive("pressure", pressure)?,
            At::Load(load) => positive("load", load)? / nominal,
            _ => return Err(self.unsupported("an answer at a separation (it gives them at loads)")),
        };
        let fraction = self.model.variance.area_fraction(pressure / self.pressure_std);
        let totals = (pressure * nominal, fraction * nominal);
        match Evaluation::of_totals(quantity, totals, nominal, ERROR) {
            Some(found) if found.scaled.is_finite() => Ok(found),
            _ => Err(ContactError::NoValue { quantity, at }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Variance;
    use asperity_core::{
        HeightDistribution, Interface, ProfileMoments, Request, Separation, Surface,
    };

    const MOMENTS: ProfileMoments = ProfileMoments { m0: 1e-12, m2: 2e-4, m4: 3.2e5 };

    fn scene() -> Scene {
        let surface = Surface::from_moments(&MOMENTS).unwrap();
        Scene::new(Interface::elastic(2e6, 0.5), surface, 3e-5)
    }

    fn on(scene: &Scene, variance: Variance) -> Result<Box<dyn Contact>, ContactError> {
        Persson { variance }.compile(scene, &Request::new(Quantity::ALL))
    }

    #[test]
    fn the_m2_of_the_moments_given_sets_the_area() {
        // g = √(2 m₂) = 0.02: the published value at p/(E g) = 0.1 is at 4 kPa.
        let contact = on(&scene(), Variance::Fudge).unwrap();
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
    fn what_it_does_not_know_is_refused_by_name() {
        let contact = on(&scene(), Variance::Full).unwrap();
        let refused = |q, at: At| contact.evaluate(q, at).unwrap_err().to_string();
        let tangent = refused(Quantity::Tangent, At::Load(1.0));
        assert!(tangent.starts_with("Persson cannot give tangent (it gives force"), "{tangent}");
        let text = refused(Quantity::Area, At::Separation(Separation::sigmas(1.0)));
        assert!(text.contains("at a separation") && text.contains("loads"), "{text}");
        assert!(contact.separation(At::Load(1.0)).is_err());
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(refused(Quantity::Area, At::Load(bad)).starts_with("load is"));
            assert!(refused(Quantity::Area, At::Pressure(bad)).starts_with("pressure is"));
        }
        let mut exponential = scene();
        exponential.heights = HeightDistribution::Exponential;
        let text = on(&exponential, Variance::Fudge).unwrap_err().to_string();
        assert!(text.contains("Persson fudge") && text.contains("exponential"), "{text}");
        let mut bad = scene();
        bad.surface.asperity_density = -1.0;
        assert!(on(&bad, Variance::Full).unwrap_err().to_string().contains("asperity_density"));
    }
}
