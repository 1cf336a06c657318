//! A contact under normal and tangential displacement: stick, partial slip and gross slip, averaged
//! over the azimuth θ.

use std::f64::consts::{FRAC_2_PI, SQRT_2};

use fearless_simd::{Level, Simd, dispatch};

use crate::azimuth::{AzimuthAverage, Integrand, ellipse_mean};
use crate::{Displacement, ForceComponent, NormalLaw, ObliqueContact, Stick, friction};

/// The response that is averaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Response {
    /// The contact force F_i.
    Force(ForceComponent),
    /// The contact stiffness K_i.
    Stiffness,
}

/// One regime of an oblique contact.
///
/// ```text
/// q₁ = min(1, r ζ* s |sin θ|/(μN)),   q₂ = min(1, r ξ* s |cos θ|/(μN)),   s = √(1 - u²)
/// T_j = μN (1 - (1 - q_j)^1.5)                                  (Cattaneo-Mindlin)
/// F_i = √(N² + T₁² + T₂²),  or its vertical component  N u + √(T₁² + T₂²) s
/// K_i = √(K_n² + 2.25 λ² r² [(1-q₁) + (1-q₂)])
/// ```
#[derive(Debug, Clone, Copy)]
pub struct ObliqueSlip {
    /// N, A*, K_n and r.
    pub normal: NormalLaw,
    /// λ = 4G/E.
    pub shear_ratio: f64,
    /// The tangential displacements ζ* and ξ*.
    pub displacement: Displacement,
    /// Whether T_j is limited by friction.
    pub stick: Stick,
    /// The response that is averaged.
    pub response: Response,
}

/// The quantities of a contact that depend on y alone.
struct AtNormal {
    load: f64,
    /// The friction limit μN.
    limit: f64,
    radius: f64,
    /// r ζ* s and r ξ* s over √(x² - y²) where ζ* and ξ* are λ x, else over s.
    shear: [f64; 2],
}

impl ObliqueSlip {
    #[inline(always)]
    fn at_normal(&self, y: f64) -> AtNormal {
        let load = self.normal.load(y);
        let radius = self.normal.radius(y);
        let shear = match self.displacement {
            Displacement::Vertical => [self.shear_ratio; 2],
            Displacement::None => [0.0; 2],
            Displacement::Given { zeta, xi } => [zeta, xi],
        };
        AtNormal { load, limit: friction(load) * load, radius, shear: shear.map(|q| radius * q) }
    }

    fn displacement_is_given(&self) -> bool {
        matches!(self.displacement, Displacement::Given { .. })
    }

    /// The gap x - y at which the tangential load over `shear` is `reached`.
    fn gap(&self, y: f64, reached: f64) -> f64 {
        if !self.displacement_is_given() {
            return reached * reached / (y + y.hypot(reached));
        }
        let u = ((1.0 - reached) * (1.0 + reached)).sqrt();
        if reached < 1.0 { y * reached * reached / (u * (1.0 + u)) } else { f64::INFINITY }
    }

    fn never_slips(&self) -> bool {
        self.stick == Stick::Unlimited || self.displacement == Displacement::None
    }

    #[inline(always)]
    fn means_at(&self, y: f64, gaps: &[f64], tolerance: f64, out: &mut [f64]) -> f64 {
        let AtNormal { load, limit, radius, shear } = self.at_normal(y);
        let vertical = self.response == Response::Force(ForceComponent::Vertical);
        let integrand = match self.response {
            Response::Force(_) => {
                let base = if vertical { 0.0 } else { load * load };
                Integrand::Force { base, limit: limit * limit }
            }
            Response::Stiffness => {
                let normal = self.normal.stiffness(y).powi(2);
                Integrand::Stiffness { normal, shear: 2.25 * (self.shear_ratio * radius).powi(2) }
            }
        };
        let azimuths = AzimuthAverage::new(integrand, tolerance);
        let mut worst = 0.0f64;
        for (out, &gap) in out.iter_mut().zip(gaps) {
            let x = y + gap;
            let across = (gap * (y + x)).sqrt();
            let s = across / x;
            let tangential =
                shear.map(|q| q * if self.displacement_is_given() { s } else { across });
            *out = match integrand {
                Integrand::Stiffness { normal, shear } if self.never_slips() => {
                    (normal + 2.0 * shear).sqrt()
                }
                Integrand::Force { base, .. } if self.never_slips() => {
                    let [a, b] = tangential.map(|q| base + 2.25 * q * q);
                    ellipse_mean(a, b)
                }
                _ => {
                    let [a, b] = tangential.map(|q| q / limit);
                    let one = azimuths.octant(a, b);
                    let two =
                        if self.displacement_is_given() { azimuths.octant(b, a) } else { one };
                    let total = one.value + two.value;
                    worst = worst.max((one.error + two.error) / total.max(f64::MIN_POSITIVE));
                    FRAC_2_PI * total
                }
            };
            if vertical {
                *out = load * (y / x) + s * *out;
            }
        }
        worst
    }
}

impl ObliqueContact for ObliqueSlip {
    fn means(&self, y: f64, gaps: &[f64], tolerance: f64, out: &mut [f64]) -> f64 {
        // Loops over azimuths work on as many values at a time as the processor's registers hold,
        // in all inlined functions; the digits are the same.
        dispatch!(Level::new(), simd => simd.vectorize(
            #[inline(always)]
            || self.means_at(y, gaps, tolerance, out),
        ))
    }

    fn corners(&self, y: f64) -> [f64; 3] {
        if self.never_slips() {
            return [f64::INFINITY; 3];
        }
        let AtNormal { limit, shear, .. } = self.at_normal(y);
        // Beyond these, each direction slips at some azimuths, and both slip at all of them.
        let [a, b] = shear.map(|q| limit / q);
        let ends = if self.displacement_is_given() {
            [a, b, a.hypot(b)]
        } else {
            [a, SQRT_2 * a, f64::INFINITY]
        };
        ends.map(|end| self.gap(y, end))
    }

    fn layer(&self, y: f64) -> f64 {
        let AtNormal { load, shear, .. } = self.at_normal(y);
        match self.response {
            Response::Force(ForceComponent::Size) => {
                self.gap(y, load / (1.5 * shear[0].max(shear[1])))
            }
            _ => f64::INFINITY,
        }
    }

    fn key(&self) -> Option<String> {
        // Every field, each number with all its digits.
        Some(format!("{self:?}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::Regime;

    #[test]
    fn vector_registers_change_no_digit() {
        // The plain loops, and the widest registers of this processor.
        let gaps: Vec<f64> = (0..40).map(|k| 1e-6 * 1.6f64.powi(k)).collect();
        for response in [Response::Force(ForceComponent::default()), Response::Stiffness] {
            let normal = NormalLaw {
                regime: Regime::Elastic,
                pressure_factor: 0.58,
                area_exponent: 0.35,
                radius_loss: 0.0,
            };
            let (displacement, stick) = (Displacement::Vertical, Stick::Clamped);
            let slip = ObliqueSlip { normal, shear_ratio: 1.4, displacement, stick, response };
            for y in [1e-4, 0.3, 2.0] {
                let (mut wide, mut plain) = (vec![0.0; gaps.len()], vec![0.0; gaps.len()]);
                let errors = [
                    slip.means(y, &gaps, 1e-12, &mut wide),
                    slip.means_at(y, &gaps, 1e-12, &mut plain),
                ];
                assert!(errors[0].to_bits() == errors[1].to_bits());
                for (wide, plain) in wide.iter().zip(&plain) {
                    assert!(wide.to_bits() == plain.to_bits() && *wide > 0.0, "{wide} {plain}");
                }
            }
        }
    }
}
