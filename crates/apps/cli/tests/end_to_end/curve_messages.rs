//! What `curve` says beside its rows, and what it refuses.

use asperity::Quantity;

use crate::bench::{Bench, NEGATIVE, NO_SHEAR, cells, column};

#[test]
fn models_that_the_scene_does_not_allow_are_named() {
    let bench = Bench::new();
    bench.write("scene.toml", NO_SHEAR);
    let run = bench.run("curve scene.toml --model all --separation 2");
    assert_eq!(run.code, Some(0));
    assert_eq!(run.out.lines().count(), 8, "{}", run.out);
    assert!(run.messages.contains("[left-out]"), "{}", run.messages);
    let refused = bench.run("curve scene.toml --model gw,gao");
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""));
    assert!(refused.messages.contains("scene.toml"));
}

#[test]
fn unusual_results_are_printed_with_a_warning() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    let run = bench.run("curve scene.toml --model at --separation 1,500 --quantity force,ln-force");
    assert_eq!(run.code, Some(0));
    let force = column(&run.out, "force_N");
    assert!(force[0] < 0.0 && force[1] == 0.0, "{force:?}");
    assert!(column(&run.out, &Quantity::LnForce.column())[1] < -1e5);
    assert!(run.messages.contains("[negative]"), "{}", run.messages);
    assert!(run.messages.contains("[underflow]"), "{}", run.messages);
}

#[test]
fn rows_without_a_value_are_blank_with_one_message() {
    let bench = Bench::new();
    let run = bench.run("curve scene.toml --model jg,ke --load 100,1e30,2e30");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    for name in ["separation_over_sigma", "separation_m", "area_m2", "tangent_N_per_m"] {
        let blank: Vec<bool> = cells(&run.out, name).iter().map(|cell| cell.is_empty()).collect();
        assert_eq!(blank, [false, true, true, false, true, true], "{name}");
    }
    assert_eq!(cells(&run.out, "load_N")[1], "1e30");
    assert_eq!(run.messages.lines().count(), 2, "{}", run.messages);
    assert!(run.messages.contains("[no-value]"));
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
    let json = bench.run("curve scene.toml --model ke --load 5.0,1e30 --format json");
    let rows: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert!(rows[0]["area_m2"].is_f64() && rows[1]["area_m2"].is_null());
    assert!(rows[1]["separation_m"].is_null() && rows[1]["load_N"].as_f64() == Some(1e30));
    let separations = bench.run("curve scene.toml --model ke --separation 1.0,2e9");
    assert_eq!(separations.code, Some(0));
    assert_eq!(cells(&separations.out, "force_N")[1], "");
    assert!(separations.messages.contains("[no-value]"), "{}", separations.messages);
}

#[test]
fn plots_other_than_svg_are_refused_first() {
    let bench = Bench::new();
    for name in ["x.png", "x", "x.svg.pdf", ".svg"] {
        let run = bench.run(&format!("curve nowhere.toml --output out.csv --plot {name}"));
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{name}");
        assert!(run.messages.contains(name), "{}", run.messages);
    }
    assert!(!bench.path("out.csv").exists());
}

#[test]
fn messages_use_the_unit_and_the_plane_of_the_user() {
    let bench = Bench::new();
    bench.write("plane.toml", &format!("{NEGATIVE}separation_from = \"surface-mean\"\n"));
    let run = bench.run("curve plane.toml --model at --separation 1.5e-6m");
    assert!(run.messages.contains("[negative]"), "{}", run.messages);
    assert_eq!(column(&run.out, "separation_m"), [1.5e-6]);
    let plan = bench.data("curve --plan plane.toml --model ke --separation 1:3:3");
    assert!(plan.contains("1 asperity_height_std from"), "{plan}");
    let plan = bench.data("curve --plan plane.toml --model ke --load 10:1000:50");
    assert!(plan.contains("50 rows from"), "{plan}");
}

#[test]
fn a_model_with_a_negative_density_of_angles_has_no_message() {
    let run = Bench::new().run("curve scene.toml --model gao,at --separation 2");
    assert_eq!((run.code, run.messages.as_str()), (Some(0), ""));
}

#[test]
fn a_reason_names_all_of_its_models_once() {
    let bench = Bench::new();
    let asked = "curve scene.toml --model ke,jg --separation 2 --quantity area,thermal-conductance";
    let run = bench.run(asked);
    assert_eq!(run.messages.matches("[no-value]").count(), 1);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
}

#[test]
fn a_comma_separates() {
    let bench = Bench::new();
    let asked = "curve scene.toml --model ke --quantity area --load";
    assert_eq!(bench.data(&format!("{asked} 1,5e2")), bench.data(&format!("{asked} 1,500")));
    let run = bench.run("joint scene.toml --friction 0.3 --load 100 --amplitude 1,5um");
    assert!(run.code == Some(2), "{}", run.messages);
}

#[test]
fn a_resistivity_that_is_a_conductivity_and_typed_numbers_are_named() {
    let bench = Bench::new();
    let scene = asperity_scene::template();
    let copper =
        scene.replace("# electrical_resistivity = 1.7e-7", "electrical_resistivity = 2.5e7");
    bench.write("copper.toml", &copper);
    let found = bench.run("check copper.toml").messages;
    assert!(found.contains("[unusual-size]"), "{found}");
    // A hardness that is missing has its place.
    bench.write("soft.toml", &scene.replace("\nhardness =", "\n# hardness ="));
    let refused = bench.run("curve soft.toml --model ke --load 1").messages;
    assert!(refused.contains("soft.toml:11"), "{refused}");
    let (head, rest) = scene.split_once("asperity_radius = 2e-4").unwrap();
    let tail = rest.split_once("heights = \"gaussian\"").unwrap().1;
    let iso = "sq = \"1.1 um\"\nspd = \"600 1/um2\"\nspc = \"5 1/mm\"";
    bench.write("iso.toml", &format!("{head}{iso}{tail}"));
    let found = bench.run("check iso.toml").messages;
    assert!(found.contains("[unusual-size]"), "{found}");
    assert!(found.contains("check these numbers and their units"), "{found}");
}

#[test]
fn a_format_follows_the_ending_and_a_failing_file_leaves_no_plot() {
    let bench = Bench::new();
    let line = "curve scene.toml --model ke --load 5,10";
    assert_eq!(bench.run(&format!("{line} --output a.json")).code, Some(0));
    let rows: serde_json::Value = serde_json::from_str(&bench.read("a.json")).unwrap();
    assert_eq!(rows[1]["load_N"], 10.0);
    assert_eq!(bench.run(&format!("{line} --format table --output a.csv")).code, Some(0));
    assert!(bench.read("a.csv").starts_with("model,load_N,"));
    let failing = bench.run(&format!("{line} --output missing/a.csv --plot a.svg"));
    assert!(failing.code == Some(1) && !bench.path("a.svg").exists(), "{}", failing.messages);
}
