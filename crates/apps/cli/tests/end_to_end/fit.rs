//! Numbers of a scene from measurements.

use crate::bench::{Bench, column};

#[cfg(unix)]
#[test]
fn an_interrupted_fit_keeps_the_models_that_are_done() {
    let bench = Bench::new();
    let grid = (0..20_000).map(|k| 1e5 * (1.0 + 1e-3 * f64::from(k)));
    let rows: String = grid.map(|p| format!("{p:e},{:e}\n", 5e2 * p)).collect();
    bench.write("data.csv", &format!("pressure_Pa,unloading_stiffness_N_per_m\n{rows}"));
    let arguments = "fit scene.toml data.csv --free asperity_height_std,hardness --model ke,jg";
    let run = bench.interrupted(arguments);
    assert_eq!(run.code, Some(130), "{}", run.messages);
    assert!(run.out.is_empty(), "{}", run.out);
}

/// Elastic data have a flat minimum at large hardnesses, beside one of yielding asperities.
#[test]
fn models_that_yield_find_the_elastic_law_within_them() {
    let bench = Bench::new();
    bench.write("elastic.toml", asperity_scene::template());
    let ask = "--model gw --pressure 1e5:3e7:8:log --quantity area,unloading-stiffness";
    bench.data(&format!("curve elastic.toml {ask} --output g.csv"));
    let start = asperity_scene::template()
        .replace("asperity_height_std = 1e-6", "asperity_height_std = 1.5e-6")
        .replace("hardness = 2e9", "hardness = 3e9");
    bench.write("start.toml", &start);
    let free = "asperity_height_std,hardness=1e8:5e11";
    let ask = format!("fit start.toml g.csv --free {free} --model ke --format csv");
    let found = bench.data(&ask);
    let of = |name: &str| column(&found, name);
    assert!((of("value")[0] / 1e-6 - 1.0).abs() < 1e-6, "{found}");
    assert!(of("rms").iter().all(|rms| *rms < 1e-6), "{found}");
}
