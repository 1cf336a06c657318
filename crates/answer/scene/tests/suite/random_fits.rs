//! Fits of models that compile tables for each scene.

use std::ops::ControlFlow;
use std::path::Path;

use asperity::fit::Fitted;
use asperity::{ContactModel, Quantity, Request};
use asperity_scene::{SceneFile, parse, read_measurements};

const TRUTH: [(&str, f64); 3] =
    [("asperity_radius", 2e-5), ("asperity_height_std", 5e-7), ("hardness", 3e9)];

fn scene(factors: [f64; 3]) -> SceneFile {
    let [radius, std, hardness] = [0, 1, 2].map(|k| TRUTH[k].1 * factors[k]);
    let text = format!(
        "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 1.15e11\npoissons_ratio = 0.3\n\
         hardness = {hardness:e}\n[surface]\nasperity_radius = {radius:e}\n\
         asperity_density = 5e9\nasperity_height_std = {std:e}\n"
    );
    parse(&text, Path::new(".")).unwrap()
}

/// Areas and tangents of a model at loads, each times `1 + scatter` for its row, fitted.
fn fitted(id: &str, pressures: &[f64], scatter: impl Fn(usize) -> f64) -> Fitted {
    let truth = scene([1.0; 3]);
    let model = truth.model(id).unwrap();
    let loads = pressures.iter().map(|pressure| 1e-4 * pressure);
    let quantities = [Quantity::Area, Quantity::Tangent];
    let request = Request::new(quantities).at_loads(loads.clone());
    let answer = model.solve(&truth.scene, &request).unwrap();
    let [area, tangent] = quantities.map(|quantity| answer.values(quantity).unwrap());
    let mut rows = "load_N,area_m2,tangent_N_per_m\n".to_string();
    for (k, load) in loads.enumerate() {
        let [area, tangent] = [area[k], tangent[k]].map(|value| value * (1.0 + scatter(k)));
        rows += &format!("{load:e},{area:e},{tangent:e}\n");
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("data.csv");
    std::fs::write(&path, rows).unwrap();
    let data = truth.data(&read_measurements(path).unwrap()).unwrap();
    let free = [TRUTH[1].0.parse().unwrap()];
    scene([1.0, 0.8, 1.0]).fit(&model, &data, &free, &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The accuracy of a fit, and its interval, by derivatives from scenes two per cent apart.
#[test]
fn a_scatter_of_the_data_moves_the_minimum_and_widens_the_interval_as_it_should() {
    let pressures = [1e5, 5e5, 3e6, 2e7];
    let scatter = |k: usize| [0.02, -0.015, 0.01, -0.02][k];
    let found = fitted("gw-random", &pressures, scatter);
    let one = &found.parameters[0];
    assert!(
        found.converged && found.findings.iter().all(|one| one.code.name() != "undetermined"),
        "{found:?}"
    );
    let values = |factor: f64| {
        let file = scene([1.0, factor * one.value / TRUTH[1].1, 1.0]);
        let quantities = [Quantity::Area, Quantity::Tangent];
        let loads = pressures.map(|pressure| 1e-4 * pressure);
        let request = Request::new(quantities).at_loads(loads);
        let answer = file.model("gw-random").unwrap().solve(&file.scene, &request).unwrap();
        let [area, tangent] = quantities.map(|quantity| answer.values(quantity).unwrap());
        (0..loads.len()).flat_map(|k| [area[k].ln(), tangent[k].ln()]).collect::<Vec<f64>>()
    };
    let [below, above] = [-0.01f64, 0.01].map(|step| values(step.exp()));
    let slopes: Vec<f64> = below.iter().zip(&above).map(|(a, b)| (b - a) / 0.02).collect();
    let residuals: Vec<f64> = found.residuals.iter().map(|one| one.residual).collect();
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let curvature = sum(&slopes, &slopes);
    // What a step of Gauss and Newton would still change.
    let rest = sum(&residuals, &slopes) / curvature;
    assert!(rest.abs() < 1e-6, "{rest:e}");
    // Student's t of seven degrees of freedom.
    let half = 2.364_624_25 * (sum(&residuals, &residuals) / 7.0 / curvature).sqrt();
    let [lower, upper] = [one.lower, one.upper].map(|end| (end.unwrap() / one.value).ln());
    assert!((upper / half - 1.0).abs() < 0.05 && (lower / -half - 1.0).abs() < 0.05, "{one:?}");
    assert!(found.evaluations < 60, "{}", found.evaluations);
}
