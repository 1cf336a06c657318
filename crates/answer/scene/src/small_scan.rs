//! Scans that are much smaller than the nominal area.

use asperity::{Code, Finding, short};

use crate::height_map::size;
use crate::scene_file::SceneFile;

/// Nominal area over scan area above which a scan may be too small.
const LARGER: f64 = 100.0;
/// The least number of long waves on a side of a scan whose spectrum flattens: of self-affine
/// surfaces without a longest wave, half of Sq² lies in waves above half of the side.
const WAVES: f64 = 3.0;

impl SceneFile {
    /// A note if the scan is much smaller than the nominal area and its spectrum does not flatten
    /// towards long waves.
    pub(crate) fn small_scan(&self) -> Option<Finding> {
        let scan = self.scan()?;
        let (long, [width, height]) = (self.measured.as_ref()?.long_wavelength?, size(scan));
        let side = if scan.is_profile() { width } else { width.min(height) };
        let (few, area) = (long * WAVES > side, self.scene.nominal_area);
        let of_scan = if scan.is_profile() { width * width } else { width * height };
        let ratio = area / of_scan;
        let found = Finding::note(Code::SmallScan, "nominal_area", area)
            .unit("m2")
            .usual([0.0, LARGER * of_scan])
            .fact(format!(
                "nominal_area is {} times the area of the scan, and half of Sq^2 lies in waves longer than {} m, which is a third of the side of the scan or more",
                short(ratio),
                short(long),
            ))
            .advice(
                "waves longer than the scan are missing, and Sq and the separation may be too small; measure a larger scan",
            );
        (few && ratio > LARGER).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use asperity_bem::RandomSurface;
    use asperity_topography::Topography;

    use super::*;
    use crate::{HandedFiles, parse_handed};

    /// A scan of 10 um with this longest wave [m] and nominal area [m^2].
    fn scene(longest: f64, nominal_area: f64) -> SceneFile {
        let surface = RandomSurface::of_wavelengths([longest, longest, 2e-7], [1e-5; 2]).unwrap();
        let map = surface.rms_height(2e-8).unwrap().heights(128).unwrap();
        let scan = Topography::new(map.heights().to_vec(), 128, [1e-5 / 128.0; 2]).unwrap();
        let files = HandedFiles::from([("scan.x3p".to_string(), scan.x3p().unwrap())]);
        let text = format!(
            "nominal_area = {nominal_area}\n[interface]\nequivalent_modulus = 1e11\n\
             poissons_ratio = 0.3\nhardness = 1e9\n[surface]\nfile = \"scan.x3p\"\n"
        );
        parse_handed(&text, &files).unwrap()
    }

    /// What is noted about it.
    fn noted(longest: f64, nominal_area: f64) -> Option<Finding> {
        let found = scene(longest, nominal_area).findings();
        found.into_iter().find(|found| found.code == Code::SmallScan)
    }

    #[test]
    fn a_small_scan_without_flat_spectrum_has_a_note() {
        let note = noted(1e-5, 1e-4).unwrap();
        assert_eq!(note.value.to_bits(), 1e-4f64.to_bits(), "{note:?}");
        // A spectrum that flattens within the scan, and an area that is hardly larger.
        assert_eq!((noted(1.25e-6, 1e-4), noted(1e-5, 5e-9)), (None, None));
    }
}
