//! Conductance of the gas in the gap.

use asperity::joints::conductance::gap_conductance;

use crate::bench::{Bench, column, conducting};

const HEAD: &str = "gap_conductance_per_area_W_per_m2_per_K";

/// Of the separation that carries the load.
#[test]
fn the_bound_has_the_error_of_the_gap() {
    let bench = Bench::new();
    let gas = "[gap]\ngas_conductivity = 0.026\ngas_parameter = \"0.37 um\"\n[options]\n";
    bench.write("scene.toml", &conducting().replace("[options]\n", gas));
    let [loose, fine] = ["1e-4", "1e-12"].map(|tolerance| {
        let asked = "curve scene.toml --model ke --pressure 1e6 --errors --quantity";
        bench.data(&format!("{asked} gap-conductance-per-area --tolerance {tolerance}"))
    });
    let [value, exact] = [&loose, &fine].map(|data| column(data, HEAD)[0]);
    let bound = column(&loose, "gap_conductance_per_area_error")[0];
    assert!((value / exact - 1.0).abs() <= bound && bound < 1e-3, "{loose}");
}

/// The mean gap of a pressed scan counts its contacts, through which no gas conducts.
#[test]
fn the_gas_in_a_pressed_scan_conducts_through_its_open_part() {
    let bench = crate::bem::bench();
    let gas = "[gap]\ngas_conductivity = 0.026\ngas_parameter = 0\n";
    let scene = bench.read("scan.toml") + gas;
    bench.write("gas.toml", &scene);
    let curve = "curve gas.toml --model bem --pressure 4e8 --format csv --quantity";
    let gas = bench.data(&format!("{curve} gap-conductance-per-area"));
    let solved = bench.data("bem gas.toml --pressure 4e8 --format csv");
    let of = |head: &str| column(&solved, head)[0];
    let open = 1.0 - of("area_fraction_pixels");
    let wanted = open * gap_conductance(0.026, of("mean_open_gap_m"), 0.0).unwrap();
    let found = column(&gas, HEAD)[0];
    // Pixels in contact cover more than the contact, by part of its edge. Without the open share,
    // and in the mean gap, the gas conducts 1/open^2 times as much.
    assert!((0.0..0.04).contains(&(found / wanted - 1.0)) && open < 0.93, "{found} {wanted}");
}
