//! `export`: the tables meet their stated errors.

use asperity::{At, ContactModel, Model, Quantity, Request};

use crate::bench::{Bench, conducting};

fn stated_error(table: &str, before: &str) -> f64 {
    let (_, after) = table.split_once(before).unwrap();
    after.split_whitespace().next().unwrap().trim_end_matches(',').parse().unwrap()
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
fn conductance_agrees_with_the_model() {
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
        let arguments = format!("{export} --as {form} --conductance");
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
    }
}
