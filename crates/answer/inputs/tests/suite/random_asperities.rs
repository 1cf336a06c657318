//! Random asperities by their ids: reference values and errors.

use std::path::Path;

use asperity::{Asperities, ContactModel, Model, Quantity, Request, Separation, Tolerance};
use asperity_inputs::{SceneFile, parse, template};

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The scene of a case of `population_scenes.csv`, as a file.
fn scene(line: &str) -> (SceneFile, f64) {
    let fields: Vec<&str> = line.split(',').collect();
    let [_, modulus, poisson, hardness, factor, m0, m2, m4] = fields[..] else { panic!("{line}") };
    let text = format!(
        "nominal_area = 1.0\n[interface]\nequivalent_modulus = {modulus}\npoissons_ratio = {poisson}\n\
         hardness = {hardness}\npressure_factor = {factor}\nequivalent_shear_modulus = 1e9\n\
         [surface]\nm0 = {m0}\nm2 = {m2}\nm4 = {m4}\n\
         separation_from = \"surface-mean\"\n"
    );
    (read(&text), m0.parse::<f64>().unwrap().sqrt())
}

fn scenes() -> impl Iterator<Item = &'static str> {
    include_str!("../../../../../tests/reference/population_scenes.csv").lines().skip(1)
}

/// Every row of three models on every surface. The reference program leaves out the sharpest
/// asperities, some 1e-9 of all and a larger share of the highest. `asperity-random` includes them,
/// and agrees with all rows to 1e-11.
#[test]
fn reference_rows_are_met_through_the_scene_file() {
    let mut count = 0;
    for line in scenes() {
        let case = line.split(',').next().unwrap();
        let (file, rms) = scene(line);
        for id in ["gw", "ke", "jg"] {
            let model = file.model(&format!("{id}-random")).unwrap();
            let quantities = [Quantity::Force, Quantity::Area, Quantity::Tangent];
            let request = Request::new(quantities).within(Tolerance::new(1e-11).unwrap());
            let contact = model.compile(&file.scene, &request).unwrap();
            let rows =
                include_str!("../../../../../tests/reference/population.csv").lines().skip(1);
            for row in rows.filter(|row| row.starts_with(&format!("{case},{id},"))) {
                let fields: Vec<&str> = row.split(',').collect();
                let height = fields[2].parse::<f64>().unwrap() * rms;
                let at = file.separation(height, asperity::SeparationUnit::Metres);
                let found = contact.evaluate(fields[3].parse().unwrap(), at).unwrap().value();
                let error = found / fields[4].parse::<f64>().unwrap() - 1.0;
                // Asperities in contact at larger separations are sharper.
                let allowed = 1e-8 * 10f64.powf(0.8 * fields[2].parse::<f64>().unwrap().max(0.0));
                assert!(error.abs() < allowed, "{row}: {error:e}");
                count += 1;
            }
        }
    }
    assert_eq!(count, 135);
}

#[test]
fn options_and_numbers_of_a_scene_hold_on_random_asperities() {
    let (mut file, rms) = scene(scenes().next().unwrap());
    let value = |file: &SceneFile| {
        let at = Separation::metres(2.0 * rms).from_surface_mean();
        let request = Request::new([Quantity::Force]).at([at]);
        let answer = file.model("ke-random").unwrap().solve(&file.scene, &request).unwrap();
        answer.values(Quantity::Force).unwrap()[0]
    };
    let area = file.inputs(["nominal_area"]).unwrap()[0];
    let moved = file.with_inputs([(area, 2.0)]).unwrap();
    assert!((value(&moved) / value(&file) - 2.0).abs() < 1e-12);
    file.options.set("af_flow_pressure", &"H".into()).unwrap();
    let af = file.model("af-random").unwrap();
    assert!(af.options().unwrap().to_string().contains("\"H\""), "{:?}", af.options());
}

#[test]
fn models_without_random_asperities_give_the_reason() {
    let (file, _) = scene(scenes().next().unwrap());
    let refused = |file: &SceneFile, model: Model| file.refusal(&model).unwrap().to_string();
    let inclined = file.model("gao").unwrap().on(Asperities::Random);
    assert!(refused(&file, inclined).contains("contacts are inclined"));
    let heights = template().replace("heights = \"gaussian\"", "heights = \"exponential\"");
    let file = read(&heights);
    let random = file.model("ke-random").unwrap();
    assert!(refused(&file, random).contains("Gaussian"));
}
