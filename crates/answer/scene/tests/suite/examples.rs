//! The example scenes agree with their comments.

use std::path::{Path, PathBuf};

use asperity::{At, Code, ContactError, Quantity, Request, Severity};
use asperity_scene::{LeftOut, SceneFile, load};

fn example(name: &str) -> SceneFile {
    load(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name)).unwrap()
}

#[test]
fn every_example_is_solved_by_every_model_it_allows() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let paths: Vec<PathBuf> =
        std::fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()).collect();
    assert_eq!(paths.len(), 6);
    for path in paths {
        let file = load(&path).unwrap();
        assert!(file.warnings.is_empty(), "{:?}", file.warnings);
        let (models, left_out) = file.models();
        let counts = match path.file_name().and_then(|name| name.to_str()) {
            Some("elastomer-on-glass.toml") => (1, 8),
            _ => (9, 0),
        };
        assert_eq!((models.len(), left_out.len()), counts);
        let beta = file.scene.surface.roughness_parameter();
        assert!((0.03..0.06).contains(&beta), "{}: beta_z = {beta}", path.display());
        for model in models {
            let request = Request::new([Quantity::Force]).at([3.0]);
            let answer = model.solve(&file.scene, &request).unwrap();
            let force = answer.values(Quantity::Force).unwrap()[0];
            assert!(force.is_finite() && (force > 0.0 || model.id() == "at"), "{model}: {force}");
        }
    }
}

#[test]
fn an_elastomer_has_no_hardness_and_greenwood_and_williamson_need_none() {
    let file = example("elastomer-on-glass.toml");
    let (allowed, left_out) = file.models();
    assert_eq!(allowed.iter().map(|model| model.id()).collect::<Vec<_>>(), ["gw"]);
    let missing =
        |one: &LeftOut| matches!(one.reason, ContactError::Missing { field: "hardness", .. });
    assert!(left_out.iter().all(missing), "{left_out:?}");
}

#[test]
fn a_load_beyond_full_contact_has_one_warning_and_full_contact_below_the_modulus_none() {
    let found = |file: &SceneFile, id: &str, at: At| {
        let warnings = file.judge(&file.model(id).unwrap(), None, &[at]);
        let warnings = warnings.at_least(Severity::Warning);
        warnings.iter().map(|found| (found.code, found.value)).collect::<Vec<_>>()
    };
    let (steel, soft) = (example("bolted-joint.toml"), example("elastomer-on-glass.toml"));
    let hardness = steel.scene.interface.softer_hardness().unwrap();
    for id in ["gw", "persson", "persson-fudge"] {
        let [light, heavy] =
            [0.99, 1.01].map(|share| found(&steel, id, At::Pressure(share * hardness)));
        let code = |(code, _): &(Code, f64)| *code == Code::BeyondFullContact;
        assert!(!light.iter().any(code) && heavy.iter().any(code), "{id}: {light:?} {heavy:?}");
        assert!(!heavy.iter().any(|(code, _)| *code == Code::Yields), "{id}: {heavy:?}");
    }
    let heavy = found(&steel, "persson-fudge", At::Pressure(1e34));
    assert_eq!(heavy, [(Code::BeyondFullContact, 1e34)]);
    // Pressed flat, the elastomer carries up to its modulus, 2.667 MPa.
    for id in ["persson", "persson-fudge"] {
        assert_eq!(found(&soft, id, At::Pressure(2.6e6)), []);
        assert_eq!(found(&soft, id, At::Pressure(1e7)), [(Code::BeyondFullContact, 1e7)]);
    }
}

#[test]
fn metals_have_the_plasticity_index_of_their_comment() {
    for (name, index) in [("wheel-rail.toml", 9.0), ("bolted-joint.toml", 10.1)] {
        let file = example(name);
        let found = file.scene.plasticity_index().unwrap();
        assert!((found / index - 1.0).abs() < 0.05, "{name}: {found}");
    }
}

#[test]
fn the_real_area_follows_from_load_and_hardness() {
    // Fully plastic contacts carry H, A/A_n = p/H; elastic-plastic ones have somewhat more area.
    for (name, load) in [("wheel-rail.toml", 100e3), ("bolted-joint.toml", 20e3)] {
        let file = example(name);
        let request = Request::new([Quantity::Force, Quantity::Area]);
        let compiled = file.model("ke").unwrap().compile(&file.scene, &request).unwrap();
        let found = compiled.separations_at(load).unwrap();
        let area = compiled.evaluate(Quantity::Area, found[0]).unwrap().value();
        let (hardness, _, _) = file.scene.interface.check().unwrap();
        let ratio = area * hardness.unwrap() / load;
        assert!(found.len() == 1 && (1.0..1.3).contains(&ratio), "{name}: {found:?} {ratio}");
    }
}
