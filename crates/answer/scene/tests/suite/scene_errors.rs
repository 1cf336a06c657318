//! Errors of scene files name the line, the field and the requirement.

use std::path::Path;

use asperity_scene::{SceneError, load};

use crate::scene_files::{INTERFACE, SURFACE, directory, read, text};

#[test]
fn refusals_have_a_kind_a_line_and_a_field() {
    let with = |from: &str, to: &str| {
        let refused = read(&text("", INTERFACE, SURFACE).replace(from, to)).unwrap_err();
        let place = refused.place().unwrap().clone();
        (refused, place.line, place.field)
    };
    let std = (Some(12), "surface.asperity_height_std".to_string());
    for number in ["-1e-6", "0", "nan", "1e999"] {
        let (refused, line, field) = with("1e-6", number);
        assert!(matches!(refused, SceneError::Value { .. }) && (line, field) == std);
    }
    let (refused, line, field) = with("1e-6", "\"1 parsec\"");
    assert!(matches!(refused, SceneError::Notation { .. }) && (line, field) == std);
    let (refused, line, _) = with("asperity_radius", "asperity_radus");
    let SceneError::UnknownKey { near, .. } = refused else { panic!("{refused}") };
    assert_eq!((near.as_deref(), line), (Some("asperity_radius"), Some(10)));
    let (refused, ..) = with("asperity_radius", "m0 = 1\nasperity_radius");
    let SceneError::Conflict { at, other, .. } = refused else { panic!("{refused}") };
    assert_eq!((&*at.field, &*other.field), ("surface.asperity_radius", "surface.m0"));
    let (refused, _, field) = with("poissons_ratio = 0.31", "");
    assert!(matches!(refused, SceneError::Missing { .. }) && field == "interface.poissons_ratio");
}

#[test]
fn errors_of_files_name_the_file() {
    let directory = directory("names");
    let path = directory.join("scene.toml");
    std::fs::write(&path, text("", INTERFACE, &SURFACE.replace("1e-6", "0"))).unwrap();
    let refused = load(&path).unwrap_err();
    let place = refused.place().unwrap();
    assert_eq!((place.file.as_deref(), place.line), (Some(&*path), Some(12)));
    for (name, bytes) in [("utf16.toml", &b"\xff\xfe\x00"[..]), ("big.toml", &[b'#'; 1_100_000])] {
        let path = directory.join(name);
        std::fs::write(&path, bytes).unwrap();
        let refused = load(&path).unwrap_err();
        assert!(matches!(refused, SceneError::Unreadable { .. }), "{refused}");
        assert!(refused.to_string().contains(name), "{refused}");
    }
    for path in [&*directory, Path::new("absent.toml")] {
        assert!(matches!(load(path), Err(SceneError::Unreadable { .. })));
    }
}
