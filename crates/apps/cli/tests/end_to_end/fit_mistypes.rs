//! Names of columns and numbers as others write them.

use crate::bench::{Bench, column};
use crate::fit_refusals::{AREAS, refusal, refused};

#[test]
fn usual_names_of_columns_and_numbers_lead_to_ours() {
    let bench = Bench::new();
    let mut all = String::new();
    for head in [
        "F [kN],area_m2",
        "p_MPa,area_m2",
        "load_N,gap_um",
        "load_N,contact_area_m2",
        "load_N,area_percent",
        "F/N,area_m2",
        "pressure [N/cm2],area_m2",
        "load_N,d [\u{b5}m]",
        "load_N,stiffness (N/um)",
        "load_N,contact_stiffness",
        "load_N,kn [GN/m]",
        "load_N,tangent_N/m",
        "load_N,tangent_N/um",
        "load_N,area_m\u{b2}",
        "load_N,displacement_um",
        "force_N,area_m2",
    ] {
        bench.write("data.csv", &format!("{head}\n10,5e-9\n100,5e-8\n"));
        all += &refusal(&bench, head, "data.csv --free hardness");
    }
    for text in [
        "load_N,area_m2,area_std\n10,5e-9,1e-9\n100,5e-8,1e-8\n",
        "load_N,area_m2,comment\n10,5e-9,first\n",
    ] {
        bench.write("data.csv", text);
        all += &refusal(&bench, text, "data.csv --free hardness");
    }
    bench.write("data.csv", AREAS);
    for key in ["H", "E", "sigma", "electrical_conductivity"] {
        all += &refusal(&bench, key, &format!("data.csv --free {key}"));
    }
    insta::assert_snapshot!(all);
    let ratio = bench.data("fit scene.toml data.csv --free poissons_ratio --format csv");
    assert!(column(&ratio, "value")[0] <= 0.5, "{ratio}");
    let run = bench.run("fit scene.toml data.csv --free hardness=2GPa");
    assert!(run.code == Some(2) && run.messages.contains("\"2GPa\""), "{}", run.messages);
}

#[test]
fn data_and_scene_in_each_others_place_are_named() {
    let bench = Bench::new();
    bench.write("data.csv", AREAS);
    let run = bench.run("fit data.csv scene.toml --free hardness");
    assert!(run.code == Some(1), "{}", run.messages);
    refused(&bench, "scene.toml --free hardness", "scene.toml");
}

#[test]
fn an_implausible_scene_is_fitted_with_a_warning() {
    let bench = Bench::new();
    bench.write("data.csv", AREAS);
    let scene = std::fs::read_to_string(bench.path("scene.toml")).unwrap();
    let wrong = scene.replace("asperity_height_std = 1e-6", "asperity_height_std = 1.0");
    assert_ne!(wrong, scene);
    bench.write("scene.toml", &wrong);
    let run = bench.run("fit scene.toml data.csv --free hardness");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("[unusual-size]"), "{}", run.messages);
}
