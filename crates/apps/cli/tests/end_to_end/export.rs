//! `export`: the tables meet their stated errors.

use asperity::{At, ContactModel, Model, Quantity, Request};

use crate::bench::{Bench, column, column_of, conducting};

/// Pressures of the model itself at clearances in metres.
fn pressures(bench: &Bench, clearances: &[f64]) -> Vec<f64> {
    let scene = bench.scene("scene.toml").scene;
    let request = Request::new([Quantity::Force]).at(clearances.iter().copied().map(At::metres));
    let answer = "ke".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
    answer.values(Quantity::Force).unwrap().iter().map(|f| f / scene.nominal_area).collect()
}

fn stated_error(table: &str, before: &str) -> f64 {
    let (_, after) = table.split_once(before).unwrap();
    after.split_whitespace().next().unwrap().trim_end_matches(',').parse().unwrap()
}

#[test]
fn lines_through_the_abaqus_pairs_meet_the_requested_error() {
    let bench = Bench::new();
    let table =
        bench.data("export scene.toml --model ke --as abaqus --separation -1:4 --max-error 1e-2");
    assert!(table.contains("\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n"));
    let pairs: Vec<(f64, f64)> = table
        .lines()
        .filter(|line| !line.starts_with('*'))
        .map(|line| {
            let (p, h) = line.split_once(", ").unwrap();
            (p.parse().unwrap(), h.parse().unwrap())
        })
        .collect();
    assert!(pairs.len() > 20 && pairs[0].0 == 0.0);
    assert!(pairs.is_sorted_by(|a, b| a.0 < b.0 && a.1 < b.1));
    assert!(stated_error(&table, "largest relative error ") <= 1e-2);
    for pair in pairs[1..].windows(2) {
        let ((p0, h0), (p1, h1)) = (pair[0], pair[1]);
        let exact = pressures(&bench, &[-0.5 * (h0 + h1)])[0];
        assert!((0.5 * (p0 + p1) / exact - 1.0).abs() < 1.001e-2);
    }
    // No kink where the cut-off meets the curve.
    let slope = |k: usize| (pairs[k + 1].0 - pairs[k].0) / (pairs[k + 1].1 - pairs[k].1);
    assert!((slope(0) / slope(1) - 1.0).abs() < 0.15, "{} {}", slope(0), slope(1));
}

#[test]
fn other_solvers_get_the_same_lines_in_their_formats() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let of = |form: &str, arguments: &str| {
        bench.run(&format!("export scene.toml --model ke --as {form} --load 1:1e3 {arguments}"))
    };
    let numbers = |line: &str| -> Vec<f64> {
        line.split([',', ' ']).filter_map(|word| word.parse().ok()).collect()
    };
    let rows = |text: &str| -> Vec<Vec<f64>> {
        text.lines().filter(|line| !line.starts_with('*')).map(numbers).collect()
    };
    let (abaqus, calculix) = (of("abaqus", "--max-error 0.1"), of("calculix", "--max-error 0.1"));
    let (pairs, shifted) = (rows(&abaqus.out), rows(&calculix.out));
    assert!(calculix.out.contains(
        "\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0.000000000e0, 0.000000000e0\n"
    ));
    assert_eq!(pairs.len(), shifted.len());
    let begins = -pairs[0][1];
    assert!(calculix.out.contains(&format!("{begins:.9e} m")));
    for (pair, moved) in pairs.iter().zip(&shifted) {
        assert!((moved[0] - pair[0]).abs() <= 1e-9 * pair[0]);
        assert!((moved[1] - (pair[1] + begins)).abs() < 1e-9 * begins);
    }
    // Both codes read 20 characters of a number.
    let conductance = of("abaqus", "--max-error 0.1 --conductance clearance").out;
    for text in [&calculix.out, &abaqus.out, &conductance] {
        let rows = text.lines().filter(|line| !line.starts_with('*'));
        let lengths: Vec<usize> = rows.flat_map(|row| row.split(", ")).map(str::len).collect();
        assert!(lengths.len() >= 4 && lengths.iter().all(|length| *length <= 20), "{lengths:?}");
    }
}

fn numbers(line: &str) -> Vec<f64> {
    line.split(", ").map(|word| word.parse().unwrap()).collect()
}

/// The lines of numbers after a keyword.
fn block(text: &str, keyword: &str) -> Vec<Vec<f64>> {
    let after = text.lines().skip_while(|line| !line.starts_with(keyword)).skip(1);
    after.take_while(|line| !line.starts_with('*')).map(numbers).collect()
}

#[test]
fn conductance_and_friction_agree_with_the_model() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let scene = bench.scene("scene.toml").scene;
    let of = |quantity, at: At| {
        let request = Request::new([quantity]).at([at]);
        let answer = "ke".parse::<Model>().unwrap().solve(&scene, &request).unwrap();
        answer.values(quantity).unwrap()[0] / scene.nominal_area
    };
    let same = |found: f64, wanted: f64| assert!((found / wanted - 1.0).abs() < 1e-8, "{found}");
    let export = "export scene.toml --model ke --pressure 1e5:1e7 --max-error 0.02";
    for (form, keyword) in
        [("abaqus", "*GAP CONDUCTANCE, PRESSURE"), ("calculix", "*GAP CONDUCTANCE")]
    {
        let arguments = format!("{export} --as {form} --conductance pressure --friction 0.2");
        let text = bench.data(&arguments);
        let pairs = block(&text, keyword);
        let behavior = block(&text, "*SURFACE BEHAVIOR");
        if form == "calculix" {
            // A line instead of the table, with which no heat flows: to the last pair of this.
            let (_, table) = text.split_once("** *SURFACE BEHAVIOR").unwrap();
            let rows = table.lines().skip(1).take(pairs.len());
            let row = |line: &str| line.strip_prefix("** ").map(numbers).unwrap();
            let rows: Vec<Vec<f64>> = rows.map(row).collect();
            let last = &rows[pairs.len() - 1];
            same(last[0] / last[1], behavior[0][0]);
            assert!(behavior.len() == 1 && text.contains("SURFACE TO SURFACE"));
            assert_eq!(pairs[pairs.len() - 1][1].to_bits(), last[0].to_bits());
        } else {
            assert_eq!(pairs.len(), behavior.len());
        }
        assert_eq!(pairs[0][..2], [0.0, 0.0]);
        assert!(pairs.is_sorted_by(|a, b| a[0] < b[0] && a[1] < b[1]));
        for pair in &pairs[1..] {
            same(pair[0], of(Quantity::ThermalConductance, At::Pressure(pair[1])));
            assert_eq!(pair.len(), if form == "calculix" { 3 } else { 2 });
        }
        // Between the nodes, too, it is as good as it says.
        let stated = stated_error(text.split_once("thermal").unwrap().1, "relative error ");
        let halfway = |pair: &[Vec<f64>]| {
            let [h, p] = [0, 1].map(|k| 0.5 * (pair[0][k] + pair[1][k]));
            (h / of(Quantity::ThermalConductance, At::Pressure(p)) - 1.0).abs()
        };
        let worst = pairs[1..].windows(2).map(halfway).fold(0.0, f64::max);
        assert!(worst < 1.05 * stated && worst > 0.5 * stated, "{worst} {stated}");
        // And on the line from the lightest of them to no conductance.
        let of_line = text.split_once("thermal").unwrap().1.split_once("\n** and ").unwrap().1;
        let of_line: f64 = of_line.split_once(' ').unwrap().0.parse().unwrap();
        let halfway = halfway(&pairs[..2]);
        assert!(halfway > 0.01 && halfway < of_line && of_line < 4.0 * halfway, "{of_line}");

        let stick = of(Quantity::TangentialStiffness, At::Pressure(1e7));
        let friction = block(&text, "*FRICTION");
        if form == "calculix" {
            same(friction[0][1], stick);
        } else {
            let slip = text.split_once("*FRICTION, ELASTIC SLIP=").unwrap().1;
            same(0.2 * 1e7 / slip.lines().next().unwrap().parse::<f64>().unwrap(), stick);
        }
        same(friction[0][0], 0.2);
    }
    let text = bench.data(&format!("{export} --as abaqus --conductance clearance"));
    let pairs = block(&text, "*GAP CONDUCTANCE");
    assert!(
        pairs.is_sorted_by(|a, b| a[0] > b[0] && a[1] < b[1]) && pairs.last().unwrap()[0] == 0.0
    );
    for pair in &pairs[..pairs.len() - 1] {
        same(pair[0], of(Quantity::ThermalConductance, At::metres(pair[1])));
    }
}

#[test]
fn tables_in_mm_hold_the_same_numbers_in_their_units() {
    let bench = Bench::new();
    bench.write("scene.toml", &conducting());
    let of = |arguments: &str| {
        let arguments = format!("export scene.toml --model ke --load 10:1000:9 {arguments}");
        let [si, mm] =
            ["SI", "mm-N-MPa"].map(|units| bench.data(&format!("{arguments} --units {units}")));
        assert_eq!(bench.data(&arguments), si);
        assert_eq!(bench.data(&format!("{arguments} --units mm-tonne-s")), mm);
        assert!(mm.contains("converted from SI") && !si.contains("mm"));
        [si, mm]
    };
    let same = |[si, mm]: [Vec<Vec<f64>>; 2], factors: &[f64]| {
        assert!(si.len() == mm.len() && !si.is_empty());
        for (si, mm) in si.iter().flatten().zip(mm.iter().flatten()).zip(factors.iter().cycle()) {
            let ((si, mm), factor) = (si, mm);
            assert!((mm - si * factor).abs() <= 1e-9 * mm.abs(), "{si} {mm} {factor}");
        }
    };
    let rows = |text: &String| {
        let lines = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        let number = |word: &str| word.parse::<f64>().unwrap();
        lines.map(|line| line.split(',').map(number).collect()).collect::<Vec<Vec<f64>>>()
    };
    same(of("--as csv").each_ref().map(rows), &[1e3, 1e-6, 1e-9]);
    for form in ["abaqus", "calculix"] {
        let texts = of(&format!("--as {form} --conductance pressure --friction 0.2"));
        let blocks = |keyword: &str| texts.each_ref().map(|text| block(text, keyword));
        let behavior = if form == "abaqus" { &[1e-6, 1e3][..] } else { &[1e-9] };
        same(blocks("*SURFACE BEHAVIOR"), behavior);
        // 1 W/(m² K) is 1e-3 mW/(mm² K).
        let conductance = if form == "abaqus" { &[1e-3, 1e-6][..] } else { &[1e-3, 1e-6, 1.0] };
        same(blocks("*GAP CONDUCTANCE"), conductance);
        assert!(texts[1].contains("mW/(mm2 K)"));
        if form == "calculix" {
            same(blocks("*FRICTION"), &[1.0, 1e-9]);
        } else {
            let slip = |text: &String| vec![vec![stated_error(text, "*FRICTION, ELASTIC SLIP=")]];
            same(texts.each_ref().map(slip), &[1e3]);
        }
    }
    let texts = of("--as abaqus --conductance clearance");
    same(texts.each_ref().map(|text| block(text, "*GAP CONDUCTANCE")), &[1e-3, 1e3]);
}

#[test]
fn a_table_of_films_has_pressure_and_factors_and_the_numbers_that_codes_take() {
    let bench = Bench::new();
    let table = bench.data("export scene.toml --model ke --as film --lambda 0.25:4:16");
    let curve = "--lambda 0.25:4:16 --quantity";
    let of = |model: &str, quantity: &str| {
        let curve = bench.data(&format!("curve scene.toml --model {model} {curve} {quantity}"));
        assert_eq!(column(&curve, "lambda"), column(&table, "lambda"));
        column(&curve, &quantity.replace('-', "_"))
    };
    assert_eq!(column(&table, "area_fraction"), of("ke", "area-fraction"));
    let factor = "friction_flow_factor";
    let filled: Vec<f64> = column_of(&table, factor).into_iter().flatten().collect();
    // The first film is below the range of the fits.
    assert_eq!(filled.len(), 15);
    let again =
        bench.data("curve scene.toml --model ke --lambda 0.5:4:15 --quantity friction-flow-factor");
    assert_eq!(filled, column(&again, factor));
    let surface = bench.scene("scene.toml").scene.surface;
    for number in [surface.asperity_density, surface.asperity_radius] {
        assert!(table.contains(&asperity::short(number)), "{table}");
    }
    let films = bench.data("export scene.toml --model ke --as film --film 1um:3um:3");
    let curve = bench.data("curve scene.toml --model ke --film 1um:3um:3 --quantity pressure");
    for name in ["film_m", "pressure_Pa"] {
        let both = column(&films, name).into_iter().zip(column(&curve, name));
        assert!(both.into_iter().all(|(one, other)| (one / other - 1.0).abs() < 1e-10), "{films}");
    }
}
