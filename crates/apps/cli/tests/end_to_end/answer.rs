//! `asperity answer`: the same numbers as the model `best` of other commands.

use asperity::{At, Compared, Tolerance};

use crate::bench::{Bench, cells};

/// That every way to an answer has these digits on all examples is tested beside the page.
#[test]
fn the_commands_pass_on_the_digits_of_the_library() {
    let bench = Bench::new();
    for name in ["lapped-seal", "ground-steel"] {
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../answer/scene/examples");
        std::fs::copy(format!("{examples}/{name}.toml"), bench.path(&format!("{name}.toml")))
            .unwrap();
        let file = bench.scene(&format!("{name}.toml"));
        let best = file.best().on(&file.scene, Tolerance::default()).unwrap();
        let known = best.known(Compared::Stiffness, At::Pressure(3e6)).unwrap();
        let [lower, upper] = known.ends.unwrap();
        let numbers = [("", known.value), ("_lower", lower), ("_upper", upper)];
        for command in ["answer", "curve --model best"] {
            let asked = "--pressure 3e6 --quantity tangent --format csv";
            let data = bench.data(&format!("{command} {name}.toml {asked}"));
            for (end, wanted) in numbers {
                let found = cells(&data, &format!("tangent{end}_N_per_m"));
                assert_eq!(found, [asperity::shortest_digits(wanted)], "{command} {name} {end}");
            }
        }
    }
    // Beyond all that was solved, and between.
    let table =
        "export ground-steel.toml --model best --as csv --pressure 1e-3:2e9 --max-error 3e-3";
    let data = bench.data(table);
    let pressures = cells(&data, "pressure_Pa");
    let numbers = pressures.iter().map(|cell| cell.parse::<f64>().unwrap());
    assert!(numbers.is_sorted_by(|a, b| a > b) && pressures.len() > 9, "{pressures:?}");
}
