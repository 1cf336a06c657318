//! `surface`: scans become numbers, and scenes that run.

use asperity_topography::{Estimator, Glance, Level, ReadOptions, read};

use crate::bench::{Bench, column};

/// A rough surface of waves in all directions, in um, as text without a head.
pub fn scan(seed: f64) -> String {
    let n = 96;
    let mut text = String::new();
    for row in 0..n {
        let heights = (0..n).map(|column| {
            let height: f64 = (1..40)
                .map(|k| {
                    let k = f64::from(k) + seed;
                    // Directions and phases that never come back.
                    let (angle, phase) = (2.399_963 * k, 7.1 * k * k);
                    let wave = 0.035 * (k + 6.0);
                    let (x, y) = (f64::from(column) * angle.cos(), f64::from(row) * angle.sin());
                    (wave * (x + y) + phase).cos() / (1.0 + 0.1 * k)
                })
                .sum();
            format!("{:.5}", 0.3 * height)
        });
        text.push_str(&heights.collect::<Vec<_>>().join(" "));
        text.push('\n');
    }
    text
}

const KEYS: [&str; 15] = [
    "sq",
    "ssk",
    "sku",
    "m0",
    "m2",
    "m4",
    "alpha",
    "asperity_density",
    "asperity_radius",
    "asperity_height_std",
    "beta",
    "beta_z",
    "missing_share",
    "despiked",
    "outliers",
];

pub fn json(bench: &Bench, arguments: &str) -> serde_json::Value {
    serde_json::from_str(&bench.data(&format!("surface {arguments} --format json"))).unwrap()
}

#[test]
fn only_the_mean_of_a_periodic_scan_is_removed() {
    let bench = Bench::new();
    let turn = std::f64::consts::TAU / 64.0;
    let height = |x: f64, y: f64| (3.0 * turn * x).sin() + (2.0 * turn * y + turn * x).sin();
    let row = |y| (0..64).map(|x| format!("{:.6}", height(f64::from(x), y))).collect::<Vec<_>>();
    let rows: Vec<String> = (0..64).map(|y| row(f64::from(y)).join(" ")).collect();
    bench.write("waves.txt", &rows.join("\n"));
    let arguments = "waves.txt --unit um --pixel-size 5 --periodic";
    let [usual, mean, plane] = ["", " --level mean", " --level plane"]
        .map(|level| json(&bench, &format!("{arguments}{level}"))["m4"].as_f64().unwrap());
    assert!((usual / mean - 1.0).abs() < 1e-15, "{usual} {mean}");
    assert!(plane > 1.1 * usual, "{plane} {usual}");
    let tilted = bench.run(&format!("surface {arguments} --level plane"));
    assert!(tilted.messages.contains("[level]"), "{}", tilted.messages);
    assert!(!bench.run(&format!("surface {arguments}")).messages.contains("level"));
    bench.data(&format!("surface {arguments} --scene waves.toml"));
    assert!(bench.read("waves.toml").contains("\nperiodic = true "));
    assert!(!tilted.messages.contains("do not match") || plane > usual, "{}", tilted.messages);
    // A part of it is not periodic.
    let part: Vec<&str> = rows.iter().take(37).map(String::as_str).collect();
    bench.write("part.txt", &part.join("\n"));
    let open = bench.run("surface part.txt --unit um --pixel-size 5 --periodic").messages;
    assert!(open.contains("[open-seam]"), "{open}");
    assert!(!bench.run(&format!("surface {arguments}")).messages.contains("do not match"));
}

#[test]
fn a_scan_instead_of_a_scene_is_recognised() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    std::fs::write(bench.path("scan.x3p"), [0x50, 0x4b, 3, 4, 0xff, 0xfe]).unwrap();
    for name in ["scan.txt", "scan.x3p"] {
        let run = bench.run(&format!("curve {name} --load 1"));
        let way = format!("asperity surface {name}");
        assert!(run.code == Some(1) && run.messages.contains(&way), "{}", run.messages);
    }
    let missing = bench.run("curve nowhere.txt --load 1").messages;
    assert!(!missing.contains("is a scan"), "{missing}");
}

#[test]
fn the_numbers_agree_with_the_library() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    let text = bench.data(
        "surface scan.txt --unit um --pixel-size 0.5 --level quadratic --estimator summits --format json",
    );
    let places: Vec<usize> =
        KEYS.iter().map(|key| text.find(&format!("\"{key}\"")).expect(key)).collect();
    assert!(places.is_sorted(), "{text}");
    let options = ReadOptions {
        unit: Some("um".parse().unwrap()),
        pixel_size: Some([0.5.into(); 2]),
        ..ReadOptions::default()
    };
    let surface = read(&bench.path("scan.txt"), &options).unwrap();
    let found = surface.level(Level::Quadratic).unwrap().statistics(Estimator::Summits).unwrap();
    let printed: serde_json::Value = serde_json::from_str(&text).unwrap();
    let options = ReadOptions { unit: Some("um".parse().unwrap()), ..options };
    let raw = read(&bench.path("scan.txt"), &options).unwrap();
    let level = raw.clone().level(Level::Quadratic).unwrap();
    let glance = Glance::new(&raw, Level::Quadratic, [None; 2], &level).unwrap();
    let glance = serde_json::to_value(glance).unwrap();
    for (key, value) in glance.as_object().unwrap() {
        assert_eq!(&printed[key], value, "{key}");
    }
    let keys = printed.as_object().unwrap().len();
    assert_eq!(keys, KEYS.len() + glance.as_object().unwrap().len());
    assert_eq!(printed["sq"].as_f64(), Some(found.sq));
    assert_eq!(printed["asperity_density"].as_f64(), found.asperity_density);
    assert_eq!(printed["beta_z"].as_f64(), found.beta_z);
}

#[test]
fn units_and_pixels_scale_as_lengths_do() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    let um = json(&bench, "scan.txt --unit um --pixel-size 0.5");
    let nm = json(&bench, "scan.txt --unit nm --pixel-size 0.5x0.5");
    let stated = json(&bench, "scan.txt --unit um --pixel-size 500nmx5e-7m");
    let ratio = stated["m4"].as_f64().unwrap() / um["m4"].as_f64().unwrap();
    assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
    for (key, power) in [("sq", 1), ("m0", 2), ("m2", 0), ("m4", -2), ("asperity_radius", 1)] {
        let ratio = um[key].as_f64().unwrap() / nm[key].as_f64().unwrap();
        assert!((ratio / 1e3f64.powi(power) - 1.0).abs() < 1e-9, "{key}: {ratio}");
    }
    let filtered = json(&bench, "scan.txt --unit um --pixel-size 0.5 --filter 1e-5");
    assert!(filtered["sq"].as_f64() < um["sq"].as_f64());
}

#[test]
fn a_scene_made_of_a_scan_runs_and_is_not_written_over() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    let arguments = "surface scan.txt --unit um --pixel-size 0.5 --scene made.toml";
    let run = bench.run(arguments);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("[example-values]"), "{}", run.messages);
    let statistics = json(&bench, "scan.txt --unit um --pixel-size 0.5");
    let surface = bench.scene("made.toml").scene.surface;
    assert_eq!(statistics["asperity_height_std"].as_f64(), Some(surface.asperity_height_std));
    assert_eq!(
        column(&bench.data("curve made.toml --model ke --separation 1"), "force_N").len(),
        1
    );
    let again = bench.run(arguments);
    assert_eq!((again.code, again.out.as_str()), (Some(1), ""));
    assert!(again.messages.contains("made.toml exists"), "{}", again.messages);
    // It names the scan, so that what needs all of it can be asked, from any folder.
    std::fs::create_dir(bench.path("below")).unwrap();
    bench.data("surface scan.txt --unit um --pixel-size 0.5 --smooth 4e-6 --level quadratic --estimator summits --scene below/made.toml");
    let bem = bench.data("bem below/made.toml --pressure 1e8 --format csv");
    assert!(column(&bem, "area_fraction")[0] > 0.0, "{bem}");
    let both =
        "surface scan.txt scan.txt --unit um --pixel-size 0.5x0.6 --periodic --scene two.toml";
    let sum: serde_json::Value =
        serde_json::from_str(&bench.data(&format!("{both} --format json"))).unwrap();
    let surface = bench.scene("two.toml").scene.surface;
    assert_eq!(sum["asperity_radius"].as_f64(), Some(surface.asperity_radius));
}
