//! Errors of scene files name the line, the field and the requirement.

use std::path::Path;

use asperity_scene::{SceneError, load};

use crate::scene_files::{INTERFACE, SURFACE, directory, text};

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
        assert!(matches!(refused, SceneError::Refused { .. }), "{refused}");
        assert!(refused.to_string().contains(name), "{refused}");
    }
    for path in [&*directory, Path::new("absent.toml")] {
        assert!(matches!(load(path), Err(SceneError::Refused { .. })));
    }
}
