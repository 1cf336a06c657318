//! What `curve` says beside its rows, and what it refuses.

use asperity::Quantity;

use crate::bench::{Bench, NEGATIVE, NO_SHEAR, cells, column};

#[test]
fn models_that_the_scene_does_not_allow_are_named() {
    let bench = Bench::new();
    bench.write("scene.toml", NO_SHEAR);
    let run = bench.run("curve scene.toml --separation 2");
    assert_eq!(run.code, Some(0));
    assert_eq!(run.out.lines().count(), 8, "{}", run.out);
    let wanted =
        "note[left-out]: left out: gao, at: equivalent_shear_modulus is missing: gao needs it";
    assert!(run.messages.contains(wanted), "{}", run.messages);
    let refused = bench.run("curve scene.toml --model gw,gao");
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""));
    assert!(
        refused.messages.contains("scene.toml: equivalent_shear_modulus is missing: gao needs it")
    );
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
    assert!(
        run.messages.contains(" N) at a separation of 1 asp")
            && run.messages.contains("force is negative ("),
        "{}",
        run.messages
    );
    assert!(run.messages.contains("too small for f64 at a separation of 500"), "{}", run.messages);
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
    assert!(run.messages.contains("ke: no value in 2 of 3 rows, first: load is 1e30 N"));
    assert!(run.messages.contains("the largest force of the model"), "{}", run.messages);
    let json = bench.run("curve scene.toml --model ke --load 5.0,1e30 --format json");
    let rows: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert!(rows[0]["area_m2"].is_f64() && rows[1]["area_m2"].is_null());
    assert!(rows[1]["separation_m"].is_null() && rows[1]["load_N"].as_f64() == Some(1e30));
    let separations = bench.run("curve scene.toml --model ke --separation 1.0,2e9");
    assert_eq!(separations.code, Some(0));
    assert_eq!(cells(&separations.out, "force_N")[1], "");
    assert!(separations.messages.contains("no value in 1 of 2 rows"), "{}", separations.messages);
}

#[test]
fn plots_other_than_svg_are_refused_first() {
    let bench = Bench::new();
    for name in ["x.png", "x", "x.svg.pdf", ".svg"] {
        let run = bench.run(&format!("curve nowhere.toml --output out.csv --plot {name}"));
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{name}");
        assert!(
            run.messages.contains(name) && run.messages.contains("ends in .svg"),
            "{}",
            run.messages
        );
    }
    assert!(!bench.path("out.csv").exists());
}

#[test]
fn messages_use_the_unit_and_the_plane_of_the_user() {
    let bench = Bench::new();
    bench.write("plane.toml", &format!("{NEGATIVE}separation_from = \"surface-mean\"\n"));
    let run = bench.run("curve plane.toml --model at --separation 1.5e-6m");
    let printed = "a separation of 1.5e-6 m from the mean plane of the surface";
    assert!(run.messages.contains(printed), "{}", run.messages);
    assert_eq!(column(&run.out, "separation_m"), [1.5e-6]);
    let plan = bench.data("curve --plan plane.toml --model ke --separation 1:3:3");
    assert!(plan.contains("a separation of 1 asperity_height_std from the mean plane"), "{plan}");
    let plan = bench.data("curve --plan plane.toml --model ke --load 10:1000:50");
    assert!(plan.contains("50 rows from a load of 1000 N to a load of 10 N"), "{plan}");
}

#[test]
fn facts_about_a_model_are_not_repeated_with_results() {
    let bench = Bench::new();
    let run = bench.run("curve scene.toml --model gao,at --separation 2");
    assert_eq!((run.code, run.messages.as_str()), (Some(0), ""));
    let models = bench.data("list models --format json");
    assert!(models.contains("gao: the angle density falls to 4 pi psi"), "{models}");
}

#[test]
fn all_stands_for_the_models_of_the_default_and_a_reason_names_them_once() {
    let bench = Bench::new();
    let by_default = bench.data("curve scene.toml --separation 2");
    assert_eq!(bench.data("curve scene.toml --separation 2 --model all"), by_default);
    let asked = "curve scene.toml --model ke,jg --separation 2 --quantity area,thermal-conductance";
    let run = bench.run(asked);
    assert_eq!(run.messages.matches("thermal_conductivity is missing").count(), 1);
    assert!(run.messages.contains("ke, jg: no thermal-conductance"), "{}", run.messages);
}

#[test]
fn a_comma_separates() {
    let bench = Bench::new();
    let asked = "curve scene.toml --model ke --quantity area --load";
    assert_eq!(bench.data(&format!("{asked} 1,5e2")), bench.data(&format!("{asked} 1,500")));
    let run = bench.run("joint scene.toml --friction 0.3 --load 100 --amplitude 1,5um");
    let one = "has a decimal comma; write 1.5um";
    assert!(run.code == Some(2) && run.messages.contains(one), "{}", run.messages);
}

#[test]
fn a_resistivity_that_is_a_conductivity_and_typed_numbers_are_named() {
    let bench = Bench::new();
    let scene = asperity_inputs::template();
    let copper =
        scene.replace("# electrical_resistivity = 1.7e-7", "electrical_resistivity = 2.5e7");
    bench.write("copper.toml", &copper);
    let found = bench.run("check copper.toml").messages;
    let wanted = "2.5e7 looks like a conductivity in S/m, of which the resistivity is 4e-8 ohm m";
    assert!(found.contains(wanted), "{found}");
    // A hardness that is missing has its place.
    bench.write("soft.toml", &scene.replace("\nhardness =", "\n# hardness ="));
    let refused = bench.run("curve soft.toml --model ke --load 1").messages;
    let wanted = "error: soft.toml:11: body[1].hardness is missing: set hardness or yield_strength";
    assert!(refused.contains(wanted), "{refused}");
    let (head, rest) = scene.split_once("asperity_radius = 2e-4").unwrap();
    let tail = rest.split_once("heights = \"gaussian\"").unwrap().1;
    let iso = "sq = \"1.1 um\"\nspd = \"600 1/um2\"\nspc = \"5 1/mm\"";
    bench.write("iso.toml", &format!("{head}{iso}{tail}"));
    let found = bench.run("check iso.toml").messages;
    let wanted = "asperities from sq = 1.1e-6 m, spd = 6e14 1/m^2, spc = 5000 1/m: roughness_parameter is 1.32e5";
    assert!(found.contains(wanted), "{found}");
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
