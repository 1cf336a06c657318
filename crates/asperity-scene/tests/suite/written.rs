//! The template and written scenes read back.

use std::path::Path;

use asperity::{HeightDistribution, Interface, Scene, Surface, WeibullHeights};
use asperity_scene::{ModelOptions, SceneFile, parse, template, write};
use proptest::prelude::*;

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn the_template_is_read_without_a_word_and_says_the_defaults() {
    let file = read(template());
    assert!(file.warnings.is_empty());
    assert_eq!(file.options, ModelOptions::default());
    assert!(
        (file.scene.plasticity_index().unwrap() - 4.501).abs() < 1e-3,
        "{:?}",
        file.scene.plasticity_index()
    );
}

#[test]
fn every_alternative_of_the_template_is_read_when_it_is_chosen() {
    let lines: Vec<&str> = template().lines().collect();
    let block = |from: &str, to: &str| {
        let place = |mark: &str| lines.iter().position(|line| line.contains(mark)).unwrap();
        let chosen = lines[place(from)..place(to)].iter().map(|line| line.trim_start_matches("# "));
        chosen
            .filter(|line| line.contains(" = ") || line.starts_with('['))
            .map(|l| format!("{l}\n"))
            .collect::<String>()
    };
    let bodies = block("# The softer body", "# ... or, instead");
    let interface = block("# [interface]", "[surface]");
    let (index, moments) =
        (block("# plasticity_index", "# 3. spectral"), block("# m0 =", "# 4. parameters"));
    let iso = block("# sq =", "# 5. a measurement");
    let surface = block("asperity_radius", "# surface_height_std");
    let options = template().split_once("[options]").unwrap().1;
    let options = format!("[options]{options}");
    for (interface, surface) in [
        (&bodies, &surface),
        (&interface, &surface),
        (&bodies, &index),
        (&interface, &moments),
        (&bodies, &iso),
    ] {
        read(&format!("nominal_area = 1e-4\n{interface}[surface]\n{surface}{options}"));
    }
    // Bodies and interface are the same steel.
    let [a, b] = [&bodies, &interface]
        .map(|i| read(&format!("nominal_area = 1\n{i}[surface]\n{surface}")).scene.interface);
    assert!((a.equivalent_modulus / b.equivalent_modulus - 1.0).abs() < 0.01);
    let shear = |i: &Interface| i.equivalent_shear_modulus.unwrap();
    assert!((shear(&a) / shear(&b) - 1.0).abs() < 0.02);
}

#[test]
fn heights_and_comments_are_written() {
    let mut scene = read(template()).scene;
    scene.heights = HeightDistribution::Exponential;
    let text = write(&scene, &ModelOptions::default(), None, &["from scan.x3p,\nlevelled\r[x]"]);
    assert!(text.starts_with("# from scan.x3p,\n# levelled [x]\n"), "{text}");
    assert!(matches!(read(&text).scene.heights, HeightDistribution::Exponential));
    scene.heights = HeightDistribution::Weibull(WeibullHeights::new(-0.6).unwrap());
    let text = write(&scene, &ModelOptions::default(), None, &[]);
    let HeightDistribution::Weibull(heights) = read(&text).scene.heights else { panic!("{text}") };
    assert_eq!(heights.skewness().to_bits(), (-0.6f64).to_bits());
    let message = parse(&text.replace("-0.6", "-6.0"), Path::new(".")).unwrap_err().to_string();
    assert!(
        message.contains("surface.heights.skewness") && message.contains("-1 to 2"),
        "{message}"
    );
    let text = write(&scene, &ModelOptions::default(), Some("my \"pdf\".csv"), &[]);
    let message = parse(&text, Path::new(".")).unwrap_err().to_string();
    assert!(message.contains("pdf") && message.contains("cannot be read"), "{message}");
}

proptest! {
    #[test]
    fn any_scene_reads_back_to_the_last_digit(
        numbers in prop::array::uniform7(-12f64..12.0),
        nu in -0.99f64..0.5,
        given in prop::array::uniform3(any::<bool>()),
        cosine in any::<bool>(),
        zeta in 0f64..3.0,
    ) {
        let [e, g, h, y, r, eta, std] = numbers.map(|n| 10f64.powf(n) * 1.1);
        let mut interface = Interface::new(e, nu, h);
        interface.equivalent_shear_modulus = given[0].then_some(g);
        interface.yield_strength = given[1].then_some(y);
        interface.pressure_factor = given[2].then_some(0.577);
        let scene = Scene::new(interface, Surface::new(r, eta, std), e);
        let mut options = ModelOptions::default();
        if cosine {
            options.set("jg_hardness", &"cosine".into()).unwrap();
            options.set("displacement", &[("zeta", zeta), ("xi", 0.0)].into()).unwrap();
        }
        let file = read(&write(&scene, &options, None, &["any"]));
        prop_assert_eq!(file.scene.interface, scene.interface);
        prop_assert_eq!(file.scene.surface, scene.surface);
        prop_assert_eq!(file.scene.nominal_area.to_bits(), scene.nominal_area.to_bits());
        prop_assert_eq!(file.options, options);
    }
}
