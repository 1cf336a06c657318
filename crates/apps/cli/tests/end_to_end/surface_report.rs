//! `surface`: the report and its picture, and results against scale.

use crate::bench::{Bench, cells, column};
use crate::surface::scan;

#[test]
fn scales_show_what_the_shortest_wave_changes() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    let of = |arguments: &str| {
        bench.data(&format!("surface scan.txt --unit um --pixel-size 2 {arguments}"))
    };
    let table = of(
        "--scales 6e-6,12e-6 --with scene.toml --pressure 1e6 --model jg --format csv --plot scales.svg",
    );
    for (k, cutoff) in ["6e-6", "12e-6"].into_iter().enumerate() {
        let one: serde_json::Value =
            serde_json::from_str(&of(&format!("--smooth {cutoff} --format json"))).unwrap();
        for (column_name, key) in [
            ("alpha", "alpha"),
            ("asperity_radius_m", "asperity_radius"),
            ("asperity_density_per_m2", "asperity_density"),
            ("asperity_height_std_m", "asperity_height_std"),
        ] {
            let (found, wanted) = (column(&table, column_name)[k], one[key].as_f64().unwrap());
            assert!((found / wanted - 1.0).abs() < 1e-12, "{column_name}: {found} {wanted}");
        }
    }
    // The answer is for the scene's bodies on this surface.
    of("--smooth 6e-6 --scene smooth.toml --output numbers.txt");
    let theirs = bench.read("smooth.toml");
    let (_, surface) = theirs.split_once("[surface]").unwrap();
    let ours = bench.read("scene.toml");
    let (bodies, _) = ours.split_once("[surface]").unwrap();
    bench.write("own.toml", &format!("{bodies}[surface]{surface}"));
    let answer =
        bench.data("curve own.toml --model jg --pressure 1e6 --quantity area-fraction,tangent");
    for name in ["area_fraction", "tangent_N_per_m"] {
        let (found, wanted) = (column(&table, name)[0], column(&answer, name)[0]);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{name}: {found} {wanted}");
    }
    assert!(bench.read("scales.svg").starts_with("<svg"));
    // A theory of the whole surface gets the spectrum of this surface, too.
    bench.write(
        "scanned.toml",
        &format!("{bodies}[surface]\nfile = \"scan.txt\"\nunit = \"um\"\npixel_size = 2\n"),
    );
    let table = of("--scales 6e-6 --with scanned.toml --pressure 1e6 --model persson --format csv");
    let smooth = bench.read("scanned.toml") + "smooth = 6e-6\n";
    bench.write("smoothed.toml", &smooth);
    let answer = bench.data(
        "curve smoothed.toml --model persson --pressure 1e6 --quantity area-fraction,tangent",
    );
    for name in ["area_fraction", "tangent_N_per_m"] {
        let (found, wanted) = (column(&table, name)[0], column(&answer, name)[0]);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{name}: {found} {wanted}");
    }
    // Cut-offs that the scan cannot have are blank, and printed why.
    let run =
        bench.run("surface scan.txt --unit um --pixel-size 2 --scales 1e-9,6e-6,2e-9 --format csv");
    assert_eq!((run.code, cells(&run.out, "alpha")[0]), (Some(0), ""));
    assert!(run.messages.contains("[no-value]"));
}

#[test]
fn the_report_leads_with_what_decides_trust_and_is_drawn() {
    let bench = Bench::new();
    bench.write("scan.txt", &scan(0.0));
    let line = "surface scan.txt --unit um --pixel-size 0.5 --filter 30um --plot report.svg";
    let out = bench.data(&format!("{line} --format csv"));
    let names: Vec<&str> = out.lines().filter_map(|row| row.split(',').next()).collect();
    let place = |name: &str| names.iter().position(|found| *found == name).expect(name);
    let trust =
        ["missing_share", "outliers", "tilt_x", "slope_ratio", "long_waves", "m4_over_half"];
    let later = ["ssk", "filtered", "sq", "sa", "spc", "m0", "asperity_radius"];
    let places: Vec<usize> = trust.into_iter().chain(later).map(place).collect();
    assert!(places.is_sorted(), "{names:?}");
    let svg = bench.read("report.svg");
    for word in ["(a) map", "(f) curvature", "scan.txt"] {
        assert!(svg.contains(word), "{word}");
    }
    let two = bench.run("surface scan.txt scan.txt --unit um --pixel-size 0.5 --plot two.svg");
    assert!(two.code == Some(2) && two.messages.contains("--plot"));
}

#[test]
fn heights_in_a_wrong_unit_and_a_few_far_points_are_told() {
    let bench = Bench::new();
    let waves = |spot: f64| -> String {
        let point = |k: usize| {
            let (x, y) = ((k % 64) as f64, (k / 64) as f64);
            let z = (0.7 * x + 0.2 * y).sin() + (0.3 * x - 0.9 * y).cos();
            if (20..23).contains(&(k % 64)) && (30..33).contains(&(k / 64)) { z + spot } else { z }
        };
        let row = |k: usize| (0..64).map(|x| point(64 * k + x).to_string()).collect::<Vec<_>>();
        (0..64).map(|k| row(k).join(" ") + "\n").collect()
    };
    bench.write("waves.txt", &waves(0.0));
    bench.write("spot.txt", &waves(400.0));
    let messages = |name: &str, words: &str| bench.run(&format!("surface {name} {words}")).messages;
    let metres = messages("waves.txt", "--unit m --pixel-size 2");
    assert!(metres.contains("[unusual-size]"), "{metres}");
    assert!(!messages("waves.txt", "--unit um --pixel-size 2").contains("sq is"));
    let spot = messages("spot.txt", "--unit um --pixel-size 2 --despike");
    assert!(spot.contains("sku is ") && spot.contains("[not-gaussian]"), "{spot}");
    let blank = bench.run("surface waves.txt --unit um --pixel-size 2 --scales 1e-12,2e-12");
    assert_eq!((blank.code, &*blank.out), (Some(1), ""), "{}", blank.messages);
}

#[test]
fn a_text_is_read_by_the_options_that_its_errors_name() {
    let bench = Bench::new();
    // 12 x 10 points with an index before the rows, a fifth of them lost.
    let height = |k: usize| if k.is_multiple_of(5) { -9999.0 } else { ((7 * k) % 31) as f64 };
    let row = |j: usize| {
        let heights = (0..12).map(|i| height(12 * j + i).to_string());
        format!("{j}\t{}\n", heights.collect::<Vec<_>>().join("\t"))
    };
    let rows: String = (0..10).map(row).collect();
    bench.write("a.txt", &format!("# Width: 12 um\n# Height: 10 um\n{rows}"));
    let run = bench.run("surface a.txt --unit nm");
    assert_eq!(run.code, Some(1));
    assert!(run.messages.contains("--columns"), "{}", run.messages);
    let run = bench.run("surface a.txt --unit nm --columns axes");
    assert!(run.messages.contains("--missing"), "{}", run.messages);
    let given = "--unit nm --columns axes --missing -9999 --max-missing 0.3";
    let table = bench.data(&format!("surface a.txt {given} --format csv --scene a.toml"));
    assert!(table.contains("\nmissing_share,0.2,"), "{table}");
    let scene = bench.read("a.toml");
    assert!(scene.contains("columns = \"axes\"") && scene.contains("missing = -9999"), "{scene}");
    let header = bench.data("surface a.txt --header --format csv");
    assert!(header.contains("1,# Width: 12 um,width"), "{header}");
}
