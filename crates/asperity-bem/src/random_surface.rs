//! Reproducible random surfaces: a power law with a roll-off and random phases.

use std::f64::consts::TAU;

use asperity_core::ProfileMoments;
use asperity_fft::Complex64;

use crate::height_map::positive;
use crate::{BemError, HeightMap, parallel};

/// An isotropic, periodic random surface on a square.
///
/// ```text
/// h(x, y) = Σ √(2 v(k)) cos(2π (i y + j x)/L + φ(i, j)),      k = √(i² + j²) waves per side
/// v(k) = s w(k),  w(k) = 1                     l <= k <= r
///                        (k/r)^(-2(1 + H))     r <  k <= s
///                        0                     elsewhere
/// ```
///
/// over one of every two opposite waves: j > 0, or j = 0 and i > 0. x runs along a row, y along a
/// column, pixel (row a, column b) lies at (x, y) = (b, a) L/n. s scales the root mean
/// square gradient, (2π/L)² Σ k² v = g²: every surface has it exactly, and the same
/// moments whatever its seed.
///
/// The phases come from the seed and the numbers of the wave alone, so the same surface is made
/// on every grid:
///
/// ```text
/// φ(i, j) = 2π · 2⁻⁵³ · (mix(mix(seed) + 2³² u(i) + u(j)) >> 11),      u(i) = i mod 2³²
/// mix(z): z += 0x9E3779B97F4A7C15, z ^= z >> 30, z *= 0xBF58476D1CE4E5B9, z ^= z >> 27,
///         z *= 0x94D049BB133111EB, z ^= z >> 31      (SplitMix64, modulo 2⁶⁴) [recalled]
/// ```
///
/// ```
/// use asperity_bem::RandomSurface;
///
/// let surface = RandomSurface::new(3.0, 3.0, 16.0)?;
/// let map = surface.heights(128)?;
/// let sq = surface.moments().m0.sqrt();
/// assert!((map.rms_height() / sq - 1.0).abs() < 1e-12);
/// # Ok::<(), asperity_bem::BemError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RandomSurface {
    longest: f64,
    roll_off: f64,
    shortest: f64,
    hurst: f64,
    side: f64,
    gradient: f64,
    seed: u64,
}

impl RandomSurface {
    /// The default of H.
    pub const HURST: f64 = 0.8;

    /// A surface whose waves are counted per side: `longest` (the fewest), where it rolls off, and
    /// `shortest` (the most). Defaults: H = 0.8, side 1 m, gradient 1, seed 0.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] unless 0 < longest <= roll-off <= shortest, when no wave lies
    /// between, and above 8192 waves.
    pub fn new(longest: f64, roll_off: f64, shortest: f64) -> Result<Self, BemError> {
        positive("longest", longest)?;
        for (field, found, least) in
            [("roll-off", roll_off, longest), ("shortest", shortest, roll_off)]
        {
            if !(found >= least && found <= 8192.0) {
                let required =
                    "longest, roll-off and shortest in this order, at most 8192 waves per side";
                return Err(BemError::OutOfRange { field, found, required });
            }
        }
        let [hurst, side, gradient] = [Self::HURST, 1.0, 1.0];
        let this = Self { longest, roll_off, shortest, hurst, side, gradient, seed: 0 };
        if this.waves().next().is_none() {
            let required = "at least one whole wave between the longest and the shortest";
            return Err(BemError::OutOfRange { field: "shortest", found: shortest, required });
        }
        Ok(this)
    }

    /// Another Hurst exponent.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] outside 0 to 1.
    pub fn hurst(mut self, hurst: f64) -> Result<Self, BemError> {
        if !(0.0..=1.0).contains(&hurst) {
            let required = "a number from 0 to 1";
            return Err(BemError::OutOfRange { field: "Hurst exponent", found: hurst, required });
        }
        self.hurst = hurst;
        Ok(self)
    }

    /// Another length of the side \[m\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when it is not a positive number.
    pub fn side(mut self, side: f64) -> Result<Self, BemError> {
        self.side = positive("side", side)?;
        Ok(self)
    }

    /// Another root mean square gradient.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when it is not a positive number.
    pub fn gradient(mut self, gradient: f64) -> Result<Self, BemError> {
        self.gradient = positive("gradient", gradient)?;
        Ok(self)
    }

    /// Another of the surfaces with these moments.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// The heights on n x n pixels.
    ///
    /// # Errors
    /// [`BemError::Size`] when n is not more than twice the number of the shortest waves.
    pub fn heights(&self, n: usize) -> Result<HeightMap, BemError> {
        if n as f64 <= 2.0 * self.shortest {
            let required = "more than two pixels for the shortest wave";
            return Err(BemError::Size { field: "pixels per side", found: n, required });
        }
        let scale = self.scale();
        let key = mix(self.seed);
        let half = n / 2 + 1;
        let mut columns = vec![Complex64::ZERO; half * n];
        for (i, j, k) in self.waves() {
            let wave = key.wrapping_add((i as u32 as u64) << 32).wrapping_add(j as u64);
            let phase = TAU * (mix(wave) >> 11) as f64 / 9_007_199_254_740_992.0;
            let amplitude = (2.0 * scale * self.weight(k)).sqrt();
            // A real map is the sum of a wave and its conjugate: half of each.
            let value = Complex64::from_polar(0.5 * amplitude, phase);
            columns[j as usize * n + i.rem_euclid(n as i64) as usize] = value;
            if j == 0 {
                columns[n - i as usize] = value.conj();
            }
        }
        let down = asperity_fft::inverse(n);
        parallel::map(columns.chunks_mut(n), || (), |(), column| down.process(column));
        let along = asperity_fft::real_inverse(n);
        let mut heights = vec![0.0; n * n];
        parallel::map(
            heights.chunks_mut(n).enumerate(),
            || (),
            |(), (a, row)| {
                let mut waves: Vec<Complex64> = (0..half).map(|j| columns[j * n + a]).collect();
                // Imaginary parts are rounding, which the transform refuses.
                waves[0].im = 0.0;
                // It fails only for wrong lengths and for these.
                let _ = along.process(&mut waves, row);
            },
        );
        HeightMap::new(heights, [n, n], [self.side / n as f64; 2])
    }

    /// The moments of profiles, exact sums over the waves and averages over all directions: m2 is
    /// half of the mean square gradient, m4 3/8 of the mean square of the Laplacian.
    #[must_use]
    pub fn moments(&self) -> ProfileMoments {
        let wave_number = TAU / self.side;
        let scale = self.scale();
        let mean = |power: i32| -> f64 {
            let term = |(_, _, k): (i64, i64, f64)| (wave_number * k).powi(power) * self.weight(k);
            scale * self.waves().map(term).sum::<f64>()
        };
        ProfileMoments { m0: mean(0), m2: 0.5 * mean(2), m4: 0.375 * mean(4) }
    }

    /// The waves (i, j, k).
    fn waves(&self) -> impl Iterator<Item = (i64, i64, f64)> {
        let most = self.shortest as i64;
        let columns = (0..=most).flat_map(move |j| (-most..=most).map(move |i| (i, j)));
        let half = columns.filter(|&(i, j)| j > 0 || i > 0);
        half.map(|(i, j)| (i, j, (i as f64).hypot(j as f64)))
            .filter(|&(_, _, k)| k >= self.longest && k <= self.shortest)
    }

    fn weight(&self, k: f64) -> f64 {
        if k <= self.roll_off { 1.0 } else { (k / self.roll_off).powf(-2.0 * (1.0 + self.hurst)) }
    }

    /// Mean square height of a wave of weight 1 \[m²\].
    fn scale(&self) -> f64 {
        let squares: f64 = self.waves().map(|(_, _, k)| k * k * self.weight(k)).sum();
        (self.gradient * self.side / TAU).powi(2) / squares
    }
}

/// The next number of SplitMix64 after the state z.
fn mix(z: u64) -> u64 {
    let z = z.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
