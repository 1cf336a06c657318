//! A lay askew to the axes of a scan: turning the sample under the instrument changes no answer.

use asperity::{At, Quantity, Request, Surface};
use asperity_bem::RandomSurface;
use asperity_scene::{SceneFile, parse};
use asperity_topography::Topography;

use crate::two_surfaces::HEAD;

const PIXELS: usize = 256;

/// Slopes 4:1, with 16 pixels in the shortest wave across the lay.
fn rough(degrees: f64) -> RandomSurface {
    let rough = RandomSurface::new(4.0, 4.0, 16.0).unwrap().side(128e-6).unwrap();
    rough.gradient(0.06).unwrap().lay(4.0, degrees).unwrap()
}

fn scene(degrees: f64) -> SceneFile {
    let map = rough(degrees).heights(PIXELS).unwrap();
    let scan = Topography::new(map.heights().to_vec(), PIXELS, map.pixel()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("lay.x3p"), scan.x3p().unwrap()).unwrap();
    parse(&format!("{HEAD}file = \"lay.x3p\"\nperiodic = true\n"), folder.path()).unwrap()
}

/// The area by `ke`.
fn area(file: &SceneFile) -> f64 {
    let asked = Request::new([Quantity::AreaFraction]).at([At::Pressure(5e7)]);
    let ke = file.model("ke").unwrap().solve(&file.scene, &asked).unwrap();
    ke.values(Quantity::AreaFraction).unwrap()[0]
}

#[test]
fn a_turned_lay_has_the_same_answers_and_its_warning() {
    let mut along_rows = None;
    for degrees in [0.0, 15.0, 30.0, 45.0, 60.0, 90.0] {
        let file = scene(degrees);
        // The moments of the spectrum, without a grid; differences lose 3 % of m4 at most.
        let wanted = Surface::from_moments(&rough(degrees).moments()).unwrap();
        let found = &file.scene.surface;
        for (name, found, wanted, within) in [
            ("R", found.asperity_radius, wanted.asperity_radius, 0.02),
            ("eta", found.asperity_density, wanted.asperity_density, 0.02),
            ("sigma", found.asperity_height_std, wanted.asperity_height_std, 0.002),
        ] {
            let off = found / wanted - 1.0;
            assert!(off.abs() < within, "{degrees} degrees: {name} is {found:e}, not {wanted:e}");
        }
        let lay = file.warnings.iter().find(|found| found.code.name() == "anisotropic").unwrap();
        assert!((lay.value / 4.0 - 1.0).abs() < 0.05, "{degrees} degrees: {lay}");
        // By which evidence is chosen.
        let shape = file.surface_shape().unwrap().unwrap();
        assert!((shape.slope_ratio / lay.value - 1.0).abs() < 1e-12, "{shape:?}");
        let area = area(&file);
        let first = *along_rows.get_or_insert(area);
        // The few long waves that fit on the side give alphas of 3.5 to 4.8.
        assert!((area / first - 1.0).abs() < 0.08, "{degrees} degrees: {area}, {first}");
    }
}
