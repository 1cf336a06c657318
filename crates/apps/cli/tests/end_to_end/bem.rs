//! `bem`: the scan of a scene, pixel by pixel.

use asperity::bem::{BemOptions, Continuation, LoadCase};

use crate::bench::{Bench, cells, column};

/// A scene on `scan.txt`.
pub const SCAN: &str = "nominal_area = 3e-5
[interface]
equivalent_modulus = 116e9
poissons_ratio = 0.31
hardness = 5e9
[surface]
file = \"scan.txt\"
unit = \"um\"
pixel_size = 0.5
";

/// A seal of that scan.
const SEAL: &str = "
[seal]
width = \"100 mm\"
length = \"2 mm\"
upstream_pressure = \"10 bar\"
downstream_pressure = \"1 bar\"
gas = \"helium\"
";

/// A folder with that scene, that scan, and the scene of a seal.
pub fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("scan.toml", SCAN);
    bench.write("scan.txt", &crate::surface::scan(0.0));
    bench.write("seal.toml", &format!("{SCAN}{SEAL}"));
    bench
}

#[test]
fn rows_are_those_of_the_library() {
    let bench = bench();
    for (arguments, boundary, elastic) in [
        ("", None, false),
        ("--elastic", None, true),
        ("--elastic --boundary free", Some(Continuation::Free), true),
    ] {
        let arguments = format!("bem scan.toml --pressure 1e7,2e9,1e8 {arguments} --format csv");
        let data = bench.data(&arguments);
        let file = bench.scene("scan.toml");
        let elements = file.clone().pressing(BemOptions { boundary, elastic }).bem().unwrap();
        let elements = elements.elements(&file.scene.interface).unwrap();
        let given = [1e7, 2e9, 1e8].map(LoadCase::MeanPressure);
        let found = elements.solve_all(&given, |_| std::ops::ControlFlow::Continue(()));
        let found: Vec<_> = found.into_iter().map(Result::unwrap).collect();
        let of = |of: &dyn Fn(&asperity::bem::Solution) -> f64| found.iter().map(of).collect();
        let required: [(&str, Vec<f64>); 9] = [
            ("area_fraction", of(&|s| s.area)),
            ("area_fraction_pixels", of(&|s| s.pixel_area)),
            ("plastic_fraction", of(&|s| s.plastic_area)),
            ("mean_gap_m", of(&|s| s.mean_gap)),
            ("mean_open_gap_m", of(&|s| s.mean_open_gap.unwrap())),
            ("patches", of(&|s| s.patches.len() as f64)),
            ("iterations", of(&|s| s.iterations as f64)),
            ("residual", of(&|s| s.residual)),
            ("pressure_Pa", vec![1e7, 2e9, 1e8]),
        ];
        for (name, required) in required {
            assert_eq!(column(&data, name), required, "{arguments}: {name}");
        }
        let loads = column(&data, "load_N");
        for (load, required) in loads.iter().zip([300.0, 6e4, 3e3]) {
            assert!((load / required - 1.0).abs() < 1e-14, "{load}");
        }
    }
    let of = |arguments: &str| bench.data(&format!("bem scan.toml --format csv {arguments}"));
    assert_eq!(of("--load 3e3"), of("--pressure 1e8"));
}

#[test]
fn coarse_grids_have_a_warning_and_refine_adds_columns() {
    let bench = bench();
    let run = bench.run("bem scan.toml --pressure 1e6,1e7 --refine --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    for arguments in
        ["[periodic-part]", "[short-waves]", "[few-pixels]", "[few-patches]", "[few-pixels]"]
    {
        assert!(run.messages.contains(arguments), "{arguments}\n{}", run.messages);
    }
    assert!(!run.out.contains("iterations_half_grid") && !run.out.contains("residual_half_grid"));
    let [fine, half] = ["mean_gap_m", "mean_gap_m_half_grid"].map(|name| column(&run.out, name));
    assert!(fine.iter().zip(&half).all(|(a, b)| (1e-6..0.2).contains(&(a / b - 1.0_f64).abs())));
}

#[test]
fn pressures_are_written_and_drawn() {
    let bench = bench();
    bench.data("bem scan.toml --pressure 1e9 --map one.npy --picture one.svg");
    bench.data("bem scan.toml --pressure 1e9,2e9 --map two.npy --elastic");
    let read = |name: &str, shape: &str| {
        let bytes = std::fs::read(bench.path(name)).unwrap();
        let (head, data) = bytes[10..].split_at(usize::from(bytes[8]));
        assert!(bytes.starts_with(b"\x93NUMPY\x01\x00") && (10 + head.len()) % 64 == 0);
        let wanted = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(std::str::from_utf8(head).unwrap().trim_end(), wanted);
        let numbers =
            data.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()));
        numbers.collect::<Vec<f64>>()
    };
    let one = read("one.npy", "(96, 96)");
    assert_eq!(one.len(), 96 * 96);
    let mean = |map: &[f64]| map.iter().sum::<f64>() / map.len() as f64;
    assert!((mean(&one) / 1e9 - 1.0).abs() < 1e-9 && one.iter().all(|p| (0.0..=5e9).contains(p)));
    let two = read("two.npy", "(2, 96, 96)");
    assert_eq!(two.len(), 2 * 96 * 96);
    for (map, pressure) in two.chunks(96 * 96).zip([1e9, 2e9]) {
        assert!((mean(map) / pressure - 1.0).abs() < 1e-9);
    }
    let svg = bench.read("one.svg");
    let pixels = bench.run("bem scan.toml --pressure 1e9 --picture one.PNG");
    assert!(!pixels.results().is_empty(), "{}", pixels.messages);
    let png = std::fs::read(bench.path("one.PNG")).unwrap();
    assert!(png.starts_with(b"\x89PNG\r\n"));
    for arguments in
        ["pressure (GPa)", ">10 µm<", "white: no contact", "Black is plastic", "data:image/png"]
    {
        assert!(svg.contains(arguments), "{arguments}");
    }
}

#[test]
fn bem_is_a_model_by_name() {
    let arguments = "curve scan.toml --model gw,bem --reference bem --pressure 1e8,1e9";
    let data =
        bench().data(&format!("{arguments} --quantity area-fraction,mean-pressure --format csv"));
    let deviations = column(&data, "area_fraction_deviation");
    assert_eq!(cells(&data, "model"), ["gw", "bem", "gw", "bem"]);
    assert!(deviations[0].abs() > 0.01 && deviations[1].abs() <= 0.0, "{data}");
    assert!(column(&data, "separation_m").iter().all(|separation| separation.abs() < 1e-5));
}

/// The slope of loading is the same in all commands.
#[test]
fn the_tangent_of_bem_is_the_stiffness_of_truth() {
    let bench = bench();
    let truth = bench.data("bem --compare scan.toml --pressure 1e8 --model gw --format csv");
    let truth = column(&truth, "stiffness_N_per_m")[0];
    let curve = bench.data("curve scan.toml --model bem --pressure 1e8 --quantity tangent");
    let bem = "bem scan.toml --pressure 1e8 --quantity tangent,stiffness --format csv";
    let bem = bench.data(bem);
    for tangent in [
        column(&curve, "tangent_N_per_m")[0],
        column(&bem, "tangent_N_per_m")[0],
        column(&bem, "stiffness_N_per_m")[0],
    ] {
        assert!((tangent / truth - 1.0).abs() < 1e-4, "{tangent} {truth}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_list_keeps_the_solved_loads() {
    let bench = bench();
    let arguments = "bem scan.toml --boundary free --pressure 1e6:2e9:5000 --format csv";
    let run = bench.interrupted(arguments);
    assert_eq!(run.code, Some(130), "{}", run.messages);
    let areas = cells(&run.out, "area_fraction");
    assert!(!areas.is_empty() && areas.len() < 5000 && areas.iter().all(|a| !a.is_empty()));
    assert!(run.messages.contains(&format!("{} of 5000", areas.len())), "{}", run.messages);
    // From the greatest load down.
    assert_eq!(column(&run.out, "pressure_Pa").last(), Some(&2e9));
}
