//! The lay of the surfaces of a scene, for the factors of flow.

use asperity::film::PatirCheng;
use asperity::{Asperities, Model};
use asperity_topography::{Lay, Topography};

use crate::error::{Place, SceneError};
use crate::scene_file::SceneFile;

/// The largest angle \[degrees\] between the lay of a scan and its rows or columns that counts as
/// none: the factors of one lay have a wider range than those of an oblique one.
const ALIGNED: f64 = 2.0;
/// The ratio of correlation lengths below which a scan has no lay, and they are taken along its
/// rows and columns.
const ISOTROPIC: f64 = 1.5;

impl SceneFile {
    /// The factors of flow between the surfaces of a model: the first moves, and a single one faces
    /// a smooth counterface or, for models of pairs, its like. A Peklenik number that is not given
    /// is that of the scan, with the angle of its lay, or 1.
    ///
    /// # Errors
    /// [`SceneError::Refused`] for a scan without one.
    pub fn flow(&self, model: &Model) -> Result<PatirCheng, SceneError> {
        self.need_flat()?;
        let alike = model.asperities() == Asperities::Pairs && self.scene.pair.is_none();
        let share_at_rest = match self.scene.pair {
            None if !alike => self.counter_variance() / self.scene.surface_height_std().powi(2),
            _ => self.scene.both_surfaces().share_of_second(),
        };
        let counterface = self.spec.counterface.as_ref();
        let resting = counterface.and_then(|second| second.peklenik_number);
        let moving = match (self.spec.surface.peklenik_number, self.scan()) {
            (Some(given), _) => Ok((given, 0.0)),
            (None, Some(scan)) => peklenik_number(scan),
            (None, None) if self.measured.is_some() => {
                Err(format!("it is measured of one scan only; set {PEKLENIK} in [surface]"))
            }
            (None, None) => Ok((1.0, 0.0)),
        };
        let moving = moving.map_err(|reason| {
            SceneError::refused(Place::field(format!("surface.{PEKLENIK}")), reason)
        })?;
        // Two scans are of like surfaces, and so are the surfaces of a model of pairs.
        let of_like = if self.measured.is_some() || alike { moving } else { (1.0, 0.0) };
        let resting = resting.map_or(of_like, |given| (given, 0.0));
        let friction_cut_off =
            self.spec.options.friction_cut_off.unwrap_or(PatirCheng::default().friction_cut_off);
        Ok(PatirCheng {
            peklenik_numbers: [moving.0, resting.0],
            lay_angles: [moving.1, resting.1],
            share_at_rest,
            friction_cut_off,
        })
    }

    /// The mean square of the heights of the second surface \[m²\], beside a scan; 0 of a single
    /// surface and of aligned scans.
    fn counter_variance(&self) -> f64 {
        let second = self.spec.counterface.as_ref().filter(|_| self.spec.pressed.is_none());
        let moments = second.and_then(|second| second.moments(&self.scene.interface));
        moments.map_or(0.0, |moments| moments.m0)
    }
}

const PEKLENIK: &str = "peklenik_number";

/// That of a scan, along the axis of its lay that is nearer to its rows, and the angle of this axis
/// from the rows, which are x.
fn peklenik_number(scan: &Topography) -> Result<(f64, f64), String> {
    let Some(Lay { lengths: [along, across], degrees }) = scan.lay() else {
        let edge = "the correlation of the heights does not fall to a half within the scan";
        return Err(format!("{edge}; set {PEKLENIK} in [surface]"));
    };
    let extent = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (cos / along).hypot(sin / across).recip()
    };
    let ratio = along / across;
    Ok(match ratio.max(ratio.recip()) < ISOTROPIC {
        // The axes of a round correlation are those of single waves.
        true => (extent(degrees) / extent(90.0 - degrees), 0.0),
        false => (ratio, if degrees.abs() > ALIGNED { degrees } else { 0.0 }),
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const HEAD: &str = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 1e11\npoissons_ratio = 0.3\n[surface]\n";

    const FACING: &str = "sq = 3e-7\nspd = 3e10\nspc = 2e5";

    fn flow(surface: &str, folder: &Path) -> Result<PatirCheng, String> {
        let file = crate::parse(&format!("{HEAD}{surface}"), folder).map_err(|e| e.to_string())?;
        file.flow(&file.model("gw").unwrap()).map_err(|error| error.to_string())
    }

    #[test]
    fn numbers_of_both_surfaces_have_their_lay_and_their_share() {
        let one = "asperity_radius = 2e-5\nasperity_density = 5e9\nsurface_height_std = 4e-7\n";
        let alone = flow(one, Path::new(".")).unwrap();
        assert_eq!(alone, PatirCheng::default());
        let two = format!("[surface.counterface]\n{FACING}\npeklenik_number = 0.5\n");
        let two = format!("peklenik_number = 3\n{two}[options]\nfriction_cut_off = 1e-3");
        let both = flow(&format!("{one}{two}"), Path::new(".")).unwrap();
        assert_eq!((both.peklenik_numbers, both.friction_cut_off), ([3.0, 0.5], 1e-3));
        // 3²/(3² + 4²).
        assert!((both.share_at_rest - 0.36).abs() < 1e-6, "{both:?}");
        // By roughness or by moments, the moving one or the resting one: in each way the same.
        let rough = |rq: f64| format!("rq = {rq}e-7, rdq = 0.03, bandwidth = 6");
        let moments = |rq: f64| format!("m0 = {}e-14, m2 = 9e-4, m4 = 1e9", rq * rq);
        let ways: [&dyn Fn(f64) -> String; 2] = [&rough, &moments];
        for (first, second) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let [moving, resting] = [ways[first](4.0).replace(", ", "\n"), ways[second](3.0)];
            let text = format!("{moving}\npeklenik_number = 3\ncounterface = {{ {resting} }}\n");
            let found = flow(&text, Path::new(".")).unwrap();
            assert!((found.share_at_rest - 0.36).abs() < 1e-12, "{text}{found:?}");
        }
        let refused = flow(&format!("{one}[options]\nfriction_cut_off = 1"), Path::new("."));
        assert!(refused.unwrap_err().contains("friction_cut_off"));
    }

    #[test]
    fn factors_of_flow_are_those_of_the_surfaces_of_the_model() {
        let given = "asperity_radius = 2e-5\nasperity_density = 4e9\nasperity_height_std = 4e-7\n";
        let roughness =
            "asperity_radius = 2e-5\nasperity_density = 5e9\nsurface_height_std = 4e-7\n";
        let facing = format!("[surface.counterface]\n{FACING}");
        for (keys, facing) in [(given, ""), (roughness, ""), (roughness, &facing)] {
            let text = format!("{HEAD}{keys}peklenik_number = 3\n{facing}");
            let file = crate::parse(&text, Path::new(".")).unwrap();
            let flow = file.flow(&file.model("gw-pairs").unwrap()).unwrap();
            let alike = facing.is_empty();
            assert_eq!(
                flow.peklenik_numbers[1].to_bits(),
                if alike { 3f64 } else { 1.0 }.to_bits()
            );
            assert_eq!((flow.share_at_rest - 0.5).abs() < 1e-12, alike);
        }
    }

    #[test]
    fn a_scan_has_its_own_lay() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, turned: f64| {
            let (sin, cos) = f64::to_radians(turned).sin_cos();
            let height = |x: f64, y: f64| {
                let (u, v) = (cos * x + sin * y, cos * y - sin * x);
                1e-7 * ((u / 2.0 + 0.3).sin() + (u / 3.3).sin() + (v / 7.0).sin() + (v / 5.1).cos())
            };
            let line = |y: u16| {
                let row = (0..160_u16).map(|x| height(x.into(), y.into()).to_string());
                row.collect::<Vec<_>>().join(" ")
            };
            let text = (0..160).map(line).collect::<Vec<_>>().join("\n");
            std::fs::write(folder.path().join(name), text).unwrap();
        };
        write("along.txt", 0.0);
        write("oblique.txt", 35.0);
        let two = "file = \"along.txt\"\nunit = \"m\"\npixel_size = 1e-6\n\
            counterface = { file = \"along.txt\", unit = \"m\", pixel_size = 1e-6 }\n";
        assert!(flow(two, folder.path()).unwrap_err().contains("peklenik_number"));
        let both = flow(&format!("{two}peklenik_number = 0.4"), folder.path()).unwrap();
        assert_eq!(both.peklenik_numbers.map(f64::to_bits), [0.4; 2].map(f64::to_bits));
        assert!((both.share_at_rest - 0.5).abs() < 1e-12);
        let scan = |name: &str, more: &str| {
            let keys = format!("file = \"{name}\"\nunit = \"m\"\npixel_size = 1e-6\n{more}");
            flow(&keys, folder.path())
        };
        let straight = scan("along.txt", "").unwrap();
        let number = straight.peklenik_numbers[0];
        assert!(number > 0.2 && number < 0.6, "{number}");
        assert!(straight.lay_angles.iter().all(|angle| angle.abs() <= 0.0), "{straight:?}");
        let oblique = scan("oblique.txt", "").unwrap();
        let [angle, _] = oblique.lay_angles;
        // Of few waves, another part of which is measured.
        assert!((oblique.peklenik_numbers[0] / number - 1.0).abs() < 0.2, "{oblique:?} {number}");
        assert!((angle - 35.0).abs() < 2.0, "{angle}");
        let given = scan("oblique.txt", "peklenik_number = 2").unwrap();
        assert_eq!((given.peklenik_numbers, given.lay_angles), ([2.0; 2], [0.0; 2]));
    }
}
