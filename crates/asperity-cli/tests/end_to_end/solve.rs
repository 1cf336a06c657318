//! `solve`: loads lead back to where they came from.

use crate::bench::{Bench, NEGATIVE, column, csv};

#[test]
fn loads_lead_back_to_their_separations() {
    let bench = Bench::new();
    let curve = bench.data("curve scene.toml --model gw,jg,gao --separation -3,0,2,20");
    let (force, separation) = (column(&curve, "force"), column(&curve, "separation_over_sigma"));
    for (k, model) in ["gw", "jg", "gao"].into_iter().enumerate() {
        let loads: Vec<String> = force[4 * k..4 * k + 4].iter().map(|f| format!("{f:e}")).collect();
        let words = format!("solve scene.toml --model {model} --load {}", loads.join(","));
        let data = bench.data(&words);
        let (head, _) = csv(&data);
        assert_eq!(
            head.join(","),
            "model,load_n,separation_over_sigma,separation_m,force,area,stiffness"
        );
        assert_eq!(column(&data, "load_n"), force[4 * k..4 * k + 4]);
        for (found, wanted) in column(&data, "separation_over_sigma").iter().zip(&separation) {
            assert!((found - wanted).abs() < 1e-9, "{model}: {found} {wanted}");
        }
    }
}

#[test]
fn pressures_are_loads_on_the_nominal_area() {
    let bench = Bench::new();
    let data = bench.data("solve scene.toml --model ke --pressure 1e6,1e-200 --quantity pressure");
    assert_eq!(column(&data, "load_n"), [1e6 * 1e-4, 1e-200 * 1e-4]);
    for (found, wanted) in column(&data, "pressure").iter().zip([1e6, 1e-200]) {
        assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
    }
}

#[test]
fn loads_that_no_separation_carries_are_refused_with_the_range() {
    let bench = Bench::new();
    let run = bench.run("solve scene.toml --model gw,ke --load 5,1e30");
    assert_eq!((run.code, run.out.as_str()), (Some(1), ""));
    assert!(
        run.words.contains("scene.toml: ") && run.words.contains("a load above 0 and at most"),
        "{}",
        run.words
    );
}

#[test]
fn all_crossings_of_a_force_that_rises_and_falls_are_rows_and_said() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    let far = bench.data("curve scene.toml --model at --separation 5 --quantity force");
    let load = column(&far, "force")[0];
    let run = bench.run(&format!("solve scene.toml --model at --load {load} --quantity force"));
    assert_eq!(run.code, Some(0));
    let forces = column(&run.out, "force");
    assert!(forces.len() >= 2 && run.words.contains("separations carry"), "{}", run.words);
    assert!(forces.iter().all(|force| (force / load - 1.0).abs() < 1e-6), "{forces:?}");
}

#[test]
fn models_beside_each_other_deviate_from_the_reference() {
    let bench = Bench::new();
    let at_two = bench.data("compare scene.toml --format csv --reference jg");
    let (head, rows) = csv(&at_two);
    assert_eq!(head[3..5], ["force", "force_deviation"]);
    assert_eq!(rows.len(), 12);
    let (force, deviation) = (column(&at_two, "force"), column(&at_two, "force_deviation"));
    assert_eq!(deviation[5..6], [0.0]);
    assert!((force[0] / force[5] - 1.0 - deviation[0]).abs() < 1e-12);
    let at_load = bench.data("compare scene.toml --format csv --load 50 --model gw,ke,gao");
    for force in column(&at_load, "force") {
        assert!((force / 50.0 - 1.0).abs() < 1e-9, "{force}");
    }
}
