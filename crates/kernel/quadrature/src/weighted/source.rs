//! The logarithm of a weight, as its author defines it.

use std::fmt;

use crate::{QuadratureError, WeightFault};

/// The name of a weight, and the function that returns its logarithm.
pub(crate) struct Source {
    pub(crate) name: String,
    pub(crate) ln: Box<dyn Fn(f64) -> f64 + Send + Sync>,
}

impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

impl Source {
    pub(crate) fn fault(&self, fault: WeightFault) -> QuadratureError {
        QuadratureError::Weight { weight: self.name.clone(), fault }
    }

    /// The typical distance of the weight from a place, on one side; `None` where it is zero.
    pub(crate) fn scale(&self, anchor: f64, side: f64) -> Option<f64> {
        let (mut best, mut most) = (None, f64::NEG_INFINITY);
        for octave in -300..=300 {
            let u = 2f64.powi(octave);
            let z = anchor + side * u;
            if u <= 64.0 * f64::EPSILON * anchor.abs() {
                continue;
            }
            // NaN is no error here: the panels may never reach this place.
            let value = (self.ln)(z);
            let mass = value + u.ln();
            if mass > most && mass < f64::INFINITY {
                (best, most) = (Some(u), mass);
            }
        }
        best
    }
}
