//! `curve`: the output agrees with the library.

use asperity::{At, ContactModel, Model, Quantity, Request};

use crate::bench::{Bench, column};

#[test]
fn every_digit_agrees_with_the_library() {
    let bench = Bench::new();
    let scene = bench.scene("scene.toml").scene;
    let quantities = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let tolerance = asperity::Tolerance::new(1e-12).unwrap();
    for (arguments, at) in [
        ("--separation -1:3:3", [-1.0, 1.0, 3.0].map(At::sigmas)),
        ("--load 0.1,1,10 --quantity force,area,tangent", [0.1, 1.0, 10.0].map(At::Load)),
    ] {
        let data =
            bench.data(&format!("curve scene.toml --model jg --tolerance 1e-12 {arguments}"));
        let request = Request::new(quantities).at(at).within(tolerance);
        let answer = "jg".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
        for quantity in quantities {
            let printed = column(&data, &quantity.column());
            let computed = answer.values(quantity).unwrap();
            assert!(printed.iter().zip(computed).all(|(a, b)| a.to_bits() == b.to_bits()));
        }
    }
}

#[test]
fn a_load_is_the_abscissa_of_its_picture() {
    let bench = Bench::new();
    for (arguments, label) in [
        ("--load 1:100:20:log", ">load (N)<"),
        ("--load 1:100:20", ">load (N)<"),
        ("--load 1.0,1e30", ">load (N)<"),
        ("--pressure 1e4,1e5,1e6", ">pressure (Pa)<"),
        ("--pressure 1e4,1e5,1e6 --quantity pressure", ">pressure (Pa)<"),
        ("--separation 1um,2um", " heights (µm)<"),
        ("--separation 2,1,3", " heights (σ"),
    ] {
        bench.data(&format!("curve scene.toml --model gw,ke {arguments} --plot p.svg"));
        let svg = bench.read("p.svg");
        assert!(svg.contains(label), "{arguments}");
        assert!(svg.contains(">ke</text>") && !svg.contains("NaN"), "{arguments}");
    }
    let data = bench.data("curve scene.toml --model ke --load 1,10 --output l.csv --plot -");
    assert!(data.starts_with("<svg ") && bench.read("l.csv").contains("load_N"));
}

#[test]
fn measured_points_stand_over_the_curves_of_their_quantities() {
    let bench = Bench::new();
    bench.write("points.csv", "pressure_Pa,area_m2\n1e6,1e-7\n3e6,3e-7\n1e7,\n");
    // At loads, the places of the file give the axis.
    let asked = "curve scene.toml --model ke --load 1:1000:9:log --quantity area,tangent";
    let run = bench.run(&format!("{asked} --plot p.svg --data points.csv"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let svg = bench.read("p.svg");
    assert!(svg.contains(">pressure (Pa)<") && svg.contains(">measured<"), "{svg}");
    // Crosses: two points and the key of the legend, each with its rim.
    assert_eq!(svg.matches("d=\"M-3.6 -3.6L3.6 3.6M-3.6 3.6L3.6 -3.6\"").count(), 2 * 3);
}

#[test]
fn a_format_follows_the_ending_and_a_failing_file_leaves_no_plot() {
    let bench = Bench::new();
    let line = "curve scene.toml --model ke --load 5,10";
    assert_eq!(bench.run(&format!("{line} --output a.json")).code, Some(0));
    let rows: serde_json::Value = serde_json::from_str(&bench.read("a.json")).unwrap();
    assert_eq!(rows[1]["load_N"], 10.0);
    assert_eq!(bench.run(&format!("{line} --format table --output a.csv")).code, Some(0));
    assert!(bench.read("a.csv").starts_with("model,load_N,"));
    let failing = bench.run(&format!("{line} --output missing/a.csv --plot a.svg"));
    assert!(failing.code == Some(1) && !bench.path("a.svg").exists(), "{}", failing.messages);
}
