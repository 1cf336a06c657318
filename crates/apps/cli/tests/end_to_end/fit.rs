//! Numbers of a scene from measurements.

use serde_json::Value;

use crate::bench::{Bench, cells, column, column_of};

/// Areas and stiffnesses of KE on the scene with other numbers, as `curve` writes them.
fn measured(bench: &Bench, change: (&str, &str), quantities: &str) -> String {
    let scene = asperity_scene::template().replace(change.0, change.1);
    bench.write("truth.toml", &scene);
    bench.data(&format!(
        "curve truth.toml --model ke --pressure 1e5:3e7:8:log --quantity {quantities} --tolerance 1e-13"
    ))
}

const STD: (&str, &str) = ("asperity_height_std = 1e-6", "asperity_height_std = 1.7e-6");

#[test]
fn a_curve_of_the_program_returns_its_scene() {
    let bench = Bench::new();
    let data = measured(&bench, STD, "area,unloading-stiffness");
    bench.write("data.csv", &data);
    let arguments =
        "fit scene.toml data.csv --free asperity_height_std=0.1um:10um,hardness --model gw,ke";
    let run = bench.run(&format!("{arguments} --format csv"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["ke", "ke", "gw", "gw"]);
    assert_eq!(cells(&run.out, "unit")[..2], ["m", "Pa"]);
    for (found, truth) in column(&run.out, "value").iter().zip([1.7e-6, 2e9]) {
        assert!((found / truth - 1.0).abs() < 1e-8, "{}", run.out);
    }
    assert!(run.messages.contains("warning[undetermined]: gw: hardness"), "{}", run.messages);
    let found: Value =
        serde_json::from_str(&bench.data(&format!("{arguments} --format json"))).unwrap();
    let ke = &found[0];
    assert_eq!((ke["model"].as_str(), ke["converged"].as_bool()), (Some("ke"), Some(true)));
    assert!(ke["rms"].as_f64().unwrap() < 1e-9 && ke["condition"].as_f64().unwrap() >= 1.0);
    // The separations of the table are compared by the pressures there.
    assert_eq!(ke["residuals"].as_array().unwrap().len(), 24);
    assert_eq!(ke["correlation"][0][0].as_f64(), Some(1.0));
    assert!(ke["parameters"][1]["lower"].as_f64() < ke["parameters"][1]["upper"].as_f64());
    let codes: Vec<_> = ke["findings"].as_array().unwrap().iter().map(|one| &one["code"]).collect();
    assert_eq!(codes, ["few-contacts"]);
    assert_eq!(found[1]["condition"], Value::Null);
    assert_eq!(found[1]["findings"][0]["field"], "hardness");
}

#[test]
fn one_target_answers_the_inverse_question() {
    let bench = Bench::new();
    let ask = |value: &str| {
        let target = format!("--target area_fraction={value} --pressure 5MPa --format csv");
        bench.run(&format!("fit scene.toml --free asperity_height_std {target}"))
    };
    let run = ask("0.4%");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let height_std = column(&run.out, "value")[0];
    assert_eq!(column_of(&run.out, "lower"), [None]);
    let scene = asperity_scene::template();
    let new = format!("asperity_height_std = {height_std:e}");
    bench.write("smooth.toml", &scene.replace("asperity_height_std = 1e-6", &new));
    let check = "curve smooth.toml --model ke --pressure 5MPa --quantity area-fraction";
    let found = column(&bench.data(check), "area_fraction")[0];
    assert!((found / 0.004 - 1.0).abs() < 1e-8, "{found}");
    // Contacts of ke carry at most the hardness.
    let run = ask("0.1%");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("warning[limits]: ke: asperity_height_std"), "{}", run.messages);
    assert!(column(&run.out, "rms")[0] > 0.1, "{}", run.out);
}

#[test]
fn a_rig_is_fitted_and_the_picture_has_data_and_models() {
    let bench = Bench::new();
    let data = measured(&bench, STD, "unloading-stiffness");
    let (pressures, clean) =
        (column(&data, "pressure_Pa"), column(&data, "unloading_stiffness_N_per_m"));
    let mut rows =
        String::from("pressure_Pa,unloading_stiffness_N_per_m,unloading_stiffness_N_per_m_std\n");
    for (pressure, stiffness) in pressures.iter().zip(&clean) {
        let softer = 1.0 / (1.0 / stiffness + 2e-11);
        rows += &format!("{pressure:e},{softer:e},{:e}\n", 0.02 * softer);
    }
    bench.write("data.csv", &rows);
    let run = bench.run(
        "fit scene.toml data.csv --free asperity_height_std,series_compliance=1pm/N:1um/N --plot fit.svg",
    );
    assert_eq!(run.code, Some(2), "{}", run.messages);
    let run = bench.run(
        "fit scene.toml data.csv --free asperity_height_std,series_compliance --plot fit.svg --format csv",
    );
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let found = column(&run.out, "value");
    assert!((found[0] / 1.7e-6 - 1.0).abs() < 1e-7, "{found:?}");
    assert!((found[1] / 2e-11 - 1.0).abs() < 1e-7, "{found:?}");
    // Separations under pressures: c F with F = p A_n.
    let data = measured(&bench, STD, "area");
    let places = column(&data, "pressure_Pa").into_iter().zip(column(&data, "separation_m"));
    let rows = places.map(|(p, d)| format!("{p:e},{:e}\n", d - 5e-11 * p * 1e-4));
    bench.write(
        "data.csv",
        &(String::from("pressure_Pa,separation_m\n") + &rows.collect::<String>()),
    );
    let free = "--free asperity_height_std,series_compliance --format csv";
    let found = column(&bench.data(&format!("fit scene.toml data.csv --model ke {free}")), "value");
    assert!((found[0] / 1.7e-6 - 1.0).abs() < 1e-6, "{found:?}");
    assert!((found[1] / 5e-11 - 1.0).abs() < 1e-4, "{found:?}");
    let svg = bench.read("fit.svg");
    for text in ["measured", "pressure (Pa)", "unloading stiffness (N/m)"] {
        assert!(svg.contains(text), "{text}");
    }
}

/// Stiffnesses of KE on the template against the pressure.
pub fn stiffness_rows(bench: &Bench) -> Vec<[f64; 2]> {
    let data = bench.data(
        "curve scene.toml --model ke --pressure 1e5:1e7:6:log --quantity unloading-stiffness",
    );
    let stiffness = column(&data, "unloading_stiffness_N_per_m");
    column(&data, "pressure_Pa").into_iter().zip(stiffness).map(|(p, k)| [p, k]).collect()
}

pub fn write_rows(bench: &Bench, rows: impl IntoIterator<Item = [f64; 2]>) {
    let rows: String = rows.into_iter().map(|[p, k]| format!("{p:e},{k:e}\n")).collect();
    bench.write("data.csv", &format!("pressure_Pa,unloading_stiffness_N_per_m\n{rows}"));
}

#[test]
fn a_hardness_starts_from_the_yield_strength() {
    let bench = Bench::new();
    write_rows(&bench, stiffness_rows(&bench));
    let scene = asperity_scene::template().replace("hardness = 2e9 ", "yield_strength = 7e8 ");
    bench.write("scene.toml", &scene.replace("hardness = 2e9\n", "yield_strength = 7e8\n"));
    // The middle of 3.3 to 7.8 times the yield strength.
    let middle = 7e8 * (3.3f64 * 7.8).sqrt();
    for free in ["hardness", "body1_hardness"] {
        let found = bench.data(&format!("fit scene.toml data.csv --free {free} --format json"));
        let found: Value = serde_json::from_str(&found).unwrap();
        let bounds = &found[0]["parameters"][0]["bounds"];
        for (k, wanted) in [middle / 30.0, middle * 30.0].iter().enumerate() {
            assert!((bounds[k].as_f64().unwrap() / wanted - 1.0).abs() < 1e-9, "{bounds}");
        }
    }
}

#[test]
fn a_spreadsheet_with_decimal_commas_gives_the_same() {
    let bench = Bench::new();
    let rows = stiffness_rows(&bench);
    write_rows(&bench, rows.iter().copied());
    let fit = "fit scene.toml data.csv --free asperity_height_std --format csv";
    let wanted = bench.data(fit);
    let text = bench.read("data.csv").replace(',', ";").replace('.', ",");
    bench.write("data.csv", &text);
    assert_eq!(bench.data(fit), wanted);
}

#[cfg(unix)]
#[test]
fn an_interrupted_fit_keeps_the_models_that_are_done() {
    let bench = Bench::new();
    let grid = (0..20_000).map(|k| 1e5 * (1.0 + 1e-3 * f64::from(k)));
    write_rows(&bench, grid.map(|pressure| [pressure, 5e2 * pressure]));
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

/// A closure is a separation with the other sign and an unknown offset.
#[test]
fn closures_are_fitted_without_an_offset_of_ones_own() {
    let bench = Bench::new();
    let curve = bench.data("curve scene.toml --model gw --load 1:100:7:log --format csv");
    let (loads, separations) = (column(&curve, "load_N"), column(&curve, "separation_m"));
    let rows = |name: &str, sign: f64| {
        let row = |(load, d): (&f64, &f64)| format!("{load},{:e}\n", sign * (d - separations[0]));
        let rows: String = loads.iter().zip(&separations).map(row).collect();
        format!("load_N,{name}\n{rows}")
    };
    bench.write("closure.csv", &rows("closure_m", -1.0));
    bench.write("separation.csv", &rows("separation_m", 1.0));
    let fit = |arguments: &str| bench.data(&format!("fit scene.toml {arguments} --model gw"));
    let closure = fit("closure.csv --free asperity_height_std");
    assert_eq!(closure, fit("separation.csv --free asperity_height_std,separation_offset"));
    bench.write("both.csv", "load_N,separation_m,closure_m\n10,1e-6,1e-9\n");
    let both = bench.run("fit scene.toml both.csv --model gw --free asperity_height_std");
    assert_eq!(both.code, Some(1), "{}", both.messages);
}
