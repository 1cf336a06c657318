//! Asperities of a random surface, by the scene and by name, in every command that takes a model.

use crate::bench::{Bench, cells, column};

/// The template on a surface given by its moments.
fn bench() -> Bench {
    let bench = Bench::new();
    let template = asperity_inputs::template();
    let equal =
        template.replace("\nasperity_radius = 2e-4 ", "\nm0 = 1.6e-13\nm2 = 2.5e-3\nm4 = 3e8\n# ");
    let equal =
        equal.replace("\nasperity_density", "\n# ").replace("\nasperity_height_std", "\n# ");
    let equal = equal.replace("hardness = 2e9", "hardness = 7e9");
    bench.write("equal.toml", &equal);
    bench.write("random.toml", &equal.replace("= \"equal\"", "= \"random\""));
    bench
}

#[test]
fn one_key_of_the_scene_selects_random_asperities() {
    let bench = bench();
    let curve = |scene: &str, models: &str| {
        let arguments = "--pressure 1e8 --quantity area --format csv";
        bench.run(&format!("curve {scene}.toml --model {models} {arguments}"))
    };
    let [random, named] = [curve("random", "gw"), curve("equal", "gw-random")];
    assert_eq!(column(&random.out, "area_m2"), column(&named.out, "area_m2"));
    assert_ne!(column(&random.out, "area_m2"), column(&curve("equal", "gw").out, "area_m2"));
}

/// An elastic model is not valid where asperities yield, whatever their radii.
#[test]
fn yielding_under_random_asperities_is_reported_and_not_recommended() {
    let bench = bench();
    let arguments =
        "recommend random.toml --load 50kN --model gw,zmc --quantity tangent --format csv";
    let run = bench.run(arguments);
    let verdict: Vec<_> =
        cells(&run.out, "model").into_iter().zip(cells(&run.out, "simplest")).collect();
    assert!(verdict.contains(&("gw-random", "no: not valid here")), "{verdict:?}");
    assert!(run.messages.contains("[yields]"), "{}", run.messages);
}

#[test]
fn models_without_random_asperities_are_refused_by_name() {
    let bench = bench();
    for model in ["gao", "bem", "ke-randm"] {
        let run =
            bench.run(&format!("curve random.toml --load 10 --quantity area --model {model}"));
        assert_ne!(run.code, Some(0), "{model}");
        assert!(run.out.is_empty(), "{}", run.messages);
    }
    let whole = |scene| {
        bench.data(&format!("curve {scene}.toml --load 10 --quantity area --model persson-fudge"))
    };
    assert_eq!(whole("random"), whole("equal"));
    let run = bench.run("curve random.toml --load 10 --model gw --quantity unloading-stiffness");
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
}
