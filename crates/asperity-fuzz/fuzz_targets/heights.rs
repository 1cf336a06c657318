#![no_main]

use asperity_inputs::{parse, write_heights};

const SCENE: &str = "nominal_area = 1e-4
[interface]
equivalent_modulus = 115e9
poissons_ratio = 0.3
hardness = 2e9
[surface]
asperity_radius = 2e-4
asperity_density = 2e8
heights = { file = \"pdf.csv\" }
";

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let folder = std::env::temp_dir().join(format!("asperity-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the table");
    let path = folder.join("pdf.csv");
    std::fs::write(&path, bytes).expect("a file for the table");
    match parse(SCENE, &folder) {
        Err(error) => {
            let error = error.to_string();
            assert!(error.contains("pdf.csv") || error.contains("surface"), "{error}");
        }
        Ok(file) => {
            let table = file.table.expect("the heights are a table");
            assert!(table.standard_deviation() > 0.0 && table.mean().is_finite());
            // A table that is written reads back unchanged.
            std::fs::write(&path, write_heights(table.points())).expect("a file for the table");
            assert!(parse(SCENE, &folder).is_ok());
        }
    }
});
