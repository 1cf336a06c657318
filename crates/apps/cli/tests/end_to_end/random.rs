//! Asperities of a random surface, in every command that takes a model.

use crate::bench::Bench;

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
fn random_asperities_are_checked() {
    let bench = bench();
    let checked = bench.data("check random.toml --model ke-random --load 100 --format csv");
    assert!(checked.contains("by ke-random"), "{checked}");
    let checked = bench.data("check random.toml --model ke-random --load 50kN --format csv");
    assert!(checked.contains("yielding_share,0.944"), "{checked}");
}
