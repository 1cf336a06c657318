//! Smooth bodies: Hertz' point contact with elliptic patch, and his line contact.

use std::f64::consts::PI;

use crate::Shape;

/// Hertz' contact of smooth elastic bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Hertz {
    /// Half axes of the patch along x and y \[m\]; of a line contact the half width, and the half
    /// length of the bodies.
    pub axes: [f64; 2],
    /// Peak pressure \[Pa\].
    pub peak_pressure: f64,
    /// Approach of the bodies \[m\]; of a line contact `None` without a reference length.
    pub approach: Option<f64>,
}

impl Hertz {
    /// Pressure at a place from the middle of the patch \[m\], y = 0 for a line contact \[Pa\].
    #[must_use]
    pub fn pressure(&self, [x, y]: [f64; 2]) -> f64 {
        let within = 1.0 - (x / self.axes[0]).powi(2) - (y / self.axes[1]).powi(2);
        self.peak_pressure * within.max(0.0).sqrt()
    }

    /// The contact of these smooth bodies with the equivalent modulus \[Pa\] at a load \[N\].
    #[must_use]
    pub fn new(shape: &Shape, modulus: f64, load: f64) -> Self {
        match *shape {
            Shape::Point { radius_x, radius_y } => {
                let (long, short) = (radius_x.max(radius_y), radius_x.min(radius_y));
                let (ratio, [k, difference]) = ellipse(long, short);
                // A = 1/(2 R) along the long axis is (p₀/E)(b/a²)(K - E)/e².
                let a = (3.0 * load * long * difference / (PI * modulus)).cbrt();
                let b = a * ratio;
                let peak_pressure = 1.5 * load / (PI * a * b);
                let approach = Some(peak_pressure / modulus * b * k);
                let axes = if radius_x >= radius_y { [a, b] } else { [b, a] };
                Self { axes, peak_pressure, approach }
            }
            Shape::Line { radius, length, reference_length } => {
                let load = load / length;
                let a = (4.0 * load * radius / (PI * modulus)).sqrt();
                let depth = 2.0 * load / (PI * modulus);
                let approach = reference_length.map(|l| depth * ((2.0 * l / a).ln() + 0.5));
                let axes = [a, 0.5 * length];
                Self { axes, peak_pressure: 2.0 * load / (PI * a), approach }
            }
        }
    }
}

/// K(e) and (K(e) - E(e))/e² of an ellipse with half axes of the ratio b/a = √(1 - e²), by the
/// arithmetic-geometric mean.
#[must_use]
pub fn elliptic(ratio: f64) -> [f64; 2] {
    let square = (1.0 - ratio) * (1.0 + ratio);
    let (mut a, mut b, mut power) = (1.0, ratio, 0.5);
    // (K - E)/K = Σ 2^(n-1) c_n² with c₀ = e; each term over e².
    let mut sum = 0.5;
    let mut difference = square;
    for _ in 0..40 {
        // c² of the next step is ((a - b)/2)², and a - b = c²/(a + b).
        let half = 0.5 * difference / (a + b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        difference = half * half;
        power *= 2.0;
        let term = power * difference / if square > 0.0 { square } else { 1.0 };
        sum += term;
        if term <= f64::EPSILON * sum {
            break;
        }
    }
    let k = 0.5 * PI / a;
    [k, k * sum]
}

/// Half axes of the ratio b/a, and the two integrals, for relative radii of curvature along and
/// across the long axis.
fn ellipse(long: f64, short: f64) -> (f64, [f64; 2]) {
    // B/A = ((a/b)² E - K)/(K - E) falls from infinity to 1 as b/a rises to 1.
    let wanted = long / short;
    let of = |ratio: f64| {
        let [k, difference] = elliptic(ratio);
        // Both over e²: (E - K (b/a)²)/e² is K - (K - E)/e².
        (k - difference) / (ratio * ratio) / difference
    };
    debug_assert!(wanted >= 1.0, "the long axis lies along the larger radius");
    let (mut low, mut high) = (1e-12_f64, 1.0_f64);
    for _ in 0..200 {
        let middle = (low * high).sqrt();
        if of(middle) > wanted {
            low = middle
        } else {
            high = middle
        }
        if high / low < 1.0 + 4.0 * f64::EPSILON {
            break;
        }
    }
    let ratio = (low * high).sqrt();
    (ratio, elliptic(ratio))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_are_those_of_tables() {
        // K and E for k² = 1/2: 1.854074677301372, 1.350643881047676.
        let [k, difference] = elliptic(0.5_f64.sqrt());
        assert!((k - 1.854_074_677_301_372).abs() < 1e-14);
        assert!((k - 0.5 * difference - 1.350_643_881_047_675_5).abs() < 1e-14);
        let [k, difference] = elliptic(1.0);
        assert!((k - PI / 2.0).abs() < 1e-15 && (difference - PI / 4.0).abs() < 1e-15);
    }

    #[test]
    fn a_sphere_has_its_closed_forms_and_an_ellipse_its_curvatures() {
        let (e, load, r) = (1e11, 30.0, 0.01);
        let sphere = Hertz::new(&Shape::Point { radius_x: r, radius_y: r }, e, load);
        let a = (0.75 * load * r / e).cbrt();
        assert!(
            (sphere.axes[0] / a - 1.0).abs() < 1e-12 && (sphere.axes[1] / a - 1.0).abs() < 1e-7
        );
        assert!((sphere.approach.unwrap_or(0.0) / (a * a / r) - 1.0).abs() < 1e-7);
        // B = (p₀/E)(b/(e² a²))((a/b)² E - K) is the other curvature.
        let [rx, ry] = [0.02, 0.3];
        let found = Hertz::new(&Shape::Point { radius_x: rx, radius_y: ry }, e, load);
        let [b, a] = found.axes;
        let [k, difference] = elliptic(b / a);
        let square = 1.0 - (b / a).powi(2);
        let second = k - square * difference;
        let curvature =
            found.peak_pressure / e * b / (square * a * a) * ((a / b).powi(2) * second - k);
        assert!((curvature * 2.0 * rx - 1.0).abs() < 1e-9, "{curvature}");
    }
}
