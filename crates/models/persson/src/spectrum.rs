//! The spectrum of a surface: the wave number as a function of the gradient reached there.

use asperity_core::{ContactError, ProfileMoments, positive, require};
use asperity_quadrature::{bracketed_root, legendre};

/// Points of the quadrature rule between two ends; 12 would suffice for panels of this length.
const POINTS: usize = 16;
/// ln(q_s/q_l) of the broadest power law; its powers do not overflow.
const BROADEST: f64 = 170.0;
/// Waves whose wave numbers differ by less than this factor are combined into one ring.
const RING: f64 = 1.05;

/// The distribution of the gradient of a surface over wave numbers.
///
/// Waves up to the wave number q have the root mean square gradient y g, with y from 0 to 1 and g
/// the gradient of all waves. The spectrum holds 1/q as a function of y.
///
/// ```
/// use asperity_persson::Spectrum;
///
/// // Mean square heights of waves, as from a Fourier transform of a scan.
/// let waves = [(1e5, 4e-14), (2e5, 1e-14), (3e5, 4e-15)]; // 1/m, m^2
/// assert!(Spectrum::of_waves(waves).is_ok());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// g.
    gradient: f64,
    law: Law,
    /// Ascending y from 0 to 1, between which the law is smooth.
    ends: Vec<f64>,
    /// ∫ dy/q from each of them to 1 \[m\].
    beyond: Vec<f64>,
}

#[derive(Debug, Clone, PartialEq)]
enum Law {
    /// q = q_l (1 + spread y²)^(1/power); q_l exp(ln(q_s/q_l) y²) for a power of 0.
    Power { lowest: f64, spread: f64, power: f64 },
    /// 1/q between an end and the next.
    Rings(Vec<f64>),
}

/// ∫ exp(n v) dv from 0 to `length`.
fn exponential(n: f64, length: f64) -> f64 {
    if n == 0.0 { length } else { (n * length).exp_m1() / n }
}

impl Spectrum {
    /// The power law C(q) ∝ q^(-2(1+H)) between two wave numbers, which follow from the moments.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a Hurst exponent outside 0.1 to 1, and for moments with a
    /// bandwidth α = m₀m₄/m₂² below 1.5.
    pub fn power_law(moments: &ProfileMoments, hurst_exponent: f64) -> Result<Self, ContactError> {
        Self::check_hurst(hurst_exponent)?;
        let power = 2.0 - 2.0 * hurst_exponent;
        // ∫ q^n C dq for n = 1, 3, 5, in units of q_l, up to ln(q_s/q_l) = length.
        let integral = |n: f64, length: f64| exponential(n - 1.0 - 2.0 * hurst_exponent, length);
        let bandwidth = |length: f64| {
            let [one, three, five] = [1.0, 3.0, 5.0].map(|n| integral(n, length));
            1.5 * (one / three) * (five / three)
        };
        let alpha = moments.bandwidth();
        let refused = ContactError::OutOfRange {
            field: "bandwidth (m0 m4/m2^2)",
            value: alpha,
            required: "at least 1.5, that of waves of one length,",
        };
        // Waves of one length, within rounding.
        let narrow = (alpha / 1.5 - 1.0).abs() < 1e-14;
        let length = match narrow {
            true => Some(0.0),
            false => bracketed_root(|length| bandwidth(length) / alpha - 1.0, 1e-7, BROADEST),
        };
        let length = length.ok_or(refused)?;
        let ratio = if narrow { 1.0 } else { integral(1.0, length) / integral(3.0, length) };
        let lowest = (2.0 * moments.m2 / moments.m0 * ratio).sqrt();
        let spread = if power > 0.0 { (power * length).exp_m1() } else { length };
        // Up to this y the law is almost constant; beyond, it is close to a power.
        let scale = (if power > 0.0 { power.min(1.0) / spread } else { 1.0 / spread }).sqrt();
        let mut ends = vec![0.0];
        let mut end = scale;
        while end < 1.0 {
            ends.push(end);
            end *= 2.0;
        }
        ends.push(1.0);
        Ok(Self::new((2.0 * moments.m2).sqrt(), Law::Power { lowest, spread, power }, ends))
    }

    /// Checks the range of a Hurst exponent.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a Hurst exponent outside 0.1 to 1.
    pub fn check_hurst(hurst_exponent: f64) -> Result<(), ContactError> {
        let holds = (0.1..=1.0).contains(&hurst_exponent);
        require(holds, "hurst_exponent", hurst_exponent, "a number from 0.1 to 1").map(drop)
    }

    /// The spectrum of waves with these wave numbers \[1/m\] and mean square heights \[m²\], in any
    /// order; waves with almost equal wave numbers are combined.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a wave number that is not above 0, a mean square below 0,
    /// or waves of no height at all.
    pub fn of_waves(waves: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, ContactError> {
        let mut waves: Vec<(f64, f64)> = waves.into_iter().collect();
        for (q, square) in &waves {
            positive("wave number", *q)?;
            let (holds, field) =
                (*square >= 0.0 && square.is_finite(), "mean square height of a wave");
            require(holds, field, *square, "a finite number, at least 0,")?;
        }
        waves.sort_by(|a, b| a.0.total_cmp(&b.0));
        let total: f64 = waves.iter().map(|(q, square)| q * q * square).sum();
        positive("mean square gradient", total)?;
        let (mut ends, mut rings) = (vec![0.0], vec![]);
        let (mut squares, mut up_to) = (0.0, 0.0);
        let mut left = &waves[..];
        while let Some((longest, _)) = left.first() {
            let ring = left.partition_point(|(q, _)| *q < longest * RING);
            let (ring, longer) = left.split_at(ring);
            left = longer;
            // ∫ dy/q, wave by wave.
            let (first, mut y, mut integral) = (up_to, up_to, 0.0);
            for (q, square) in ring {
                squares += q * q * square;
                let next = (squares / total).sqrt();
                integral += (next - y) / q;
                y = next;
            }
            if y > first {
                ends.push(y);
                rings.push(integral / (y - first));
                up_to = y;
            }
        }
        if let Some(last) = ends.last_mut() {
            *last = 1.0;
        }
        Ok(Self::new(total.sqrt(), Law::Rings(rings), ends))
    }

    fn new(gradient: f64, law: Law, ends: Vec<f64>) -> Self {
        let mut new = Self { gradient, law, beyond: vec![0.0; ends.len()], ends };
        for k in (0..new.ends.len() - 1).rev() {
            new.beyond[k] = new.beyond[k + 1] + new.between(k, new.ends[k]);
        }
        new
    }

    /// The root mean square gradient g of all waves.
    #[must_use]
    pub fn gradient(&self) -> f64 {
        self.gradient
    }

    /// Ascending y from 0 to 1 at which the law is not smooth or changes fast.
    pub(crate) fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// 1/q \[m\] at a y in the k-th interval.
    fn inverse(&self, k: usize, y: f64) -> f64 {
        match &self.law {
            Law::Rings(rings) => rings[k],
            Law::Power { lowest, spread, power } => {
                let ln = spread * y * y;
                let ln = if *power > 0.0 { ln.ln_1p() / power } else { ln };
                (-ln).exp() / lowest
            }
        }
    }

    /// ∫ dy/q from y to the end of the k-th interval.
    fn between(&self, k: usize, y: f64) -> f64 {
        let rule = legendre(POINTS);
        let width = self.ends[k + 1] - y;
        let points = rule.nodes.iter().zip(&rule.weights);
        width * points.map(|(x, weight)| weight * self.inverse(k, y + width * x)).sum::<f64>()
    }

    fn interval(&self, y: f64) -> usize {
        (self.ends.partition_point(|end| *end <= y)).clamp(1, self.ends.len() - 1) - 1
    }

    /// 1/q \[m\] at y.
    pub(crate) fn wave(&self, y: f64) -> f64 {
        self.inverse(self.interval(y), y)
    }

    /// ∫ dy/q from y to 1 \[m\].
    pub(crate) fn from(&self, y: f64) -> f64 {
        let k = self.interval(y);
        self.between(k, y) + self.beyond[k + 1]
    }
}
