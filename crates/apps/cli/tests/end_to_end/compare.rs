//! `bem --compare`: comparison of models with boundary elements on a scan.

use crate::bem::bench;
use crate::bench::{NO_SHEAR, cells, column, column_of};

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
    // Its shortest waves are 3.5 pixels long.
    assert!(!run.results().is_empty() && !run.messages.contains("nearest to"), "{}", run.messages);
}

#[test]
fn random_asperities_and_persson_are_included_by_default() {
    let bench = bench();
    let run = bench.run("bem --compare scan.toml --pressure 1e9 --format csv");
    let ids = cells(&run.out, "model");
    for id in ["bem", "ke", "ke-random", "jg-random", "persson-fudge"] {
        assert_eq!(ids.iter().filter(|known| **known == id).count(), 1, "{id}: {ids:?}");
    }
}

#[test]
fn missing_scans_and_unsolved_loads_are_reported() {
    let bench = bench();
    bench.write("none.toml", NO_SHEAR);
    let printed = bench.refusals(
        "{}",
        &["bem --compare none.toml --pressure 1e6", "bem --compare scan.toml --pressure 9e9"],
    );
    insta::assert_snapshot!(printed);
    assert_eq!(bench.run("bem --compare scan.toml").code, Some(2));
}

#[test]
fn the_reason_for_a_blank_row_is_reported() {
    let bench = bench();
    let measured = format!("{}heights = \"measured\"\n", crate::bem::SCAN);
    bench.write("measured.toml", &measured);
    let ask = "bem --compare measured.toml --pressure 1e8 --format csv";
    let printed = "[no-value]";
    let run = bench.run(&format!("{ask} --model ke-random"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "area_fraction")[1], "", "{}", run.out);
    assert!(run.messages.contains(printed), "{}", run.messages);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
    let two = bench.run(&format!("{ask} --model ke-random,ke"));
    assert!(two.code == Some(0) && two.messages.contains(printed), "{}", two.messages);
    let all = bench.run(ask);
    assert_eq!(all.code, Some(0), "{}", all.messages);
    assert!(all.messages.contains("[left-out]"), "{}", all.messages);
    assert!(!cells(&all.out, "model").contains(&"ke-random"), "{}", all.out);
}

#[test]
fn invalid_results_are_reported_and_blank() {
    let bench = bench();
    let scan = crate::bem::SCAN;
    // GPa where Pa was needed: thousands of times the area.
    let soft = scan.replace("116e9", "116").replace("hardness = 5e9\n", "");
    bench.write("soft.toml", &soft);
    let run = bench.run("bem --compare soft.toml --pressure 1e8 --model gw --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "area_fraction"), ["1", ""], "{}", run.out);
    for printed in ["[unusual-size]", "[crowded]", "[no-value]"] {
        assert!(run.messages.contains(printed), "{}", run.messages);
    }
    // The reverse: that is printed, and what knows no yielding is as far off as it is.
    bench.write("hard.toml", &scan.replace("116e9", "116e15"));
    let run = bench.run("bem --compare hard.toml --pressure 1e8 --model gw,ke --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("[unusual-size]"), "{}", run.messages);
    assert!(column(&run.out, "area_deviation")[1] < -0.99, "{}", run.out);
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

/// A scan with resolved waves, of this skewness.
fn resolved(bench: &crate::bench::Bench, skewness: f64) {
    let generate = "generate --long 20um --roll-off 16um --short 2um --size 256x256 --pixel 0.25um --gradient 0.1 --seed 3";
    let run = bench.run(&format!("{generate} --skewness={skewness} --output made.npy"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let keys = "file = \"made.npy\"\nunit = \"m\"\npixel_size = 2.5e-7\nperiodic = true\n";
    let interface =
        "[interface]\nequivalent_modulus = 116e9\npoissons_ratio = 0.3\nhardness = 1e10\n";
    bench.write("made.toml", &format!("nominal_area = 1e-9\n{interface}[surface]\n{keys}"));
}

#[test]
fn the_solved_surfaces_agree_or_differ() {
    let bench = bench();
    for (skewness, shape) in [(0.0, "psi 1."), (-1.0, "")] {
        resolved(&bench, skewness);
        let run =
            bench.run("bem --compare made.toml --pressure 2e8,1e9 --model gw,ke --format csv");
        let line = run.results().into_iter().find(|line| line.starts_with("real area "));
        assert!(line.is_some_and(|line| line.contains(shape)), "{}", run.messages);
    }
}
