//! The public law test-kit, on every model of the project.

use asperity::{Asperity, Described, Model, testkit};

use crate::{one_of, scenes};

#[test]
fn no_adhesive_model_has_a_finding() {
    for (scene, work) in [("at-paper", 0.05), ("mild", 1.0), ("severe", 1e-3), ("severe", 0.0)] {
        let mut scene = scenes::named(scene);
        scene.interface.work_of_adhesion = Some(work);
        let asperity: Asperity = scene.asperity().unwrap();
        for model in Model::adhesive() {
            let found = testkit::check(&model, &asperity).unwrap();
            assert!(found.is_empty(), "{model} {work}: {found:?}");
        }
    }
}

#[test]
fn no_model_has_a_finding() {
    let mut findings = vec![];
    for scene in one_of(3, ["at-paper", "mild", "severe"]) {
        let asperity: Asperity = scenes::named(scene).asperity().unwrap();
        for model in Model::of_asperities() {
            let found = testkit::check(&model, &asperity).unwrap();
            // JG and Etsion state that their forces may fall.
            let stated = |code: asperity::Code| {
                code.name() == "not-monotone" && !model.validity().force_monotone
            };
            let found = found.iter().filter(|finding| !stated(finding.code));
            findings.extend(found.map(|finding| format!("{scene} {model} {finding}")));
        }
    }
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}
