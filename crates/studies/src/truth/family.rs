//! Families of random surfaces, and the materials that press them.

use anyhow::Result;
use asperity::bem::RandomSurface;
use asperity::{At, Compared, Evidence, EvidenceCase, Interface, Scene, Surface};

use xtask::figures::compared::equal;

/// Root mean square gradient. E g is the unit of pressures, so that neither E nor g changes a
/// result.
pub const GRADIENT: f64 = Evidence::GRADIENT;
/// Pixels per shortest wave.
const PIXELS_PER_WAVE: f64 = 8.0;
/// E \[Pa\].
pub const MODULUS: f64 = 1e11;
const POISSON: f64 = 0.3;
/// Loads to this p/(E g) are solved with the highest pixels as unknowns.
pub const LIGHT: f64 = 3e-4;
/// Steps of the bisection of the waves of a bandwidth.
const STEPS: usize = 24;

/// Pressures over E g.
pub const LOADS: [f64; 10] = [1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3];

/// Surfaces with the same moments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Family {
    /// Name of its files.
    pub name: &'static str,
    /// The longest waves and the roll-off in waves on 512 pixels.
    pub waves: [f64; 2],
    /// H beyond the roll-off.
    pub hurst: f64,
    /// Of the heights.
    pub skewness: f64,
    /// Slope across the lay over that along it; the lay is along the rows.
    pub slope_ratio: f64,
    /// Pixels per side under loads that are not light.
    pub pixels: usize,
    /// Pixels per side under the lightest loads: the most asperities for their cost.
    pub most_pixels: usize,
}

const ISOTROPIC: Family = Family {
    name: "a8",
    waves: [4.0, 8.0],
    hurst: RandomSurface::HURST,
    skewness: 0.0,
    slope_ratio: 1.0,
    pixels: 512,
    most_pixels: 2048,
};
/// Skewed surfaces take ten times as long to make.
const SKEWED: Family = Family { most_pixels: 1024, ..ISOTROPIC };

/// The mean pressure of a load.
#[must_use]
pub fn pressure(load: f64) -> At {
    At::Pressure(load * MODULUS * GRADIENT)
}

/// The unit of a quantity on a scene with this Sq \[m\].
#[must_use]
pub fn unit(quantity: Compared, scene: &Scene, sq: f64) -> f64 {
    match quantity {
        Compared::Area => 1.0,
        Compared::MeanGap => sq,
        _ => MODULUS * scene.nominal_area / sq,
    }
}

/// Every family of the evidence: bandwidths, skewnesses, lays.
pub const FAMILIES: [Family; 11] = [
    ISOTROPIC,
    Family { name: "a3", waves: [14.0, 14.0], pixels: 256, ..ISOTROPIC },
    Family { name: "a30", waves: [2.0, 2.4], ..ISOTROPIC },
    Family { name: "a100", waves: [1.0, 1.2], pixels: 1024, ..ISOTROPIC },
    Family { name: "a140", waves: [0.6, 0.7], pixels: 2048, ..ISOTROPIC },
    Family { name: "a8-skew-1", skewness: -1.0, ..SKEWED },
    Family { name: "a8-skew-2", skewness: -2.0, ..SKEWED },
    Family { name: "a8-skew+1", skewness: 1.0, ..SKEWED },
    Family { name: "a8-lay2", slope_ratio: 2.0, ..SKEWED },
    Family { name: "a8-lay4", slope_ratio: 4.0, pixels: 1024, ..SKEWED },
    Family { name: "a8-lay8", slope_ratio: 8.0, pixels: 1024, ..SKEWED },
];

impl Family {
    /// Pixels per side for a load.
    #[must_use]
    pub fn pixels_for(&self, load: f64) -> usize {
        match load {
            light if light < 0.5 * LIGHT => self.most_pixels,
            light if light <= LIGHT => 1024,
            _ => self.pixels,
        }
    }

    /// An isotropic family of this bandwidth, without a plateau of long waves.
    ///
    /// # Errors
    /// Waves that these pixels cannot carry.
    pub fn of_bandwidth(name: &'static str, alpha: f64) -> Result<Self> {
        let of = |waves: f64| Self { name, waves: [waves; 2], ..ISOTROPIC };
        let (mut broad, mut narrow) = (2.0, 40.0f64);
        for _ in 0..STEPS {
            let middle = (broad * narrow).sqrt();
            let found = of(middle).surface(1024)?.moments().bandwidth();
            if found > alpha { broad = middle } else { narrow = middle }
        }
        Ok(of((broad * narrow).sqrt()))
    }

    /// The cases of the family in some evidence.
    ///
    /// # Errors
    /// Waves that the pixels cannot carry.
    pub fn cases<'e>(&self, evidence: &'e Evidence) -> Result<Vec<&'e EvidenceCase>> {
        let alpha = self.surface(self.pixels)?.moments().bandwidth();
        let own = |case: &&EvidenceCase| {
            equal(case.skewness, self.skewness)
                && equal(case.slope_ratio, self.slope_ratio)
                && (case.alpha / alpha - 1.0).abs() < 1e-3
        };
        Ok(evidence.cases().iter().filter(own).collect())
    }

    /// The surface on n x n pixels; a seed determines its heights.
    ///
    /// # Errors
    /// Waves that these pixels cannot carry.
    pub fn surface(&self, pixels: usize) -> Result<RandomSurface> {
        let n = pixels as f64;
        let [longest, roll_off] = self.waves.map(|waves| waves * n / 512.0);
        let surface = RandomSurface::new(longest, roll_off, n / PIXELS_PER_WAVE)?;
        let surface = surface.hurst(self.hurst)?.side(1e-4)?.gradient(GRADIENT)?;
        let surface = surface.lay(self.slope_ratio, 0.0)?;
        Ok(if self.skewness == 0.0 { surface } else { surface.skewness(self.skewness)? })
    }
}

/// The scene of a surface and a plasticity index, which determines the hardness: steel on steel.
///
/// # Errors
/// Moments of no surface.
pub fn scene(surface: &RandomSurface, index: f64) -> Result<Scene> {
    let mut interface = Interface::elastic(MODULUS, POISSON);
    // Two equal materials.
    interface.equivalent_shear_modulus = Some(MODULUS * (1.0 - POISSON) / (2.0 * (2.0 - POISSON)));
    let surface = Surface::from_moments(&surface.moments())?;
    let mut scene = Scene::new(interface, surface, 1e-8);
    if index > 0.0 {
        // ψ is inversely proportional to the hardness.
        scene.interface.hardness = Some(1e9);
        scene.interface.hardness = Some(1e9 * scene.plasticity_index()? / index);
    }
    Ok(scene)
}
