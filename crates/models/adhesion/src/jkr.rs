//! Johnson, Kendall & Roberts: adhesion stretches the contact, which lasts below w = 0 on
//! separation.

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Provenance,
    Tolerance, Validity,
};
use asperity_gw::GreenwoodWilliamson;
use serde::{Deserialize, Serialize};

use crate::adhesive_validity;

/// The direction in which the surfaces move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum JkrBranch {
    /// Towards each other for the first time: contacts form at w = 0.
    #[default]
    Approach,
    /// Away from each other after contact: contacts last until w = -w_p.
    Separation,
}

impl JkrBranch {
    /// w/w_p at the onset of contact.
    fn onset(self) -> f64 {
        match self {
            Self::Approach => 0.0,
            Self::Separation => -1.0,
        }
    }

    /// r at the onset of contact, where it is least.
    fn least(self) -> f64 {
        match self {
            Self::Approach => 4f64.cbrt(),
            Self::Separation => 1.0,
        }
    }

    /// r at the distance x = w/w_p - onset from the onset of contact: (r⁴ - 4r)/3 = x + onset.
    fn root(self, x: f64) -> f64 {
        let b = self.least();
        // With r = b + u: 3x = u (c₁ + u (c₂ + u (c₃ + u))), all terms ≥ 0, without cancellation.
        let c1 = match self {
            Self::Approach => 12.0,
            Self::Separation => 0.0,
        };
        let (c2, c3, y) = (6.0 * b * b, 4.0 * b, 3.0 * x);
        // The smallest root of the single terms is above u; Newton's method descends from it.
        let mut u = y.sqrt().sqrt().min((y / c2).sqrt());
        if c1 > 0.0 {
            u = u.min(y / c1);
        }
        for _ in 0..60 {
            let value = u * (c1 + u * (c2 + u * (c3 + u)));
            let slope = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * 4.0));
            let next = u - (value - y) / slope;
            // The descent ends at rounding.
            if !(next < u && next > 0.0) {
                break;
            }
            u = next;
        }
        b + u
    }
}

/// The model of Johnson, Kendall and Roberts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct JohnsonKendallRoberts {
    /// The direction in which the surfaces move.
    pub branch: JkrBranch,
}

const SOURCE: Citation = Citation {
    id: "jkr",
    name: "JKR",
    authors: "Johnson, Kendall & Roberts",
    year: 1971,
    title: "Surface energy and the contact of elastic solids",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Johnson, K. L. and Kendall, K. and Roberts, A. D."),
        ("journal", "Proceedings of the Royal Society of London A"),
        ("volume", "324"),
        ("number", "1558"),
        ("pages", "301--313"),
        ("doi", "10.1098/rspa.1971.0141"),
    ],
};

const SEPARATION: Citation = Citation { id: "jkr-separation", name: "JKR separation", ..SOURCE };

/// w_a and w_p; `None` without adhesion.
fn constants(asperity: &Asperity) -> Result<Option<[f64; 2]>, ContactError> {
    let (work, r) = (asperity.adhesion(SOURCE.id)?, asperity.radius);
    let strain = PI * work / (8.0 * asperity.equivalent_modulus * r);
    let last = 3.0 * r * (strain * strain).cbrt();
    Ok((work != 0.0).then_some([work, last]))
}

impl JohnsonKendallRoberts {
    /// A power of r as a function of x.
    fn power(self, coefficient: f64, exponent: i32) -> Formula {
        let branch = self.branch;
        let name = match branch {
            JkrBranch::Approach => "power of JKR's radius on approach",
            JkrBranch::Separation => "power of JKR's radius on separation",
        };
        Formula::function(move |x| coefficient * branch.root(x).powi(exponent))
            .known_as(name, vec![coefficient, f64::from(exponent)])
    }
}

impl Described for JohnsonKendallRoberts {
    fn citation(&self) -> &Citation {
        match self.branch {
            JkrBranch::Approach => &SOURCE,
            JkrBranch::Separation => &SEPARATION,
        }
    }

    fn variant(&self) -> Vec<&'static str> {
        match self.branch {
            JkrBranch::Approach => vec![],
            JkrBranch::Separation => vec!["for surfaces that move apart after contact"],
        }
    }

    fn validity(&self) -> Validity {
        let valid_for = "elastic asperities with adhesion; Tabor parameter above about 5";
        adhesive_validity([5.0, f64::INFINITY], valid_for)
    }
}

impl AsperityModel for JohnsonKendallRoberts {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        let Some([work, last]) = constants(asperity)? else {
            return GreenwoodWilliamson.force(asperity, tolerance);
        };
        // F/(π w_a R) = r⁶/6 - r³
        Ok(Law::in_units(last, PI * work * asperity.radius)
            .with_onset(self.branch.onset())
            .elastic(0.0..f64::INFINITY, self.power(1.0 / 6.0, 6))
            .less_adhesion(0.0..f64::INFINITY, self.power(1.0, 3)))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        let Some([_, last]) = constants(asperity)? else {
            return GreenwoodWilliamson.area(asperity, tolerance);
        };
        // A = π a², a² = (R w_p/3) r⁴
        Ok(Law::in_units(last, PI * asperity.radius * last / 3.0)
            .with_onset(self.branch.onset())
            .elastic(0.0..f64::INFINITY, self.power(1.0, 4)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::{Interface, testkit};

    /// The published equations, as functions of the contact radius.
    fn printed(asperity: &Asperity, a: f64) -> [f64; 3] {
        let (e, r) = (asperity.equivalent_modulus, asperity.radius);
        let work = asperity.work_of_adhesion.unwrap();
        let w = a * a / r - (2.0 * PI * work * a / e).sqrt();
        let force = 4.0 * e * a.powi(3) / (3.0 * r) - (8.0 * PI * work * e * a.powi(3)).sqrt();
        [w, force, PI * a * a]
    }

    #[test]
    fn both_branches_satisfy_the_published_equations() {
        let mut interface = Interface::elastic(3e6, 0.5);
        interface.work_of_adhesion = Some(0.08);
        let asperity = Asperity::new(&interface, 2e-4).unwrap();
        let least = (PI * 0.08 * 2e-4f64.powi(2) / (8.0 * 3e6)).cbrt();
        for branch in [JkrBranch::Approach, JkrBranch::Separation] {
            let model = JohnsonKendallRoberts { branch };
            assert_eq!(testkit::check(&model, &asperity).unwrap()[..], []);
            let force = model.force(&asperity, Tolerance::default()).unwrap();
            let area = model.area(&asperity, Tolerance::default()).unwrap();
            // From the smallest radius of the branch upwards.
            let first = least * branch.least().powi(2);
            for k in 1..60 {
                let a = first * 1.3f64.powi(k);
                let [w, f, area_wanted] = printed(&asperity, a);
                let found = area.value(w).unwrap();
                assert!((found / area_wanted - 1.0).abs() < 1e-13, "{k}: {found}");
                // The two published terms cancel in part.
                let large = 4.0 * 3e6 * a.powi(3) / (3.0 * 2e-4);
                assert!((force.value(w).unwrap() - f).abs() < 1e-12 * (large + f.abs()), "{k}");
            }
            let [w, f, _] = printed(&asperity, first);
            let (below, above) = (w - 1e-6 * w.abs() - 1e-15, w + 1e-12 * w.abs() + 1e-21);
            assert!(force.value(below).unwrap() == 0.0 && area.value(below).unwrap() == 0.0);
            assert!((force.value(above).unwrap() / f - 1.0).abs() < 1e-5);
            let jump = [-4.0 / 3.0, -5.0 / 6.0][usize::from(branch == JkrBranch::Separation)];
            assert!((f / (jump * PI * 0.08 * 2e-4) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_root_is_accurate_at_all_scales() {
        for branch in [JkrBranch::Approach, JkrBranch::Separation] {
            for k in -300..300 {
                let x = 10f64.powi(k);
                let (b, r) = (branch.least(), branch.root(x));
                let u = r - b;
                let c1 = if branch == JkrBranch::Approach { 12.0 } else { 0.0 };
                let back = u * (c1 + u * (6.0 * b * b + u * (4.0 * b + u))) / 3.0;
                // r = b + u loses digits of u where x is small.
                let lost = 4.0 * f64::EPSILON * b / u.max(f64::MIN_POSITIVE);
                assert!((back / x - 1.0).abs() < 1e-14 + 2.0 * lost || lost > 1.0, "{k}");
            }
            assert!(branch.root(0.0).to_bits() == branch.least().to_bits());
        }
    }
}
