//! A lay askew to the axes of a scan: turning the sample under the instrument changes no answer.

use asperity::{At, Compared, Evidence, Quantity, Request, Surface};
use asperity_bem::RandomSurface;
use asperity_inputs::{SceneFile, parse};
use asperity_topography::Topography;

use crate::two_surfaces::HEAD;

const PIXELS: usize = 256;
const PRESSURE: f64 = 5e7;

/// Slopes 4:1, with 16 pixels in the shortest wave across the lay.
fn rough(degrees: f64) -> RandomSurface {
    let rough = RandomSurface::new(6.0, 6.0, 16.0).unwrap().side(128e-6).unwrap();
    rough.gradient(0.06).unwrap().lay(4.0, degrees).unwrap()
}

fn scene(degrees: f64) -> SceneFile {
    let map = rough(degrees).heights(PIXELS).unwrap();
    let scan = Topography::new(map.heights().to_vec(), PIXELS, map.pixel()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("lay.x3p"), scan.x3p().unwrap()).unwrap();
    parse(&format!("{HEAD}file = \"lay.x3p\"\nperiodic = true\n"), folder.path()).unwrap()
}

/// The area by `ke`, and that which boundary elements are expected to find.
fn areas(file: &SceneFile) -> [f64; 2] {
    let asked = Request::new([Quantity::AreaFraction]).at([At::Pressure(PRESSURE)]);
    let ke = file.model("ke").unwrap().solve(&file.scene, &asked).unwrap();
    let shape = file.surface_shape().unwrap();
    let evidence = Evidence::committed().unwrap();
    let expected = evidence.expected(&file.scene, shape, PRESSURE, None).unwrap();
    [
        ke.values(Quantity::AreaFraction).unwrap()[0],
        expected.estimate(Compared::Area).unwrap().value,
    ]
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
            println!("{degrees} {name} {off:.4}");
            assert!(off.abs() < within, "{degrees} degrees: {name} is {found:e}, not {wanted:e}");
        }
        let lay = file.warnings.iter().find(|found| found.code == "anisotropic").unwrap();
        println!("{degrees} ratio {}", lay.value);
        assert!((lay.value / 4.0 - 1.0).abs() < 0.05, "{degrees} degrees: {lay}");
        let areas = areas(&file);
        let first = *along_rows.get_or_insert(areas);
        for (area, first) in areas.iter().zip(first) {
            println!("{degrees} area {:.4}", area / first - 1.0);
            assert!((area / first - 1.0).abs() < 0.02, "{degrees} degrees: {areas:?}, {first}");
        }
    }
}
