//! Two rough surfaces whose asperities meet.

use crate::bench::{Bench, column};

/// Two like surfaces by moments, the second one named or not.
fn by_moments(bench: &Bench) {
    let one = "m0 = 3.43e-13\nm2 = 5.658e-3\nm4 = 1.57e9\n";
    let text = format!(
        "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\npoissons_ratio = 0.3\n\
         hardness = 6e9\n[surface]\n{one}"
    );
    let gas = "[gap]\ngas_conductivity = 0.026\ngas_parameter = 0.37e-6\n";
    bench.write("alone.toml", &format!("{text}{gas}"));
    let both = format!("{text}counterface = {{ {} }}\n", one.trim().replace('\n', ", "));
    bench.write("both.toml", &format!("{both}{gas}"));
}

/// Mean planes 2.684 um apart: the sum of the asperities' offsets, and of their heights, by hand.
#[test]
fn the_gap_of_a_pair_is_one_for_its_film_its_gas_and_its_joint() {
    let bench = Bench::new();
    by_moments(&bench);
    let [m2, m4]: [f64; 2] = [5.658e-3, 1.57e9];
    let offset = 2.0 * 4.0 * m2 / (std::f64::consts::PI * m4).sqrt();
    for scene in ["alone", "both"] {
        let curve = bench.data(&format!("curve {scene}.toml --model ke-pairs --pressure 1MPa"));
        let of = |name: &str| column(&curve, name)[0];
        let film = of("separation_m") + offset;
        assert!((film / 2.684e-6 - 1.0).abs() < 1e-4, "{curve}");
        let asked = "--model ke-pairs --pressure 1MPa --quantity gap-conductance-per-area";
        let gas = bench.data(&format!("curve {scene}.toml {asked}"));
        let gas = column(&gas, "gap_conductance_per_area_W_per_m2_per_K")[0];
        assert!((gas / 8513.0 - 1.0).abs() < 1e-4, "{gas}");
        assert!((gas / (0.026 / (film + 0.37e-6)) - 1.0).abs() < 1e-9, "{gas} {film}");
        let back =
            format!("curve {scene}.toml --model ke-pairs --film 2.684um --quantity pressure");
        assert!((column(&bench.data(&back), "pressure_Pa")[0] / 1e6 - 1.0).abs() < 1e-4);
        // A retreat counts in the same unit as the separation.
        let joint = format!("joint {scene}.toml --model ke-pairs --pressure 1MPa --retreat 0.1");
        let found = column(&bench.data(&joint), "separation_over_sigma")[0];
        assert!((found - of("separation_over_sigma") - 0.1).abs() < 1e-9, "{found} {curve}");
        assert!((found - 2.6308).abs() < 5e-5, "{found}");
        // The factors of flow are at the same film: two like surfaces have no shear factor.
        let asked = "--film 2.684um --quantity shear-flow-factor,pressure-flow-factor-x";
        let flow = bench.data(&format!("curve {scene}.toml --model ke-pairs {asked}"));
        let lambda = column(&flow, "lambda")[0];
        let shear = column(&flow, "shear_flow_factor")[0];
        let along = column(&flow, "pressure_flow_factor_x")[0];
        assert!(shear.abs() < 1e-15, "{flow}");
        assert!((along - (1.0 - 0.9 * (-0.56 * lambda).exp())).abs() < 1e-12, "{flow}");
    }
}

/// What a film code computes from the three numbers, by the closed form of Greenwood & Tripp.
#[test]
fn the_head_of_a_film_table_says_what_a_code_must_use() {
    let bench = Bench::new();
    bench.write(
        "pair.toml",
        "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 118e9\npoissons_ratio = 0.3\n\
         hardness = 3e9\n[surface]\nasperity_radius = 1e-4\nasperity_density = 8e8\n\
         asperity_height_std = 5e-7\n",
    );
    let table = bench.data("export pair.toml --model gw-pairs --as film --lambda 1:3:3");
    let number = |name: &str| -> f64 {
        let start = table.find(&format!("{name} = ")).unwrap() + name.len() + 3;
        table[start..].split([' ', ',', ':']).next().unwrap().parse().unwrap()
    };
    // √2 times the σ of one surface, which `check` gives.
    let surface = 5e-7f64.hypot(3.716_97e-4f64.sqrt() / 8e4);
    assert!((number("sigma") / (2f64.sqrt() * surface) - 1.0).abs() < 1e-5, "{table}");
    assert!((number("sigma") - 7.85e-7).abs() < 5e-10, "{table}");
    let [eta, beta, sigma, offset, e] =
        ["eta", "beta", "sigma_z", "offset", "modulus E"].map(number);
    assert!((offset / (2.0 * 0.045_944_074 / (eta * beta)) - 1.0).abs() < 1e-5, "{table}");
    for (film, wanted) in column(&table, "film_m").into_iter().zip(column(&table, "pressure_Pa")) {
        let s = (film - offset) / sigma;
        let step = 1e-4;
        let term = |k: u32| {
            let x = (f64::from(k) + 0.5) * step;
            x.powf(2.5) * (-0.5 * (s + x).powi(2)).exp() * step
        };
        let f = (0..100_000).map(term).sum::<f64>() / (2.0 * std::f64::consts::PI).sqrt();
        let rough = (eta * beta * sigma).powi(2) * (sigma / beta).sqrt();
        let found = 16.0 * 2f64.sqrt() * std::f64::consts::PI / 15.0 * rough * e * f;
        assert!((found / wanted - 1.0).abs() < 1e-4, "{film}: {found} {wanted}");
    }
    // σ of the table, and the film of its λ.
    let film = column(&table, "film_m")[1];
    assert!((film / (2.0 * number("sigma")) - 1.0).abs() < 1e-5, "{table}");
    let check = bench.data("check pair.toml --model gw-pairs --load 1 --format csv");
    let of = |name: &str| -> f64 {
        let row = check.lines().find(|row| row.starts_with(&format!("{name},"))).unwrap();
        row.split(',').nth(1).unwrap().parse().unwrap()
    };
    let near = |found: f64, wanted: f64| assert!((found / wanted - 1.0).abs() < 1e-4, "{found}");
    near(of("surface_height_std"), 5.5505e-7);
    near(of("pair_surface_height_std"), 7.8495e-7);
    near(of("pair_asperity_height_std"), 5e-7 * 2f64.sqrt());
    near(of("pair_mean_plane_offset"), 1.148_6e-6);
    // β and ψ of one surface: a contact of both has half the radius and w_c.
    near(of("roughness_parameter"), 0.04);
    near(of("plasticity_index"), (5e-7 / (2.0 * of("critical_interference"))).sqrt());
}
