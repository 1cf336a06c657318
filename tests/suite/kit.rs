//! The public law test-kit, on every model of the project.

use asperity::{Asperity, Model, testkit};

use crate::scenes;

#[test]
fn no_model_has_a_finding() {
    let mut findings = vec![];
    for scene in ["at-paper", "mild", "severe"] {
        let asperity: Asperity = scenes::named(scene).asperity().unwrap();
        for model in Model::all() {
            let found = testkit::check(&model, &asperity).unwrap();
            findings.extend(found.iter().map(|finding| format!("{scene} {model} {finding}")));
        }
    }
    assert!(findings.is_empty(), "{}", findings.join("\n"));
}
