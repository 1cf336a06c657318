//! Two rough surfaces whose asperities meet, by the scene and by name.

use crate::bench::{Bench, cells, column};

fn bench() -> Bench {
    let bench = Bench::new();
    let template = asperity_inputs::template();
    bench.write("equal.toml", template);
    bench.write("pairs.toml", &template.replace("= \"equal\"", "= \"pairs\""));
    let film = "separation_from = \"surface-mean\"";
    let from = template.replace("separation_from = \"asperity-mean\"", film);
    bench.write("film.toml", &from);
    bench
}

#[test]
fn one_key_of_the_scene_selects_pairs() {
    let bench = bench();
    let curve = |scene: &str, models: &str| {
        bench.data(&format!("curve {scene}.toml --model {models} --pressure 1e7,1e8 --format csv"))
    };
    let [pairs, named] = [curve("pairs", "gw"), curve("equal", "gt")];
    for name in ["area_m2", "separation_m"] {
        assert_eq!(column(&pairs, name), column(&named, name));
        assert_ne!(column(&pairs, name), column(&curve("equal", "gw"), name));
    }
    let all = bench.run("solve pairs.toml --load 100 --format csv");
    let ids = "gw-pairs ceb-pairs zmc-pairs ke-pairs etsion-pairs jg-pairs af-pairs";
    assert_eq!(cells(&all.out, "model").join(" "), ids);
    let printed = "left out: gao, at cannot give contacts between the asperities of two rough surfaces: contacts are inclined; set asperities";
    assert!(all.messages.contains(printed), "{}", all.messages);
    let checked = bench.data("check pairs.toml --model ke --load 100 --format csv");
    assert!(checked.contains("real area of contact, by ke-pairs"), "{checked}");
    let unloaded = bench.data("unload pairs.toml --model ke --load 100 --retreat 0 --format csv");
    assert!((column(&unloaded, "force_N")[0] / 100.0 - 1.0).abs() < 1e-9, "{unloaded}");
    let slips = bench.run("slip pairs.toml --model ke --load 100 --friction 0.2 --amplitude 1e-7");
    assert!(slips.messages.contains("which counts under friction"), "{}", slips.messages);
    let corrected = bench.run("curve pairs.toml --model ke --load 100 --corrected");
    assert!(corrected.messages.contains("pressed by a flat"), "{}", corrected.messages);
}

/// The separation at a load is the distance of the mean planes, which the asperities of both
/// surfaces part, and leads back to that load.
#[test]
fn separations_are_those_of_the_pair() {
    let bench = bench();
    let run = |scene: &str, at: &str| {
        bench.data(&format!(
            "curve {scene}.toml --model ke-pairs {at} --quantity force --format csv"
        ))
    };
    let at_load = |scene: &str| column(&run(scene, "--load 100"), "separation_m")[0];
    let film = at_load("film");
    let offset = 2.0 * 0.045_944_074_618_5 / (2e-4 * 2e8);
    assert!(((film - at_load("equal")) / offset - 1.0).abs() < 1e-9, "{film}");
    let force = column(&run("film", &format!("--separation {film:e}m")), "force_N")[0];
    assert!((force / 100.0 - 1.0).abs() < 1e-9, "{force}");
}

#[test]
fn another_joint_is_told_unless_a_counterface_makes_it_the_same() {
    let bench = bench();
    let ask = "--model gw,gw-pairs --reference gw --load 100 --format csv";
    let run = bench.run(&format!("compare equal.toml {ask}"));
    let note = "note[other-joint]: gw-pairs presses two surfaces with these asperities on each other, gw one such surface on a flat";
    assert!(run.messages.contains(note), "{}", run.messages);
    let text = asperity_inputs::template();
    let line = "# counterface = { sq = 4e-7, spd = 3e8, spc = 4e3 }";
    bench.write("both.toml", &text.replace(line, &line[2..]));
    let run = bench.run(&format!("compare both.toml {ask}"));
    assert!(!run.messages.contains("other-joint"), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["gw", "gw-pairs"]);
}
