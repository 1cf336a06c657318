//! `asperity answer`: the same numbers as the model `best` of other commands.

use asperity::{At, Compared, Tolerance};

use crate::bench::{Bench, cells, column};

/// The example scenes.
const EXAMPLES: [&str; 6] =
    ["bolted-joint", "elastomer-on-glass", "ground-steel", "lapped-seal", "wheel-rail", "worn-pin"];

fn examples() -> Bench {
    let bench = Bench::new();
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../answer/scene/examples");
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        std::fs::copy(&path, bench.path(path.file_name().unwrap().to_str().unwrap())).unwrap();
    }
    bench
}

/// `answer`, `curve --model best`, `export --model best` and the library have one number, to the
/// last digit; the page compares its own with that of the library.
#[test]
fn every_way_to_an_answer_gives_the_same_digits() {
    let bench = examples();
    let quantities = "area,tangent,unloading-stiffness";
    for name in EXAMPLES {
        let loads = "1e5,3e6";
        let answer = bench.data(&format!(
            "answer {name}.toml --pressure {loads} --quantity {quantities} --format csv"
        ));
        let curve = bench.data(&format!(
            "curve {name}.toml --model best,gw --pressure {loads} --quantity {quantities} --format csv"
        ));
        let file = bench.scene(&format!("{name}.toml"));
        let best = file.best().on(&file.scene, Tolerance::default()).unwrap();
        for (head, of, unit) in [
            ("area", Compared::Area, file.scene.nominal_area),
            ("tangent", Compared::Stiffness, 1.0),
            ("unloading_stiffness", Compared::UnloadingStiffness, 1.0),
        ] {
            let units = if head == "area" { "m2" } else { "N_per_m" };
            let ends = ["", "_lower", "_upper"].map(|end| format!("{head}{end}_{units}"));
            for (k, column) in ends.iter().enumerate() {
                let [answered, drawn] = [&answer, &curve].map(|text| cells(text, column));
                assert_eq!(answered, drawn[..2], "{name} {column}");
                for (pressure, cell) in [1e5, 3e6].into_iter().zip(&answered) {
                    // None where no contact carries so much.
                    let known = best.known(of, At::Pressure(pressure)).ok();
                    let wanted = known.and_then(|known| match k {
                        0 => Some(known.value),
                        end => Some(known.ends?[end - 1]),
                    });
                    let wanted = wanted.map(|x| asperity::shortest_digits(x * unit));
                    assert_eq!(*cell, wanted.unwrap_or_default(), "{name} {column}");
                }
            }
        }
    }
    // A table begins and ends at the loads, and has their tangents.
    let ask = "--as csv --pressure 1e6:1e7:2";
    let table = bench.data(&format!("export ground-steel.toml --model best {ask}"));
    let table: Vec<Vec<f64>> = table
        .lines()
        .filter_map(|line| line.split(',').map(|cell| cell.parse().ok()).collect())
        .collect();
    let curve =
        "curve ground-steel.toml --model best --pressure 1e7,1e6 --quantity tangent --format csv";
    let curve = bench.data(curve);
    for (row, (separation, tangent)) in table
        .iter()
        .zip(column(&curve, "separation_m").into_iter().zip(column(&curve, "tangent_N_per_m")))
    {
        assert!((row[0] / separation - 1.0).abs() < 1e-12, "{row:?} {separation}");
        assert!((row[2] * 1e-4 / tangent - 1.0).abs() < 1e-8, "{row:?} {tangent}");
    }
    assert_eq!(table.len(), 2);
    let apart = bench.run("export ground-steel.toml --model best --as csv --pressure 1e-3:1e7:9");
    assert!(
        apart.code == Some(1) && apart.messages.contains("evidence ends"),
        "{}",
        apart.messages
    );
}
