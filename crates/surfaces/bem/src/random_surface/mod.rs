//! Reproducible random surfaces: a power law with a roll-off and random phases.

mod lay;
mod waves;

use std::f64::consts::TAU;

use asperity_core::ProfileMoments;
use asperity_fft::Complex64;

use crate::height_map::positive;
use crate::{BemError, HeightMap};
use lay::Lay;
use waves::{Waves, mix, skewed};

/// The most waves along a side.
const MOST: f64 = 8192.0;
/// Cut-offs are lengths over lengths: a wave on a cut-off must not be lost to their rounding.
const ROUNDING: f64 = 1e-12;

/// A periodic random surface on a rectangle.
///
/// ```text
/// h(x, y) = Σ √(2 v(k)) cos(2π (i y/L_y + j x/L_x) + φ(i, j))
/// v(k) = c w(k),  w(k) = 1                     l <= k <= r
///                        (k/r)^(-2(1 + H))     r <  k <= s
///                        0                     elsewhere
/// k = √((i L_x/L_y)² + j²) waves on the length L_x            of an isotropic surface
///     √((a q∥)² + q⊥²)                                        with a lay
/// ```
///
/// over one of every two opposite waves: j > 0, or j = 0 and i > 0. x runs along a row, y along a
/// column, pixel (row m, column n) lies at (x, y) = (n L_x/columns, m L_y/rows). c makes the root
/// mean square gradient what is asked for, (2π/L_x)² Σ |q|² v = g², or Sq, Σ v = Sq²: every surface
/// has it exactly, and the same moments whatever its seed.
///
/// With a [lay](Self::lay) q∥ and q⊥ are the waves along the lay and across it. The cut-offs are
/// those across the lay; along it waves are about a times longer, where a is such that the ratio of
/// the slopes is what is asked for. With a [skewness](Self::skewness) only the phases change: the
/// spectrum and the moments stay exactly the same.
///
/// The phases come from the seed and the numbers of the wave alone, so the same surface is made
/// on every grid, unless it is skewed:
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
/// // Waves of 1 to 20 µm on 64 x 32 µm, flat above 10 µm; Sq = 0.5 µm, deep valleys, lay along x.
/// let surface = RandomSurface::of_wavelengths([20e-6, 10e-6, 1e-6], [64e-6, 32e-6])?
///     .rms_height(0.5e-6)?
///     .lay(3.0, 0.0)?
///     .skewness(-1.0)?
///     .seed(7);
/// let map = surface.map([128, 256])?;
/// assert!((map.rms_height() / 0.5e-6 - 1.0).abs() < 1e-12);
/// # Ok::<(), asperity_bem::BemError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RandomSurface {
    /// Cut-offs in waves on the length of a row.
    longest: f64,
    roll_off: f64,
    shortest: f64,
    hurst: f64,
    /// The length of a row \[m\].
    side: f64,
    /// The length of a row over the length of a column.
    aspect: f64,
    size: Size,
    lay: Option<Lay>,
    skewness: Option<f64>,
    seed: u64,
}

/// What fixes the heights.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Size {
    /// The root mean square gradient.
    Gradient(f64),
    /// Sq \[m\].
    Height(f64),
}

/// A wave: its numbers on a column and on a row, its wave number in waves on the length of a row,
/// and its share of the spectrum.
#[derive(Debug, Clone, Copy)]
struct Wave {
    i: i64,
    j: i64,
    k: f64,
    weight: f64,
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
            if !(found >= least && found <= MOST) {
                let required =
                    "longest, roll-off and shortest in this order, at most 8192 waves per side";
                return Err(BemError::OutOfRange { field, found, required });
            }
        }
        let required = "at least one whole wave between the longest and the shortest";
        let none = BemError::OutOfRange { field: "shortest", found: shortest, required };
        Self::of([longest, roll_off, shortest], [1.0; 2], none)
    }

    /// A surface of `size` = \[length of a row, length of a column\] \[m\] whose waves have the
    /// lengths \[longest, roll-off, shortest\] \[m\]; between the longest wave and the roll-off the
    /// spectrum is flat. Defaults: H = 0.8, gradient 1, seed 0.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] unless longest >= roll-off >= shortest > 0, when no whole wave lies
    /// between, and above 8192 waves on a side.
    pub fn of_wavelengths(
        [longest, roll_off, shortest]: [f64; 3],
        [row, column]: [f64; 2],
    ) -> Result<Self, BemError> {
        positive("size", row)?;
        positive("size", column)?;
        positive("shortest wave", shortest)?;
        for (field, found, least) in
            [("roll-off", roll_off, shortest), ("longest wave", longest, roll_off)]
        {
            if !(found >= least && found.is_finite()) {
                let required = "longest wave, roll-off and shortest wave in this order";
                return Err(BemError::OutOfRange { field, found, required });
            }
        }
        if row.max(column) > MOST * shortest {
            let required = "at least 1/8192 of the size";
            return Err(BemError::OutOfRange { field: "shortest wave", found: shortest, required });
        }
        let required = "at least one whole wave on the size between longest and shortest";
        let none = BemError::OutOfRange { field: "longest wave", found: longest, required };
        let waves = [longest, roll_off, shortest].map(|length| row / length);
        Self::of(waves, [row, row / column], none)
    }

    /// A surface of these cut-offs; the error `none` if no whole wave lies between them.
    fn of(
        [longest, roll_off, shortest]: [f64; 3],
        [side, aspect]: [f64; 2],
        none: BemError,
    ) -> Result<Self, BemError> {
        let (hurst, size) = (Self::HURST, Size::Gradient(1.0));
        let (lay, skewness, seed) = (None, None, 0);
        let this =
            Self { longest, roll_off, shortest, hurst, side, aspect, size, lay, skewness, seed };
        if this.waves().next().is_some() { Ok(this) } else { Err(none) }
    }

    /// Another Hurst exponent.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] outside 0 to 1, and as [`lay`](Self::lay) where there is one.
    pub fn hurst(mut self, hurst: f64) -> Result<Self, BemError> {
        if !(0.0..=1.0).contains(&hurst) {
            let required = "a number from 0 to 1";
            return Err(BemError::OutOfRange { field: "Hurst exponent", found: hurst, required });
        }
        self.hurst = hurst;
        // Other weights have another ratio of slopes.
        match self.lay {
            Some(lay) => self.lay(lay.asked[0], lay.asked[1].to_degrees()),
            None => Ok(self),
        }
    }

    /// Another length of the side, or of the rows \[m\]; the length of the columns follows.
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
        self.size = Size::Gradient(positive("gradient", gradient)?);
        Ok(self)
    }

    /// The standard deviation of the heights Sq \[m\], instead of the gradient.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when it is not a positive number.
    pub fn rms_height(mut self, sq: f64) -> Result<Self, BemError> {
        self.size = Size::Height(positive("Sq", sq)?);
        Ok(self)
    }

    /// A lay: `ratio` is the rms slope across the lay over that along it, `direction` the angle
    /// \[degrees\] of the lay from the rows (x) towards the columns (y). A ratio of 1 is isotropic.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] unless the ratio is from 1 to 100 and the direction is finite, and
    /// where the waves that fit on the size cannot have this ratio to 1 %.
    pub fn lay(mut self, ratio: f64, direction: f64) -> Result<Self, BemError> {
        self.lay = Lay::new(&self, ratio, direction.to_radians())?;
        Ok(self)
    }

    /// The skewness of the heights. The phases of the waves, and no amplitudes, are those of
    /// exp(c g), where g is the Gaussian surface of this seed and c is found.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] unless it is from -5 to 5.
    pub fn skewness(mut self, skewness: f64) -> Result<Self, BemError> {
        if !(-5.0..=5.0).contains(&skewness) {
            let required = "a number from -5 to 5";
            return Err(BemError::OutOfRange { field: "skewness", found: skewness, required });
        }
        self.skewness = Some(skewness);
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
    /// The errors of [`map`](Self::map).
    pub fn heights(&self, n: usize) -> Result<HeightMap, BemError> {
        self.map([n, n])
    }

    /// The heights on `shape` = \[rows, columns\] pixels.
    ///
    /// # Errors
    /// [`BemError::Size`] when a side has not more than two pixels for the shortest wave;
    /// [`BemError::OutOfRange`] when these waves cannot have the skewness.
    pub fn map(&self, shape: [usize; 2]) -> Result<HeightMap, BemError> {
        let most = [self.shortest / self.aspect, self.shortest];
        for (n, most) in shape.into_iter().zip(most) {
            if n as f64 <= 2.0 * most * (1.0 + ROUNDING) {
                let required = "more than two pixels for the shortest wave";
                return Err(BemError::Size { field: "pixels per side", found: n, required });
            }
        }
        let scale = self.scale();
        let key = mix(self.seed);
        let mut waves = Waves::none(shape);
        for Wave { i, j, weight, .. } in self.waves() {
            let wave = key.wrapping_add((i as u32 as u64) << 32).wrapping_add(j as u64);
            let phase = TAU * (mix(wave) >> 11) as f64 / 9_007_199_254_740_992.0;
            let amplitude = (2.0 * scale * weight).sqrt();
            // A real map is the sum of a wave and its conjugate: half of each.
            waves.set(i, j, Complex64::from_polar(0.5 * amplitude, phase));
        }
        let heights = match self.skewness {
            Some(skewness) => skewed(&waves, skewness)?,
            None => waves.heights(),
        };
        let [rows, columns] = shape;
        let pixel = [self.side / self.aspect / rows as f64, self.side / columns as f64];
        HeightMap::new(heights, shape, pixel)
    }

    /// The moments of profiles, exact sums over the waves and averages over all directions: m2 is
    /// half of the mean square gradient, m4 3/8 of the mean square of the Laplacian.
    #[must_use]
    pub fn moments(&self) -> ProfileMoments {
        let wave_number = TAU / self.side;
        let scale = self.scale();
        let mean = |power: i32| -> f64 {
            let term = |wave: Wave| (wave_number * wave.k).powi(power) * wave.weight;
            scale * self.waves().map(term).sum::<f64>()
        };
        ProfileMoments { m0: mean(0), m2: 0.5 * mean(2), m4: 0.375 * mean(4) }
    }

    /// Every wave.
    fn waves(&self) -> impl Iterator<Item = Wave> {
        let [down, along] = [self.shortest / self.aspect, self.shortest]
            .map(|most| (most * (1.0 + ROUNDING)) as i64);
        let columns = (0..=along).flat_map(move |j| (-down..=down).map(move |i| (i, j)));
        let half = columns.filter(|&(i, j)| j > 0 || i > 0);
        half.filter_map(|(i, j)| {
            let [x, y] = [j as f64, i as f64 * self.aspect];
            let k = y.hypot(x);
            let across = self.lay.map_or(k, |lay| lay.across([x, y]));
            let shown = across >= self.longest * (1.0 - ROUNDING)
                && across <= self.shortest * (1.0 + ROUNDING);
            shown.then(|| Wave { i, j, k, weight: self.weight(across) })
        })
    }

    fn weight(&self, k: f64) -> f64 {
        if k <= self.roll_off { 1.0 } else { (k / self.roll_off).powf(-2.0 * (1.0 + self.hurst)) }
    }

    /// Mean square height of a wave of weight 1 \[m²\].
    fn scale(&self) -> f64 {
        match self.size {
            Size::Gradient(gradient) => {
                let squares: f64 = self.waves().map(|wave| wave.k * wave.k * wave.weight).sum();
                (gradient * self.side / TAU).powi(2) / squares
            }
            Size::Height(sq) => sq * sq / self.waves().map(|wave| wave.weight).sum::<f64>(),
        }
    }
}
