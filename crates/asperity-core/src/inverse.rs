//! From a load back to the separation that carries it.

use asperity_quadrature::bracketed_root;

use crate::{Compiled, ContactError, Quantity};

/// The smallest separation that can be evaluated, over σ_z.
const DEEPEST: f64 = -1e6;
/// Down to here, crossings are looked for where the force need not be monotone; deeper down all
/// asperities are in contact, and none is known to turn around.
const DEEP: f64 = -64.0;
/// Where the force need not be monotone, crossings nearer to each other than this may be missed.
const STEP: f64 = 0.1;

impl Compiled {
    /// The separations d/σ_z at which the force is `load` \[N\], ascending: one for a model whose
    /// force is monotone, possibly several for others (AT as printed rises and falls).
    ///
    /// Any load that a double can hold is met, far tails included, to the last digits of d, down
    /// to a separation of -1e6. Where the force is not monotone, crossings are sought in steps of
    /// 0.1 from the first separation above which it falls below the load for good down to -64, and
    /// in steps that double further down.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a load that is not positive, [`ContactError::OutOfReach`]
    /// with the largest force for one that the model cannot carry, [`ContactError::NotRequested`]
    /// when the scene was compiled without the force, and [`ContactError::Integral`].
    pub fn separations_at(&self, load: f64) -> Result<Vec<f64>, ContactError> {
        let ln_load = crate::positive("load", load)?.ln();
        // Positive where the force is above the load.
        let above = |s: f64| -> Result<f64, ContactError> {
            let force = self.evaluate(Quantity::Force, s)?;
            Ok(if force.scaled > 0.0 { force.ln_value() - ln_load } else { -f64::MAX })
        };
        let mut high = 1.0;
        // Whatever its sign, the force must be below the load from there on.
        while self.evaluate(Quantity::Force, high)?.ln_value() > ln_load {
            // A Gaussian tail falls as exp(-s²/2), an exponential one as exp(-s): doubling finds both.
            high *= 2.0;
        }
        let mut found = vec![];
        let mut above_high = above(high)?;
        let mut step = if self.monotone() { 1.0 } else { STEP };
        while high > DEEPEST {
            let low = if high > DEEP && !self.monotone() {
                (high - step).max(DEEP)
            } else if found.is_empty() {
                step = (2.0 * step).max(1.0);
                (high - step).max(DEEPEST)
            } else {
                break;
            };
            let above_low = match above(low) {
                // Where the integrals end, so does what can be carried.
                Err(ContactError::Integral { .. }) if low < DEEP => break,
                other => other?,
            };
            if above_low * above_high <= 0.0 {
                // The ends have been evaluated; inside, nothing new can go wrong.
                found.extend(bracketed_root(|s| above(s).unwrap_or(f64::NAN), low, high));
            }
            (high, above_high) = (low, above_low);
        }
        if found.is_empty() {
            let largest = self.evaluate(Quantity::Force, high)?.value();
            return Err(ContactError::OutOfReach { load, largest, separation: high });
        }
        found.sort_by(f64::total_cmp);
        found.dedup();
        Ok(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Asperity, ContactModel, Interface, Law, Power, Provenance, Request, Scene, Source, Surface,
        Tolerance,
    };

    #[derive(Debug)]
    struct Hertz;

    const SOURCE: Source = Source {
        id: "hertz",
        name: "Hertz",
        authors: "Hertz",
        year: 1882,
        title: "",
        provenance: Provenance::Seen,
    };

    impl ContactModel for Hertz {
        fn source(&self) -> &Source {
            &SOURCE
        }
        fn law(&self, a: &Asperity, _: Quantity, _: Tolerance) -> Result<Law, ContactError> {
            let unit = 4.0 / 3.0 * a.equivalent_modulus * a.radius.sqrt();
            Ok(Law::in_units(1.0, unit).elastic(0.0..f64::INFINITY, [Power::new(1.0, 1.5)]))
        }
    }

    #[test]
    fn loads_lead_back_to_their_separations() {
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-5);
        let compiled = Hertz.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        for s in [-63.0, -10.0, -0.3, 0.0, 1.0, 4.4, 20.0, 36.0] {
            let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
            let found = compiled.separations_at(load).unwrap();
            // The rule's own error moves the root by less than this.
            assert!(
                found.len() == 1 && (found[0] - s).abs() < 1e-12 * (1.0 + s.abs()),
                "{s}: {found:?}"
            );
        }
    }

    #[test]
    fn loads_that_press_all_asperities_flat_are_met_too() {
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-5);
        let compiled = Hertz.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        for s in [-70.0, -1e5] {
            let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
            let found = compiled.separations_at(load).unwrap();
            // Each force is integrated anew there, to the tolerance of 1e-10.
            assert!(found.len() == 1 && (found[0] / s - 1.0).abs() < 1e-9, "{s}: {found:?}");
        }
    }

    #[test]
    fn loads_out_of_reach_are_refused_with_the_largest_force() {
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-5);
        let compiled = Hertz.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        let error = compiled.separations_at(1e30).unwrap_err();
        assert!(
            matches!(error, ContactError::OutOfReach { largest, .. } if largest > 1e6),
            "{error}"
        );
        for bad in [0.0, -1.0, f64::NAN] {
            assert!(compiled.separations_at(bad).unwrap_err().to_string().starts_with("load is"));
        }
    }
}
