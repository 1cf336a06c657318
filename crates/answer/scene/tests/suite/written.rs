//! The template and written scenes read back.

use std::collections::BTreeMap;
use std::path::Path;

use asperity::{
    Datum, HeightDistribution, Interface, Scene, Surface, TabulatedHeights, WeibullHeights,
};
use asperity_scene::{HeightsSpec, ModelOptions, SceneError, SceneFile, load, parse, template};
use proptest::prelude::*;

use crate::two_surfaces::{HEAD, write_scan};

const OFFSET: &str = "asperity_height_std = 1e-6\nmean_plane_offset = \"2 um\"";

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Writes the scene and reads it again, unchanged.
fn again(file: &SceneFile) -> (String, SceneFile) {
    let text = file.to_toml().unwrap();
    let again = read(&text);
    assert_same(file, &again);
    assert_eq!(again.to_toml().unwrap(), text);
    (text, again)
}

fn assert_same(one: &SceneFile, other: &SceneFile) {
    assert_same_inputs(one, other);
    // Messages name the lines of a file.
    let findings = |file: &SceneFile| -> Vec<_> {
        let each = file.findings().into_iter();
        each.map(|f| (f.code, f.severity, f.field, f.value.to_bits(), f.usual)).collect()
    };
    assert_eq!(findings(one), findings(other));
}

fn assert_same_inputs(one: &SceneFile, other: &SceneFile) {
    assert_eq!(one.scene.interface, other.scene.interface);
    assert_eq!(one.scene.surface, other.scene.surface);
    let bits = |file: &SceneFile| {
        let offset = file.scene.mean_plane_offset.map(f64::to_bits);
        let points = file.table().map(|table| format!("{:?}", table.points()));
        let skewness = match &file.scene.heights {
            HeightDistribution::Weibull(heights) => Some(heights.skewness().to_bits()),
            _ => None,
        };
        let kind = std::mem::discriminant(&file.scene.heights);
        (file.scene.nominal_area.to_bits(), offset, points, skewness, kind)
    };
    assert_eq!(bits(one), bits(other));
    assert_eq!(one.spec.options, other.spec.options);
    assert_eq!(one.spec.separation_from, other.spec.separation_from);
    assert_eq!(one.bodies(), other.bodies());
}

#[test]
fn the_template_has_the_defaults_and_no_warning() {
    let file = read(template());
    assert!(file.warnings.is_empty());
    assert_eq!(file.spec.options, ModelOptions::default());
    assert!(
        (file.scene.plasticity_index().unwrap() - 4.501).abs() < 1e-3,
        "{:?}",
        file.scene.plasticity_index()
    );
}

#[test]
fn every_alternative_of_the_template_is_read_and_written() {
    let lines: Vec<&str> = template().lines().collect();
    let block = |from: &str, to: &str| {
        let place = |mark: &str| lines.iter().position(|line| line.contains(mark)).unwrap();
        let chosen = lines[place(from)..place(to)].iter().map(|line| line.trim_start_matches("# "));
        chosen
            .filter(|line| line.contains(" = ") || line.starts_with('['))
            .map(|l| format!("{l}\n"))
            .collect::<String>()
    };
    // A material stands instead of the numbers below it.
    let (material, bodies): (Vec<&str>, Vec<&str>) = lines
        [lines.iter().position(|line| line.starts_with("[[body]]")).unwrap()..]
        .iter()
        .map(|line| line.trim_start_matches("# "))
        .take_while(|line| !line.starts_with("... or, instead"))
        .filter(|line| line.contains(" = ") || line.starts_with('['))
        .partition(|line| line.starts_with("material"));
    let bodies = bodies.join("\n") + "\n";
    let material = format!("[[body]]\n{0}\n[[body]]\n{0}\n", material[0]);
    let interface = block("# [interface]", "[surface]");
    let (index, moments) =
        (block("# plasticity_index", "# 3. spectral"), block("# m0 =", "# 4. parameters"));
    let iso = block("# sq =", "# 5. roughness");
    let finish = block("# ra =", "# bandwidth =");
    let surface = block("asperity_radius", "# surface_height_std");
    let options = template().split_once("[options]").unwrap().1;
    let options = format!("[options]{options}");
    for (interface, surface, kept) in [
        (&bodies, &surface, "[[body]]"),
        (&material, &surface, "material = \"steel-100cr6\""),
        (&interface, &surface, "[interface]"),
        (&bodies, &index, "plasticity_index = 2e0"),
        (&interface, &moments, "m4 = 5e4"),
        (&bodies, &iso, "spc = 5e3"),
        (&bodies, &finish, "finish = \"ground\""),
    ] {
        let file = read(&format!("nominal_area = 1e-4\n{interface}[surface]\n{surface}{options}"));
        let (text, _) = again(&file);
        assert!(text.contains(kept), "{text}");
    }
    // Bodies and interface are the same steel.
    let [a, b] = [&bodies, &interface]
        .map(|i| read(&format!("nominal_area = 1\n{i}[surface]\n{surface}")).scene.interface);
    assert!((a.equivalent_modulus / b.equivalent_modulus - 1.0).abs() < 0.01);
    let shear = |i: &Interface| i.equivalent_shear_modulus.unwrap();
    assert!((shear(&a) / shear(&b) - 1.0).abs() < 0.02);
}

#[test]
fn every_key_of_the_top_and_of_the_surface_is_written_again() {
    let folder = tempfile::tempdir().unwrap();
    let wave = |k: usize| {
        let (x, y) = ((k % 48) as f64, (k / 48) as f64);
        1e-7 * ((0.9 * x).sin() + (0.7 * y + 1.0).cos() + (0.5 * x - 0.8 * y).sin())
    };
    let heights: Vec<f64> = (0..48 * 32).map(wave).collect();
    write_scan(&folder.path().join("scan.txt"), &heights, 48);
    let head = format!("work_of_adhesion = 0.05\n{HEAD}");
    let scan = "file = \"scan.txt\"\nunit = \"m\"\npixel_size = [1e-6, 1.5e-6]\n";
    let second = scan.trim_end().replace('\n', ", ");
    let two = format!("{scan}counterface = {{ {second} }}\n");
    let asperities = "asperity_radius = \"0.2 mm\"\nasperity_density = 2e8\n";
    for surface in [
        &format!("{scan}level = \"quadratic\"\nfilter = \"20 um\"\nsmooth = 4e-6"),
        &format!("{scan}max_missing = 0.2"),
        &format!("{scan}estimator = \"summits\"\nfill_missing = true\nheights = \"measured\""),
        &format!("{scan}periodic = true\nseparation_from = \"surface-mean\""),
        &two,
        &format!("{asperities}surface_height_std = 1.1e-6"),
        &format!("{asperities}asperity_height_std = 1e-6\nheights = \"exponential\""),
        &"surface_height_std = \"1 um\"\nmean_slope = 0.1\nasperity_density = 2e9".to_string(),
        &format!("{asperities}{OFFSET}\nseparation_from = \"surface-mean\""),
        &format!("{asperities}heights = {{ skewness = -0.3 }}\n{OFFSET}"),
        &format!(
            "{asperities}heights = {{ height_m = [0, 1e-6, 3e-6], density_per_m = [0, 1, 0] }}\nseparation_from = \"surface-mean\""
        ),
    ] {
        let file = parse(&format!("{head}{surface}\n"), folder.path()).unwrap();
        let (text, again) = again(&file);
        // Names of keys, independent of the values.
        let names = |text: &str| -> Vec<String> {
            let lines = text.lines().filter_map(|line| line.trim().split_once(" = "));
            let mut names: Vec<String> = lines.map(|(name, _)| name.to_string()).collect();
            names.sort();
            names
        };
        let (mut given, written) = (names(&format!("{head}{surface}")), names(&text));
        given.retain(|name| {
            written.contains(name) || !["heights", "counterface"].contains(&&**name)
        });
        for name in &given {
            assert!(written.contains(name), "{name} is lost\n{text}");
        }
        assert_eq!(
            again.scan().map(|s| s.heights().to_vec()),
            file.scan().map(|s| s.heights().to_vec())
        );
        let statistics =
            |file: &SceneFile| file.measured.as_ref().map(|m| format!("{:?}", m.statistics));
        assert_eq!(statistics(&file), statistics(&again));
    }
}

#[test]
fn heights_are_written() {
    let with = |heights: HeightDistribution| {
        let mut spec = read(template()).spec;
        spec.heights = heights.into();
        SceneFile::of_spec(spec).unwrap()
    };
    let file = with(HeightDistribution::Exponential);
    again(&file);
    again(&with(HeightDistribution::Weibull(WeibullHeights::new(-0.6).unwrap())));
}

#[test]
fn a_table_of_heights_is_in_the_text() {
    let folder = tempfile::tempdir().unwrap();
    let points: Vec<(f64, f64)> =
        (0..50).map(|k| (1e-6 * f64::from(k) / 7.0, (f64::from(k) / 3.0).sin().powi(2))).collect();
    let table = TabulatedHeights::new("own", &points).unwrap();
    let std = read(template()).inputs(["asperity_height_std"]).unwrap()[0];
    let file = read(template()).with_inputs([(std, table.standard_deviation())]).unwrap();
    let with = |heights: HeightsSpec| {
        let separation_from = Datum::SurfaceMean;
        let mut spec = file.spec.clone();
        (spec.heights, spec.separation_from) = (heights, separation_from);
        SceneFile::of_spec(spec).unwrap()
    };
    // Without its points the density cannot be written.
    let unwritable = |refused: SceneError| match refused {
        SceneError::Refused { at, .. } => at.field,
        other => panic!("{other}"),
    };
    let other = with(HeightDistribution::other(table.clone()).into());
    assert_eq!(unwritable(other.to_toml().unwrap_err()), "surface.heights");
    let file = with(HeightsSpec::of_table(table));
    again(&file);
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, file.to_toml().unwrap()).unwrap();
    assert_same(&file, &load(&path).unwrap());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_scene_reads_back_bit_for_bit(
        numbers in prop::array::uniform8(-12f64..12.0),
        nu in -0.99f64..0.5,
        given in prop::array::uniform5(any::<bool>()),
        vertical in any::<bool>(),
        zeta in 0f64..3.0,
    ) {
        let [e, g, h, y, r, eta, std, offset] = numbers.map(|n| 10f64.powf(n) * 1.1);
        let mut interface = Interface::new(e, nu, h);
        interface.equivalent_shear_modulus = given[0].then_some(g);
        interface.yield_strength = given[1].then_some(y);
        interface.pressure_factor = given[2].then_some(0.577);
        let mut scene = Scene::new(interface, Surface::new(r, eta, std), e);
        scene.mean_plane_offset = given[3].then_some(offset);
        let mut file = SceneFile::from(scene);
        if given[4] {
            file.spec.separation_from = Datum::SurfaceMean;
        }
        if vertical {
            file.spec.options.set("force", &"vertical".into()).unwrap();
            file.spec.options.set("displacement", &BTreeMap::from([("zeta", zeta), ("xi", 0.0)]).into()).unwrap();
        }
        again(&file);
    }
}
