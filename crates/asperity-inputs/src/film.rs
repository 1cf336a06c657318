//! The lay of the surfaces of a scene, for the factors of flow.

use asperity::film::PatirCheng;
use asperity_topography::{Lay, Topography};

use crate::keys::COUNTERFACE;
use crate::{ModelOptions, Place, SceneError, SceneFile};

/// The largest angle between the lay of a scan and its rows or columns.
const OBLIQUE: f64 = 10.0;
/// The ratio of correlation lengths below which a scan has no lay.
const ISOTROPIC: f64 = 1.5;

impl SceneFile {
    /// The factors of flow between the surfaces: the first moves, and a single one faces a smooth
    /// counterface. A Peklenik number that is not given is that of the scan, or 1.
    ///
    /// # Errors
    /// [`SceneError::Refused`] for a scan without one, and for one with an oblique lay.
    pub fn flow(&self, options: &ModelOptions) -> Result<PatirCheng, SceneError> {
        let share_at_rest = self.counter_variance / self.scene.surface_height_std().powi(2);
        let [moving, resting] = self.peklenik_numbers;
        let refused = |reason: String| {
            let at = Place::field(&format!("surface.{PEKLENIK}")).into();
            Err(SceneError::Refused { at, reason })
        };
        let moving = match (moving, self.scan.as_deref()) {
            (Some(given), _) => given,
            (None, Some(scan)) => match peklenik_number(scan) {
                Ok(measured) => measured,
                Err(reason) => return refused(reason),
            },
            (None, None) if self.measured.is_some() => {
                let both = format!("it is measured of one scan only; set {PEKLENIK} in [surface]");
                return refused(format!("{both} and [{COUNTERFACE}]"));
            }
            (None, None) => 1.0,
        };
        let friction_cut_off =
            options.friction_cut_off.unwrap_or(PatirCheng::default().friction_cut_off);
        Ok(PatirCheng {
            peklenik_numbers: [moving, resting.unwrap_or(1.0)],
            share_at_rest,
            friction_cut_off,
        })
    }
}

const PEKLENIK: &str = "peklenik_number";

/// That of a scan, with x along its rows.
fn peklenik_number(scan: &Topography) -> Result<f64, String> {
    let Some(Lay { along_row, along_column, extremes: [shortest, longest], degrees }) = scan.lay()
    else {
        let edge = "the correlation of the heights does not fall to a half within the scan";
        return Err(format!("{edge}; set {PEKLENIK} in [surface]"));
    };
    match longest > ISOTROPIC * shortest && degrees.min(90.0 - degrees) > OBLIQUE {
        true => Err(format!(
            "the lay of the scan is {degrees:.0} degrees from its rows; turn the scan, or set {PEKLENIK} in [surface]"
        )),
        false => Ok(along_row / along_column),
    }
}
