//! Scans that are made and read again.

use crate::bench::Bench;

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

/// Where bins of a quarter of an octave alone would find up to 1.4 times as much.
#[test]
fn the_shortest_wave_of_a_made_surface_is_its_cut_off() {
    let bench = Bench::new();
    for short in [0.7, 1.0, 1.3, 2.0, 2.5] {
        let line = "generate --long 16um --size 256x256 --pixel 0.125um --sq 0.1um --output c.x3p";
        assert_eq!(bench.run(&format!("{line} --short {short}um")).code, Some(0));
        let report = bench.data("surface c.x3p --periodic --format json");
        let report: serde_json::Value = serde_json::from_str(&report).unwrap();
        let found = 1e6 * report["cut_off"].as_f64().unwrap();
        assert!((found / short - 1.0).abs() < 0.01, "{short} {found}");
    }
}
