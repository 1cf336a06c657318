//! `curve`: the output agrees with the library.

use asperity::{At, ContactModel, Model, Quantity, Request};

use crate::bench::{Bench, NEGATIVE, NO_SHEAR, cells, column, conducting, csv};

#[test]
fn the_default_is_best_and_the_nearest_model_at_401_separations() {
    let bench = Bench::new();
    let data = bench.data("curve scene.toml --quantity force,area");
    let models: Vec<_> = cells(&data, "model").into_iter().step_by(401).collect();
    assert_eq!(models, ["best", "jg"]);
    let data = bench.data("curve scene.toml --model all");
    let (head, rows) = csv(&data);
    assert_eq!(
        head,
        ["model", "separation_over_sigma", "separation_m", "force_N", "area_m2", "tangent_N_per_m"]
    );
    assert_eq!(rows.len(), 9 * 401);
    assert_eq!(rows[0][..2], ["gw", "0"]);
    assert_eq!(rows[9 * 401 - 1][..2], ["at", "4"]);
}

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
fn all_quantities_and_their_errors_have_columns() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let all: Vec<Quantity> =
        Quantity::ALL.into_iter().filter(|quantity| quantity.is_of_models()).collect();
    let names: Vec<String> = all.iter().map(ToString::to_string).collect();
    let arguments = format!(
        "curve scene.toml --model ke,jg --errors --separation -1,2.5 --quantity {}",
        names.join(",")
    );
    let data = bench.data(&arguments);
    let (head, rows) = csv(&data);
    let columns: Vec<String> = all.iter().map(|quantity| quantity.column()).collect();
    let errors: Vec<String> =
        names.iter().map(|name| format!("{}_error", name.replace('-', "_"))).collect();
    assert_eq!(head[3..], [columns, errors.clone()].concat());
    assert_eq!(rows.len(), 4);
    let scene = bench.scene("scene.toml").scene;
    let request = Request::new(all.clone()).at([2.5]);
    let answer = "ke".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
    for (quantity, error) in all.into_iter().zip(&errors) {
        let printed = column(&data, &quantity.column())[1];
        let value = answer.values(quantity).unwrap()[0];
        // Few places and many may be integrated in different ways.
        assert!((printed - value).abs() <= 1e-9 * value.abs(), "{quantity}");
        assert!(column(&data, error)[1] < 1e-8, "{error}");
    }
}

#[test]
fn lists_may_be_repeated_or_joined() {
    let bench = Bench::new();
    let joined =
        bench.data("curve scene.toml --model gw,ke --quantity force,area --separation 1,2");
    let repeated = bench.data(
        "curve --model gw --separation 1 --quantity force scene.toml --quantity area --model ke --separation 2",
    );
    assert_eq!(joined, repeated);
    assert_eq!(joined.lines().count(), 5);
    let asked = "curve scene.toml --model ke --quantity area --load";
    assert_eq!(bench.data(&format!("{asked} 1,5e2")), bench.data(&format!("{asked} 1,500")));
    let by_default = bench.data("curve scene.toml --separation 2");
    assert_eq!(cells(&by_default, "model"), ["best", "jg"]);
    let all = bench.data("curve scene.toml --separation 2 --model all");
    assert_eq!(cells(&all, "model").len(), 9);
}

/// Rows of several scenes are those of each, below each other.
#[test]
fn several_scenes_stand_in_one_table_and_one_picture() {
    let bench = Bench::new();
    bench.write("soft.toml", NEGATIVE);
    let ask = "--model best,ke --load 1,10 --per-area --film-columns";
    let run = bench.run(&format!("curve scene.toml soft.toml {ask} --plot p.svg"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "scene"), [["scene.toml"; 4], ["soft.toml"; 4]].concat());
    for (k, name) in ["scene.toml", "soft.toml"].into_iter().enumerate() {
        let own = bench.data(&format!("curve {name} {ask}"));
        for head in csv(&own).0 {
            assert_eq!(cells(&run.out, head)[4 * k..4 * k + 4], cells(&own, head), "{head}");
        }
        let [area, whole] = [bench.scene(name).scene.nominal_area, 1.0];
        let [each, all] = ["tangent_per_area_N_per_m3", "tangent_N_per_m"].map(|c| column(&own, c));
        assert!(each.iter().zip(all).all(|(each, all)| (each * area / all - whole).abs() < 1e-15));
        let films = column(&own, "film_m");
        let at_films = bench.data(&format!("curve {name} --model ke --film {}", films[2]));
        assert!((column(&at_films, "force_N")[0] - 1.0).abs() < 1e-8, "{at_films}");
    }
    let svg = bench.read("p.svg");
    assert_eq!(svg.matches(">ke, scene: soft.toml</text>").count(), 1, "{svg}");
    // Its head stands above the messages about each.
    let heads: Vec<&str> = run.messages.lines().filter(|line| line.ends_with(".toml:")).collect();
    assert_eq!(heads, ["scene.toml:", "soft.toml:"]);
    // Columns that one of them has are blank in the other, and its values follow the scene.
    let varied =
        bench.data("curve soft.toml scene.toml --model ke --vary hardness=1GPa,2GPa --load 1");
    assert_eq!(csv(&varied).0[..3], ["model", "scene", "hardness_Pa"]);
    assert_eq!(cells(&varied, "model").len(), 4);
    let refused = bench.run("curve scene.toml soft.toml --plan");
    assert_eq!(refused.code, Some(2));
}

#[test]
fn negative_numbers_follow_a_blank_or_an_equals_sign() {
    let bench = Bench::new();
    for flag in ["--separation -1:4:11", "--separation=-1:4:11"] {
        let data = bench.data(&format!("curve scene.toml --model gw {flag}"));
        assert_eq!(column(&data, "separation_over_sigma")[..2], [-1.0, -0.5]);
    }
    let data = bench.data("curve --separation -.5,2e-1 --model gw scene.toml");
    assert_eq!(column(&data, "separation_over_sigma"), [-0.5, 0.2]);
}

#[test]
fn separations_from_the_mean_plane_are_printed_as_given() {
    let bench = Bench::new();
    bench.write("plane.toml", &format!("{NO_SHEAR}separation_from = \"surface-mean\"\n"));
    bench.write("asperities.toml", NO_SHEAR);
    let offset = bench.scene("asperities.toml").scene.surface.mean_plane_offset() / 1e-6;
    let plane = bench.data("curve plane.toml --model ke --separation 3");
    let same =
        bench.data(&format!("curve asperities.toml --model ke --separation {}", 3.0 - offset));
    assert_eq!(column(&plane, "separation_over_sigma"), [3.0]);
    let (a, b) = (column(&plane, "force_N")[0], column(&same, "force_N")[0]);
    assert!(offset > 0.5 && (a / b - 1.0).abs() < 1e-12, "{offset}: {a} {b}");
    let solved = bench.data(&format!("curve plane.toml --model ke --load {a}"));
    assert!((column(&solved, "separation_over_sigma")[0] - 3.0).abs() < 1e-9, "{solved}");
}

#[test]
fn json_and_table_agree_with_the_csv() {
    let bench = Bench::new();
    let arguments =
        "curve scene.toml --model gw,at --separation 0:40:3 --quantity force,mean-pressure";
    let data = bench.data(arguments);
    let json: serde_json::Value =
        serde_json::from_str(&bench.data(&format!("{arguments} --format json"))).unwrap();
    let rows = json.as_array().unwrap();
    for name in ["separation_m", "force_N", "mean_pressure_Pa"] {
        let numbers: Vec<f64> = rows.iter().map(|row| row[name].as_f64().unwrap()).collect();
        assert_eq!(numbers, column(&data, name));
    }
    assert_eq!(rows[3]["model"], "at");
    let table = bench.data(&format!("{arguments} --format table"));
    assert_eq!(table.lines().count(), data.lines().count());
    assert!(table.starts_with("model  separation_over_sigma  separation_m"), "{table}");
}

#[test]
fn plots_have_a_curve_for_every_model_and_finite_numbers_only() {
    let bench = Bench::new();
    bench.write("scene.toml", NEGATIVE);
    bench.data(
        "curve scene.toml --model all --quantity force,plastic-share,ln-area --separation -2:9:50 --plot p.svg --output out.csv",
    );
    let svg = bench.read("p.svg");
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"));
    for model in Model::usual() {
        assert_eq!(svg.matches(&format!(">{}</text>", model.id())).count(), 1, "{model}");
    }
    assert!(svg.matches("<polyline").count() >= (3 + 1) * 9);
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
    assert!(svg.contains(": force of at."));
    assert_eq!(bench.read("out.csv").lines().count(), 1 + 9 * 50);
}

#[test]
fn loads_and_pressures_are_places_like_separations() {
    let bench = Bench::new();
    let data = bench.data("curve scene.toml --model gw,ke --load 10:1000:3:log");
    let (head, rows) = csv(&data);
    assert_eq!(
        head.join(","),
        "model,load_N,pressure_Pa,separation_over_sigma,separation_m,area_m2,tangent_N_per_m"
    );
    let loads = column(&data, "load_N");
    assert_eq!((rows.len(), loads[0], loads[2], loads[5]), (6, 10.0, 1000.0, 1000.0));
    assert!((loads[1] - 100.0).abs() < 1e-12);
    // There and back.
    let separations = cells(&data, "separation_over_sigma");
    for (model, k) in [("gw", 0), ("ke", 3)] {
        let places = separations[k..k + 3].join(",");
        let back = bench.data(&format!("curve scene.toml --model {model} --separation {places}"));
        for name in ["area_m2", "tangent_N_per_m"] {
            let (there, back) = (column(&data, name), column(&back, name));
            for (a, b) in there[k..].iter().zip(&back) {
                assert!((a / b - 1.0).abs() < 1e-9, "{model} {name}: {a} {b}");
            }
        }
        for (load, force) in loads[k..].iter().zip(column(&back, "force_N")) {
            assert!((force / load - 1.0).abs() < 1e-9, "{model}: {load} {force}");
        }
    }
    // 1e-4 m2 of nominal area; what was given is printed as given.
    let pressures = bench.data("curve scene.toml --model ke --pressure 1e5 --pressure 0.3,7e6");
    assert_eq!(column(&pressures, "pressure_Pa"), [1e5, 0.3, 7e6]);
    assert_eq!(cells(&pressures, "load_N")[0], "10");
    assert_eq!(cells(&pressures, "area_m2")[0], cells(&data, "area_m2")[3]);
    let asked = bench.data("curve scene.toml --model ke --pressure 1e5 --quantity pressure,force");
    let head = csv(&asked).0.join(",");
    assert_eq!(head, "model,load_N,separation_over_sigma,separation_m,pressure_Pa,force_N");
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
