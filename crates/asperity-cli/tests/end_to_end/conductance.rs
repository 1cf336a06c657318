//! Conductances and stiffnesses of contact radii, and correlations beside them.

use crate::bench::{Bench, cells, column, column_of, conducting, csv};

#[test]
fn the_list_of_models_is_what_is_printed() {
    let bench = Bench::new();
    let ids = |models: &str| {
        let run = bench.run(&format!(
            "conductance scene.toml --conductivity 50 --load 100 --model {models} --format csv"
        ));
        assert_eq!(run.code, Some(0), "{}", run.messages);
        cells(&run.out, "model").join(" ")
    };
    assert_eq!(ids("CMY"), "cmy");
    assert_eq!(ids("ke,gao,mikic"), "ke mikic");
    assert_eq!(ids("ke"), "ke");
    // A model that lacks a property of the scene leaves the others.
    assert_eq!(ids("dmt,ke,ghaednia,cmy"), "ke cmy");
    let run = bench.run("conductance scene.toml --conductivity 50 --load 100 --model dmt,ke");
    assert!(run.messages.contains("[left-out]"), "{}", run.messages);
    let run = bench.run("conductance scene.toml --conductivity 50 --load 100 --model dmt");
    assert_eq!(run.code, Some(1), "{}", run.messages);
    let run = bench.run("conductance scene.toml --conductivity 50 --load 100 --model cym");
    assert!(run.code == Some(2) && run.messages.contains("\"cmy\""), "{}", run.messages);
}

#[test]
fn models_whose_contacts_are_no_circles_are_left_out_and_bodies_conduct() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let run = bench.run(
        "curve scene.toml --separation 1 --quantity contact-radius-sum,thermal-conductance,electrical-conductance",
    );
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("[left-out]"), "{}", run.messages);
    assert_eq!(csv(&run.out).1.len(), 7, "gw to af");
    let radii = column(&run.out, "contact_radius_sum_m");
    for (name, factor) in
        [("thermal_conductance_W_per_K", 2.0 * 50.0), ("electrical_conductance_S", 2.0 / 1.7e-7)]
    {
        for (value, radii) in column(&run.out, name).iter().zip(&radii) {
            assert!((value / (factor * radii) - 1.0).abs() < 1e-12, "{name}");
        }
    }
}

#[test]
fn correlations_of_conductance_stand_beside_the_models_with_where_they_hold() {
    use asperity::joints::conductance::{cooper_mikic_yovanovich, gap_conductance, mikic_elastic};
    let bench = Bench::new();
    let arguments = "conductance scene.toml --conductivity 50 --pressure 1e6,1e8 --format csv";
    let run = bench.run(&format!("{arguments} --gas 0.026 --gas-parameter 0.37um"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let file = bench.scene("scene.toml");
    let (roughness, modulus) = (file.gap_roughness(), file.scene.interface.equivalent_modulus);
    let found = column_of(&run.out, "thermal_conductance_per_area_W_per_m2_per_K");
    assert_eq!(cells(&run.out, "model"), ["ke", "ke", "cmy", "cmy", "mikic", "mikic"]);
    assert_eq!(cells(&run.out, "holds"), ["", "", "yes", "no", "no", "no"]);
    assert!(run.messages.contains("[correlation]"), "{}", run.messages);
    for (k, pressure) in [1e6, 1e8].into_iter().enumerate() {
        let cmy = cooper_mikic_yovanovich(50.0, &roughness, pressure, 2e9).unwrap();
        let mikic = mikic_elastic(50.0, &roughness, pressure, modulus).unwrap();
        assert_eq!((found[2 + k], found[4 + k]), (Some(cmy.conductance), Some(mikic.conductance)));
    }
    // Models give what their quantity does, and the gas that of the mean gap.
    bench.write("scene.toml", &conducting().replace("asperity-mean", "surface-mean"));
    let arguments =
        "curve scene.toml --model ke --pressure 1e6,1e8 --quantity thermal-conductance-per-area";
    let curve = bench.data(arguments);
    let wanted = column_of(&curve, "thermal_conductance_per_area_W_per_m2_per_K");
    assert!((found[0].unwrap() / wanted[0].unwrap() - 1.0).abs() < 1e-9, "{found:?} {wanted:?}");
    let gas = column_of(&run.out, "gas_thermal_conductance_per_area_W_per_m2_per_K");
    let gap = column(&curve, "separation_m")[0];
    let wanted = gap_conductance(0.026, gap, 0.37e-6).unwrap();
    assert!((gas[0].unwrap() / wanted - 1.0).abs() < 1e-9 && gas[2].is_none(), "{gas:?} {wanted}");
    let total = column_of(&run.out, "total_thermal_conductance_per_area_W_per_m2_per_K");
    assert_eq!(total[0], Some(found[0].unwrap() + gas[0].unwrap()));
    assert!(total[2..].iter().all(Option::is_none), "{total:?}");
    for printed in ["[correlation]", "[gap-roughness]"] {
        assert!(run.messages.contains(printed), "{}", run.messages);
    }
    let printed = |extra: &str| {
        bench.run(&format!(
            "conductance scene.toml --conductivity 50 --pressure 1e6 --gas 0.026{extra}"
        ))
    };
    let unsaid = printed("").messages;
    assert!(unsaid.contains("[gas-parameter]"), "{unsaid}");
    assert!(!run.messages.contains("--gas-parameter"), "{}", run.messages);
    bench.write(
        "soft.toml",
        include_str!("../../../asperity-inputs/examples/elastomer-on-glass.toml"),
    );
    let soft = bench.run("conductance soft.toml --conductivity 0.3 --pressure 100 --format csv");
    assert_eq!(cells(&soft.out, "model"), ["gw", "mikic"]);
    assert!(soft.messages.contains("[left-out]"), "{}", soft.messages);
    assert!(soft.messages.contains("[default-model]"), "{}", soft.messages);
    // The only one of the list is missed with its reason, also under --quiet.
    let alone =
        bench.run("conductance soft.toml --conductivity 0.3 --pressure 100 --model cmy --quiet");
    assert!(alone.code == Some(1) && alone.messages.contains("soft.toml"), "{}", alone.messages);
}

#[test]
fn sigma_and_slope_of_the_correlations_may_be_given_and_curves_are_drawn() {
    use asperity::joints::conductance::{GapRoughness, cooper_mikic_yovanovich};
    let bench = Bench::new();
    let asked = "conductance scene.toml --conductivity 50 --pressure 1e5:1e7:20:log --format csv";
    let run = bench.run(&format!(
        "{asked} --sigma 1.4um --mean-slope 0.14 --gas 0.026 --gas-parameter 0.37um --plot h.svg"
    ));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.messages.contains("[gap-roughness]"), "{}", run.messages);
    let roughness = GapRoughness { height_std: 1.4e-6, mean_slope: 0.14 };
    let wanted = cooper_mikic_yovanovich(50.0, &roughness, 1e5, 2e9).unwrap().conductance;
    let found = column_of(&run.out, "thermal_conductance_per_area_W_per_m2_per_K");
    assert!((found[20].unwrap() / wanted - 1.0).abs() < 1e-12, "{found:?} {wanted}");
    let picture = std::fs::read_to_string(bench.path("h.svg")).unwrap();
    let labels = [
        ">ke<",
        ">cmy, holds: yes<",
        ">mikic, holds: no<",
        ">total thermal conductance per area (W/(m² K))<",
    ];
    for label in labels {
        assert!(picture.contains(label), "{label}");
    }
    for wrong in ["--sigma 1um", "--sigma 1um --mean-slope -1", "--conductivity 45:200:2"] {
        assert_eq!(bench.run(&format!("{asked} {wrong}")).code, Some(2), "{wrong}");
    }
}

#[test]
fn unlikely_numbers_are_named_with_their_unit() {
    let bench = Bench::new();
    let asked =
        "conductance scene.toml --conductivity 50 --pressure 1MPa --model cmy,ke --format csv";
    let run = bench.run(&format!("{asked} --sigma 1um --mean-slope 14"));
    assert!(run.code == Some(2) && run.messages.contains("mean_slope"), "{}", run.messages);
    let run = bench.run(&format!("{asked} --conductivity 50000"));
    assert_eq!(run.code, Some(2), "given twice: {}", run.messages);
    let run = bench.run("conductance scene.toml --conductivity 50000 --pressure 1MPa");
    assert!(run.messages.contains("[unusual-size]"), "{}", run.messages);
    let run = bench.run(&format!("{asked} --sigma 1.4um --mean-slope 0.14 --gas 0.026"));
    assert!(run.messages.contains("[gap-roughness]"), "{}", run.messages);
    let run = bench.run(&format!("{asked} --sigma 1.4um --mean-slope 14% --gas 0.026"));
    assert!(!run.messages.contains("looks like"), "{}", run.messages);
}

#[test]
fn the_conductivities_of_two_bodies_may_be_given_and_a_missing_one_is_named() {
    let bench = Bench::new();
    let asked = "conductance scene.toml --pressure 1MPa --format csv";
    let two = bench.run(&format!("{asked} --conductivity 50,401"));
    assert_eq!(two.code, Some(0), "{}", two.messages);
    let mean = 2.0 * 50.0 * 401.0 / 451.0;
    let one = bench.data(&format!("{asked} --conductivity {mean}"));
    let value = |data: &str| column(data, "thermal_conductance_per_area_W_per_m2_per_K")[0];
    assert!((value(&two.out) / value(&one) - 1.0).abs() < 1e-12);
    for wrong in ["50,4,3", "50,-1", "0,5", "50:60:9"] {
        let run = bench.run(&format!("{asked} --conductivity {wrong}"));
        assert_eq!(run.code, Some(2), "{wrong}: {}", run.messages);
    }
    let run = bench.run("conductance scene.toml --pressure 1MPa");
    assert!(
        run.code == Some(1) && run.messages.contains("thermal_conductivity"),
        "{}",
        run.messages
    );
}
