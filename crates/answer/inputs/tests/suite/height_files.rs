//! Tables of heights in files beside a scene file.

use asperity_inputs::{SceneFile, load};

use crate::scene_files::{INTERFACE, SURFACE, directory, text};

#[test]
fn a_table_of_heights_beside_the_scene_is_read_in_metres() {
    let directory = directory("heights");
    // Triangular, of standard deviation sqrt(6)/6 of its half width, mean 2e-6.
    let table = "# measured\nheight_m, density_per_m\n0,0\n2e-6,5e5\n4e-6,0\n";
    std::fs::write(directory.join("pdf.csv"), table).unwrap();
    let read = |lines: &str| {
        let surface = format!(
            "[surface]\nasperity_radius = 3.59e-4\nasperity_density = 1.11e8\nheights = {{ file = \"pdf.csv\" }}\n{lines}"
        );
        std::fs::write(directory.join("scene.toml"), text("", INTERFACE, &surface)).unwrap();
        load(directory.join("scene.toml"))
    };
    let std = 2e-6 / 6f64.sqrt();
    let own = read("").unwrap();
    assert!((own.scene.surface.asperity_height_std / std - 1.0).abs() < 1e-12);
    assert!(own.warnings.is_empty(), "{:?}", own.warnings);
    let other = read("asperity_height_std = 1e-6").unwrap();
    assert!(
        other.warnings.len() == 1 && other.warnings[0].message().contains("8.1650e-7 m"),
        "{:?}",
        other.warnings
    );
    // The same separation in metres gives the same force in either unit.
    let force = |file: &SceneFile, metres: f64| {
        let request = asperity::Request::new([asperity::Quantity::Force]).at_metres([metres]);
        let answer = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        answer.values(asperity::Quantity::Force).unwrap()[0]
    };
    assert!((force(&own, 0.5e-6) / force(&other, 0.5e-6) - 1.0).abs() < 1e-12);
    // The mean of the table is the offset from the mean plane.
    let plane = read("separation_from = \"surface-mean\"").unwrap();
    assert!((plane.scene.mean_plane_offset() - 2e-6).abs() < 1e-18);
    std::fs::write(directory.join("pdf.csv"), "height_m,density_per_m\n-2e-6,0\n0,1\n2e-6,0\n")
        .unwrap();
    let centred = read("separation_from = \"surface-mean\"").unwrap_err().to_string();
    assert!(centred.contains("the mean of this table is 0"), "{centred}");
    let normalised = read("").unwrap().warnings;
    assert!(
        normalised[0].message().contains("the integral of the table is 2.0000e-6, not 1"),
        "{normalised:?}"
    );
    let unit = read("asperity_height_std = 1").unwrap_err().to_string();
    assert!(
        unit.contains("surface.heights is a table") && unit.contains("heights in metres"),
        "{unit}"
    );
}

#[test]
fn invalid_tables_of_heights_are_refused_with_the_line() {
    let directory = directory("bad-heights");
    let surface = format!("{SURFACE}heights = {{ file = \"pdf.csv\" }}\n");
    std::fs::write(directory.join("scene.toml"), text("", INTERFACE, &surface)).unwrap();
    let long: String = (0..10_001).map(|k| format!("{k},1\n")).collect();
    for (table, wanted) in [
        ("", "pdf.csv:1: the header is \"\": \"height_m,density_per_m\""),
        ("z,p\n0,1\n1,1\n", "pdf.csv:1: the header is \"z,p\""),
        ("height_m,density_per_m\n", "pdf.csv: CSV: no row of values under the header"),
        ("height_m,density_per_m\n0,1\n\n1e-6,x\n", "pdf.csv:4: density_per_m is \"x\": a number"),
        ("height_m,density_per_m\n0,1\n1e-6,-1\n", "pdf.csv:3: density_per_m is -1.0"),
        ("height_m,density_per_m\n0,1\n#\n1e-6,1\n0,1\n", "pdf.csv:5: height_m is 0.0"),
        (
            "height_m,density_per_m\n0,1\n1e-6\n",
            "pdf.csv:3: CSV: 1 cells under a header of 2 columns",
        ),
        ("height_m,density_per_m\n0,0\n1e-6,0\n", "pdf.csv: integral of density_per_m is 0.0"),
        (
            &format!("height_m,density_per_m\n{long}"),
            "pdf.csv:10002: CSV: there are more than 10000",
        ),
    ] {
        std::fs::write(directory.join("pdf.csv"), table).unwrap();
        let message = load(directory.join("scene.toml")).unwrap_err().to_string();
        assert!(message.contains(wanted), "{message}\nlacks: {wanted}");
        assert!(!message.contains('\n'), "{message}");
    }
}
