//! Two rough surfaces in contact: numbers, scans, and one of each.

use std::path::Path;

use asperity::{ContactModel, ProfileMoments, Quantity, Request, Surface};
use asperity_scene::{SceneError, SceneFile, parse};

pub(crate) const HEAD: &str = "nominal_area = 1e-8\nrigid_counterface = true
[[body]]\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\nhardness = 2e9\n[surface]\n";

pub(crate) const READ: &str = "unit = \"m\"\npixel_size = 1e-6\nperiodic = true";

fn scene(folder: &Path, surface: &str) -> Result<SceneFile, SceneError> {
    parse(&format!("{HEAD}{surface}\n"), folder)
}

/// Two scans that are read alike, and more keys of both.
fn two_scans(more: &str) -> String {
    let second = format!("[surface.counterface]\nfile = \"b.txt\"\n{READ}");
    format!("file = \"a.txt\"\n{READ}\n{more}\n{second}")
}

fn numbers(surface: &str) -> SceneFile {
    scene(Path::new("."), surface).unwrap()
}

fn near(found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{found} is not {wanted}");
}

/// The asperities of an isotropic Gaussian surface, in closed form: η, R and σ_z.
fn asperities([m0, m2, m4]: [f64; 3]) -> [f64; 3] {
    let pi = std::f64::consts::PI;
    let alpha = m0 * m4 / (m2 * m2);
    let density = m4 / (6.0 * 3f64.sqrt() * pi * m2);
    // By the summits of an isotropic Gaussian surface.
    let loss = 1.0 - 3.0 * 3f64.sqrt() + 16.0 / pi;
    [density, 0.375 * (pi / m4).sqrt(), ((1.0 - loss / alpha) * m0).sqrt()]
}

fn is(surface: &Surface, wanted: [f64; 3]) {
    let Surface { asperity_density, asperity_radius, asperity_height_std, .. } = *surface;
    for (found, wanted) in
        [asperity_density, asperity_radius, asperity_height_std].into_iter().zip(wanted)
    {
        near(found, wanted, 1e-9);
    }
}

#[test]
fn moments_of_two_sets_add() {
    let file = numbers(
        "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\n[surface.counterface]\nm0 = 4e-13\nm2 = 2e-5\nm4 = 3e4",
    );
    is(&file.scene.surface, asperities([1.4e-12, 1.2e-4, 8e4]));
    assert!(file.warnings.is_empty(), "{:?}", file.warnings);
}

#[test]
fn iso_parameters_add_as_moments_of_gaussian_surfaces() {
    // 9 π Spc²/64 and m4/(6 √3 π Spd), as the note says.
    let pi = std::f64::consts::PI;
    let moments = |sq: f64, spd: f64, spc: f64| {
        let m4 = 9.0 * pi / 64.0 * spc * spc;
        [sq * sq, m4 / (6.0 * 3f64.sqrt() * pi * spd), m4]
    };
    let [a, b] = [moments(1.1e-6, 2e8, 5e3), moments(0.4e-6, 3e8, 4e3)];
    let keys = "sq = \"1.1 um\"\nspd = \"200 1/mm2\"\nspc = \"5 1/mm\"\n\
                counterface = { sq = \"0.4 um\", spd = 3e8, spc = 4e3 }";
    let file = numbers(keys);
    is(&file.scene.surface, asperities([a[0] + b[0], a[1] + b[1], a[2] + b[2]]));
    let mixed = numbers(&format!(
        "m0 = {:e}\nm2 = {:e}\nm4 = {:e}\n[surface.counterface]\nsq = 0.4e-6\nspd = 3e8\nspc = 4e3",
        a[0], a[1], a[2]
    ));
    is(&mixed.scene.surface, asperities([a[0] + b[0], a[1] + b[1], a[2] + b[2]]));
    // Asperities are those of an isotropic Gaussian surface, too.
    let own = Surface::new(2e-4, 2e8, 1e-6);
    let ProfileMoments { m0, m2, m4 } = own.moments();
    let twice = "asperity_radius = 2e-4\nasperity_density = 2e8\nasperity_height_std = 1e-6";
    let file = numbers(&format!("{twice}\n[surface.counterface]\n{twice}"));
    is(&file.scene.surface, asperities([2.0 * m0, 2.0 * m2, 2.0 * m4]));
}

#[test]
fn a_pair_is_written_and_read_again() {
    let file = numbers(
        "sq = \"1.1 um\"\nspd = 2e8\nspc = 5e3\n[surface.counterface]\nm0 = 4e-13\nm2 = 2e-5\nm4 = 3e4",
    );
    let text = file.to_toml().unwrap();
    assert!(text.contains("counterface = { m0 = 4e-13, m2 = 2e-5, m4 = 3e4 }"), "{text}");
    assert_eq!(parse(&text, Path::new(".")).unwrap().scene.surface, file.scene.surface);
}

/// Writes heights \[m\] as the text of a scan.
pub(crate) fn write_scan(path: &Path, heights: &[f64], columns: usize) {
    let row = |row: &[f64]| row.iter().map(f64::to_string).collect::<Vec<_>>().join(" ") + "\n";
    std::fs::write(path, heights.chunks(columns).map(row).collect::<String>()).unwrap();
}

/// Two independent Gaussian surfaces of 128 x 128 points, as files and as heights.
fn pair(folder: &Path) -> [Vec<f64>; 2] {
    [("a.txt", 3), ("b.txt", 4)].map(|(name, seed)| {
        let rough = asperity_bem::RandomSurface::new(2.0, 4.0, 24.0).unwrap();
        let rough = rough.side(128e-6).unwrap().gradient(0.05).unwrap().seed(seed);
        let heights = rough.heights(128).unwrap().heights().to_vec();
        write_scan(&folder.join(name), &heights, 128);
        heights
    })
}

#[test]
fn a_scan_and_a_set_add() {
    let folder = tempfile::tempdir().unwrap();
    pair(folder.path());
    let of = |more: &str| scene(folder.path(), &format!("file = \"a.txt\"\n{READ}\n{more}"));
    let alone = of("").unwrap();
    let set = "m0 = 1e-14\nm2 = 5e-4\nm4 = 1e9";
    let sum = of(&format!("[surface.counterface]\n{set}")).unwrap();
    let own = &alone.measured.as_ref().unwrap().statistics;
    let ProfileMoments { m0, m2, m4 } = own.moments.profile;
    let both = asperities([m0 + 1e-14, m2 + 5e-4, m4 + 1e9]);
    is(&sum.scene.surface, both);
    let of_sum = &sum.measured.as_ref().unwrap().statistics;
    near(
        of_sum.ssk * of_sum.moments.profile.m0.powf(1.5),
        own.ssk * own.moments.profile.m0.powf(1.5),
        1e-12,
    );
    let turned =
        scene(folder.path(), &format!("{set}\n[surface.counterface]\nfile = \"a.txt\"\n{READ}"));
    let turned = turned.unwrap();
    is(&turned.scene.surface, both);
    assert!(sum.bem().is_err());
    // The path of the second scan is absolute, so that the text is valid in any folder.
    let again = parse(&turned.to_toml().unwrap(), Path::new("/")).unwrap();
    assert_eq!(again.scene.surface, turned.scene.surface);
}

#[test]
fn two_scans_may_have_keys_of_their_own() {
    let folder = tempfile::tempdir().unwrap();
    let [_, b] = pair(folder.path());
    let nm: Vec<f64> = b.iter().map(|z| 1e9 * z).collect();
    write_scan(&folder.path().join("nm.txt"), &nm, 128);
    let files = scene(folder.path(), &two_scans("")).unwrap();
    let own = READ.replace("1e-6", "[\"1 um\", 1000]").replace("\"m\"", "\"nm\"");
    let counterface = format!("[surface.counterface]\nfile = \"nm.txt\"\n{own}");
    let text = format!("file = \"a.txt\"\n{READ}\n{counterface}");
    let keys = scene(folder.path(), &text).unwrap();
    let [a, b] = [&files, &keys].map(|file| file.scene.surface);
    is(&b, [a.asperity_density, a.asperity_radius, a.asperity_height_std]);
    // Between both, the asperities of each stand above its own mean plane.
    let alone = ["a.txt", "b.txt"].map(|name| {
        let one = scene(folder.path(), &format!("file = \"{name}\"\n{READ}")).unwrap().scene;
        [one.mean_plane_offset(), one.surface_height_std()]
    });
    let both = files.scene.both_surfaces();
    near(both.mean_plane_offset(), alone[0][0] + alone[1][0], 1e-12);
    near(both.surface_height_std(), alone[0][1].hypot(alone[1][1]), 1e-9);
}

#[test]
fn aligned_scans_add_point_by_point_and_their_moments_within_the_sampling_error() {
    let folder = tempfile::tempdir().unwrap();
    let [a, b] = pair(folder.path());
    let of = |more: &str| scene(folder.path(), &two_scans(more)).unwrap();
    let (independent, aligned) = (of(""), of("aligned = true"));
    let scan = aligned.scan().unwrap();
    let mean = a.iter().chain(&b).sum::<f64>() / a.len() as f64;
    for (k, z) in scan.heights().iter().enumerate() {
        assert!((z - (a[k] + b[k] - mean)).abs() < 1e-18, "{k}");
    }
    let statistics = |file: &SceneFile| file.measured.clone().unwrap().statistics.clone();
    let (sum, both) = (statistics(&independent), statistics(&aligned));
    // 128² points with 24 points in the longest wave: some tens of independent ones.
    near(both.moments.profile.m0, sum.moments.profile.m0, 0.15);
    near(both.moments.profile.m2, sum.moments.profile.m2, 0.05);
    // A share of m4 is of products of both directions, as few independent ones again.
    near(both.moments.profile.m4, sum.moments.profile.m4, 0.05);
    assert!((both.moments.profile.m0 / sum.moments.profile.m0 - 1.0).abs() > 1e-6);
    assert!(independent.scan().is_none());
    let again = parse(&aligned.to_toml().unwrap(), Path::new("/")).unwrap();
    assert_eq!(again.scan().unwrap().heights(), scan.heights());
    let request = Request::new([Quantity::Area]).at([asperity::At::Pressure(1e8)]);
    let bem = aligned.model("bem").unwrap().solve(&aligned.scene, &request).unwrap();
    assert!(bem.values(Quantity::Area).unwrap()[0] > 0.0);
    let mirrored = of("aligned = \"mirrored\"");
    let mirrored = mirrored.scan().unwrap();
    for (k, z) in mirrored.heights().iter().enumerate() {
        let turned = k / 128 * 128 + 127 - k % 128;
        assert!((z - (a[k] + b[turned] - mean)).abs() < 1e-18, "{k}");
    }
    // Summits are found on the sum.
    assert!(
        of("aligned = true\nestimator = \"summits\"\nheights = \"measured\"").table().is_some()
    );
}

#[test]
fn findings_of_the_only_scan_are_at_that_scan() {
    let folder = tempfile::tempdir().unwrap();
    let rough = asperity_bem::RandomSurface::new(2.0, 4.0, 24.0).unwrap();
    let ground = rough.side(128e-6).unwrap().gradient(0.05).unwrap().lay(5.0, 0.0).unwrap();
    let heights = ground.heights(128).unwrap().heights().to_vec();
    write_scan(&folder.path().join("lay.txt"), &heights, 128);
    let numbers = "m0 = 1e-16\nm2 = 1e-6\nm4 = 1e5\n";
    let scan = format!("file = \"lay.txt\"\n{READ}\n");
    for (surface, place) in [
        (format!("{scan}[surface.counterface]\n{numbers}"), "line 8: surface.file: "),
        (format!("{numbers}[surface.counterface]\n{scan}"), "line 12: surface.counterface.file: "),
    ] {
        let file = scene(folder.path(), &surface).unwrap();
        let lay = file.warnings.iter().find(|found| found.code.name() == "anisotropic").unwrap();
        assert!(lay.to_string().starts_with(place), "{lay}");
    }
}

#[test]
fn a_counterface_of_nothing_keeps_the_hurst_exponent_of_the_scan() {
    let folder = tempfile::tempdir().unwrap();
    let rough = asperity_bem::RandomSurface::of_wavelengths([128e-6, 128e-6, 4e-6], [256e-6; 2]);
    let rough = rough.unwrap().hurst(0.3).unwrap().gradient(0.02).unwrap().seed(3);
    let heights = rough.heights(256).unwrap().heights().to_vec();
    write_scan(&folder.path().join("rough.txt"), &heights, 256);
    let hurst = |more: &str| {
        let file = scene(folder.path(), &format!("file = \"rough.txt\"\n{READ}\n{more}")).unwrap();
        file.surface_shape().unwrap().unwrap().hurst
    };
    let alone = hurst("").unwrap();
    assert!((alone - 0.3).abs() < 0.1, "{alone}");
    let beside =
        |m4: f64| hurst(&format!("counterface = {{ m0 = 1e-18, m2 = 1e-10, m4 = {m4:e} }}"));
    assert_eq!(beside(1.0), Some(alone));
    // Of a rougher counterface, the spectrum is unknown.
    let rougher = hurst("counterface = { m0 = 1e-12, m2 = 1e-2, m4 = 1e13 }");
    assert_eq!(rougher, None);
    let given = "counterface = { m0 = 1e-18, m2 = 1e-10, m4 = 1 }\n[options]\nhurst_exponent = 0.4";
    // The option is of models; the scan has its own.
    assert_eq!(hurst(given), Some(alone));
}
