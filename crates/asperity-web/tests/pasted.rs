//! The Rust code that the page gives compiles and runs beside its scene file.

use asperity_web::Desk;
use serde_json::{Value, json};

/// The lines to paste, as a program.
mod pasted {
    include!("pasted/program.rs");

    pub(super) fn run() -> Result<(), Box<dyn std::error::Error>> {
        main()
    }
}

#[test]
fn the_code_to_paste_runs_beside_its_scene() {
    let mut desk = Desk::default();
    let mut call = |message: Value| -> Value {
        serde_json::from_str(&desk.call(&message.to_string())).unwrap()
    };
    let scene = asperity_inputs::template();
    let shown = call(json!({ "call": "show", "text": scene }));
    assert!(shown["ok"]["error"].is_null(), "{shown}");
    let load = json!({ "text": "123 N" });
    let code = call(json!({ "call": "code", "models": ["gw", "persson-fudge"], "load": load }));
    assert_eq!(code["ok"]["rust"], include_str!("pasted/program.rs"), "{}", code["ok"]["rust"]);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
    std::env::set_current_dir(folder.path()).unwrap();
    pasted::run().unwrap();
}
