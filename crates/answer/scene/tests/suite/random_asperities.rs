//! Random asperities by their ids: options, numbers and errors.

use std::path::Path;

use asperity::{Asperities, ContactModel, Model, Quantity, Request, Separation};
use asperity_scene::{SceneFile, parse, template};

use crate::scene_files::INTERFACE;

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A scene by its moments, whose mean plane is the origin of separations.
fn scene() -> SceneFile {
    let head = "nominal_area = 1e-4\n".to_string() + INTERFACE;
    let moments = "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 5e4\n";
    read(&(head + moments + "separation_from = \"surface-mean\"\n"))
}

#[test]
fn options_and_numbers_of_a_scene_hold_on_random_asperities() {
    let mut file = scene();
    let value = |file: &SceneFile| {
        let at = Separation::metres(2e-6).from_surface_mean();
        let request = Request::new([Quantity::Force]).at([at]);
        let answer = file.model("ke-random").unwrap().solve(&file.scene, &request).unwrap();
        answer.values(Quantity::Force).unwrap()[0]
    };
    let area = file.inputs(["nominal_area"]).unwrap()[0];
    let moved = file.with_inputs([(area, 2e-4)]).unwrap();
    assert!((value(&moved) / value(&file) - 2.0).abs() < 1e-12);
    file.spec.options.set("af_flow_pressure", &"H".into()).unwrap();
    let af = file.model("af-random").unwrap();
    assert!(af.options().unwrap().to_string().contains("\"H\""), "{:?}", af.options());
}

#[test]
fn models_without_random_asperities_give_the_reason() {
    let file = scene();
    let refused = |file: &SceneFile, model: Model| file.refusal(&model).unwrap().to_string();
    let inclined = file.model("gao").unwrap().on(Asperities::Random);
    assert!(refused(&file, inclined).contains("contacts are inclined"));
    let heights = template().replace("heights = \"gaussian\"", "heights = \"exponential\"");
    let file = read(&heights);
    let random = file.model("ke-random").unwrap();
    assert!(refused(&file, random).contains("Gaussian"));
}
