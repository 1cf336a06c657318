//! Gaussian surfaces of known spectrum: sums of cosines with random phases.

#![allow(clippy::unwrap_used, dead_code, reason = "a generator for tests; each test uses some")]

use std::f64::consts::TAU;

use asperity_topography::Topography;

/// Uniform numbers in 0..1: the generator of Knuth's MMIX, its upper bits.
pub struct Uniform(pub u64);

impl Uniform {
    pub fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Waves (p, q) per side and their powers: a periodic surface of n × n points.
pub struct Spectrum {
    pub n: usize,
    pub pixel_size: [f64; 2],
    /// p, q, ⟨z²⟩ of the wave.
    pub waves: Vec<(i32, i32, f64)>,
}

impl Spectrum {
    /// Isotropic, with power k^-slope per wave for `from` ≤ k ≤ `to` waves a side, of rms height
    /// `sq`; `keep` picks waves.
    pub fn isotropic(
        n: usize,
        pixel: f64,
        [from, to]: [f64; 2],
        slope: f64,
        sq: f64,
        keep: impl Fn(i32, i32) -> bool,
    ) -> Self {
        let k = to as i32;
        let mut waves = Vec::new();
        // Half of the plane: the other half has the same waves.
        for q in 0..=k {
            for p in (if q == 0 { 1 } else { -k })..=k {
                let size = f64::from(p * p + q * q).sqrt();
                if size >= from && size <= to && keep(p, q) {
                    waves.push((p, q, size.powf(-slope)));
                }
            }
        }
        let total: f64 = waves.iter().map(|wave| wave.2).sum();
        waves.iter_mut().for_each(|wave| wave.2 *= sq * sq / total);
        Self { n, pixel_size: [pixel; 2], waves }
    }

    /// A realisation with phases from the seed.
    pub fn surface(&self, seed: u64) -> Topography {
        let n = self.n;
        let mut uniform = Uniform(seed);
        let turn: Vec<(f64, f64)> = (0..n).map(|i| (TAU * i as f64 / n as f64).sin_cos()).collect();
        let mut heights = vec![0.0; n * n];
        let mut by_q: std::collections::BTreeMap<i32, Vec<(f64, f64)>> = Default::default();
        for (p, q, power) in &self.waves {
            let (amplitude, phase) = ((2.0 * power).sqrt(), TAU * uniform.next());
            let (sin, cos) = (amplitude * phase.sin(), amplitude * phase.cos());
            let line = by_q.entry(*q).or_insert_with(|| vec![(0.0, 0.0); n]);
            for (x, (re, im)) in line.iter_mut().enumerate() {
                let (s, c) = turn[(x as i64 * i64::from(*p)).rem_euclid(n as i64) as usize];
                *re += cos * c - sin * s;
                *im += cos * s + sin * c;
            }
        }
        for (q, line) in &by_q {
            for y in 0..n {
                let (s, c) = turn[(y as i64 * i64::from(*q)).rem_euclid(n as i64) as usize];
                for (z, (re, im)) in heights[y * n..][..n].iter_mut().zip(line) {
                    *z += re * c - im * s;
                }
            }
        }
        Topography::new(heights, n, self.pixel_size).unwrap().with_periodic(true)
    }

    /// m₂ and m₄ along rows and along columns, by differences of points or exactly.
    pub fn moments(&self, differences: bool) -> [[f64; 2]; 2] {
        let mut moments = [[0.0; 2]; 2];
        for (p, q, power) in &self.waves {
            for (axis, waves) in [*p, *q].into_iter().enumerate() {
                let phase = TAU * f64::from(waves) / self.n as f64;
                let seen = if differences { 2.0 * (phase / 2.0).sin() } else { phase };
                let k = seen / self.pixel_size[axis];
                moments[axis][0] += power * k * k;
                moments[axis][1] += power * k.powi(4);
            }
        }
        moments
    }

    pub fn m0(&self) -> f64 {
        self.waves.iter().map(|wave| wave.2).sum()
    }
}
