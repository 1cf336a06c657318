//! `asperity answer`: the same numbers as the model `best` of other commands.

use asperity::{At, Best, Compared, Model, Quantity, Tolerance};
use asperity_answer::Answer;

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

#[test]
fn an_answer_has_ten_lines_with_values_between_limits() {
    let bench = examples();
    let text = bench.data("answer bolted-joint.toml --load 20kN");
    assert!(text.lines().count() <= 12, "{text}");
    for part in ["real area, share of the nominal", "first-loading stiffness", "mean gap", "by  "] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let file = bench.scene("bolted-joint.toml");
    let asked = Answer::new(&file, &[], [At::Load(2e4)], Tolerance::default());
    let mut sheet = asperity_answer::Sheet::default();
    let basis = asked.answer(&file, &mut sheet).unwrap();
    assert!(basis.by.contains("nine of ten surfaces of this spectrum"), "{}", basis.by);
    assert!(basis.also.contains("not valid here: gw"), "{}", basis.also);
    assert!(asked.request.quantities.contains(&Quantity::ThermalConductancePerArea));
    // Every model with its deviation, the answer first.
    let all = bench.data("answer bolted-joint.toml --load 20kN --quantity area --all --format csv");
    assert_eq!(cells(&all, "model")[0], Best::<Model>::ID);
    assert!(cells(&all, "model").contains(&"zmc"));
    assert!(column(&all, "area_deviation")[0].abs() < 1e-15, "{all}");
}

#[test]
fn what_was_solved_answers_only_where_it_is_asked_for() {
    let bench = crate::bem::bench();
    let ask = "answer scan.toml --pressure 3e8 --quantity area-fraction --format csv";
    let [without, with] = [ask.into(), format!("{ask} --solve")].map(|line| bench.data(&line));
    let solved = bench.data("bem scan.toml --pressure 3e8 --format csv");
    let curve = "curve scan.toml --solve --per-area --model best --pressure 1e8,3e8 --quantity area-fraction,tangent";
    let curve = bench.data(curve);
    assert_eq!(cells(&curve, "area_fraction")[1], cells(&with, "area_fraction")[0]);
    // The tables of a solver likewise, and those of boundary elements alone.
    for model in ["best --solve", "bem"] {
        let ask = format!("export scan.toml --model {model} --as csv --pressure 1e8,3e8");
        let table = bench.data(&ask);
        assert!(table.contains("no bound of the error is known"), "{table}");
        let rows = table.lines().filter(|line| !line.starts_with('#')).skip(1);
        let rows: Vec<Vec<f64>> =
            rows.map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
        let [gaps, tangents] =
            ["separation_m", "tangent_per_area_N_per_m3"].map(|name| column(&curve, name));
        for (row, k) in rows.iter().zip([1, 0]) {
            for (found, wanted) in [(row[0], gaps[k]), (row[2], tangents[k])] {
                assert!((found / wanted - 1.0).abs() < 1e-8, "{model}: {found} {wanted}");
            }
        }
    }
    let run = bench.run("export scan.toml --model bem --as csv --pressure 1e8:3e8:3");
    assert!(run.code == Some(1) && run.messages.contains("list of loads"), "{}", run.messages);
    let [without, with, solved] =
        [without, with, solved].map(|text| column(&text, "area_fraction")[0]);
    assert!((with / solved - 1.0).abs() < 1e-12, "{with} {solved}");
    assert!((without / solved - 1.0).abs() > 1e-6, "{without} {solved}");
}

#[test]
fn a_fit_refuses_the_answer_with_the_reason() {
    let bench = Bench::new();
    let run =
        bench.run("fit scene.toml --free hardness --load 1 --target area_fraction=1% --model best");
    assert!(run.code != Some(0) && run.messages.contains("best"), "{}", run.messages);
}
