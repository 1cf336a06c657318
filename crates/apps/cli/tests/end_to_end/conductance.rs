//! Conductances of contact radii, of correlations and of the gas in the gap.

use asperity::joints::conductance::{cooper_mikic_yovanovich, gap_conductance, mikic_elastic};

use crate::bench::{Bench, cells, column, column_of, conducting, csv};

const GAS: &str = "[gap]\ngas_conductivity = 0.026\ngas_parameter = \"0.37 um\"\n[options]\n";
const CONTACTS: &str = "thermal_conductance_per_area_W_per_m2_per_K";

#[test]
fn models_whose_contacts_are_no_circles_are_left_out_and_bodies_conduct() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let run = bench.run(
        "curve scene.toml --model all --separation 1 --quantity contact-radius-sum,thermal-conductance,electrical-conductance",
    );
    assert_eq!(run.code, Some(0), "{}", run.messages);
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
fn correlations_and_the_gas_stand_beside_the_models() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting().replace("[options]\n", GAS));
    let asked = "curve scene.toml --model ke,cmy,mikic --pressure 1e6,1e8 --format csv --quantity";
    let run = bench.run(&format!(
        "{asked} thermal-conductance-per-area,gap-conductance-per-area,joint-conductance-per-area"
    ));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let file = bench.scene("scene.toml");
    let (roughness, modulus) = (file.gap_roughness(), file.scene.interface.equivalent_modulus);
    let contacts = column_of(&run.out, CONTACTS);
    assert_eq!(cells(&run.out, "model"), ["ke", "ke", "cmy", "cmy", "mikic", "mikic"]);
    for (k, pressure) in [1e6, 1e8].into_iter().enumerate() {
        let cmy = cooper_mikic_yovanovich(50.0, &roughness, pressure, 2e9).unwrap();
        let mikic = mikic_elastic(50.0, &roughness, pressure, modulus).unwrap();
        let of = [contacts[2 + k], contacts[4 + k]];
        assert_eq!(of, [Some(cmy.conductance), Some(mikic.conductance)]);
    }
    // p/H is 0.05 at the second pressure, and the contacts are plastic.
    assert_eq!(run.messages.matches("warning[correlation]").count(), 2, "{}", run.messages);
    // The gas has the mean gap; correlations have none.
    let film = bench.data("curve scene.toml --model ke --pressure 1e6 --quantity area");
    let offset = file.scene.mean_plane_offset();
    let gap = column(&film, "separation_m")[0] + offset;
    let wanted = gap_conductance(0.026, gap, 0.37e-6).unwrap();
    let [gas, joint] = ["gap", "joint"]
        .map(|part| column_of(&run.out, &format!("{part}_conductance_per_area_W_per_m2_per_K")));
    assert!((gas[0].unwrap() / wanted - 1.0).abs() < 1e-9, "{gas:?} {wanted}");
    assert_eq!(joint[0], Some(contacts[0].unwrap() + gas[0].unwrap()));
    assert!(gas[2..].iter().chain(&joint[2..]).all(Option::is_none), "{gas:?} {joint:?}");
    // The bound has the error of the separation that carries the load.
    let of = |tolerance: &str| {
        let asked = "curve scene.toml --model ke --pressure 1e6 --errors --quantity";
        bench.data(&format!("{asked} gap-conductance-per-area --tolerance {tolerance}"))
    };
    let value = |data: &str| column(data, "gap_conductance_per_area_W_per_m2_per_K")[0];
    let (loose, fine) = (of("1e-4"), of("1e-12"));
    let bound = column(&loose, "gap_conductance_per_area_error")[0];
    assert!((value(&loose) / value(&fine) - 1.0).abs() <= bound && bound < 1e-3, "{loose}");
}

/// The mean gap of a pressed scan counts its contacts, through which no gas conducts.
#[test]
fn the_gas_in_a_pressed_scan_conducts_through_its_open_part() {
    let bench = crate::bem::bench();
    let scene = bench.read("scan.toml")
        + "
[gap]
gas_conductivity = 0.026
gas_parameter = 0
";
    bench.write("gas.toml", &scene);
    let curve = "curve gas.toml --model bem --pressure 4e8 --format csv --quantity";
    let gas = bench.data(&format!("{curve} gap-conductance-per-area"));
    let solved = bench.data("bem gas.toml --pressure 4e8 --format csv");
    let of = |head: &str| column(&solved, head)[0];
    let open = 1.0 - of("area_fraction_pixels");
    let wanted = open * gap_conductance(0.026, of("mean_open_gap_m"), 0.0).unwrap();
    let found = column(&gas, "gap_conductance_per_area_W_per_m2_per_K")[0];
    // Pixels in contact cover more than the contact, by part of its edge. Without the open share,
    // and in the mean gap, the gas conducts 1/open^2 times as much.
    assert!((0.0..0.04).contains(&(found / wanted - 1.0)) && open < 0.93, "{found} {wanted}");
}
