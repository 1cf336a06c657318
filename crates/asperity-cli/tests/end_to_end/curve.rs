//! `curve`: what is printed is what the library says.

use asperity::{Model, Output, Quantity, Readout, Request};

use crate::bench::{Bench, NEGATIVE, NO_SHEAR, column, csv};

#[test]
fn the_default_is_every_model_at_401_separations() {
    let bench = Bench::new();
    let data = bench.data("curve scene.toml");
    let (head, rows) = csv(&data);
    assert_eq!(
        head,
        ["model", "separation_over_sigma", "separation_m", "force", "area", "stiffness"]
    );
    assert_eq!(rows.len(), 12 * 401);
    assert_eq!(rows[0][..2], ["gw", "0"]);
    assert_eq!(rows[12 * 401 - 1][..2], ["at-overlap", "4"]);
}

#[test]
fn every_digit_is_the_librarys() {
    let bench = Bench::new();
    let scene = bench.scene("scene.toml").scene;
    let data = bench.data("curve scene.toml --model jg --separation -1:4:6 --tolerance 1e-12");
    let request = Request::new([Quantity::Force, Quantity::Area, Quantity::Stiffness])
        .at(column(&data, "separation_over_sigma"))
        .within(asperity::Tolerance::new(1e-12).unwrap());
    let answer = "jg".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
    for quantity in request.quantities {
        let (printed, computed) =
            (column(&data, &quantity.to_string()), answer.values(quantity).unwrap());
        assert!(printed.iter().zip(computed).all(|(a, b)| a.to_bits() == b.to_bits()));
    }
}

#[test]
fn all_quantities_and_their_errors_have_columns() {
    let bench = Bench::new();
    let names: Vec<String> = Output::ALL.iter().map(ToString::to_string).collect();
    let words = format!(
        "curve scene.toml --model ke,at-overlap --errors --separation -1,2.5 --quantity {}",
        names.join(",")
    );
    let data = bench.data(&words);
    let (head, rows) = csv(&data);
    let columns: Vec<String> = names.iter().map(|name| name.replace('-', "_")).collect();
    assert_eq!(head[3..16], columns);
    let errors: Vec<String> = columns.iter().map(|name| format!("{name}_error")).collect();
    assert_eq!(head[16..], errors);
    assert_eq!(rows.len(), 4);
    let scene = bench.scene("scene.toml").scene;
    let model = "ke".parse().unwrap();
    let readout = Readout::new(&model, &scene, &Request::new([]), &Output::ALL).unwrap();
    for (output, (name, error)) in Output::ALL.into_iter().zip(columns.iter().zip(&errors)) {
        let value = readout.value(output, 2.5).unwrap();
        assert_eq!(Some(column(&data, name)[1]), value.value, "{name}");
        assert!(column(&data, error)[1] < 1e-8, "{error}");
    }
}

#[test]
fn lists_may_be_repeated_or_joined() {
    let bench = Bench::new();
    let joined =
        bench.data("curve scene.toml --model gw,ke --quantity force,area --separation 1,2");
    let repeated = bench.data(
        "curve --model gw --separation 1 --quantity force scene.toml --quantity area --model ke --separation 2",
    );
    assert_eq!(joined, repeated);
    assert_eq!(joined.lines().count(), 5);
}

#[test]
fn negative_numbers_follow_a_blank_or_an_equals_sign() {
    let bench = Bench::new();
    for flag in ["--separation -1:4:11", "--separation=-1:4:11"] {
        let data = bench.data(&format!("curve scene.toml --model gw {flag}"));
        assert_eq!(column(&data, "separation_over_sigma")[..2], [-1.0, -0.5]);
    }
    let data = bench.data("curve --separation -.5,2e-1 --model gw scene.toml");
    assert_eq!(column(&data, "separation_over_sigma"), [-0.5, 0.2]);
}

#[test]
fn metres_and_multiples_of_sigma_are_the_same_place() {
    let bench = Bench::new();
    let metres = bench.data("curve scene.toml --model ke --separation 2e-6 --separation-unit m");
    let sigmas = bench.data("curve scene.toml --model ke --separation 2");
    for name in ["separation_over_sigma", "separation_m", "force"] {
        let (a, b) = (column(&metres, name)[0], column(&sigmas, name)[0]);
        assert!((a / b - 1.0).abs() < 1e-13, "{name}: {a} {b}");
    }
}

#[test]
fn separations_from_the_mean_plane_are_printed_as_given() {
    let bench = Bench::new();
    bench.write("plane.toml", &format!("{NO_SHEAR}separation_from = \"surface-mean\"\n"));
    bench.write("asperities.toml", NO_SHEAR);
    let offset = bench.scene("asperities.toml").scene.surface.mean_plane_offset() / 1e-6;
    let plane = bench.data("curve plane.toml --model ke --separation 3");
    let same =
        bench.data(&format!("curve asperities.toml --model ke --separation {}", 3.0 - offset));
    assert_eq!(column(&plane, "separation_over_sigma"), [3.0]);
    let (a, b) = (column(&plane, "force")[0], column(&same, "force")[0]);
    assert!(offset > 0.5 && (a / b - 1.0).abs() < 1e-12, "{offset}: {a} {b}");
    let solved = bench.data(&format!("solve plane.toml --model ke --load {a}"));
    assert!((column(&solved, "separation_over_sigma")[0] - 3.0).abs() < 1e-9, "{solved}");
}

#[test]
fn json_and_table_hold_what_the_csv_holds() {
    let bench = Bench::new();
    let words = "curve scene.toml --model gw,at --separation 0:40:3 --quantity force,mean-pressure";
    let data = bench.data(words);
    let json: serde_json::Value =
        serde_json::from_str(&bench.data(&format!("{words} --format json"))).unwrap();
    let rows = json.as_array().unwrap();
    for name in ["separation_m", "force", "mean_pressure"] {
        let numbers: Vec<f64> = rows.iter().map(|row| row[name].as_f64().unwrap()).collect();
        assert_eq!(numbers, column(&data, name));
    }
    assert_eq!(rows[3]["model"], "at");
    let table = bench.data(&format!("{words} --format table"));
    assert_eq!(table.lines().count(), data.lines().count());
    assert!(table.starts_with("model  separation_over_sigma  separation_m [m]"), "{table}");
}

#[test]
fn models_that_the_scene_does_not_allow_are_named() {
    let bench = Bench::new();
    bench.write("scene.toml", NO_SHEAR);
    let run = bench.run("curve scene.toml --separation 2");
    assert_eq!(run.code, Some(0));
    assert_eq!(run.out.lines().count(), 9, "{}", run.out);
    for id in ["gao", "at", "at-additive", "at-overlap"] {
        assert!(run.words.contains(&format!("{id} is left out: equivalent_shear_modulus")));
    }
    let refused = bench.run("curve scene.toml --model gw,gao");
    assert_eq!((refused.code, refused.out.as_str()), (Some(1), ""));
    assert!(
        refused.words.contains("scene.toml: equivalent_shear_modulus is missing: Gao needs it")
    );
}

#[test]
fn odd_answers_stand_and_are_warned_of() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    let run = bench.run("curve scene.toml --model at --separation 1,500 --quantity force,ln-force");
    assert_eq!(run.code, Some(0));
    let force = column(&run.out, "force");
    assert!(force[0] < 0.0 && force[1] == 0.0, "{force:?}");
    assert!(column(&run.out, "ln_force")[1] < -1e5);
    assert!(run.words.contains("the force is negative at 1 of"), "{}", run.words);
    assert!(run.words.contains("too small for a double at 1 of"), "{}", run.words);
}

#[test]
fn pictures_have_a_curve_for_every_model_and_nothing_that_is_no_number() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    bench.data(
        "curve scene.toml --quantity force,plastic-share,ln-area --separation -2:9:50 --plot p.svg --output out.csv",
    );
    let svg = bench.read("p.svg");
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    // Each model in the legend and in the panel, of each quantity.
    assert!(svg.matches("<polyline").count() >= 2 * 3 * 12);
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    assert!(svg.contains("at: values of 0 and below are not on this logarithmic axis"));
    assert_eq!(bench.read("out.csv").lines().count(), 1 + 12 * 50);
}

#[test]
fn the_default_separations_are_multiples_of_sigma_whatever_the_unit() {
    let bench = Bench::new();
    let sigmas = bench.data("curve scene.toml --model gw");
    assert_eq!(bench.data("curve scene.toml --model gw --separation-unit m"), sigmas);
    let two = bench.data("compare scene.toml --model gw --format csv --separation-unit m");
    assert_eq!(column(&two, "separation_over_sigma"), [2.0]);
}
