//! Loads lead back to where they came from, and models beside each other.

use crate::bench::{Bench, NEGATIVE, cells, column, csv};

#[test]
fn loads_lead_back_to_their_separations() {
    let bench = Bench::new();
    let curve = bench.data("curve scene.toml --model gw,jg,gao --separation -3,0,2,20");
    let (force, separation) = (column(&curve, "force_N"), column(&curve, "separation_over_sigma"));
    for (k, model) in ["gw", "jg", "gao"].into_iter().enumerate() {
        let loads: Vec<String> = force[4 * k..4 * k + 4].iter().map(|f| format!("{f:e}")).collect();
        let arguments = format!("curve scene.toml --model {model} --load {}", loads.join(","));
        let data = bench.data(&arguments);
        let (head, _) = csv(&data);
        assert_eq!(
            head.join(","),
            "model,load_N,pressure_Pa,separation_over_sigma,separation_m,area_m2,tangent_N_per_m"
        );
        assert_eq!(column(&data, "load_N"), force[4 * k..4 * k + 4]);
        for (found, wanted) in column(&data, "separation_over_sigma").iter().zip(&separation) {
            assert!((found - wanted).abs() < 1e-9, "{model}: {found} {wanted}");
        }
    }
}

#[test]
fn pressures_are_loads_on_the_nominal_area() {
    let bench = Bench::new();
    let data = bench.data("curve scene.toml --model ke --pressure 1e6,1e-200 --quantity pressure");
    assert_eq!(column(&data, "load_N"), [1e6 * 1e-4, 1e-200 * 1e-4]);
    for (found, wanted) in column(&data, "pressure_Pa").iter().zip([1e6, 1e-200]) {
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    }
}

#[test]
fn loads_that_no_separation_carries_are_refused_with_the_range() {
    let bench = Bench::new();
    let run = bench.run("curve scene.toml --model gw,ke --load 1e30");
    assert_eq!((run.code, run.out.as_str()), (Some(1), ""));
    for printed in ["[no-value]", "N, above ", "scene.toml"] {
        assert!(run.messages.contains(printed), "{}", run.messages);
    }
}

#[test]
fn all_separations_of_a_load_are_rows_on_request() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    let far = bench.data("curve scene.toml --model at --separation 5 --quantity force");
    let load = column(&far, "force_N")[0];
    let arguments = format!("curve scene.toml --model at --load {load},1e30 --quantity force");
    let all = bench.run(&format!("{arguments} --all"));
    assert_eq!(all.code, Some(0));
    let separations = cells(&all.out, "separation_over_sigma");
    assert!(separations.len() >= 4 && separations.last() == Some(&""), "{separations:?}");
    let found: Vec<f64> = separations.iter().filter_map(|cell| cell.parse().ok()).collect();
    let forces = cells(&all.out, "force_N");
    for (separation, force) in found.iter().zip(&forces) {
        let force: f64 = force.parse().unwrap();
        assert!((force / load - 1.0).abs() < 1e-6, "{separation}: {force}");
    }
    assert!(found.is_sorted(), "{found:?}");
    // The first that is met on approach.
    let one = bench.data(&arguments);
    let largest: f64 = cells(&one, "separation_over_sigma")[0].parse().unwrap();
    // One row and tables for many have integrals of their own, each with a tolerance of 1e-10.
    let last = found.last().copied().unwrap_or(f64::NAN);
    assert!((largest - 5.0).abs() < 1e-9 && (last - largest).abs() < 1e-9, "{largest} {last}");
    // How ill-conditioned a load near a zero of the force is, is in the bound.
    let near = bench.data("curve scene.toml --model at --load 1e-3 --errors --quantity force");
    let additive = "curve scene.toml --model at-additive --load 1e-3 --errors --quantity force";
    let sum = column(&bench.data(additive), "force_error")[0];
    assert!(column(&near, "force_error")[0] > 10.0 * sum, "{near} {sum:e}");
}

#[test]
fn models_beside_each_other_deviate_from_the_reference() {
    let bench = Bench::new();
    let at_two = bench.data("curve scene.toml --model all --separation 2 --reference jg");
    let (head, rows) = csv(&at_two);
    assert_eq!(head[3..5], ["force_N", "force_deviation"]);
    assert_eq!(rows.len(), 9);
    let (force, deviation) = (column(&at_two, "force_N"), column(&at_two, "force_deviation"));
    assert_eq!(cells(&at_two, "force_deviation")[5], "0");
    assert!((force[0] / force[5] - 1.0 - deviation[0]).abs() < 1e-12);
}

#[test]
fn models_are_compared_at_every_load_and_what_is_equal_deviates_by_0() {
    let bench = Bench::new();
    let arguments = "curve scene.toml --reference ke --load 50,500 --model gw,ke,gao";
    let data = bench.data(&format!("{arguments} --quantity force,area,pressure"));
    assert_eq!(cells(&data, "model"), ["gw", "ke", "gao", "gw", "ke", "gao"]);
    assert_eq!(column(&data, "load_N"), [50.0, 50.0, 50.0, 500.0, 500.0, 500.0]);
    for (force, load) in column(&data, "force_N").iter().zip(column(&data, "load_N")) {
        assert!((force / load - 1.0).abs() < 1e-9, "{force}");
    }
    for name in ["force_deviation", "pressure_deviation"] {
        assert_eq!(cells(&data, name), ["0"; 6], "{name}");
    }
    let area = cells(&data, "area_deviation");
    assert!(area[1] == "0" && area[0].starts_with('-') && !area[2].is_empty(), "{area:?}");
}

/// The number between two pieces of a sentence.
fn printed(arguments: &str, before: &str, after: &str) -> f64 {
    let (_, rest) = arguments.split_once(before).unwrap_or_else(|| panic!("{arguments}"));
    rest.split_once(after).unwrap().0.parse().unwrap()
}

#[test]
fn cancellation_is_reported_with_its_error() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    let run = |arguments: &str| bench.run(&format!("{arguments} --model at,jg,ke"));
    // Next to a zero crossing, as large a part of the force as of its parts moves it.
    let near = run("curve scene.toml --separation 3.4637,0 --quantity force");
    let to = printed(&near.messages, "leave a relative error of ", "\n");
    assert!((1e-4..0.5).contains(&to), "{to}");
    assert!(near.messages.contains("[cancelled]"));
    assert_eq!(near.messages.matches("[cancelled]").count(), 1, "{}", near.messages);
    // Below the top, at a load.
    let force =
        column(&bench.data("curve scene.toml --model at --separation 3.69:3.71:2001"), "force_N");
    let load = 0.9999999 * force.iter().copied().fold(0.0, f64::max);
    let top = run(&format!("curve scene.toml --load {load:e},20"));
    assert!(top.messages.contains("[cancelled]"));
    assert!(top.messages.contains("[cancelled]"), "{}", top.messages);
    assert_eq!(top.messages.matches("[cancelled]").count(), 1, "{}", top.messages);
    // Nothing is printed elsewhere.
    for arguments in ["curve scene.toml --separation 0,2,5", "curve scene.toml --load 1e-3,1"] {
        let arguments = run(arguments).messages;
        assert!(!arguments.contains("known to"), "{arguments}");
    }
}
