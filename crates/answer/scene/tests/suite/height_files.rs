//! Tables of heights in files beside a scene file.

use asperity_scene::{SceneFile, load};

use crate::scene_files::{INTERFACE, SURFACE, directory, text};

#[test]
fn a_table_of_heights_beside_the_scene_is_read_in_metres() {
    let directory = directory("heights");
    // Triangular, of standard deviation sqrt(6)/6 of its half width, mean 2e-6.
    let table = "# measured\nheight_m, density_per_m\n0,0\n2e-6,5e5\n4e-6,0\n";
    std::fs::write(directory.join("pdf.csv"), table).unwrap();
    let read = |lines: &str| {
        let asperities = SURFACE.replace("asperity_height_std = 1e-6\n", "");
        let surface = format!("{asperities}heights = {{ file = \"pdf.csv\" }}\n{lines}");
        std::fs::write(directory.join("scene.toml"), text("", INTERFACE, &surface)).unwrap();
        load(directory.join("scene.toml"))
    };
    let std = 2e-6 / 6f64.sqrt();
    let own = read("").unwrap();
    assert!((own.scene.surface.asperity_height_std / std - 1.0).abs() < 1e-12);
    assert!(own.warnings.is_empty(), "{:?}", own.warnings);
    let other = read("asperity_height_std = 1e-6").unwrap();
    assert_eq!(other.warnings.len(), 1, "{:?}", other.warnings);
    // The same separation in metres gives the same force in either unit.
    let force = |file: &SceneFile, metres: f64| {
        let request =
            asperity::Request::new([asperity::Quantity::Force]).at([asperity::At::metres(metres)]);
        let answer = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        answer.values(asperity::Quantity::Force).unwrap()[0]
    };
    assert!((force(&own, 0.5e-6) / force(&other, 0.5e-6) - 1.0).abs() < 1e-12);
    // The mean of the table is the offset from the mean plane.
    let plane = read("separation_from = \"surface-mean\"").unwrap();
    assert!((plane.scene.mean_plane_offset() - 2e-6).abs() < 1e-18);
}

#[test]
fn a_table_with_too_many_rows_is_refused_at_the_first_of_them() {
    let directory = directory("bad-heights");
    let surface = format!("{SURFACE}heights = {{ file = \"pdf.csv\" }}\n");
    std::fs::write(directory.join("scene.toml"), text("", INTERFACE, &surface)).unwrap();
    let long: String = (0..10_001).map(|k| format!("{k},1\n")).collect();
    std::fs::write(directory.join("pdf.csv"), format!("height_m,density_per_m\n{long}")).unwrap();
    let refused = load(directory.join("scene.toml")).unwrap_err();
    assert_eq!(refused.place().unwrap().line, Some(10_002), "{refused}");
}
