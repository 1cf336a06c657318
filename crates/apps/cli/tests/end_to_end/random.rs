//! Asperities of a random surface, in every command that takes a model.

use crate::bench::{Bench, cells, column};

/// The template on a surface given by its moments.
fn bench() -> Bench {
    let bench = Bench::new();
    let template = asperity_scene::template();
    let scene =
        template.replace("\nasperity_radius = 2e-4 ", "\nm0 = 1.6e-13\nm2 = 2.5e-3\nm4 = 3e8\n# ");
    let scene =
        scene.replace("\nasperity_density", "\n# ").replace("\nasperity_height_std", "\n# ");
    let scene = scene.replace("hardness = 2e9", "hardness = 7e9");
    bench.write("random.toml", &scene);
    bench
}

#[test]
fn random_asperities_are_compared_checked_and_recommended() {
    let bench = bench();
    let checked = bench.data("check random.toml --model ke-random --load 100 --format csv");
    assert!(checked.contains("by ke-random"), "{checked}");
    let arguments = "recommend random.toml --model gw-random,ke-random --load 10000 --quantity area --format csv";
    let advice = bench.data(arguments);
    assert!(column(&advice, "area_off_bem").iter().all(|off| off.abs() < 0.5), "{advice}");
}

/// An elastic model is not valid where asperities yield, whatever their radii.
#[test]
fn yielding_under_random_asperities_is_reported_and_not_recommended() {
    let bench = bench();
    let asked =
        "recommend random.toml --model gw-random,ke-random --reference ke-random --load 50kN";
    let run = bench.run(&format!("{asked} --quantity tangent --within 90% --format csv"));
    let verdict: Vec<_> =
        cells(&run.out, "model").into_iter().zip(cells(&run.out, "simplest")).collect();
    assert!(verdict.contains(&("gw-random", "no: not valid here")), "{verdict:?}");
    assert!(run.messages.contains("[yields]"), "{}", run.messages);
    let checked = bench.data("check random.toml --model ke-random --load 50kN --format csv");
    assert!(checked.contains("yielding_share,0.944"), "{checked}");
}
