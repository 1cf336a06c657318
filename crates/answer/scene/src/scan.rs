//! The scan of a scene for boundary elements.

use std::sync::Arc;

use asperity::Spectrum;
use asperity_bem::{Bem, BemOptions, Continuation, HeightMap};
use asperity_topography::Topography;

use crate::error::{Place, SceneError};
use crate::measured::{ScanSpectrum, height_map};
use crate::scene_file::SceneFile;

impl SceneFile {
    /// The boundary-element model of the scene's scan, levelled and filtered, with the options of
    /// the scene: see [`Bem::new`]. Unless they name a boundary, a scan with `periodic = true` is
    /// repeated as it is.
    ///
    /// # Errors
    /// [`SceneError::Refused`] without a scan or with two that are not aligned;
    /// [`SceneError::Refused`] for a profile and for missing points.
    pub fn bem(&self) -> Result<Bem, SceneError> {
        self.pressed(self.spec.options.bem())
    }

    /// The scene with these options of boundary elements in front of its own.
    #[must_use]
    pub fn pressing(mut self, given: BemOptions) -> Self {
        let options = &mut self.spec.options;
        options.boundary = given.boundary.or(options.boundary);
        options.elastic |= given.elastic;
        self
    }

    /// [`bem`](Self::bem) with these options instead of the scene's.
    pub(crate) fn pressed(&self, options: BemOptions) -> Result<Bem, SceneError> {
        self.need_flat()?;
        let at = Place::field("surface.file");
        let Some(scan) = self.scan() else {
            let needed = "boundary elements (bem) need the scan of one surface, file = \"scan.x3p\" in [surface] with unit and pixel_size if the file does not state them, or scans of both with aligned = true";
            return Err(SceneError::missing(at, needed));
        };
        let map = whole_map(scan, "boundary elements need");
        let map = map.map_err(|reason| SceneError::refused(at, reason))?;
        let boundary = options.boundary.or(declared(scan));
        Ok(Bem::new(map, BemOptions { boundary, ..options }))
    }

    /// The spectrum of the scene's scan, continued periodically, or the reason why it has none;
    /// `None` without a scan. Computed once.
    pub(crate) fn spectrum(&self) -> Option<ScanSpectrum> {
        let of = |scan: &Topography| {
            let map = whole_map(scan, "its spectrum needs")?;
            // As boundary elements press it.
            let map = declared(scan).unwrap_or_else(|| Continuation::of(&map)).applied(map);
            let spectrum = Spectrum::of_waves(map.waves()).map_err(|error| error.to_string())?;
            Ok(Arc::new(spectrum))
        };
        let scan = self.spec.single_scan()?;
        Some(scan.spectrum.get_or_init(|| of(&scan.topography)).clone())
    }
}

/// The continuation of a scan that is declared periodic.
fn declared(scan: &Topography) -> Option<Continuation> {
    scan.is_periodic().then_some(Continuation::Periodic)
}

/// The height map of a scan; the error for missing points explains how to fill them.
fn whole_map(scan: &Topography, needing: &str) -> Result<HeightMap, String> {
    height_map(scan).map_err(|error| match scan.missing_share() {
        missing if missing > 0.0 => {
            let (percent, most) = (100.0 * missing, 100.0 * Topography::MOST_FILLED);
            format!(
                "{percent:.3} % of the points are missing, and {needing} all points: fill_missing = true in [surface] fills up to {most} %"
            )
        }
        _ => error.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use asperity::ContactModel;

    use asperity::Code;

    use super::*;
    use crate::measured::open_seam;

    const FREE: BemOptions = BemOptions { boundary: Some(Continuation::Free), elastic: true };

    const BAND: &str = "smooth = 4e-6\nfilter = 8e-6";

    /// Waves of two lengths on a grid that is wider than high.
    fn scan() -> Topography {
        let height = |k: usize| {
            let (x, y) = ((k % 48) as f64, (k / 48) as f64);
            1e-7 * ((0.8 * x + 0.3 * y).cos() + (0.7 * y - 0.2 * x).sin())
        };
        Topography::new((0..48 * 32).map(height).collect(), 48, [1e-6, 2e-6]).unwrap()
    }

    fn scene(surface: &str) -> SceneFile {
        let folder = tempfile::tempdir().unwrap();
        let lines: Vec<String> = scan()
            .heights()
            .chunks(48)
            .map(|row| row.iter().map(f64::to_string).collect::<Vec<_>>().join(" "))
            .collect();
        std::fs::write(folder.path().join("scan.txt"), lines.join("\n")).unwrap();
        let text = format!(
            "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\npoissons_ratio = 0.3\n\
             hardness = 1e9\n[surface]\nunit = \"m\"\npixel_size = [1e-6, 2e-6]\n{surface}"
        );
        crate::parse(&text, folder.path()).unwrap()
    }

    #[test]
    fn rows_and_columns_keep_their_distances() {
        let map = height_map(&scan()).unwrap();
        assert_eq!((map.shape(), map.pixel()), ([32, 48], [2e-6, 1e-6]));
        assert!((map.area() / (48.0 * 32.0 * 2e-12) - 1.0).abs() < 1e-12);
        assert!(
            (map.heights()[1] - map.heights()[0] - scan().heights()[1] + scan().heights()[0]).abs()
                < 1e-20
        );
    }

    #[test]
    fn a_hurst_exponent_with_a_scan_is_used() {
        let own = scene("file = \"scan.txt\"");
        let given = scene("file = \"scan.txt\"\n[options]\nhurst_exponent = 0.8");
        let request =
            asperity::Request::new([asperity::Quantity::Tangent]).at([asperity::At::Pressure(1e8)]);
        let [a, b] = [own, given].map(|file| {
            let answer = file.model("persson").unwrap().solve(&file.scene, &request).unwrap();
            answer.columns[0].rows[0].as_ref().unwrap().value()
        });
        assert!((a / b - 1.0).abs() > 1e-3, "{a} {b}");
    }

    #[test]
    fn a_step_at_periodic_edges_and_crossed_cut_offs_are_reported() {
        // A quarter of a wave more than whole waves leaves a step at the edges.
        let tilted = |k: usize| 1e-7 * (TAU * (k % 48) as f64 / 38.4).sin();
        let tilted = Topography::new((0..48 * 32).map(tilted).collect(), 48, [1e-6; 2]).unwrap();
        assert_eq!(open_seam(&tilted), None);
        assert!(open_seam(&tilted.with_periodic(true)).is_some());
        let file = scene(&format!("file = \"scan.txt\"\nperiodic = true\n{BAND}"));
        let seam = file.warnings.iter().find(|found| found.code == Code::OpenSeam).unwrap();
        assert_eq!(seam.origin.as_deref(), Some("line 10: surface.periodic"));
        let whole = |k: usize| (TAU * (k % 48) as f64 / 12.0).cos();
        let whole = Topography::new((0..48 * 32).map(whole).collect(), 48, [1e-6; 2]).unwrap();
        assert_eq!(open_seam(&whole.with_periodic(true)), None);
    }

    #[test]
    fn the_spectrum_of_a_scan_is_computed_once_and_its_absence_explained() {
        let file = scene("file = \"scan.txt\"");
        let [first, again] = [&file, &file.clone()].map(|file| file.spectrum().unwrap().unwrap());
        assert!(Arc::ptr_eq(&first, &again));
        assert!(file.inputs(["asperity_height_std"]).is_err());
        let profile = Topography::new(scan().heights()[..48].to_vec(), 48, [1e-6; 2]).unwrap();
        let mut heights = scan().heights().to_vec();
        heights[100] = f64::NAN;
        let holed = Topography::new(heights, 48, [1e-6, 2e-6]).unwrap();
        for (scan, reason) in [(profile, "rows is 1"), (holed, "fill_missing = true in [surface]")]
        {
            let file = SceneFile::from(file.scene.clone()).pressing_scan(scan);
            let request = asperity::Request::new([asperity::Quantity::Tangent]);
            let request = request.at([asperity::At::Pressure(1e8)]);
            let answer = file.model("persson").unwrap().solve(&file.scene, &request).unwrap();
            let text = answer.columns[0].rows[0].as_ref().unwrap_err().to_string();
            assert!(
                text.starts_with("hurst_exponent is missing") && text.contains(reason),
                "{text}"
            );
        }
    }

    #[test]
    fn a_few_missing_points_are_filled_on_request() {
        let folder = tempfile::tempdir().unwrap();
        let lines = |missing: usize| -> String {
            let point = |(k, z): (usize, &f64)| {
                let there = k % 19 != 5 || k >= 19 * missing;
                let end = if k % 48 == 47 { "\n" } else { " " };
                if there { format!("{z}{end}") } else { format!("nan{end}") }
            };
            scan().heights().iter().enumerate().map(point).collect()
        };
        std::fs::write(folder.path().join("few.txt"), lines(10)).unwrap();
        let text = "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\n\
             poissons_ratio = 0.3\n[surface]\nfile = \"few.txt\"\nunit = \"m\"\npixel_size = [1e-6, 2e-6]\n";
        let read = |more: &str| crate::parse(&format!("{text}{more}"), folder.path()).unwrap();
        assert!(read("").pressing(FREE).bem().is_err());
        let filled = read("fill_missing = true");
        let bem = filled.clone().pressing(FREE).bem().unwrap();
        let whole = scan().level(asperity_topography::Level::Plane).unwrap();
        let largest = whole.heights().iter().fold(0.0, |m: f64, z| m.max(z.abs()));
        let off = bem.map().heights().iter().zip(whole.heights()).map(|(a, b)| (a - b).abs());
        // A wave of 8 pixels is 0.3 of its height higher than the mean of its neighbours.
        assert!(off.fold(0.0, f64::max) < 0.4 * largest);
        assert!(
            filled.warnings.iter().any(|one| one.code == Code::Filled),
            "{:?}",
            filled.warnings
        );
        std::fs::write(folder.path().join("few.txt"), lines(81)).unwrap();
        let more = format!("{text}fill_missing = true\n");
        assert!(crate::parse(&more, folder.path()).is_err());
    }

    #[test]
    fn a_scan_is_pressed_with_the_options_of_its_scene_and_those_given_in_front() {
        let options = |text: &str| scene(&format!("file = \"scan.txt\"\n[options]\n{text}"));
        let plain = options("");
        let of = |bem: Bem, file: &SceneFile| {
            (bem.continuation(), bem.hardness(&file.scene.interface).unwrap())
        };
        let usual = of(plain.bem().unwrap(), &plain);
        assert_eq!(usual, (Continuation::PeriodicPart, Some(1e9)));
        let own = options("boundary = \"free\"\nelastic = true");
        for free in [&own, &plain.clone().pressing(FREE)] {
            assert_eq!(of(free.bem().unwrap(), free), (Continuation::Free, None));
        }
        // Without options, the given ones change nothing; a boundary is replaced.
        let periodic = BemOptions { boundary: Some(Continuation::Periodic), elastic: false };
        for (given, boundary) in
            [(BemOptions::default(), Continuation::Free), (periodic, Continuation::Periodic)]
        {
            let found = own.clone().pressing(given);
            assert_eq!(of(found.bem().unwrap(), &found), (boundary, None));
        }
    }

    #[test]
    fn the_scan_is_levelled_and_belongs_to_its_surface() {
        let file = scene("file = \"scan.txt\"");
        let levelled = scan().level(asperity_topography::Level::Plane).unwrap();
        let bem = file.clone().pressing(FREE).bem().unwrap();
        for (a, b) in bem.map().heights().iter().zip(levelled.heights()) {
            assert!((a - b).abs() < 1e-18);
        }
        assert_eq!(file.model("bem").unwrap().id(), "bem");
        let names = ["hardness", "nominal_area"];
        let inputs = file.inputs(names).unwrap();
        let same = file.with_inputs([(inputs[0], 2e9), (inputs[1], 2e-6)]).unwrap();
        assert!(same.bem().is_ok());
        let second = "counterface = { file = \"scan.txt\", unit = \"m\", pixel_size = 1e-6 }";
        let two = scene(&format!("file = \"scan.txt\"\n{second}"));
        let refused = two.bem().unwrap_err();
        assert!(refused.to_string().starts_with("surface.file is missing"), "{refused}");
    }
}
