//! Skewed heights with a given spectrum: all of the skewness is in the phases.

use super::waves::Waves;
use crate::{BemError, parallel};

/// The largest bend c of exp(c g), beyond which the skewness hardly grows.
const MOST_BENT: f64 = 4.0;
/// More than false position takes, about 10.
const TRIALS: usize = 60;
/// Accepted deviation of the skewness, relative to the larger of it and a tenth.
const TOLERANCE: f64 = 1e-4;

/// Heights with these waves' amplitudes and a skewness.
pub(super) fn heights(waves: &Waves, skewness: f64) -> Result<Vec<f64>, BemError> {
    let gaussian = waves.heights();
    let [square] = parallel::sum([&gaussian], |[h]| [h * h]);
    let sq = (square / gaussian.len() as f64).sqrt();
    let bent = |c: f64| {
        let bent: Vec<f64> = gaussian.iter().map(|h| (c * h / sq).exp_m1() / c).collect();
        let heights = waves.with_phases_of(&bent).heights();
        let [cube] = parallel::sum([&heights], |[h]| [(h / sq).powi(3)]);
        (cube / heights.len() as f64 - skewness, heights)
    };
    let [cube] = parallel::sum([&gaussian], |[h]| [(h / sq).powi(3)]);
    let tolerance = TOLERANCE * skewness.abs().max(0.1);
    let natural = cube / gaussian.len() as f64 - skewness;
    if natural.abs() <= tolerance {
        return Ok(gaussian);
    }
    // Doubled until the skewness is passed, then by false position (Illinois).
    let side = -natural.signum();
    let (mut low, mut high) = ((0.0, natural), None);
    let mut c = 0.25 * side;
    for _ in 0..TRIALS {
        let (off, heights) = bent(c);
        if off.abs() <= tolerance {
            return Ok(heights);
        }
        let passed = off * side > 0.0;
        match &mut high {
            None if !passed => (low, c) = ((c, off), 2.0 * c),
            None => high = Some((c, off)),
            Some(high) if passed => (*high, low.1) = ((c, off), 0.5 * low.1),
            Some(high) => (low, high.1) = ((c, off), 0.5 * high.1),
        }
        match high {
            Some(high) => c = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1),
            None if c.abs() > MOST_BENT => break,
            None => {}
        }
    }
    let required = "a skewness that these waves can have (nearer 0, or with more waves)";
    Err(BemError::OutOfRange { field: "skewness", found: skewness, required })
}
