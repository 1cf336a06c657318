//! From a load back to the separations that carry it.

use asperity_quadrature::Moments;

use crate::engine::onset::Onset;
use crate::request::separation::{HIGHEST, LOWEST, Place};
use crate::{At, ContactError};

/// Below this all asperities are in contact.
pub(crate) const DEEP: f64 = -64.0;
/// A Newton search ends in some five steps; a bracketed one, at the worst, in some sixty.
const MOST: usize = 200;

/// The force of a scene, to be inverted: where its integrals come from, and their unit.
pub(crate) trait ForceCurve {
    /// The integral and its slope.
    fn at(&mut self, s: f64) -> Result<Moments, ContactError>;

    /// The same as [`at`](Self::at), but for sizes that are sums over those of the law's parts: these
    /// fall with s where each part rises with the interference, and their sum does not.
    fn parts(&mut self, s: f64) -> Result<Moments, ContactError>;

    /// Whether what [`at`](Self::at) tells has become better near s, so that it is worth asking
    /// again.
    fn settle(&mut self, _s: f64) -> Result<bool, ContactError> {
        Ok(false)
    }
}

/// A load to be carried, and what is known of the force law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Target {
    /// \[N\]; below 0 for a tension.
    pub(crate) load: f64,
    /// What the integral is multiplied with \[N\].
    pub(crate) factor: f64,
    /// Whether the force never rises with the separation.
    pub(crate) monotone: bool,
    /// Whether parts of the law are subtracted.
    pub(crate) signed: bool,
    /// Whether adhesion is what is subtracted.
    pub(crate) adhesive: bool,
    /// Where the law begins.
    pub(crate) begins: Onset,
}

/// A load, or a pressure, that may be asked for: above 0, or a tension where there is adhesion.
pub(crate) fn check_load(
    field: &'static str,
    value: f64,
    adhesive: bool,
) -> Result<f64, ContactError> {
    if value != 0.0 && value.abs() < f64::MIN_POSITIVE {
        let required = "one that a double holds to all digits (2.2e-308 and more)";
        return Err(ContactError::OutOfRange { field, value, required });
    }
    let required = "a finite number other than 0 (below it for tensions)";
    match adhesive {
        true if value.is_finite() && value != 0.0 => Ok(value),
        true => Err(ContactError::OutOfRange { field, value, required }),
        false => crate::positive(field, value),
    }
}

/// Which integral is set against the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Of {
    /// The force itself.
    Value,
    /// The integral of the law's absolute value, which no force exceeds.
    Size,
}

impl Target {
    /// Where the load is first met on approach: the largest separation that carries it.
    pub(crate) fn first(&self, curve: &mut impl ForceCurve) -> Result<Place, ContactError> {
        if !self.signed {
            return self.newton(curve, Of::Value);
        }
        let mut s = self.crossings(curve, true)?[0];
        let mut moments = curve.at(s)?;
        for _ in 0..MOST {
            // Where integrals were made elsewhere, what they say of s is a guide.
            if !curve.settle(s)? {
                break;
            }
            let step = self.step(curve, s)?;
            moments = curve.at(s)?;
            s += step;
        }
        Ok(self.place(s, &moments))
    }

    /// All separations d/σ_z that carry it, ascending.
    pub(crate) fn all(&self, curve: &mut impl ForceCurve) -> Result<Vec<f64>, ContactError> {
        if self.monotone {
            return Ok(vec![self.newton(curve, Of::Value)?.s]);
        }
        let mut found = self.crossings(curve, false)?;
        found.sort_by(f64::total_cmp);
        found.dedup();
        Ok(found)
    }

    /// ln of an integral over the load, and its fall with s.
    fn measure(&self, moments: &Moments, of: Of) -> (f64, f64) {
        let [value, slope] = match of {
            Of::Value => [moments.value, moments.slope],
            Of::Size => moments.sizes,
        };
        if value > 0.0 {
            let ln = value.ln() + moments.ln_scale + (self.factor / self.load.abs()).ln();
            (ln, slope / value)
        } else {
            (f64::NEG_INFINITY, 0.0)
        }
    }

    /// The root of a positive integral. In the tail its logarithm is concave, so that Newton's
    /// steps come down from the right; brackets guard what is not.
    pub(crate) fn newton(
        &self,
        curve: &mut impl ForceCurve,
        of: Of,
    ) -> Result<Place, ContactError> {
        let parts = self.adhesive && of == Of::Size;
        let look = |curve: &mut _, s| match parts {
            true => ForceCurve::parts(curve, s),
            false => ForceCurve::at(curve, s),
        };
        let mut s = self.guess(&look(curve, 0.0)?, of);
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut last = f64::INFINITY;
        for _ in 0..MOST {
            let moments = match look(curve, s) {
                // Where the integrals end, so does what can be carried.
                Err(ContactError::Integral { .. }) if s < DEEP && low < DEEP => {
                    return Err(self.out_of_reach(curve, high.min(DEEP)));
                }
                other => other?,
            };
            let (above, fall) = self.measure(&moments, of);
            if above > 0.0 {
                low = s;
            } else {
                high = s;
            }
            if s <= LOWEST && above < 0.0 {
                return Err(self.out_of_reach(curve, s));
            }
            if s >= HIGHEST && above > 0.0 {
                let smallest = self.load.abs() * above.exp();
                return Err(ContactError::TooLight { load: self.load, smallest, at: s.into() });
            }
            let mut next = s + above / fall;
            let unit = f64::EPSILON * (1.0 + s.abs());
            // A root that is met lies on its own bracket.
            let inside = next > low && next < high || (next - s).abs() <= unit;
            if !(inside || above == 0.0) {
                next = match (low.is_finite(), high.is_finite()) {
                    (true, true) => 0.5 * (low + high),
                    (false, _) => high - 2.0 * (1.0 + high.abs()),
                    (true, false) => low + 2.0 * (1.0 + low.abs()),
                };
            }
            next = next.clamp(LOWEST, HIGHEST);
            let step = (next - s).abs();
            // Newton's steps shrink as their squares: this one may be the last that is seen.
            let remains = match inside && last.is_finite() {
                true => step * (step / last) * (step / last),
                false => step,
            };
            s = next;
            if step <= 4.0 * unit || remains <= 0.25 * unit || high - low <= 4.0 * unit {
                if curve.settle(s)? {
                    (low, high, last) = (f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY);
                    continue;
                }
                return Ok(self.place(s, &moments));
            }
            last = if inside { step } else { f64::INFINITY };
        }
        Ok(Place { s, rounding: high - low })
    }

    /// From the value and the slope at 0: exp(-a s - s²/2) above, a power of the overlap below.
    fn guess(&self, at_zero: &Moments, of: Of) -> f64 {
        let (above, fall) = self.measure(at_zero, of);
        if !(above.is_finite() && fall > 0.0) {
            return -1.0;
        }
        if above > 0.0 {
            return 2.0 * above / (fall + (fall * fall + 2.0 * above).sqrt());
        }
        const POWER: f64 = 1.3;
        (-(POWER / fall) * (-above / POWER).exp_m1()).max(LOWEST)
    }

    /// What the error of the force makes of the root's.
    fn place(&self, s: f64, moments: &Moments) -> Place {
        let error = moments.error * moments.sizes[0] / moments.slope.abs();
        let rounding = error + 2.0 * f64::EPSILON * (1.0 + s.abs());
        Place { s, rounding }
    }

    pub(crate) fn out_of_reach(&self, curve: &mut impl ForceCurve, s: f64) -> ContactError {
        let force = |m: Moments| m.value * m.ln_scale.exp() * self.factor;
        match curve.at(s) {
            Ok(moments) => ContactError::OutOfReach {
                load: self.load,
                largest: force(moments),
                at: At::sigmas(s),
            },
            Err(error) => error,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Asperity, AsperityModel, Citation, Contact, ContactModel, Described, Interface, Law, Power,
        Provenance, Quantity, Request, Scene, Surface, Tolerance,
    };

    #[derive(Debug)]
    struct Hertz;

    const SOURCE: Citation = Citation {
        id: "hertz",
        name: "Hertz",
        authors: "Hertz",
        year: 1882,
        title: "",
        provenance: Provenance::Seen,
    };

    impl Described for Hertz {
        fn citation(&self) -> &Citation {
            &SOURCE
        }
    }

    impl AsperityModel for Hertz {
        fn law(
            &self,
            a: &Asperity,
            _: Quantity,
            _: Tolerance,
        ) -> Result<Option<Law>, ContactError> {
            let unit = 4.0 / 3.0 * a.equivalent_modulus * a.radius.sqrt();
            Ok(Some(Law::in_units(1.0, unit).elastic(0.0..f64::INFINITY, [Power::new(1.0, 1.5)])))
        }
    }

    fn compiled() -> Box<dyn Contact> {
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-5);
        Hertz.compile(&scene, &Request::new([Quantity::Force])).unwrap()
    }

    #[test]
    fn loads_lead_back_to_their_separations() {
        let compiled = compiled();
        for s in [-63.0, -10.0, -0.3, 0.0, 1.0, 4.4, 20.0, 36.0] {
            let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
            let found = compiled.separations_at(load).unwrap();
            assert!(found.len() == 1 && found[0] == compiled.separation_at(load).unwrap());
            // The rule's own error moves the root by less than this.
            let error = (found[0].value - s).abs();
            assert!(error < 1e-12 * (1.0 + s.abs()), "{s}: {found:?}");
        }
    }

    #[test]
    fn loads_that_press_all_asperities_flat_are_met_too() {
        let compiled = compiled();
        for s in [-70.0, -1e5] {
            let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
            let found = compiled.separations_at(load).unwrap();
            // Each force is integrated anew there, to the tolerance of 1e-10.
            assert!(found.len() == 1 && (found[0].value / s - 1.0).abs() < 1e-9, "{s}: {found:?}");
        }
    }

    #[test]
    fn quantities_at_a_load_are_those_at_its_separation_within_their_bounds() {
        let compiled = compiled();
        for load in [1e-30, 1e-3, 1.0, 1e4] {
            let force = compiled.evaluate(Quantity::Force, At::Load(load)).unwrap();
            assert!((force.value() / load - 1.0).abs() <= force.relative_error(), "{load}");
            assert!(force.relative_error() < 1e-9);
            let by_pressure =
                compiled.evaluate(Quantity::Force, At::Pressure(load / 1e-5)).unwrap();
            assert!((by_pressure.value() / load - 1.0).abs() <= by_pressure.relative_error());
        }
    }

    #[test]
    fn loads_out_of_reach_are_refused_with_the_largest_force() {
        let compiled = compiled();
        let error = compiled.separations_at(1e30).unwrap_err();
        assert!(
            matches!(error, ContactError::OutOfReach { largest, .. } if largest > 1e6),
            "{error}"
        );
        for bad in [0.0, -1.0, f64::NAN, 1e-320] {
            assert!(compiled.separations_at(bad).unwrap_err().to_string().starts_with("load is"));
        }
        let error = compiled.evaluate(Quantity::Force, At::Pressure(-1.0)).unwrap_err().to_string();
        assert!(error.starts_with("pressure is -1.0"), "{error}");
    }
}
