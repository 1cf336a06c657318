//! Heights of any density.

use std::fmt;
use std::sync::{Arc, OnceLock};

use asperity_quadrature::{QuadratureError, Weight};

/// A density of heights z \[m\] about the plane from which separations are measured: the mean of
/// the asperity heights, unless a density defines another plane.
///
/// Heights are in metres; the scene's `asperity_height_std` is only the unit of separations.
/// Derivatives are not needed, as the engine samples the density.
///
/// ```
/// use asperity_core::{HeightDistribution, Heights};
///
/// /// 12 u²(1-u) between -2 µm and 2.5 µm.
/// #[derive(Debug)]
/// struct Worn;
///
/// impl Heights for Worn {
///     fn name(&self) -> &str {
///         "worn"
///     }
///     fn ln_density(&self, z: f64) -> f64 {
///         let u = (z + 2e-6) / 4.5e-6;
///         if (0.0..=1.0).contains(&u) { (12.0 * u * u * (1.0 - u) / 4.5e-6).ln() } else { f64::NEG_INFINITY }
///     }
///     fn support(&self) -> (f64, f64) {
///         (-2e-6, 2.5e-6)
///     }
/// }
///
/// let heights = HeightDistribution::other(Worn); // the `heights` of a `Scene`
/// ```
pub trait Heights: fmt::Debug + Send + Sync {
    /// Name, for plans, tables and errors.
    fn name(&self) -> &str;

    /// Natural logarithm of the density \[1/m\] at z \[m\]; -∞ where it is zero, and +∞ only
    /// exactly at a pole. The density integrates to 1.
    fn ln_density(&self, z: f64) -> f64;

    /// Smallest and largest height \[m\]; may be infinite.
    fn support(&self) -> (f64, f64);

    /// Heights \[m\] inside the support at which the density or its slope jumps, or that are poles.
    ///
    /// Undeclared kinks and jumps are found but cost time; undeclared poles are refused. A pole, at
    /// an end of the support or a break, is a power above -0.95 of the distance.
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// Relative error of the density if it is an approximation.
    fn error(&self) -> f64 {
        0.0
    }
}

/// User-defined heights with their sampled density, shared by scenes with these heights.
#[derive(Debug)]
pub struct OtherHeights {
    heights: Arc<dyn Heights>,
    weight: OnceLock<Result<Arc<Weight>, QuadratureError>>,
}

impl OtherHeights {
    pub(crate) fn new(heights: impl Heights + 'static) -> Self {
        Self { heights: Arc::new(heights), weight: OnceLock::new() }
    }

    /// The user-defined heights.
    #[must_use]
    pub fn heights(&self) -> &dyn Heights {
        &*self.heights
    }

    /// The density, sampled once.
    pub(crate) fn weight(&self) -> Result<Arc<Weight>, QuadratureError> {
        let sampled = self.weight.get_or_init(|| {
            let name = format!("the density of the heights {:?}", self.heights.name());
            let heights = self.heights.clone();
            let (support, breaks, error) =
                (heights.support(), heights.breaks().to_vec(), heights.error());
            let weight =
                Weight::new(name, move |z| heights.ln_density(z), support, &breaks, error)?;
            Ok(Arc::new(weight))
        });
        sampled.clone()
    }
}
