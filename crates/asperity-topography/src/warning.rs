//! Statistics that stand, and still deserve a word.

use std::fmt;

use serde::Serialize;

/// Something a user should know of the statistics of a surface, and what to do about it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
#[non_exhaustive]
pub enum Warning {
    /// β = η R Sq lies outside 0.02 to 0.1, where rough surfaces are found.
    RoughnessParameter {
        /// β.
        beta: f64,
    },
    /// The two estimators of asperity parameters differ by more than a factor 2.
    EstimatorsDisagree {
        /// Where they do.
        parameters: Vec<Disagreement>,
    },
    /// The estimator that was not asked for could not be applied.
    NoSecondEstimator {
        /// Why.
        reason: String,
    },
    /// More than half of the summits are gone when only every second point is looked at:
    /// the pixel size, not the surface, says how many asperities there are.
    SummitsFollowSampling {
        /// Summits per area \[1/m²\] of all points.
        fine: f64,
        /// Summits per area \[1/m²\] of every second point.
        coarse: f64,
    },
    /// m₄ of a profile falls by more than 4 when only every second point is looked at.
    CurvatureFollowsSampling {
        /// m₄ \[1/m²\] of all points.
        fine: f64,
        /// m₄ \[1/m²\] of every second point.
        coarse: f64,
    },
    /// Missing points were filled.
    Filled {
        /// Their share.
        share: f64,
    },
    /// The rms slopes along rows and columns differ by more than a factor 2.
    Anisotropic {
        /// Along rows.
        slope_x: f64,
        /// Along columns.
        slope_y: f64,
    },
}

impl Warning {
    /// Whether it is about the asperities that are made of the surface, and not about the surface.
    #[must_use]
    pub fn is_of_asperities(&self) -> bool {
        match self {
            Self::RoughnessParameter { .. }
            | Self::EstimatorsDisagree { .. }
            | Self::NoSecondEstimator { .. }
            | Self::SummitsFollowSampling { .. } => true,
            Self::CurvatureFollowsSampling { .. }
            | Self::Filled { .. }
            | Self::Anisotropic { .. } => false,
        }
    }
}

/// A parameter that two estimators tell differently.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Disagreement {
    /// Its name, as in [`Statistics`](crate::Statistics).
    pub parameter: &'static str,
    /// Its value by the spectral moments.
    pub moments: f64,
    /// Its value by the summits.
    pub summits: f64,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RoughnessParameter { beta } if *beta > 0.1 => write!(
                f,
                "beta = eta R Sq is {beta:.4}, rough surfaces are found between 0.02 and 0.1: form and waviness raise Sq, noise raises eta; level with quadratic, filter with a cut-off, or smooth the scan"
            ),
            Self::RoughnessParameter { beta } => write!(
                f,
                "beta = eta R Sq is {beta:.4}, rough surfaces are found between 0.02 and 0.1: the scan is smoothed, too coarse for the asperities, or of a regular surface; scan finer, with more points to the asperity"
            ),
            Self::EstimatorsDisagree { parameters } => {
                for (k, Disagreement { parameter, moments, summits }) in
                    parameters.iter().enumerate()
                {
                    match k {
                        0 => write!(
                            f,
                            "{parameter} is {moments:.4e} by the spectral moments and {summits:.4e} by the summits"
                        )?,
                        _ => write!(f, ", {parameter} {moments:.4e} and {summits:.4e}")?,
                    }
                }
                f.write_str(
                    ", more than a factor 2 apart: the surface is not an isotropic Gaussian one at this sampling; compare the results of both estimators",
                )
            }
            Self::NoSecondEstimator { reason } => {
                write!(f, "the two estimators could not be compared: {reason}")
            }
            Self::SummitsFollowSampling { fine, coarse } => write!(
                f,
                "{fine:.4e} summits per m2 become {coarse:.4e} when every second point is left out: noise, or structure down to the pixel size, makes the asperities; smooth the scan or choose the pixel size for the contact that is meant"
            ),
            Self::CurvatureFollowsSampling { fine, coarse } => write!(
                f,
                "m4 of {fine:.4e} 1/m2 becomes {coarse:.4e} when every second point is left out: noise, or structure down to the pixel size, makes the asperities; smooth the scan or choose the pixel size for the contact that is meant"
            ),
            Self::Filled { share } => write!(
                f,
                "{:.3} % of the points were missing and are filled from those around them (harmonic): smoother than the surface, and without summits",
                100.0 * share
            ),
            Self::Anisotropic { slope_x, slope_y } => write!(
                f,
                "the rms slope is {slope_x:.4e} along rows and {slope_y:.4e} along columns: asperities are taken as round; use the numbers with care"
            ),
        }
    }
}
