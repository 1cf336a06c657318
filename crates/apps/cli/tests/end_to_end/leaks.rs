//! `bem`: hydraulic gaps, flows and their map.

use crate::bem::bench;
use crate::bench::{Bench, column};

#[test]
fn the_map_of_the_flow_shows_contact_and_path() {
    let bench = bench();
    let run = bench.run("bem scan.toml --pressure 1e9 --flow-picture flow.svg --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let svg = bench.read("flow.svg");
    for text in ["hydraulic gap is", "white: no flow", ">contact<"] {
        assert!(svg.contains(text), "{text}");
    }
    let closed = bench.run("bem scan.toml --elastic --pressure 4e10 --flow-picture flow.svg");
    assert!(closed.code == Some(0) && bench.read("flow.svg").contains("no open path"));
}

#[test]
fn a_seal_closes_between_its_lowest_and_its_highest_sealing_pressure() {
    let bench = bench();
    let asked = "bem seal.toml --elastic --sealing-pressure --samples 3 --picture last.svg";
    let run = bench.run(&format!("{asked} --format csv"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    let of = |which: &str| column(&run.out, &format!("{which}_sealing_pressure_Pa"));
    let [low, middle, high] = ["lowest", "middle", "highest"].map(of);
    assert!(low.len() == 2 && column(&run.out, "samples") == [3.0, 3.0], "{}", run.out);
    for k in 0..2 {
        assert!(low[k] <= middle[k] && middle[k] <= high[k] && low[k] < high[k]);
    }
    // The heaviest contact is open along x, y or both.
    assert!(bench.read("last.svg").contains("the tightest gap of the widest path"));
    // The scan is one of the samples.
    let ends = format!("{},{}", 0.98 * low[0], 1.02 * high[0]);
    let asked = format!("bem seal.toml --elastic --pressure {ends} --quantity leak --format csv");
    let flows = column(&bench.data(&asked), "leak_x_kg_per_s");
    assert!(flows[0] > 0.0 && flows[1] == 0.0, "{flows:?}");
}

/// The commands beside the picture of the guide make it; single pixels may have other shades
/// on another machine.
#[test]
fn the_picture_of_the_guide_is_drawn_by_its_commands() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../");
    let read = |name: &str| std::fs::read_to_string(format!("{root}{name}")).unwrap();
    let bench = Bench::new();
    let scene = "nominal_area = 1e-8\ninterface = { equivalent_modulus = 115e9, poissons_ratio = 0.3 }\nsurface = { file = \"seal.x3p\", periodic = true }\n";
    bench.write("seal.toml", scene);
    let chapter = read("crates/apps/web/guide/boundary-elements.md");
    for start in ["asperity generate ", "asperity bem seal.toml "] {
        let line = chapter.lines().find(|line| line.starts_with(start)).unwrap();
        let run = bench.run(line.trim_start_matches("asperity "));
        assert_eq!(run.code, Some(0), "{}", run.messages);
    }
    let without_shades = |svg: &str| -> Vec<String> {
        svg.lines().filter(|line| !line.contains("<image ")).map(str::to_owned).collect()
    };
    let [drawn, committed] = [bench.read("leak-map.svg"), read("figures/leak-map.svg")];
    assert_eq!(without_shades(&drawn), without_shades(&committed));
}
