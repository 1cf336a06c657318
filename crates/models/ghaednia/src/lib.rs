#![doc = include_str!("../README.md")]

use std::f64::consts::PI;
use std::ops::Range;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Power, Provenance,
    Tolerance, Validity, require,
};
use serde::{Deserialize, Serialize};

/// The model of Ghaednia, Brake, Berryhill and Jackson.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Ghaednia;

const SOURCE: Citation = Citation {
    id: "ghaednia",
    name: "Ghaednia",
    authors: "Ghaednia, Brake, Berryhill & Jackson",
    year: 2019,
    title: "Strain hardening from elastic-perfectly plastic to perfectly elastic flattening single asperity contact",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Ghaednia, H. and Brake, M. R. W. and Berryhill, M. and Jackson, R. L."),
        ("journal", "Journal of Tribology"),
    ],
};

/// End of the elastic range, in units of w_y.
const ELASTIC_END: f64 = 1.9;
const BEYOND: Range<f64> = ELASTIC_END..f64::INFINITY;

/// The numbers of the law beyond x = 1.9. None depends on the radius.
#[derive(Debug, Clone, Copy)]
struct FittedLaw {
    c: f64,
    /// √(w_y/R) = π C S_y/(2E).
    strain: f64,
    b: f64,
    /// E_t/E_b.
    hardening: f64,
    /// k = 2 √(E_b/S_y).
    k: f64,
}

impl FittedLaw {
    fn new(asperity: &Asperity) -> Result<Self, ContactError> {
        let (strength, modulus) = (asperity.yield_strength()?, asperity.equivalent_modulus);
        let tangent = asperity.tangent_modulus.ok_or_else(|| ContactError::Missing {
            field: "tangent_modulus",
            reason: "ghaednia needs two bodies with the same youngs_modulus and poissons_ratio, and a tangent_modulus of the softer one, or the same of both if they are equally hard".into(),
        })?;
        let c = 1.295 * (0.736 * asperity.poissons_ratio).exp();
        let strain = 0.5 * PI * c * strength / modulus;
        let required = "a yield strength below 2E/(pi C), so that the interference at first yield is smaller than the radius,";
        require(strain < 1.0, "yield_strength", strength, required)?;
        let youngs_modulus = 2.0 * (1.0 - asperity.poissons_ratio.powi(2)) * modulus;
        Ok(Self {
            c,
            strain,
            b: 0.14 * (11.5 * strength / modulus).exp(),
            hardening: tangent / youngs_modulus,
            k: 2.0 * (youngs_modulus / strength).sqrt(),
        })
    }

    /// a/a_e = 1 + (a_p/a_e - 1) e^U, with a_p/a_e = (x/1.9)^(B/2).
    fn radius_ratio(&self, x: f64) -> f64 {
        let exponent = if self.hardening > 0.0 {
            let interference = 0.25 * self.strain * self.strain * (x - 1.0);
            let share = self.hardening.powf(1.0 - interference);
            let (k, e) = (self.k, self.hardening);
            -k * share / ((4.0 - 3.0 * (-k * e).exp()) * (1.0 - e))
        } else {
            0.0
        };
        1.0 + (0.5 * self.b * (x / ELASTIC_END).ln()).exp_m1() * exponent.exp()
    }

    /// F/F_y: the plastic law with the share e^(-3.3 E_t/E_b), and the elastic one with the rest.
    fn force(&self, x: f64) -> f64 {
        let (ln_x, elastic) = (x.ln(), x * x.sqrt());
        // a/(2R), with a_e/R = strain √x.
        let half_angle = 0.5 * self.strain * x.sqrt() * self.radius_ratio(x);
        let hardness = 2.84 - 0.92 * (1.0 - (PI * half_angle).cos());
        let full = -(-(5.0 / 9.0 * ln_x).exp() / 25.0).exp_m1();
        let plastic =
            (-(5.0 / 12.0 * ln_x).exp() / 4.0).exp() * elastic + 4.0 / self.c * hardness * full * x;
        let share = (-3.3 * self.hardening).exp();
        share * plastic + (1.0 - share) * elastic
    }

    /// A/A_y = x (a/a_e)².
    fn area(&self, x: f64) -> f64 {
        x * self.radius_ratio(x).powi(2)
    }

    fn key(&self) -> Vec<f64> {
        vec![self.c, self.strain, self.b, self.hardening, self.k]
    }
}

impl Described for Ghaednia {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            force_monotone: false,
            valid_for: "w < R; two like bodies with a tangent modulus; fitted to finite elements with hardening",
            ..Validity::default()
        }
    }
}

impl AsperityModel for Ghaednia {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let (fit, r) = (FittedLaw::new(asperity)?, asperity.radius);
        // F/F_y = x^1.5, then the fit; F_y = (4/3) E R² strain³
        let unit = 4.0 / 3.0 * asperity.equivalent_modulus * r * r * fit.strain.powi(3);
        let form = Formula::function(move |x| fit.force(x)).known_as("Ghaednia force", fit.key());
        Ok(Law::in_units(fit.strain * fit.strain * r, unit)
            .elastic(0.0..ELASTIC_END, [Power::new(1.0, 1.5)])
            .elastic_plastic(BEYOND, form))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let (fit, r) = (FittedLaw::new(asperity)?, asperity.radius);
        // A/A_y = x, then the fit
        let unit = fit.strain * fit.strain * r;
        let form = Formula::function(move |x| fit.area(x)).known_as("Ghaednia area", fit.key());
        Ok(Law::in_units(unit, PI * r * unit)
            .elastic(0.0..ELASTIC_END, [Power::new(1.0, 1.0)])
            .elastic_plastic(BEYOND, form))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::{Body, Interface, testkit};

    fn asperity(e: f64, nu: f64, tangent: f64, strength: f64, radius: f64) -> Asperity {
        let mut body = Body::yielding(e, nu, strength);
        body.tangent_modulus = Some(tangent);
        Asperity::new(&Interface::between(&body, &body).unwrap(), radius).unwrap()
    }

    /// Force [N] and area [m²].
    fn at(asperity: &Asperity, interference: f64) -> [f64; 2] {
        let tolerance = Tolerance::default();
        let laws = [Ghaednia.force(asperity, tolerance), Ghaednia.area(asperity, tolerance)];
        laws.map(|law| law.unwrap().value(interference).unwrap())
    }

    /// Forces and contact radii that public code of joint dynamics publishes with its tests.
    #[test]
    fn forces_and_radii_are_those_of_public_code() {
        let steel = |tangent| asperity(192e9, 0.3, tangent, 330e6, 1.4e-3);
        let soft = asperity(250e9, 0.2, 800e6, 200e6, 5e-3);
        let rows = [
            (steel(620e6), 2.644729276723e-7, 0.6888366827256, 1.982362642132e-5),
            (steel(620e6), 3.526305702297e-7, 1.027539609829, 2.332476313491e-5),
            (steel(620e6), 5.289458553446e-7, 1.79358619399, 2.933583720063e-5),
            (steel(620e6), 7.052611404594e-7, 2.649302530405, 3.452008361584e-5),
            (steel(0.0), 2.644729276723e-7, 0.6885474816181, 1.989065002445e-5),
            (soft, 1.965663967998e-7, 1.052855831184, 3.225058324276e-5),
        ];
        for (asperity, w, force, radius) in rows {
            let [found, area] = at(&asperity, w);
            assert!((found / force - 1.0).abs() < 1e-12, "{w}");
            assert!(((area / PI).sqrt() / radius - 1.0).abs() < 1e-12, "{w}");
        }
    }

    #[test]
    fn the_force_jumps_where_hertz_ends_as_stated() {
        let steel = asperity(192e9, 0.3, 0.0, 330e6, 1.4e-3);
        let force = Ghaednia.force(&steel, Tolerance::default()).unwrap();
        let end = ELASTIC_END * force.interference_unit;
        let jump = at(&steel, end * (1.0 + 1e-9))[0] / at(&steel, end * (1.0 - 1e-9))[0] - 1.0;
        assert!((jump - 0.0047).abs() < 5e-5, "{jump}");
    }

    #[test]
    fn hardening_up_to_youngs_modulus_is_nearly_hertz() {
        let hard = asperity(200e9, 0.3, 0.999_999 * 200e9, 400e6, 1e-3);
        let w = 2e-6f64;
        let hertz = 4.0 / 3.0 * hard.equivalent_modulus * 1e-3f64.sqrt() * w.powf(1.5);
        let [force, area] = at(&hard, w);
        // e^(-3.3) of the plastic law is left.
        assert!((force / hertz - 1.0).abs() < 0.04);
        assert!((area / (PI * 1e-3 * w) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_laws_keep_what_they_claim() {
        for tangent in [0.0, 1e8, 2e9, 5e10] {
            let asperity = asperity(200e9, 0.3, tangent, 400e6, 1e-3);
            let found = testkit::check(&Ghaednia, &asperity).unwrap();
            assert!(
                found.iter().all(|finding| finding.code == asperity_core::Code::NotMonotone),
                "{found:?}"
            );
        }
    }

    #[test]
    fn other_pairs_are_refused_with_what_is_needed() {
        let mut body = Body::yielding(200e9, 0.3, 400e6);
        let bare = Asperity::new(&Interface::between(&body, &body).unwrap(), 1e-3).unwrap();
        body.tangent_modulus = Some(1e9);
        let on_rigid = Asperity::new(&Interface::against_rigid(&body).unwrap(), 1e-3).unwrap();
        for asperity in [bare, on_rigid] {
            let refused = Ghaednia.force(&asperity, Tolerance::default());
            let message = refused.unwrap_err().to_string();
            assert!(message.starts_with("tangent_modulus is missing"), "{message}");
        }
    }
}
