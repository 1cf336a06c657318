//! A contact pushed along and across its normal: stick, partial slip, gross slip, averaged over
//! the azimuth θ.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::ops::Range;
use std::sync::LazyLock;

use asperity_core::ObliqueContact;
use asperity_quadrature::{bracketed_root, legendre, with_wide_registers};

use crate::{Displacement, ForceComponent, NormalLaw, Stick, friction};

/// Nodes on each of the two or three ranges of θ between slip limits.
const NODES: usize = 16;

/// What is averaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Response {
    /// F_i.
    Force(ForceComponent),
    /// K_i.
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
    /// ζ* and ξ*.
    pub displacement: Displacement,
    /// Whether T_j is limited by friction.
    pub stick: Stick,
    /// What is averaged.
    pub response: Response,
}

/// Everything of a contact that does not depend on θ.
struct Contact {
    load: f64,
    limit: f64,
    normal_stiffness_squared: f64,
    shear_stiffness_squared: f64,
    /// r ζ* s and r ξ* s.
    push: [f64; 2],
    u: f64,
    s: f64,
}

impl ObliqueSlip {
    #[inline(always)]
    fn contact(&self, y: f64, x: f64) -> Contact {
        let load = self.normal.load(y);
        let radius = self.normal.radius(y);
        let kn = if self.response == Response::Stiffness { self.normal.stiffness(y) } else { 0.0 };
        let across = ((x - y) * (x + y)).sqrt();
        let s = across / x;
        let push = match self.displacement {
            Displacement::Vertical => [self.shear_ratio * across; 2],
            Displacement::None => [0.0; 2],
            Displacement::Given { zeta, xi } => [zeta * s, xi * s],
        };
        Contact {
            load,
            limit: friction(load) * load,
            normal_stiffness_squared: kn * kn,
            shear_stiffness_squared: 2.25 * (self.shear_ratio * radius).powi(2),
            push: push.map(|p| radius * p),
            u: y / x,
            s,
        }
    }

    /// κ₁ and κ₂: the largest push over the friction limit.
    fn slip_ratios(&self, y: f64, x: f64) -> [f64; 2] {
        let contact = self.contact(y, x);
        contact.push.map(|p| p / contact.limit)
    }

    fn equal_pushes(&self) -> bool {
        !matches!(self.displacement, Displacement::Given { .. })
    }

    /// How thin, in the variable of `mean`, the layer is next to a slip limit in which K_i falls
    /// from its tangential to its normal part: K_n² against the shear term, which goes there as
    /// the square of that variable.
    #[inline(always)]
    fn layer(&self, contact: &Contact, ratios: [f64; 2], width: f64) -> f64 {
        if self.response != Response::Stiffness {
            return 1.0;
        }
        let steepest = (ratios[0].max(ratios[1]).powi(2) - 1.0).sqrt();
        let shear = contact.shear_stiffness_squared * 3.0 * steepest * width;
        (contact.normal_stiffness_squared / shear).sqrt().clamp(1e-8, 1.0)
    }

    /// The integral over θ = `to` - `width` v² (3 - 2v) for v from `near` to `far`: half powers at
    /// both ends become whole ones.
    #[inline(always)]
    fn on_piece(&self, contact: &Contact, (to, width): (f64, f64), (near, far): (f64, f64)) -> f64 {
        static RULE: LazyLock<([f64; NODES], [f64; NODES])> = LazyLock::new(|| {
            let rule = legendre(NODES);
            (std::array::from_fn(|k| rule.nodes[k]), std::array::from_fn(|k| rule.weights[k]))
        });
        let (nodes, rule_weights) = &*RULE;
        let (mut theta, mut weights) = ([0.0; NODES], [0.0; NODES]);
        for k in 0..NODES {
            let v = near + (far - near) * nodes[k];
            theta[k] = to - width * v * v * (3.0 - 2.0 * v);
            weights[k] = rule_weights[k] * (far - near) * width * 6.0 * v * (1.0 - v);
        }
        let (sin, cos) = sines_and_cosines(&theta);
        let values = self.at(contact, &sin, &cos);
        let mut sums = [0.0; 4];
        for k in 0..NODES {
            sums[k % 4] += values[k] * weights[k];
        }
        (sums[0] + sums[1]) + (sums[2] + sums[3])
    }

    #[inline(always)]
    fn mean_over_azimuths(&self, y: f64, x: f64) -> f64 {
        let contact = self.contact(y, x);
        let equal = self.equal_pushes();
        let [a, b] = contact.push;
        if a.max(b) <= 0.0 || (self.stick == Stick::Unlimited && equal) {
            // Nothing depends on θ.
            let half = [0.5f64.sqrt(); NODES];
            return self.at(&contact, &half, &half)[0];
        }
        // sin and cos change places at π/4 when both pushes are equal.
        let end = if equal { FRAC_PI_4 } else { FRAC_PI_2 };
        let ratios = contact.push.map(|p| p / contact.limit);
        let slips = slip_limits(if self.never_slips() { [0.0; 2] } else { ratios }, end);
        // The series of sine and cosine change at π/4. A limit outside (0, end) is at the end.
        let mut limits = [slips[0], slips[1], FRAC_PI_4, end];
        limits.sort_unstable_by(f64::total_cmp);
        let (mut total, mut from) = (0.0, 0.0);
        for to in limits {
            let width = to - from;
            let layer = if to < end { self.layer(&contact, ratios, width) } else { 1.0 };
            // v counts back from `to`; pieces shrink towards it down to the layer.
            let mut far = if width > 0.0 { 1.0 } else { 0.0 };
            while far > 0.0 {
                let near = if far > 2.0 * layer { far / 6.0 } else { 0.0 };
                total += self.on_piece(&contact, (to, width), (near, far));
                far = near;
            }
            from = to;
        }
        total / end
    }

    fn never_slips(&self) -> bool {
        self.stick == Stick::Unlimited || self.displacement == Displacement::None
    }

    /// F_i or K_i at azimuths with these sines and cosines; plain loops, for vector registers.
    #[inline(always)]
    fn at(&self, c: &Contact, sin: &[f64; NODES], cos: &[f64; NODES]) -> [f64; NODES] {
        let mut out = [0.0; NODES];
        let ratios = c.push.map(|p| p / c.limit);
        match (self.response, self.stick) {
            (Response::Stiffness, stick) => {
                for k in 0..NODES {
                    let left =
                        (1.0 - ratios[0] * sin[k]).max(0.0) + (1.0 - ratios[1] * cos[k]).max(0.0);
                    let stuck = if stick == Stick::Clamped { left } else { 2.0 };
                    out[k] =
                        (c.normal_stiffness_squared + c.shear_stiffness_squared * stuck).sqrt();
                }
            }
            (Response::Force(_), Stick::Clamped) => {
                for k in 0..NODES {
                    let t1 = cattaneo_mindlin((ratios[0] * sin[k]).min(1.0));
                    let t2 = cattaneo_mindlin((ratios[1] * cos[k]).min(1.0));
                    out[k] = c.limit * c.limit * (t1 * t1 + t2 * t2);
                }
            }
            (Response::Force(_), Stick::Unlimited) => {
                for k in 0..NODES {
                    let (t1, t2) = (1.5 * c.push[0] * sin[k], 1.5 * c.push[1] * cos[k]);
                    out[k] = t1 * t1 + t2 * t2;
                }
            }
        }
        match self.response {
            Response::Force(ForceComponent::Size) => {
                out.iter_mut().for_each(|squares| *squares = (c.load * c.load + *squares).sqrt());
            }
            Response::Force(ForceComponent::Vertical) => {
                out.iter_mut().for_each(|squares| *squares = c.load * c.u + squares.sqrt() * c.s);
            }
            Response::Stiffness => {}
        }
        out
    }
}

/// Coefficients of sin(t)/t and cos(t) in t², highest first: good to 2e-16 for t ≤ π/4.
const SINE: [f64; 9] = series([17, 15, 13, 11, 9, 7, 5, 3, 1]);
const COSINE: [f64; 9] = series([16, 14, 12, 10, 8, 6, 4, 2, 0]);

/// ±1/n! for each n, + where n mod 4 is 0 or 1.
const fn series(orders: [u32; 9]) -> [f64; 9] {
    let mut terms = [0.0; 9];
    let mut k = 0;
    while k < 9 {
        let (mut factorial, mut n) = (1.0, orders[k]);
        while n > 1 {
            factorial *= n as f64;
            n -= 1;
        }
        terms[k] = if orders[k] % 4 < 2 { 1.0 / factorial } else { -1.0 / factorial };
        k += 1;
    }
    terms
}

/// Sines and cosines of azimuths that all lie in [0, π/4] or all in [π/4, π/2].
#[inline(always)]
fn sines_and_cosines(theta: &[f64; NODES]) -> ([f64; NODES], [f64; NODES]) {
    let upper = theta[0] > FRAC_PI_4;
    let t = if upper { theta.map(|t| FRAC_PI_2 - t) } else { *theta };
    let z = t.map(|t| t * t);
    let horner = |terms: &[f64; 9]| {
        let mut sum = [0.0; NODES];
        for term in terms {
            for k in 0..NODES {
                sum[k] = sum[k] * z[k] + term;
            }
        }
        sum
    };
    let (mut sin, cos) = (horner(&SINE), horner(&COSINE));
    for k in 0..NODES {
        sin[k] *= t[k];
    }
    if upper { (cos, sin) } else { (sin, cos) }
}

/// 1 - (1-q)^1.5 without cancellation for small q.
#[inline(always)]
fn cattaneo_mindlin(q: f64) -> f64 {
    let left = 1.0 - q;
    q * (3.0 + q * (q - 3.0)) / (1.0 + left * left.sqrt())
}

/// Azimuths at which one of the two directions begins to slip, or `end` where none does before.
#[inline(always)]
fn slip_limits([sine, cosine]: [f64; 2], end: f64) -> [f64; 2] {
    let a = if sine > 1.0 { (1.0 / sine).asin() } else { end };
    let b = if cosine > 1.0 { (1.0 / cosine).acos() } else { end };
    [a.min(end), b.min(end)]
}

impl ObliqueContact for ObliqueSlip {
    fn mean(&self, y: f64, x: f64) -> f64 {
        with_wide_registers(
            #[inline(always)]
            || self.mean_over_azimuths(y, x),
        )
    }

    fn breaks(&self, x: f64, range: &Range<f64>) -> Vec<f64> {
        if self.never_slips() {
            return vec![];
        }
        // A direction begins to slip somewhere (κ = 1), or the two slip limits cross.
        let events: [fn([f64; 2]) -> f64; 3] =
            [|[a, _]| a - 1.0, |[_, b]| b - 1.0, |[a, b]| 1.0 - 1.0 / (a * a) - 1.0 / (b * b)];
        let mut breaks = vec![];
        for event in events {
            let f = |y: f64| event(self.slip_ratios(y, x)).clamp(-1e300, 1e300);
            // κ falls with y but for a fold just above the beginning of a regime, where A* rises
            // before N does.
            let shares =
                [1e-15, 1e-4, 1e-3, 4e-3, 0.012, 0.04, 0.1, 0.25, 0.5, 0.75, 0.95, 1.0 - 1e-15];
            let probe = |share: f64| range.start + (range.end - range.start) * share;
            let mut left = (probe(shares[0]), f(probe(shares[0])));
            for share in &shares[1..] {
                let right = (probe(*share), f(probe(*share)));
                if left.1 * right.1 <= 0.0 {
                    breaks.extend(bracketed_root(f, left.0, right.0));
                }
                left = right;
            }
        }
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| (*a - *b).abs() <= 1e-14 * *a);
        breaks
    }

    fn key(&self) -> Option<String> {
        // Every field; numbers are written so that they read back.
        Some(format!("{self:?}"))
    }

    fn kinks(&self, range: &Range<f64>) -> Vec<f64> {
        if self.never_slips() {
            return vec![];
        }
        // The events of `breaks` reaching an end of the range: κ² = 1 or 2 (equal pushes) at y.
        let mut kinks = vec![];
        for y in [range.start, range.end].into_iter().filter(|y| *y > 0.0 && y.is_finite()) {
            let limit = friction(self.normal.load(y)) * self.normal.load(y) / self.normal.radius(y);
            match self.displacement {
                Displacement::None => {}
                Displacement::Vertical => {
                    let across = limit / self.shear_ratio;
                    kinks.extend([1.0, 2.0].map(|k| (y * y + k * across * across).sqrt()));
                }
                Displacement::Given { zeta, xi } => {
                    let both = 1.0 / (zeta * zeta) + 1.0 / (xi * xi);
                    for inverse in [1.0 / (zeta * zeta), 1.0 / (xi * xi), both] {
                        let share = limit * limit * inverse;
                        kinks.extend((share < 1.0).then(|| y / (1.0 - share).sqrt()));
                    }
                }
            }
        }
        kinks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_sine_and_cosine_are_good_to_rounding() {
        for k in 0..100 {
            for side in [0.0, FRAC_PI_4] {
                let theta = [side + FRAC_PI_4 * f64::from(k) / 100.0 + 1e-9; NODES];
                let (sin, cos) = sines_and_cosines(&theta);
                assert!((sin[0] - theta[0].sin()).abs() < 3e-16);
                assert!((cos[0] - theta[0].cos()).abs() < 3e-16);
            }
        }
    }

    #[test]
    fn gross_slip_is_friction_and_light_pushes_stick() {
        assert!((cattaneo_mindlin(1.0) - 1.0).abs() < 1e-15);
        assert!((cattaneo_mindlin(1e-12) / 1.5e-12 - 1.0).abs() < 1e-11);
    }
}
