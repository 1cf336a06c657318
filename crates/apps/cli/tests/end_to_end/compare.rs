//! `bem --compare`: comparison of models with boundary elements on a scan.

use crate::bem::bench;
use crate::bench::{cells, column, column_of};

#[test]
fn models_are_compared_with_boundary_elements() {
    let bench = bench();
    let arguments = "bem --compare scan.toml --pressure 1e8,1e9 --model zmc,ke --format csv";
    let run = bench.run(arguments);
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["bem", "zmc", "ke", "bem", "zmc", "ke"]);
    let areas = column(&run.out, "area_fraction");
    let deviations = column(&run.out, "area_deviation");
    for (k, deviation) in deviations.iter().enumerate() {
        let truth = areas[k / 3 * 3];
        assert!((deviation - (areas[k] / truth - 1.0)).abs() < 1e-12);
    }
    let bem = bench.data("bem scan.toml --pressure 1e8,1e9 --format csv");
    // Solved in another order: the load of yielded contacts is the same to rounding.
    let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    let [light, heavy] = column(&bem, "area_fraction")[..] else { panic!("{bem}") };
    same(areas[0], light);
    same(areas[3], heavy);
    let curve = "curve scan.toml --pressure 1e8,1e9 --model ke --format csv";
    let curve = bench.data(&format!("{curve} --quantity area-fraction,tangent"));
    for (name, other) in
        [("area_fraction", "area_fraction"), ("stiffness_N_per_m", "tangent_N_per_m")]
    {
        let all = column(&run.out, name);
        // Two loads without tables, and each with its model's: the same to rounding.
        let [light, heavy] = column(&curve, other)[..] else { panic!("{curve}") };
        same(all[2], light);
        same(all[5], heavy);
    }
    // A fifth of the area and more: one warning for both models.
    assert_eq!(run.messages.matches("warning[crowded]").count(), 1, "{}", run.messages);
    let path = bench.run("joint scan.toml --model bem --pressure 1e7 --retreat 0um,1um");
    assert!(path.code == Some(0) && path.messages.contains("[few-patches]"), "{}", path.messages);
}

#[test]
fn half_the_grid_stands_beside_it() {
    let bench = bench();
    let arguments = "bem --compare scan.toml --pressure 9e9,1e9 --model ke --refine --format csv";
    let run = bench.run(arguments);
    assert_eq!(cells(&run.out, "model"), ["bem", "bem-half-grid", "ke"], "{}", run.messages);
    let bem = bench.data("bem scan.toml --pressure 1e9 --refine --format csv");
    let half = column(&run.out, "area_fraction")[1];
    let of_bem = column(&bem, "area_fraction_half_grid")[0];
    assert!((half / of_bem - 1.0).abs() < 1e-12, "{half} {of_bem}");
    assert!(column(&run.out, "stiffness_N_per_m")[1] > 0.0);
}

#[test]
fn unloading_stiffnesses_are_compared_if_named() {
    let bench = bench();
    let ask = "bem --compare scan.toml --pressure 1e9 --format csv --quantity";
    // Conductances deviate alike, and need no conductivity for that.
    let [stiffness, conductance] = ["unloading-stiffness", "thermal-conductance"]
        .map(|quantity| bench.run(&format!("{ask} {quantity} --model zmc,gw-random")));
    assert_eq!(stiffness.out, conductance.out);
    let bem =
        bench.data("bem scan.toml --pressure 1e9 --format csv --quantity unloading-stiffness");
    let of_model = "curve scan.toml --pressure 1e9 --model zmc --format csv --quantity";
    let of_model = bench.data(&format!("{of_model} unloading-stiffness"));
    let name = "unloading_stiffness_N_per_m";
    let [bem, of_model] = [bem, of_model].map(|data| column(&data, name)[0]);
    let [Some(found), Some(zmc), None] = column_of(&stiffness.out, name)[..] else {
        panic!("{}", stiffness.out)
    };
    assert!((found / bem - 1.0).abs() < 1e-12 && (zmc / of_model - 1.0).abs() < 1e-12);
    let off = column_of(&stiffness.out, "unloading_stiffness_deviation")[1];
    assert!((off.unwrap() - (of_model / bem - 1.0)).abs() < 1e-12);
    assert!(!stiffness.out.contains(",stiffness_deviation"), "{}", stiffness.out);
    assert_eq!(stiffness.messages.matches("[no-value]").count(), 1, "{}", stiffness.messages);
    let both = bench.run(&format!("{ask} unloading-stiffness,tangent --model zmc"));
    assert!(both.out.contains(",stiffness_deviation"), "{}", both.out);
    let none = bench.run(&format!("{ask} force"));
    assert!(none.code == Some(1), "{}", none.messages);
}
