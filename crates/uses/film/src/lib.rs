#![doc = include_str!("../README.md")]

mod factors;

use asperity_core::{
    Citation, Code, ContactError, Evaluation, Finding, HeightDistribution, Provenance, Quantity,
};
use serde::{Deserialize, Serialize};

pub use factors::{
    friction_factor, friction_pressure_factor, friction_shear_factor, pressure_flow_factor,
    shear_flow_factor,
};

/// Bound on the error of a factor relative to its terms, which is rounding.
const ERROR: f64 = 1e-12;

/// The flow factors of Patir and Cheng.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PatirCheng {
    /// γ of each surface: the correlation length along x over that along y, 1/9 to 9.
    pub peklenik_numbers: [f64; 2],
    /// The angles \[degrees\] from x towards y of the axes along which these numbers are measured.
    pub lay_angles: [f64; 2],
    /// (σ₂/σ)²: the share of the second surface, which rests, in the mean square of all heights;
    /// 0 for one rough surface, which moves.
    pub share_at_rest: f64,
    /// The least gap over σ that carries fluid friction, 1e-6 to 0.1.
    pub friction_cut_off: f64,
}

impl Default for PatirCheng {
    fn default() -> Self {
        Self {
            peklenik_numbers: [1.0; 2],
            lay_angles: [0.0; 2],
            share_at_rest: 0.0,
            friction_cut_off: 0.01,
        }
    }
}

/// Where the factors were published.
pub const SOURCE: Citation = Citation {
    id: "patir-cheng",
    name: "Patir & Cheng",
    authors: "Patir & Cheng",
    year: 1978,
    title: "An average flow model for determining effects of three-dimensional roughness on partial hydrodynamic lubrication",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Patir, N. and Cheng, H. S."),
        ("journal", "Journal of Lubrication Technology"),
        ("volume", "100"),
        ("number", "1"),
        ("pages", "12--17"),
        ("doi", "10.1115/1.3453103"),
    ],
};

impl PatirCheng {
    /// A factor at H, the film over σ: a mean of both surfaces weighted by their shares in the mean
    /// square of all heights, which is exact for thick films; of the factors of shear the weighted
    /// difference, with the error of its terms. Of an oblique lay it is the component along x, or
    /// y, of the tensor with the factors along and across the lay. \[derived\]
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a film or a Peklenik number outside the range of the fit,
    /// [`ContactError::NotRequested`] for other quantities.
    pub fn factor(&self, quantity: Quantity, film: f64) -> Result<Evaluation, ContactError> {
        let across = |film, gamma: f64| pressure_flow_factor(film, 1.0 / gamma);
        let (of, sign): (&dyn Fn(f64, f64) -> Result<f64, ContactError>, f64) = match quantity {
            Quantity::PressureFlowFactorX => (&pressure_flow_factor, 1.0),
            Quantity::PressureFlowFactorY => (&across, 1.0),
            Quantity::ShearFlowFactor => (&shear_flow_factor, -1.0),
            Quantity::FrictionShearFactor => (&friction_shear_factor, -1.0),
            Quantity::FrictionPressureFactor => (&friction_pressure_factor, 1.0),
            Quantity::FrictionFlowFactor => {
                let factor = friction_factor(film, self.friction_cut_off)?;
                return Ok(Evaluation::new(factor, ERROR));
            }
            _ => return Err(ContactError::NotRequested { quantity }),
        };
        let mut terms = vec![];
        for (k, (share, sign)) in
            [(1.0 - self.share_at_rest, 1.0), (self.share_at_rest, sign)].into_iter().enumerate()
        {
            let (gamma, turned) = (self.peklenik_numbers[k], self.lay_angles[k].to_radians());
            for (part, gamma) in [(turned.cos(), gamma), (turned.sin(), 1.0 / gamma)] {
                let weight = share * part * part;
                if weight > 0.0 {
                    terms.push(sign * weight * of(film, gamma)?);
                }
            }
        }
        let mut found = Evaluation::new(terms.iter().sum(), ERROR);
        found.size = terms.iter().map(|term| term.abs()).sum();
        Ok(found)
    }
}

/// A warning of heights for which the factors were not made.
#[must_use]
pub fn not_gaussian(heights: &HeightDistribution) -> Option<Finding> {
    let skewness = match heights {
        HeightDistribution::Gaussian => return None,
        HeightDistribution::Weibull(heights) => heights.skewness(),
        _ => f64::NAN,
    };
    let found = Finding::warning(Code::GaussianFactors, "heights", skewness)
        .fact(format!(
            "the flow factors are those of Gaussian surfaces, and the heights of this scene are {}",
            heights.name()
        ))
        .advice("valleys carry more flow, and peaks less, than these factors say: use them as an estimate only");
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(model: PatirCheng, quantities: &[Quantity], film: f64) -> Vec<f64> {
        quantities.iter().map(|one| model.factor(*one, film).unwrap().value()).collect()
    }

    #[test]
    fn both_surfaces_share_the_pressure_factors_and_differ_in_those_of_shear() {
        use Quantity::{
            FrictionShearFactor, PressureFlowFactorX, PressureFlowFactorY, ShearFlowFactor,
        };
        let all = [PressureFlowFactorX, PressureFlowFactorY, ShearFlowFactor, FrictionShearFactor];
        let of = |peklenik_numbers, share_at_rest| {
            let model = PatirCheng { peklenik_numbers, share_at_rest, ..PatirCheng::default() };
            values(model, &all, 2.0)
        };
        let close =
            |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-14, "{found} {wanted}");
        let (moving, resting) = (of([3.0, 9.0], 0.0), of([3.0, 9.0], 1.0));
        let both = of([3.0, 9.0], 0.25);
        for k in 0..4 {
            close(both[k], 0.75 * moving[k] + 0.25 * resting[k]);
        }
        let turned = of([1.0 / 3.0, 1.0], 0.0);
        close(turned[0], moving[1]);
        close(turned[1], moving[0]);
        let alike = of([3.0, 3.0], 0.5);
        close(alike[0], moving[0]);
        assert!(alike[2].abs() < 1e-15 && alike[3].abs() < 1e-15, "{alike:?}");
        let halves = PatirCheng { share_at_rest: 0.5, ..PatirCheng::default() };
        close(halves.factor(ShearFlowFactor, 2.0).unwrap().size, of([1.0; 2], 0.0)[2]);
        close(of([3.0, 3.0], 1.0)[2], -moving[2]);
        // A lay at an angle: between the factors along and across it, whichever number is said.
        let oblique = |gamma: f64, angle| {
            let (peklenik_numbers, lay_angles) = ([gamma; 2], [angle; 2]);
            values(PatirCheng { peklenik_numbers, lay_angles, ..PatirCheng::default() }, &all, 2.0)
        };
        for angle in [-30.0_f64, 15.0, 45.0] {
            let share = angle.to_radians().sin().powi(2);
            let (found, same) = (oblique(3.0, angle), oblique(1.0 / 3.0, angle + 90.0));
            for k in 0..4 {
                close(found[k], (1.0 - share) * moving[k] + share * turned[k]);
                close(same[k], found[k]);
            }
        }
    }

    #[test]
    fn options_are_read_by_their_names() {
        let text = r#"{"peklenik_numbers":[3.0,1.0],"lay_angles":[0.0,0.0],"share_at_rest":0.5,"friction_cut_off":0.001}"#;
        let model: PatirCheng = serde_json::from_str(text).unwrap();
        assert_eq!(serde_json::to_string(&model).unwrap(), text);
    }
}
