//! `generate`: random surfaces as files.

use asperity::bem::RandomSurface;
use asperity_topography::{ReadOptions, read};

use crate::bench::Bench;

const LINE: &str = "generate --hurst 0.7 --long 40um --roll-off 20um --short 2um --size 128x96 \
                    --pixel 0.5umx0.4um --sq 0.3um --anisotropy 2 --direction 30 --skewness -0.8 \
                    --seed 7 --output";

#[test]
fn both_files_hold_the_heights_of_the_library() {
    let bench = Bench::new();
    let npy = bench.run(&format!("{LINE} s.npy"));
    assert!(npy.code == Some(0) && npy.results().len() == 1, "{}", npy.messages);
    assert_eq!(bench.run(&format!("{LINE} s.x3p")).code, Some(0));
    let size = [128.0 * 0.5e-6, 96.0 * 0.4e-6];
    let surface = RandomSurface::of_wavelengths([40e-6, 20e-6, 2e-6], size).unwrap();
    let surface = surface.hurst(0.7).unwrap().rms_height(0.3e-6).unwrap().seed(7);
    let surface = surface.lay(2.0, 30.0).unwrap().skewness(-0.8).unwrap();
    let map = surface.map([96, 128]).unwrap();
    let pixel_size = Some([0.5e-6, 0.4e-6].map(Into::into));
    let unit = Some("m".parse().unwrap());
    let options = ReadOptions { unit, pixel_size, ..ReadOptions::default() };
    for (name, options) in [("s.npy", options), ("s.x3p", ReadOptions::default())] {
        let found = read(&bench.path(name), &options).unwrap();
        assert_eq!((found.rows(), found.columns()), (96, 128), "{name}");
        assert!((found.pixel_size()[1] / 0.4e-6 - 1.0).abs() < 1e-12, "{name}");
        let mean = found.mean();
        let square = found.heights().iter().map(|z| (z - mean).powi(2)).sum::<f64>();
        let sq = (square / 12288.0).sqrt();
        assert!((sq / 0.3e-6 - 1.0).abs() < 1e-9, "{name} {sq:e}");
        // Units of the command line are read to the last digit but one.
        let far = found.heights().iter().zip(map.heights()).map(|(a, b)| (a - b).abs());
        assert!(far.fold(0.0, f64::max) < 1e-12 * sq * 1e3, "{name}");
    }
    let report = bench.data("surface s.x3p --periodic --format json");
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let near = |key: &str, value: f64, within: f64| {
        let found = report[key].as_f64().unwrap();
        assert!((found - value).abs() < within, "{key} {found}");
    };
    near("ssk", -0.8, 0.002);
    near("slope_ratio", 2.0, 0.15);
    near("lay_direction", 30.0, 4.0);
    near("hurst_exponent", 0.7, 0.1);
    // Exact, where bins of a quarter of an octave alone would be up to 1.4 times as long.
    for short in [0.7, 1.0, 1.3, 2.0, 2.5] {
        let line = "generate --long 16um --size 256x256 --pixel 0.125um --sq 0.1um --output c.x3p";
        assert_eq!(bench.run(&format!("{line} --short {short}um")).code, Some(0));
        let report = bench.data("surface c.x3p --periodic --format json");
        let report: serde_json::Value = serde_json::from_str(&report).unwrap();
        let found = 1e6 * report["cut_off"].as_f64().unwrap();
        assert!((found / short - 1.0).abs() < 0.01, "{short} {found}");
    }
}
