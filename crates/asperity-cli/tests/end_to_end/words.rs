//! The commands that answer in words: plan, recommend, models.

use crate::bench::{Bench, NO_SHEAR, column, csv};

#[test]
fn a_plan_says_what_is_integrated() {
    let bench = Bench::new();
    let plan = bench.data("plan scene.toml --model ke,zmc --quantity force,tangent,contacts");
    assert!(plan.starts_with("KE, gaussian heights, 401 separations from 0 to 4"), "{plan}");
    assert!(plan.contains("force, tangent from the force law") && plan.contains("\nZMC,"));
}

#[test]
fn an_elastic_scene_needs_no_more_than_greenwood_and_williamson() {
    let bench = Bench::new();
    bench.write("soft.toml", &NO_SHEAR.replace("_std = 1e-6", "_std = 1e-10"));
    let run = bench.run("recommend soft.toml");
    assert_eq!(run.code, Some(0));
    assert!(run.out.starts_with("gw is the simplest model within 0.05 of ke\n"), "{}", run.out);
    assert!(run.words.contains("gao is left out"));
    let data = bench.data("recommend scene.toml --format csv --reference gao --within 1e-3");
    let (head, rows) = csv(&data);
    assert_eq!(head, ["model", "force_deviation", "area_deviation", "verdict"]);
    let gao = rows.iter().find(|row| row[0] == "gao").unwrap();
    assert_eq!(gao[1..], ["0", "0", "recommended"]);
    assert!(column(&data, "force_deviation")[0] > 1.0);
}

#[test]
fn the_list_of_models_has_every_source() {
    let bench = Bench::new();
    let json: serde_json::Value =
        serde_json::from_str(&bench.data("models --format json")).unwrap();
    let ids: Vec<&str> =
        json.as_array().unwrap().iter().map(|row| row["model"].as_str().unwrap()).collect();
    assert_eq!(ids.join(" "), "gw ceb zmc ke etsion jg jg-cosine af gao at at-additive at-overlap");
    assert_eq!(json[3]["authors"], "Kogut & Etsion");
    assert_eq!(bench.data("models").lines().count(), 13);
}
