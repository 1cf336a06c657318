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
        let arguments = "--pressure 1e7,1e8 --quantity area --format csv";
        bench.data(&format!("curve {scene}.toml --model {models} {arguments}"))
    };
    let [random, named] = [curve("random", "gw"), curve("equal", "gw-random")];
    assert_eq!(column(&random, "area_m2"), column(&named, "area_m2"));
    assert_ne!(column(&random, "area_m2"), column(&curve("equal", "gw"), "area_m2"));
    let all = bench.run("curve random.toml --load 100 --format csv");
    let ids = "gw-random ceb-random zmc-random ke-random etsion-random jg-random af-random";
    assert_eq!(cells(&all.out, "model").join(" "), ids);
    let printed = "left out: gao, at cannot give averages over the asperities of a random surface: contacts are inclined; set asperities = \"equal\" in [surface]";
    assert!(all.messages.contains(printed), "{}", all.messages);
    let compared =
        bench.data("curve random.toml --model gw,gw-random --reference gw --format csv --load 100");
    assert_eq!(column(&compared, "area_deviation"), [0.0, 0.0]);
    let checked = bench.data("check random.toml --model ke --load 100 --format csv");
    assert!(checked.contains("real area of contact, by ke-random"), "{checked}");
    let arguments = "recommend random.toml --model gw,ke --load 10000 --quantity area --format csv";
    let advice = bench.data(arguments);
    assert!(column(&advice, "area_off_bem").iter().all(|off| off.abs() < 0.5), "{advice}");
}

/// An elastic model is not valid where asperities yield, whatever their radii.
#[test]
fn yielding_under_random_asperities_is_reported_and_not_recommended() {
    let bench = bench();
    let share = "yielding asperities carry 94.72 % of the force at a load of 50000 N";
    let run = bench.run("curve random.toml --model gw --load 50kN");
    assert!(run.messages.contains(&format!("gw-random: {share}")), "{}", run.messages);
    let run = bench.run("recommend random.toml --load 50kN --quantity tangent --format csv");
    let verdict: Vec<_> =
        cells(&run.out, "model").into_iter().zip(cells(&run.out, "simplest")).collect();
    assert!(verdict.contains(&("gw-random", "no: not valid here")), "{verdict:?}");
    let checked = bench.data("check random.toml --load 50kN --format csv");
    assert!(checked.contains("yielding_share,0.944"), "{checked}");
}

#[test]
fn models_without_random_asperities_are_refused_by_name() {
    let bench = bench();
    for (arguments, printed) in [
        ("--model gao", "contacts are inclined; set asperities = \"equal\" in [surface]"),
        ("--model bem", "surface.file is missing"),
    ] {
        let run = bench.run(&format!("curve random.toml --load 10 --quantity area {arguments}"));
        assert_ne!(run.code, Some(0), "{arguments}");
        assert!(run.messages.contains(printed), "{arguments}: {}", run.messages);
    }
    let whole = |scene| {
        bench.data(&format!("curve {scene}.toml --load 10 --quantity area --model persson-fudge"))
    };
    assert_eq!(whole("random"), whole("equal"));
    let run = bench.run("curve random.toml --load 10 --model ke --quantity unloading-stiffness");
    let printed = "contact radii, which need asperities of one radius; set asperities = \"equal\"";
    assert!(run.messages.contains(printed), "{}", run.messages);
    let run = bench.run("curve equal.toml --model ke-randm");
    assert!(run.messages.contains("the nearest is \"ke-random\""), "{}", run.messages);
}
