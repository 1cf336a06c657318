//! Two rough surfaces: moments add, and heights of aligned scans.

use crate::bench::{Bench, column};
use crate::surface::{json, scan};

#[test]
fn moments_of_two_surfaces_add() {
    let bench = Bench::new();
    bench.write("a.txt", &scan(0.0));
    bench.write("b.txt", &scan(0.37));
    let [a, b, both] = ["a.txt", "b.txt", "a.txt b.txt"]
        .map(|f| json(&bench, &format!("{f} --unit um --pixel-size 0.5")));
    // Summits do not add, and no option is ignored.
    let run = bench.run("surface a.txt b.txt --unit um --pixel-size 0.5 --estimator summits");
    assert_eq!((run.code, run.out.as_str()), (Some(1), ""));
    assert!(run.messages.contains("\"moments\""), "{}", run.messages);
    for key in ["m0", "m2", "m4"] {
        let sum = a[key].as_f64().unwrap() + b[key].as_f64().unwrap();
        assert!((both[key].as_f64().unwrap() / sum - 1.0).abs() < 1e-12, "{key}");
    }
}

#[test]
fn heights_of_aligned_scans_add_in_the_report_the_scene_and_boundary_elements() {
    let bench = Bench::new();
    bench.write("a.txt", &scan(0.0));
    bench.write("b.txt", &scan(0.37));
    let sum = |a: &str, b: &str| -> String {
        let row = |(a, b): (&str, &str)| {
            let each = a.split(' ').zip(b.split(' '));
            let sums = each.map(|(a, b)| a.parse::<f64>().unwrap() + b.parse::<f64>().unwrap());
            sums.map(|z| format!("{z:.5}")).collect::<Vec<_>>().join(" ")
        };
        a.lines().zip(b.lines()).map(row).collect::<Vec<_>>().join("\n")
    };
    let turned = |text: &str| -> String {
        let row = |row: &str| row.split(' ').rev().collect::<Vec<_>>().join(" ");
        text.lines().map(row).collect::<Vec<_>>().join("\n")
    };
    bench.write("sum.txt", &sum(&scan(0.0), &scan(0.37)));
    bench.write("mirrored.txt", &sum(&scan(0.0), &turned(&scan(0.37))));
    let read = "--unit um --pixel-size 2";
    for (option, whole) in [("--aligned", "sum.txt"), ("--aligned=mirrored", "mirrored.txt")] {
        let both = json(&bench, &format!("a.txt b.txt {read} {option}"));
        let one = json(&bench, &format!("{whole} {read}"));
        for key in ["sq", "m2", "m4", "sa", "asperity_radius"] {
            let [both, one] = [&both, &one].map(|found| found[key].as_f64().unwrap());
            assert!((both / one - 1.0).abs() < 1e-6, "{option} {key}: {both} {one}");
        }
        let [made, one] = [format!("made-{whole}.toml"), format!("one-{whole}.toml")];
        let scene = format!("surface a.txt b.txt {read} {option} --scene {made}");
        bench.data(&format!("{scene} --plot both.svg"));
        assert!(bench.read("both.svg").contains("a.txt and b.txt"));
        bench.data(&format!("surface {whole} {read} --scene {one}"));
        let [both, one] = [made, one].map(|name| {
            let table = bench.data(&format!("bem {name} --pressure 1e8 --format csv"));
            column(&table, "area_fraction")[0]
        });
        assert!((both / one - 1.0).abs() < 1e-4, "{option}: {both} {one}");
    }
}
