//! `bem`: edges of scans that match or do not, and waves in closed form.

use crate::bench::Bench;

/// A scan of 64 x 64 points on a side of 1 m, in a scene of E = 1e9 Pa.
fn square_metre(bench: &Bench, height: impl Fn(usize, usize) -> f64) {
    let row = |y| (0..64).map(|x| height(x, y).to_string()).collect::<Vec<_>>().join(" ");
    let rows: Vec<String> = (0..64).map(row).collect();
    bench.write("line.txt", &rows.join("\n"));
    let scene = "nominal_area = 1\n[interface]\nequivalent_modulus = 1e9\npoissons_ratio = 0.3\n\
                 [surface]\nfile = \"line.txt\"\nunit = \"m\"\npixel_size = 0.015625\n";
    bench.write("bare.toml", scene);
    bench.write("declared.toml", &format!("{scene}periodic = true\n"));
}

#[test]
fn an_option_beats_the_scene_and_the_scene_beats_the_default() {
    let bench = Bench::new();
    // tests/reference/bem_steps.csv.
    square_metre(&bench, |x, _| 0.01 * f64::from(u8::from(x < 32)));
    let solved = |arguments: &str| {
        let run = bench.run(&format!("bem {arguments} --pressure 5e6 --format json"));
        assert_eq!(run.code, Some(0), "{}", run.messages);
        let rows: serde_json::Value = serde_json::from_str(&run.out).unwrap();
        let row = &rows[0];
        let boundary = row["boundary"].as_str().unwrap().to_string();
        (boundary, row["area_fraction_pixels"].as_f64().unwrap(), run.messages)
    };
    for arguments in ["declared.toml", "bare.toml --boundary periodic"] {
        let (boundary, contact, _) = solved(arguments);
        assert_eq!((boundary.as_str(), contact), ("periodic", 0.5), "{arguments}");
    }
    for arguments in ["bare.toml", "bare.toml --boundary periodic-part"] {
        let (boundary, _, messages) = solved(arguments);
        assert_eq!(boundary, "periodic-part", "{arguments}");
        let asked = arguments.contains("--boundary");
        assert_eq!(messages.matches("[periodic-part]").count(), usize::from(!asked), "{messages}");
    }
    assert_eq!(solved("declared.toml --boundary periodic-part").0, "periodic-part");
    let (boundary, _, messages) = solved("declared.toml --boundary free");
    assert!(boundary == "free" && !messages.contains("periodic component"), "{messages}");
}

#[test]
fn a_wave_is_solved_although_it_has_no_asperities() {
    let bench = Bench::new();
    let turn = std::f64::consts::TAU / 64.0;
    // No Gaussian surface has the bandwidth of one wave along a diagonal.
    square_metre(&bench, |x, y| 1e-3 * (turn * (x + y) as f64).cos());
    let wave = bench.run("bem declared.toml --pressure 1e5 --format json");
    assert_eq!(wave.code, Some(0), "{}", wave.messages);
    for about_asperities in ["error:", "asperity_", "no asperities", "heights = "] {
        assert!(!wave.messages.contains(about_asperities), "{}", wave.messages);
    }
    let rows: serde_json::Value = serde_json::from_str(&wave.out).unwrap();
    // Westergaard: the contact of half-width a has sin²(π a/L) = p/(π E h/L), L = 1/√2 m.
    let full = std::f64::consts::PI * 1e9 * 1e-3 * std::f64::consts::SQRT_2;
    let share = (1e5 / full).sqrt().asin() / std::f64::consts::FRAC_PI_2;
    let found = rows[0]["area_fraction_pixels"].as_f64().unwrap();
    assert!((found - share).abs() < 1.5 / 64.0, "{found} {share}");
    let refused = bench.run("curve declared.toml --model gw --load 1");
    assert!(
        refused.code == Some(1) && refused.messages.contains("bandwidth"),
        "{}",
        refused.messages
    );
    let surface = bench.run("surface line.txt --unit m --pixel-size 0.015625 --periodic");
    assert_eq!(surface.code, Some(0), "{}", surface.messages);
    assert!(surface.messages.contains("[no-asperities]"), "{}", surface.messages);
    let kurtosis = surface.out.lines().find(|line| line.starts_with("sku ")).unwrap();
    assert!(kurtosis.split_whitespace().nth(1) == Some("1.5"), "{kurtosis}");
    // Models without asperities, and the comparison with them, need none either.
    for line in ["curve declared.toml --model bem,persson", "bem --compare declared.toml"] {
        let run = bench.run(&format!("{line} --pressure 1e5 --format csv"));
        assert_eq!(run.code, Some(0), "{line}: {}", run.messages);
        let ids = crate::bench::cells(&run.out, "model");
        assert!(ids.contains(&"bem") && ids.contains(&"persson"), "{line}: {ids:?}");
        assert!(!ids.contains(&"gw"), "{line}: {ids:?}");
    }
    let truth = bench.run("bem --compare declared.toml --pressure 1e5").messages;
    let line = truth.lines().find(|line| line.starts_with("note[left-out]"));
    assert!(line.is_some_and(|line| line.contains("bandwidth")), "{truth}");
    let made = "surface line.txt --unit m --pixel-size 0.015625 --periodic --scene made.toml";
    assert_eq!(bench.run(made).code, Some(0));
    assert_eq!(bench.run("bem made.toml --pressure 1e5").code, Some(0));
}
