//! Scenes whose surface is a measured file.

use std::path::Path;

use asperity::{Code, Quantity, Request};
use asperity_scene::{SceneError, SceneFile, load};
use asperity_topography::{Estimator, Level, ReadOptions, Statistics, read};

use crate::scene_files::directory;
use crate::two_surfaces::{HEAD, READ, write_scan};

fn scene(directory: &Path, surface: &str) -> Result<SceneFile, SceneError> {
    let path = directory.join("scene.toml");
    std::fs::write(&path, HEAD.replace("1e-8", "1e-4") + surface).unwrap();
    load(&path)
}

/// Heights \[nm\] of 96 x 96 points, as text: waves in many directions.
fn scan(phase: f64) -> String {
    let waves: Vec<[f64; 3]> = (0..40)
        .map(|k| {
            let (turn, size) = (2.399_963 * f64::from(k), 0.2 + 0.4 * f64::from(k % 7) / 7.0);
            [size * turn.cos(), size * turn.sin(), phase * f64::from(k * k)]
        })
        .collect();
    let height = |x: i32, y: i32| {
        let wave = |[a, b, c]: &[f64; 3]| (a * f64::from(x) + b * f64::from(y) + c).cos();
        100.0 * waves.iter().map(wave).sum::<f64>()
    };
    let row = |y| (0..96).map(|x| format!("{:.4}", height(x, y))).collect::<Vec<_>>().join("\t");
    (0..96).map(|y| row(y) + "\n").collect()
}

#[test]
fn a_periodic_scan_keeps_its_moments_by_default() {
    let directory = tempfile::tempdir().unwrap();
    let rough = asperity_bem::RandomSurface::new(2.0, 2.0, 12.0).unwrap();
    let rough = rough.side(96e-6).unwrap().gradient(0.02).unwrap().seed(2);
    let map = rough.heights(96).unwrap();
    write_scan(&directory.path().join("scan.txt"), map.heights(), 96);
    let read = |more: &str| {
        scene(directory.path(), &format!("file = \"scan.txt\"\n{READ}\n{more}")).unwrap()
    };
    let moments = |file: &asperity_scene::SceneFile| {
        let statistics = &file.measured.as_ref().unwrap().statistics;
        (statistics.moments.profile.m2, statistics.moments.profile.m4)
    };
    let (usual, mean) = (read(""), read("level = \"mean\""));
    let (m2, m4) = moments(&usual);
    assert_eq!((m2, m4), moments(&mean));
    // Differences underestimate the shortest waves, of 8 pixels, by 2.5 and 5 %.
    let exact = rough.moments();
    assert!((m2 / exact.m2 - 1.0).abs() < 0.04 && (m4 / exact.m4 - 1.0).abs() < 0.06, "{m2} {m4}");
    let tilted = read("level = \"plane\"");
    assert!(moments(&tilted).1 > 1.1 * m4);
    let tilt_warning =
        |file: &asperity_scene::SceneFile| file.warnings.iter().any(|w| w.code.name() == "level");
    assert!(
        tilt_warning(&tilted) && !tilt_warning(&usual) && !tilt_warning(&mean),
        "{:?}",
        tilted.warnings
    );
    // Boundary elements use the same scan.
    let bem = usual.bem().unwrap();
    assert!(bem.note().is_none());
    assert_eq!(bem.continuation(), asperity_bem::Continuation::Periodic);
}

#[test]
fn files_give_the_surfaces_of_the_topography_crate() {
    let directory = directory("measured-files");
    let header = "# Width: 96 um\n# Height: 96 um\n# Value units: nm\n";
    std::fs::write(directory.join("a.txt"), header.to_string() + &scan(5.1)).unwrap();
    std::fs::write(directory.join("b.txt"), header.to_string() + &scan(2.7)).unwrap();
    std::fs::write(directory.join("bare.txt"), scan(5.1)).unwrap();

    let statistics = |name: &str| {
        let topography = read(&directory.join(name), &ReadOptions::default()).unwrap();
        topography.level(Level::Plane).unwrap().statistics(Estimator::Moments).unwrap()
    };
    let (a, b) = (statistics("a.txt"), statistics("b.txt"));
    let one = scene(&directory, "file = \"a.txt\"").unwrap();
    assert_eq!(one.scene.surface, a.surface().unwrap());
    assert!(one.warnings.len() == a.warnings.len());
    let both = scene(&directory, "file = \"a.txt\"\ncounterface = { file = \"b.txt\" }").unwrap();
    assert_eq!(both.scene.surface, Statistics::combined(&a, &b).unwrap().surface().unwrap());

    let bare = scene(&directory, "file = \"bare.txt\"").unwrap_err();
    assert_eq!(bare.place().unwrap().field, "surface.file", "{bare}");
    let tilt_warning =
        scene(&directory, "file = \"bare.txt\"\nunit = \"nm\"\npixel_size = 1000").unwrap();
    assert!(
        (tilt_warning.scene.surface.asperity_radius / a.surface().unwrap().asperity_radius - 1.0)
            .abs()
            < 1e-9
    );
    let wide = "file = \"bare.txt\"\nunit = \"nm\"\npixel_size = [1000, 2000]";
    let wide = scene(&directory, wide).unwrap().scene.surface;
    assert!(wide.asperity_radius > 1.1 * a.surface().unwrap().asperity_radius);

    let from = scene(&directory, "file = \"a.txt\"\nseparation_from = \"surface-mean\"").unwrap();
    assert!((from.scene.mean_plane_offset() - a.mean_plane_offset.unwrap()).abs() < 1e-15);
    assert!(
        from.model("ke")
            .unwrap()
            .solve(&from.scene, &Request::new([Quantity::Force]).at([1.0]))
            .is_ok()
    );
}

#[test]
fn measured_heights_smooth_and_periodic_are_applied() {
    let directory = directory("measured-heights");
    let header = "# Width: 96 um\n# Height: 96 um\n# Value units: nm\n";
    std::fs::write(directory.join("a.txt"), header.to_string() + &scan(5.1)).unwrap();
    let read_with = |keys: &str| scene(&directory, &format!("file = \"a.txt\"\n{keys}"));
    let file = read_with(
        "heights = \"measured\"\nestimator = \"summits\"\nseparation_from = \"surface-mean\"",
    );
    let file = file.unwrap();
    let topography = read(&directory.join("a.txt"), &ReadOptions::default()).unwrap();
    let topography = topography.level(Level::Plane).unwrap();
    let summits = topography.summits().unwrap();
    let table = file.table().unwrap();
    let std = summits.surface().unwrap().asperity_height_std;
    assert!((table.standard_deviation() / std - 1.0).abs() < 1e-9);
    // The offset from the mean plane is that of the summits.
    let offset = summits.mean() - topography.mean();
    assert!(offset > 0.3 * std && (file.scene.mean_plane_offset() / offset - 1.0).abs() < 1e-9);
    let plain = read_with("").unwrap();
    let smooth = read_with("smooth = 12e-6\nperiodic = true").unwrap();
    let options = Statistics::clone(&plain.measured.as_ref().unwrap().statistics);
    assert!(smooth.scene.surface.asperity_radius > 1.05 * plain.scene.surface.asperity_radius);
    assert!((options.sq - topography.statistics(Estimator::Moments).unwrap().sq).abs() < 1e-20);
}

#[test]
fn unusual_scans_have_warnings() {
    let directory = directory("measured-check");
    std::fs::write(directory.join("a.txt"), scan(5.1)).unwrap();
    // Pits: most of the surface is flat.
    let pits = scan(5.1);
    let pits =
        pits.split_whitespace().map(|z| (-(0.002 * z.parse::<f64>().unwrap()).exp()).to_string());
    let rows: Vec<String> = pits.collect();
    let rows: String = rows.chunks(96).map(|row| row.join(" ") + "\n").collect();
    std::fs::write(directory.join("pits.txt"), rows).unwrap();
    let codes = |words: &str| {
        let file = scene(&directory, words).unwrap();
        file.findings().iter().map(|f| f.code).collect::<Vec<_>>()
    };
    assert!(codes("file = \"a.txt\"\nunit = \"nm\"\npixel_size = 1000").is_empty());
    // The pixels are in micrometres, the heights in nanometres.
    let steep = codes("file = \"a.txt\"\nunit = \"nm\"\npixel_size = 1");
    assert!(steep.contains(&Code::UnusualSize), "{steep:?}");
    let flat = codes("file = \"a.txt\"\nunit = \"nm\"\npixel_size = 1e7");
    assert!(flat.contains(&Code::UnusualSize), "{flat:?}");
    let pits = codes("file = \"pits.txt\"\nunit = \"nm\"\npixel_size = 1000");
    assert!(pits.contains(&Code::NotGaussian), "{pits:?}");
}

#[test]
fn outliers_are_the_first_warning_and_despike_replaces_them() {
    let directory = directory("measured-outliers");
    std::fs::write(directory.join("a.txt"), scan(5.1)).unwrap();
    let spiked: Vec<String> = scan(5.1).split_whitespace().map(Into::into).collect();
    let spiked: Vec<String> = spiked
        .into_iter()
        .enumerate()
        .map(|(k, z)| if k % 1537 == 700 { "9000".to_string() } else { z })
        .collect();
    let rows: String = spiked.chunks(96).map(|row| row.join(" ") + "\n").collect();
    std::fs::write(directory.join("spiked.txt"), rows).unwrap();
    let of = |name: &str, words: &str| {
        let words = format!("file = \"{name}\"\nunit = \"nm\"\npixel_size = 1000\n{words}");
        scene(&directory, &words).unwrap()
    };
    let (clean, spiked) = (of("a.txt", ""), of("spiked.txt", ""));
    let found = spiked.findings();
    assert_eq!(spiked.warnings.iter().next().unwrap().code.name(), "outliers");
    assert!(found.iter().all(|f| f.code.name() != "not-gaussian"), "{found:?}");
    let radius = |file: &asperity_scene::SceneFile| file.scene.surface.asperity_radius;
    assert!(radius(&spiked) < 0.5 * radius(&clean));
    let despiked = of("spiked.txt", "despike = true");
    assert!((radius(&despiked) / radius(&clean) - 1.0).abs() < 0.02);
    assert_eq!(despiked.measured.as_ref().unwrap().statistics.despiked, 6);
    // Smoothing spreads them, so they are looked for before.
    let smooth = of("spiked.txt", "smooth = 5e-6");
    assert_eq!(smooth.measured.as_ref().unwrap().statistics.outliers.count, 6);
}
