//! Options of the models: every value changes a result, and all interfaces agree.

use std::collections::BTreeMap;
use std::path::Path;

use asperity::{Model, Quantity, Request, Tolerance};
use asperity_scene::{ModelOptions, SceneError, SceneFile, parse, template};

use crate::scene_files::{SURFACE, text};

const BARE: &str = include_str!("scenes/bare.toml");

/// Options other than the defaults.
const OTHERS: &str = include_str!("scenes/options.toml");

/// The template's scene with one line of `[options]` instead of its own.
fn scene(option: &str) -> SceneFile {
    let (scene, _) = template().split_once("[options]").unwrap();
    parse(&format!("{scene}[options]\n{option}\n"), Path::new(".")).unwrap()
}

fn values(file: &SceneFile, id: &str) -> Vec<f64> {
    // A loose tolerance is fast; the same law still gives the same digits.
    let request = Request::new([Quantity::Force]).at([0.5, 2.0]);
    let request = request.within(Tolerance::new(1e-3).unwrap());
    let answer = file.model(id).unwrap().solve(&file.scene, &request).unwrap();
    answer.values(Quantity::Force).unwrap().to_vec()
}

#[test]
fn every_option_changes_the_results_of_its_models_only() {
    let ids = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "jg-cosine", "af", "gao", "at"];
    let ids = ids.into_iter().chain(["at-additive", "at-overlap"]);
    let plain = scene("");
    let defaults: Vec<_> = ids.map(|id| (id, values(&plain, id))).collect();
    let lateral = &["gao", "at", "at-additive", "at-overlap"][..];
    for (option, changed) in [
        ("angle_density = { a20 = -0.5, a21 = 1.0, b21 = 1.0 }", &[][..]),
        ("angle_density = { a20 = 0, a21 = 1, b21 = 1 }", lateral),
        ("angle_density = { a20 = -0.5, a21 = 0.1, b21 = 0.2 }", &[]),
        ("angle_density = \"upright\"", lateral),
        ("displacement = \"vertical\"", &[]),
        ("displacement = \"none\"", lateral),
        ("displacement = { zeta = 0.1, xi = 0.1 }", lateral),
        ("stick = \"clamped\"", &[]),
        ("stick = \"unlimited\"", lateral),
        ("force = \"size\"", &[]),
        ("force = \"vertical\"", lateral),
        ("af_flow_pressure = \"SH\"", &[]),
        ("af_flow_pressure = \"H\"", &["af"]),
    ] {
        let file = scene(option);
        for (id, before) in &defaults {
            let after = values(&file, id);
            let largest = before.iter().zip(&after).map(|(a, b)| (b / a - 1.0).abs());
            let largest = largest.fold(0.0, f64::max);
            let should = changed.contains(id);
            assert!(
                if should { largest > 1e-4 } else { largest < 1e-12 },
                "{option} {id}: {largest:e}"
            );
        }
    }
    // ξ has its own effect, like ζ.
    let [a, b] = ["{ zeta = 0.1, xi = 0.3 }", "{ zeta = 0.1, xi = 0.1 }"]
        .map(|d| values(&scene(&format!("displacement = {d}")), "gao"));
    assert!((a[0] / b[0] - 1.0).abs() > 1e-6, "{a:?} {b:?}");
}

#[test]
fn models_that_a_scene_does_not_allow_are_left_out_with_the_reason() {
    let (models, left_out) = scene("").models();
    let usual = Model::usual();
    assert!(usual.len() == 9 && usual.iter().all(|model| !model.id().contains('-')));
    assert!(models.len() == usual.len() && left_out.is_empty());
    let of =
        |more: &str| parse(&text("", &format!("{BARE}{more}"), SURFACE), Path::new(".")).unwrap();
    let file = of("");
    let (models, left_out) = file.models();
    assert_eq!(models.len(), 7);
    // Like bodies that harden have a model more.
    let with_it = of("tangent_modulus = 2e9").models().0;
    let ids = with_it[models.len()..].iter().map(|model| model.id());
    assert_eq!(ids.collect::<Vec<_>>(), ["ghaednia"]);
    let ids: Vec<&str> = left_out.iter().map(|left| left.id.as_str()).collect();
    assert_eq!(ids, ["gao", "at"]);
    assert!(left_out[0].reason.to_string().starts_with("equivalent_shear_modulus is missing"));
}

#[test]
fn keywords_serde_and_scene_files_agree() {
    let from_file = scene(OTHERS).spec.options;
    let mut by_keyword = ModelOptions::default();
    for (name, value) in [
        ("angle_density", "upright".into()),
        ("displacement", BTreeMap::from([("zeta", 0.1), ("xi", 0.2)]).into()),
        ("stick", "unlimited".into()),
        ("force", "vertical".into()),
        ("af_flow_pressure", "H".into()),
    ] {
        by_keyword.set(name, &value).unwrap();
    }
    assert_eq!(from_file, by_keyword);
    let json = serde_json::to_string(&from_file).unwrap();
    assert_eq!(serde_json::from_str::<ModelOptions>(&json).unwrap(), from_file);
    assert_eq!(serde_json::from_str::<ModelOptions>("{}").unwrap(), ModelOptions::default());
    assert!(matches!(by_keyword.set("stik", &"x".into()), Err(SceneError::Refused { .. })));
    let harmonic = |a20| BTreeMap::from([("a20", a20), ("a21", 0.0), ("b21", 0.0)]).into();
    for (name, bad) in [
        ("angle_density", harmonic(5.0)),
        ("angle_density", harmonic(f64::NAN)),
        ("angle_density", BTreeMap::from([("a20", 0.0), ("a21", 0.0)]).into()),
        ("angle_density", "flat".into()),
        ("angle_density", "vertical".into()),
        ("displacement", BTreeMap::from([("zeta", -1.0), ("xi", 0.0)]).into()),
        ("stick", BTreeMap::from([("zeta", 1.0)]).into()),
    ] {
        let refused = by_keyword.set(name, &bad).unwrap_err();
        assert!(refused.place().is_some_and(|at| at.field.starts_with(name)), "{refused}");
        assert_eq!(by_keyword, from_file);
    }
    let changed = by_keyword.changed();
    assert!(changed.len() == 5 && ModelOptions::default().changed().is_empty());
}

#[test]
fn an_option_is_of_the_models_that_it_changes() {
    for (id, option, is_own) in [
        ("gao", "stick", true),
        ("at-overlap", "force", true),
        ("ke", "force", false),
        ("af-random", "af_flow_pressure", true),
        ("persson-fudge", "hurst_exponent", true),
        ("persson-plastic", "hurst_exponent", false),
        ("bem", "elastic", true),
        ("bem", "friction_cut_off", false),
    ] {
        assert_eq!(ModelOptions::check_for(id, option).is_ok(), is_own, "{id} {option}");
    }
}
