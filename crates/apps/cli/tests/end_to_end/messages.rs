//! Messages of the commands, with plan and models.

use crate::bench::{Bench, NO_SHEAR, cells, column};

/// The models on other asperities.
const ON_OTHERS: &str = "gw-* ceb-* zmc-* ke-* etsion-* jg-* jg-cosine-* af-* ghaednia-*";

#[test]
fn the_list_of_models_has_every_source() {
    let bench = Bench::new();
    let json: serde_json::Value =
        serde_json::from_str(&bench.data("list models --format json")).unwrap();
    let ids: Vec<&str> =
        json.as_array().unwrap().iter().map(|row| row["model"].as_str().unwrap()).collect();
    let of_asperities = "gw ceb zmc ke etsion jg jg-cosine af gao at at-additive at-overlap";
    assert_eq!(
        ids.join(" "),
        format!(
            "{of_asperities} persson persson-fudge persson-plastic dmt jkr jkr-separation ghaednia \
             cmy mikic {} best bem",
            ["random", "pairs"].map(|end| ON_OTHERS.replace('*', end)).join(" ")
        )
    );
    assert_eq!(json[3]["authors"], "Kogut & Etsion");
    let table = bench.data("list models");
    assert_eq!(table.lines().count(), 1 + ids.len());
    assert!(table.lines().next().unwrap().contains("valid_for"), "{table}");
    assert!(table.contains("fitted to finite elements up to 110 w_c"), "{table}");
    for row in json.as_array().unwrap() {
        assert!(row["valid_for"].as_str().unwrap().len() > 10, "{row}");
        let id = row["model"].as_str().unwrap();
        let is_variant = id.contains('-');
        assert_eq!(row["variant"].as_str().unwrap().len() > 10, is_variant, "{row}");
    }
    assert!(bench.run("list models").results().len() > 3);
}

#[test]
fn models_are_listed_by_id_name_authors_or_year() {
    let bench = Bench::new();
    let ids = |word: &str| {
        let table = bench.data(&format!("list models {word} --format csv"));
        cells(&table, "model").join(" ")
    };
    assert_eq!(ids("ke"), "ke ke-random ke-pairs");
    assert_eq!(ids("Kogut"), "ke");
    assert_eq!(ids("jkr"), "jkr jkr-separation");
    assert_eq!(ids("gw-random"), "gw-random");
    assert_eq!(ids("2005"), "etsion jg jg-cosine af");
    let pairs = ON_OTHERS.replace('*', "pairs");
    assert_eq!(
        [ids("pairs"), ids("tripp"), ids("greenwood tripp")],
        [(); 3].map(|()| pairs.clone())
    );
    assert_eq!(ids("greenwood"), "gw");
    // How all of these differ, and three words for their sources.
    assert_eq!(bench.run("list models pairs").results().len(), 4);
    let entries = bench.data("list models gw --format bibtex");
    let readme = include_str!("../../../../../README.md");
    let (program, gw) = entries.split_once("gw, gw-random, gw-pairs\n").unwrap();
    assert!(readme.contains(program.trim_end()), "{program}");
    assert!(gw.starts_with("@article{greenwood1966,\n  author = {Greenwood, J. A. and Williamson"));
}

#[test]
fn persson_is_compared_with_asperity_models_at_loads() {
    let bench = Bench::new();
    let ask = "--model persson,persson-fudge,gw --pressure 1e7 --quantity area-fraction,tangent";
    let run = bench.run(&format!("curve scene.toml --reference gw {ask} --format csv"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert_eq!(cells(&run.out, "model"), ["persson", "persson-fudge", "gw"]);
    assert!(run.messages.contains("[no-value]"), "{}", run.messages);
    // erf(p/√(2V)), V = E² m₂/2: of the scene's own surface.
    let scene = bench.scene("scene.toml").scene;
    let m2 = scene.surface.moments().m2;
    let small = (4.0 / std::f64::consts::PI / m2).sqrt() * 1e7 / scene.interface.equivalent_modulus;
    let area: f64 = cells(&run.out, "area_fraction")[0].parse().unwrap();
    assert!((area / small - 1.0).abs() < 0.01 && area < small, "{area} {small}");
    // With it, there are stiffnesses, and separations lead back to loads.
    bench.write("hurst.toml", &format!("{}hurst_exponent = 0.8\n", asperity_scene::template()));
    let loads = "curve hurst.toml --model persson,persson-fudge --pressure 1e6,1e7 --format csv";
    let data = bench.data(&format!("{loads} --quantity tangent"));
    let (gaps, tangents) = (column(&data, "separation_m"), column(&data, "tangent_N_per_m"));
    assert!(gaps[0] > gaps[1] && tangents[0] < tangents[1], "{data}");
    let back = "curve hurst.toml --model persson --format csv --quantity force";
    let back = bench.data(&format!("{back} --separation {}m", gaps[0]));
    assert!((column(&back, "force_N")[0] / 100.0 - 1.0).abs() < 1e-8, "{back}");
}

#[test]
fn models_of_the_whole_surface_have_no_asperity_warnings() {
    let bench = Bench::new();
    // Few asperities on the nominal area, heavy loads, a broad surface: nothing to Persson.
    let surface = "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 1e7\n";
    let head = NO_SHEAR.split_once("[surface]").unwrap().0.replace("3e-5", "1e-12");
    bench.write("broad.toml", &format!("{head}{surface}"));
    let arguments = |model: &str| {
        let ask = "--pressure 2e8 --quantity area-fraction";
        bench.run(&format!("curve broad.toml --model {model} {ask}")).messages
    };
    let (gw, persson) = (arguments("gw"), arguments("persson-fudge"));
    assert!(gw.contains("roughness_parameter") && !persson.contains("roughness"), "{gw}{persson}");
    bench.write("few.toml", &NO_SHEAR.replace("3e-5", "1e-10"));
    for (scene, load, printed) in
        [("scene.toml", "2e9", "[crowded]"), ("few.toml", "1e7", "[few-asperities]")]
    {
        let arguments = |model: &str| {
            let ask = format!("--pressure {load} --quantity area-fraction");
            bench.run(&format!("curve {scene} --model {model} {ask}")).messages
        };
        let (ke, fudge) = (arguments("ke"), arguments("persson-fudge"));
        assert!(ke.contains(printed) && !fudge.contains(printed), "{ke}\n{fudge}");
        let check = format!("check {scene} --pressure {load} --format csv");
        let [ke, fudge] = ["ke", "persson-fudge"]
            .map(|model| bench.run(&format!("{check} --model {model}")).messages);
        assert!(ke.contains(printed) && !fudge.contains(printed), "{ke}\n{fudge}");
    }
}
