//! `--corrected`: models divided by their expected ratio to boundary elements.

use crate::bench::{Bench, cells};

#[test]
fn corrected_models_have_intervals_and_reasons_for_blanks() {
    let bench = Bench::new();
    let arguments =
        "curve scene.toml --model ke,jg --pressure 1e6,1e7,1e11 --corrected --format csv";
    let run = bench.run(&format!("{arguments} --quantity area,contacts"));
    // At 1e11 Pa models need more than the nominal area.
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let models: Vec<_> = cells(&run.out, "model").into_iter().step_by(3).collect();
    assert_eq!(models, ["ke", "ke-corrected", "jg", "jg-corrected"]);
    for names in [
        ["area_m2", "area_lower_m2", "area_upper_m2"],
        ["separation_m", "separation_lower_m", "separation_upper_m"],
    ] {
        let [value, lower, upper] = names.map(|name| cells(&run.out, name));
        for row in [3, 4, 9, 10] {
            let number = |cell: &str| cell.parse::<f64>().unwrap();
            let [value, lower, upper] = [value[row], lower[row], upper[row]].map(number);
            assert!(0.7 * value < lower && lower < value && value < upper, "{}", run.out);
        }
        assert!(value[5].is_empty() && value[11].is_empty(), "{}", run.out);
        // The models as they are have no interval.
        assert!([0, 1, 6].iter().all(|row| !value[*row].is_empty() && lower[*row].is_empty()));
    }
    let contacts = cells(&run.out, "contacts");
    assert!([0, 1, 6, 7].iter().all(|row| !contacts[*row].is_empty()), "{}", run.out);
    assert!([3, 4, 9, 10].iter().all(|row| contacts[*row].is_empty()), "{}", run.out);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
    let apart = bench.run("curve scene.toml --model ke --pressure 1e-6,1e7,1e12 --corrected");
    assert_eq!(apart.messages.matches("[no-value]").count(), 2, "{}", apart.messages);
    let far = bench.run("curve scene.toml --model ke --pressure 1e100 --corrected").messages;
    assert!(far.contains("[no-value]"), "{far}");
    let refused = bench.run("curve scene.toml --model ke --corrected");
    assert_eq!(refused.code, Some(2), "{}", refused.messages);
    let solved = bench.data("curve scene.toml --model ke --load 100 --corrected --quantity area");
    assert_eq!(cells(&solved, "model"), ["ke", "ke-corrected"]);
}

#[test]
fn without_evidence_the_models_stand_as_they_are() {
    let bench = Bench::new();
    bench.write("rough.toml", &asperity_scene::template().replace("_std = 1e-6", "_std = 2e-5"));
    let asked = "--load 1000 --quantity area,stiffness --corrected";
    let rough = bench.run(&format!("curve rough.toml --model ke {asked} --format csv"));
    assert_eq!(cells(&rough.out, "model"), ["ke", "ke-corrected"]);
    let area = cells(&rough.out, "area_m2");
    assert!(!area[0].is_empty() && area[1].is_empty(), "{}", rough.out);
    assert!(rough.messages.contains("[no-value]"), "{}", rough.messages);
    // The row of the model as it is keeps its warning.
    for asked in ["--quantity area", "--quantity area --corrected"] {
        let asked = format!("curve scene.toml --model persson-fudge --load 1000 {asked}");
        let messages = bench.run(&asked).messages;
        assert!(messages.contains("ignores yielding"), "{messages}");
    }
    let stiffness =
        bench.run("curve scene.toml --model ke --load 1000 --quantity stiffness --corrected");
    assert!(stiffness.messages.contains("[no-value]"), "{}", stiffness.messages);
}

#[test]
fn areas_of_the_least_that_carries_the_load_are_reported() {
    let bench = Bench::new();
    let soft = crate::bench::NEGATIVE.replace("index = 2.0", "index = 8.0");
    bench.write("soft.toml", &soft);
    for (loads, least) in [("3e6,3e8", 1), ("3e8", 1), ("3e6", 0)] {
        let asked = format!("curve soft.toml --model ke --corrected --pressure {loads}");
        let run = bench.run(&format!("{asked} --quantity area,area-fraction --format csv"));
        assert_eq!(run.results().len(), least, "{loads}: {}", run.messages);
        // Of what was not asked for there is no result.
        let other = bench.run(&format!("{asked} --quantity unloading-stiffness --format csv"));
        assert!(other.results().is_empty(), "{}", other.messages);
        // F/H to the last digit.
        let fractions = cells(&run.out, "area_fraction");
        let pressures = cells(&run.out, "pressure_Pa");
        for (fraction, pressure) in fractions.iter().zip(pressures).skip(fractions.len() / 2) {
            let [fraction, pressure] = [*fraction, pressure].map(|x| x.parse::<f64>().unwrap());
            assert!(fraction >= pressure / 1.12e9, "{fraction:e} at {pressure:e}");
        }
    }
}

#[test]
fn light_loads_have_a_note_with_their_number() {
    let bench = Bench::new();
    let asked = "curve scene.toml --model ke --corrected --quantity area --format csv";
    let run = bench.run(&format!("{asked} --load 1.5,1e3"));
    assert_eq!(run.messages.matches("[extrapolated]").count(), 1, "{}", run.messages);
}

/// Rows of all loads, blank, with the reason once.
#[test]
fn scans_unlike_the_solved_surfaces_have_blank_rows() {
    let bench = crate::bem::bench();
    let scan = bench.read("scan.txt");
    // A groove and a ridge, five times as high as the waves.
    let line = |(k, line): (usize, &str)| match k {
        40 => line.split(' ').map(|_| "-9").collect::<Vec<_>>().join(" "),
        50 => line.split(' ').map(|_| "9").collect::<Vec<_>>().join(" "),
        _ => line.to_string(),
    };
    bench.write("scan.txt", &scan.lines().enumerate().map(line).collect::<Vec<_>>().join("\n"));
    let asked = "curve scan.toml --model ke --corrected --pressure 1e7,1e8 --quantity area,tangent";
    let run = bench.run(&format!("{asked} --format csv"));
    assert_eq!(cells(&run.out, "model"), ["ke", "ke", "ke-corrected", "ke-corrected"]);
    assert_eq!(cells(&run.out, "pressure_Pa")[2..], ["10000000", "100000000"], "{}", run.out);
    for name in
        ["area_m2", "area_lower_m2", "tangent_N_per_m", "separation_m", "separation_upper_m"]
    {
        assert_eq!(cells(&run.out, name)[2..], ["", ""], "{name}: {}", run.out);
    }
    assert_eq!(run.messages.matches("[no-value]").count(), 1, "{}", run.messages);
}

#[test]
fn a_separation_that_the_model_itself_lacks_is_no_failure_of_its_corrected_values() {
    let bench = Bench::new();
    let line = "curve scene.toml --model persson --pressure 1e6,1e7 --corrected --format csv";
    let run = bench.run(&format!("{line} --quantity area"));
    assert!(
        cells(&run.out, "area_lower_m2")[2..].iter().all(|cell| !cell.is_empty()),
        "{}",
        run.out
    );
    assert!(!run.messages.contains("separation"), "{}", run.messages);
}
