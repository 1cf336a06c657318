#![no_main]

use std::path::Path;

use asperity_inputs::{ModelOptions, parse};

libfuzzer_sys::fuzz_target!(|text: &str| {
    match parse(text, Path::new("/nowhere")) {
        Err(error) => {
            let error = error.to_string();
            assert!(error.contains("line ") && error.len() < 2000 && !error.contains('\n'), "{error}");
        }
        Ok(file) => {
            let written = file.to_toml(&[text]).expect("what was read");
            let again = parse(&written, Path::new("/nowhere")).expect("what was written");
            assert_eq!(again.scene.surface, file.scene.surface);
            assert_eq!(again.options.changed(), file.options.changed());
            let mut options = ModelOptions::default();
            for (name, value) in file.options.changed() {
                options.set(&name, &value).expect("what was read");
            }
            assert_eq!(options.changed(), file.options.changed());
        }
    }
});
