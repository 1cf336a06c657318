//! Messages of the commands, with plan, recommend and models.

use crate::bench::{Bench, NO_SHEAR, cells, column, csv, is_long};

#[test]
fn an_elastic_scene_needs_no_more_than_greenwood_and_williamson() {
    let bench = Bench::new();
    bench.write("soft.toml", &NO_SHEAR.replace("_std = 1e-6", "_std = 1e-10"));
    let run = bench.run("recommend soft.toml");
    // The density is implausible beside these heights.
    assert_eq!(run.code, Some(0));
    assert!(run.results()[0].starts_with("gw "), "{}", run.messages);
    assert!(run.messages.contains("[left-out]"));
    let data = bench
        .data("recommend scene.toml --format csv --reference gao --within 1e-3 --model gw,gao");
    let (head, rows) = csv(&data);
    assert_eq!(head[..5], ["model", "asperities", "force_deviation", "area_deviation", "simplest"]);
    let gao = rows.iter().find(|row| row[0] == "gao").unwrap();
    assert_eq!(gao[2..5], ["0", "0", "yes"]);
    let gw: f64 = cells(&data, "force_deviation")[0].parse().unwrap();
    assert!(gw > 1.0, "{gw}");
}

/// Of all kinds.
const MODELS: &str = "--model gao,persson-plastic,gw-random,ke,zmc,jg,gw";

#[test]
fn the_order_of_the_recommendation_is_the_one_that_is_printed() {
    let bench = Bench::new();
    let cases = [("0.3", "--pressure 1e6"), ("0.05", ""), ("0.02", "--load 1:1000:7:log")];
    for (within, arguments) in &cases[..if is_long() { 3 } else { 1 }] {
        let arguments = format!(
            "recommend scene.toml --within {within} --quantity area,tangent {MODELS} {arguments}"
        );
        let data = bench.data(&format!("{arguments} --format csv"));
        let (_, rows) = csv(&data);
        let kinds = ["upright", "random", "none", "at angles"];
        let kind = |row: &Vec<&str>| kinds.iter().position(|kind| *kind == row[1]).unwrap();
        assert!(rows.is_sorted_by_key(kind), "{data}");
        // The simplest model is the first that is near enough and holds.
        let most: f64 = within.parse().unwrap();
        let near = |row: &&Vec<&str>| {
            let within = |cell: &&str| cell.parse::<f64>().is_ok_and(|off| off <= most);
            row[2..4].iter().all(within) && row[4] != "no: not valid here"
        };
        let first = rows.iter().find(near).unwrap();
        let simplest: Vec<_> = rows.iter().filter(|row| row[4] == "yes").collect();
        assert_eq!(simplest, [first], "{data}");
    }
    let some = bench.data("recommend scene.toml --model zmc,jg,ke --load 10 --format csv");
    assert_eq!(cells(&some, "model"), ["jg", "zmc", "ke"]);
}

#[test]
fn the_recommendation_reports_evidence_or_its_absence() {
    let bench = Bench::new();
    let arguments = "recommend scene.toml --model gw,ke,persson-fudge --quantity area --format csv";
    let run = bench.run(&format!("{arguments} --load 20000"));
    assert_eq!(run.code, Some(0), "{}", run.messages);
    // One statement of the area, from the same ratio as the column.
    let lines: Vec<&str> = run
        .messages
        .lines()
        .filter(|line| line.contains("ke here") && line.contains("the area"))
        .collect();
    assert_eq!(lines.len(), 1, "{lines:?}");
    // Only what was asked for; the columns of the table are always the same.
    for other in ["first loading", "mean gap"] {
        assert!(!run.messages.contains(other), "{}", run.messages);
    }
    let (head, rows) = csv(&run.out);
    let columns =
        ["area_off_bem", "area_off_bem_spread", "stiffness_off_bem", "stiffness_off_bem_spread"];
    assert_eq!(head[head.len() - 4..], columns);
    let off = column(&run.out, "area_off_bem");
    assert!(off.iter().all(|off| off.abs() < 3.0) && rows.len() == 3, "{}", run.out);
    let run = bench.run(&format!("{arguments} --load 1e-9"));
    assert!(run.results().len() > 1 && run.code == Some(0), "{}", run.messages);
    assert!(cells(&run.out, "area_off_bem").iter().all(|cell| cell.is_empty()), "{}", run.out);
}

#[test]
fn each_load_has_its_own_evidence_and_invalid_models_are_not_recommended() {
    let bench = Bench::new();
    let run = bench
        .run("recommend scene.toml --load 1e-9,19000,20000 --quantity area,tangent --format csv");
    assert_eq!(run.code, Some(0), "{}", run.messages);
    assert!(run.results().len() > 1, "{}", run.messages);
    // Every model in a note has a row.
    let ids = cells(&run.out, "model");
    let pieces: Vec<&str> = run.messages.split(" (at most ").collect();
    let named: Vec<&str> = pieces[..pieces.len() - 1]
        .iter()
        .filter_map(|text| text.split_whitespace().last())
        .collect();
    assert!(named.len() > 3 && named.iter().all(|id| ids.contains(id)), "{named:?}");
    let off = cells(&run.out, "area_off_bem");
    assert!(off.iter().filter(|cell| !cell.is_empty()).count() > 10, "{}", run.out);
    // gw is near, and yet asperities yield.
    let run =
        bench.run("recommend scene.toml --load 1000 --within 80% --model gw,ceb --format csv");
    assert!(run.messages.contains("[yields]"), "{}", run.messages);
    assert!(!run.results().is_empty(), "{}", run.messages);
    assert_eq!(cells(&run.out, "simplest"), ["no: not valid here", "yes"]);
}

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
             cmy mikic {} bem",
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
fn evidence_is_about_what_is_requested() {
    let bench = Bench::new();
    let run = bench.run("recommend scene.toml --model ke --pressure 1e9 --quantity area");
    // The reference is also the recommended model.
    assert!(run.messages.contains("[crowded]"), "{}", run.messages);
    assert!(!run.messages.contains("2 rows"), "{}", run.messages);
    let ask = "--model ke,jg --quantity unloading-stiffness --format csv";
    let run = bench.run(&format!("recommend scene.toml --pressure 1e6 {ask}"));
    let off = cells(&run.out, "unloading_stiffness_off_bem");
    assert!(off.iter().all(|off| off.parse::<f64>().is_ok()), "{}", run.out);
    assert!(run.results().len() > 1, "{}", run.messages);
    let heavy = bench.run(&format!("recommend scene.toml --pressure 8e8 {ask}"));
    assert!(heavy.results().len() > 1, "{}", heavy.messages);
    // More digits than a choice of models needs take twice the time.
    assert!(bench.data("recommend --help").contains("[default: 1e-4]"));
    let area =
        bench.data("recommend scene.toml --pressure 1e6 --quantity area --model ke --format csv");
    assert!(!area.contains("unloading"), "{area}");
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
