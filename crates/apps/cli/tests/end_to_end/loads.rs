//! Loads lead back to where they came from, and models beside each other.

use crate::bench::{Bench, NEGATIVE, cells, column};

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
