//! Adaptive Gauss-Kronrod quadrature with 21 points: the general method of comparisons and tests.

use crate::QuadratureError;

/// An integral with its error estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The integral.
    pub value: f64,
    /// Estimate of the absolute error.
    pub error: f64,
    /// Number of evaluations of the integrand.
    pub evaluations: usize,
}

/// Nodes in (0, 1] of the 21-point Kronrod rule (QUADPACK's QK21), largest first, then 0.
const NODES: [f64; 11] = [
    0.995_657_163_025_808_1,
    0.973_906_528_517_171_7,
    0.930_157_491_355_708_2,
    0.865_063_366_688_984_5,
    0.780_817_726_586_416_9,
    0.679_409_568_299_024_4,
    0.562_757_134_668_604_7,
    0.433_395_394_129_247_2,
    0.294_392_862_701_460_2,
    0.148_874_338_981_631_2,
    0.0,
];
const KRONROD: [f64; 11] = [
    0.011_694_638_867_371_874,
    0.032_558_162_307_964_725,
    0.054_755_896_574_351_996,
    0.075_039_674_810_919_96,
    0.093_125_454_583_697_6,
    0.109_387_158_802_297_64,
    0.123_491_976_262_065_85,
    0.134_709_217_311_473_33,
    0.142_775_938_577_060_1,
    0.147_739_104_901_338_5,
    0.149_445_554_002_916_9,
];
/// Weights of the 10-point Gauss rule inside it, for nodes 1, 3, 5, 7, 9.
const GAUSS: [f64; 5] = [
    0.066_671_344_308_688_14,
    0.149_451_349_150_580_6,
    0.219_086_362_515_982_04,
    0.269_266_719_309_996_35,
    0.295_524_224_714_752_87,
];

struct Panel {
    low: f64,
    high: f64,
    value: f64,
    error: f64,
}

fn panel(f: &mut impl FnMut(f64) -> f64, low: f64, high: f64) -> Panel {
    let (centre, half) = (0.5 * (low + high), 0.5 * (high - low));
    let middle = f(centre);
    let (mut kronrod, mut gauss) = (KRONROD[10] * middle, 0.0);
    for k in 0..10 {
        let pair = f(centre - half * NODES[k]) + f(centre + half * NODES[k]);
        kronrod += KRONROD[k] * pair;
        if k % 2 == 1 {
            gauss += GAUSS[k / 2] * pair;
        }
    }
    Panel { low, high, value: kronrod * half, error: (kronrod - gauss).abs() * half }
}

/// Integrates `f` over consecutive intervals between `breaks` (ascending, at least two), bisecting
/// the worst panel until the error estimate is below `tolerance` relative to the integral.
///
/// # Errors
/// [`QuadratureError::NotConverged`] when `limit` evaluations do not suffice, and
/// [`QuadratureError::NotFinite`] when the integral is not finite.
pub fn gauss_kronrod(
    mut f: impl FnMut(f64) -> f64,
    breaks: &[f64],
    tolerance: f64,
    limit: usize,
) -> Result<Estimate, QuadratureError> {
    let mut panels: Vec<Panel> =
        breaks.windows(2).filter(|w| w[1] > w[0]).map(|w| panel(&mut f, w[0], w[1])).collect();
    let mut evaluations = 21 * panels.len();
    loop {
        let value: f64 = panels.iter().map(|p| p.value).sum();
        let error: f64 = panels.iter().map(|p| p.error).sum();
        if !value.is_finite() {
            return Err(QuadratureError::NotFinite { at: breaks[0], value });
        }
        if error <= tolerance * value.abs() || error <= f64::MIN_POSITIVE {
            return Ok(Estimate { value, error, evaluations });
        }
        let worst = (0..panels.len()).max_by(|&a, &b| panels[a].error.total_cmp(&panels[b].error));
        let split = worst.map(|k| (k, 0.5 * (panels[k].low + panels[k].high)));
        match split {
            Some((k, middle))
                if evaluations < limit && middle > panels[k].low && middle < panels[k].high =>
            {
                let Panel { low, high, .. } = panels.swap_remove(k);
                panels.push(panel(&mut f, low, middle));
                panels.push(panel(&mut f, middle, high));
                evaluations += 42;
            }
            _ => return Err(QuadratureError::missed(error / value.abs(), tolerance, evaluations)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_panel_is_exact_to_degree_31() {
        for degree in [0, 1, 10, 20, 31] {
            let p = panel(&mut |x: f64| x.powi(degree), 0.0, 1.0);
            assert!((p.value * f64::from(degree + 1) - 1.0).abs() < 1e-14, "degree {degree}");
        }
    }

    #[test]
    fn kinks_are_bisected_and_a_missed_tolerance_is_an_error() {
        let kink = |x: f64| (x - 0.3).abs();
        let exact = 0.5 * (0.09 + 0.49);
        let found = gauss_kronrod(kink, &[0.0, 1.0], 1e-10, 100_000).unwrap();
        assert!((found.value / exact - 1.0).abs() < 1e-10);
        let split = gauss_kronrod(kink, &[0.0, 0.3, 1.0], 1e-10, 100_000).unwrap();
        assert!(split.evaluations == 42 && found.evaluations > 200);
        let error = gauss_kronrod(kink, &[0.0, 1.0], 1e-15, 200).unwrap_err();
        assert!(matches!(error, QuadratureError::NotConverged { reached, .. } if reached > 1e-15));
    }
}
