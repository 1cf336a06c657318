//! Random asperities by one key of the scene file: reference values and errors.

use std::path::Path;

use asperity::{ContactModel, Model, Quantity, Request, Separation, Tolerance};
use asperity_inputs::{Asperities, OptionValue, SceneFile, parse, template};

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The scene of a case of `population_scenes.csv`, as a file.
fn scene(line: &str, asperities: &str) -> (SceneFile, f64) {
    let fields: Vec<&str> = line.split(',').collect();
    let [_, modulus, poisson, hardness, factor, m0, m2, m4] = fields[..] else { panic!("{line}") };
    let text = format!(
        "nominal_area = 1.0\n[interface]\nequivalent_modulus = {modulus}\npoissons_ratio = {poisson}\n\
         hardness = {hardness}\npressure_factor = {factor}\nequivalent_shear_modulus = 1e9\n\
         [surface]\nm0 = {m0}\nm2 = {m2}\nm4 = {m4}\nasperities = \"{asperities}\"\n\
         separation_from = \"surface-mean\"\n"
    );
    (read(&text), m0.parse::<f64>().unwrap().sqrt())
}

fn scenes() -> impl Iterator<Item = &'static str> {
    include_str!("../../../../tests/reference/population_scenes.csv").lines().skip(1)
}

/// Every row of three models on every surface. The reference program leaves out the sharpest
/// asperities, some 1e-9 of all and a larger share of the highest. `asperity-random` includes them,
/// and agrees with all rows to 1e-11.
#[test]
fn reference_rows_are_met_through_the_scene_file() {
    let mut count = 0;
    for line in scenes() {
        let case = line.split(',').next().unwrap();
        let (file, rms) = scene(line, "random");
        for id in ["gw", "ke", "jg"] {
            let model = file.model(id).unwrap();
            assert_eq!(model.id(), format!("{id}-random"));
            let quantities = [Quantity::Force, Quantity::Area, Quantity::Tangent];
            let request = Request::new(quantities).within(Tolerance::new(1e-11).unwrap());
            let contact = model.compile(&file.scene, &request).unwrap();
            let rows = include_str!("../../../../tests/reference/population.csv").lines().skip(1);
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
fn the_key_changes_the_meaning_of_ids_only() {
    let line = scenes().next().unwrap();
    let ((random, rms), (equal, _)) = (scene(line, "random"), scene(line, "equal"));
    assert_eq!(random.options.asperities, Asperities::Random);
    let value = |file: &SceneFile, id: &str| {
        let at = Separation::metres(2.0 * rms).from_surface_mean();
        let request = Request::new([Quantity::Force]).at([at]);
        file.model(id)
            .unwrap()
            .solve(&file.scene, &request)
            .unwrap()
            .values(Quantity::Force)
            .unwrap()
    };
    assert_eq!(value(&random, "ke"), value(&equal, "ke-random"));
    assert_eq!(value(&random, "ke-random"), value(&equal, "ke-random"));
    assert!((value(&random, "ke")[0] / value(&equal, "ke")[0] - 1.0).abs() > 0.01);
    // The key as an option, and with other options.
    let mut file = equal.clone();
    file.options.set("asperities", &OptionValue::from("random")).unwrap();
    file.options.set("af_flow_pressure", &"H".into()).unwrap();
    assert_eq!(value(&file, "ke"), value(&random, "ke"));
    let af = file.model("af").unwrap();
    assert_eq!((af.id(), af.options()), ("af-random", file.model("af-random").unwrap().options()));
    assert!(af.options().unwrap().to_string().contains("\"H\""), "{:?}", af.options());
    let back = read(&file.to_toml(&[]).unwrap());
    assert_eq!(back.options, file.options);
    // The same scene with other numbers.
    let area = random.inputs(["nominal_area"]).unwrap()[0];
    let moved = random.with_inputs([(area, 2.0)]).unwrap();
    assert!((value(&moved, "ke")[0] / value(&random, "ke")[0] - 2.0).abs() < 1e-12);
}

#[test]
fn models_without_random_asperities_give_the_reason() {
    let (file, _) = scene(scenes().next().unwrap(), "random");
    let (allowed, left_out) = file.models();
    let ids: Vec<&str> = allowed.iter().map(|model| model.id()).collect();
    let wanted = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"].map(|id| format!("{id}-random"));
    assert_eq!(ids, wanted);
    assert_eq!(left_out.len(), 2);
    for model in &left_out {
        assert!(model.reason.to_string().contains("contacts are inclined"), "{model:?}");
    }
    // Theories of the whole surface have no asperities.
    for id in ["persson", "persson-fudge"] {
        let model = file.model(id).unwrap();
        assert_eq!(model.id(), id);
        assert!(model.compile(&file.scene, &Request::new([Quantity::Area])).is_ok());
    }
    let template = template().replace("asperities = \"equal\"", "asperities = \"random\"");
    let twice = template.replace("[options]", "[options]\nasperities = \"equal\"");
    let message = parse(&twice, Path::new(".")).unwrap_err().to_string();
    assert!(message.contains("surface.asperities") && message.contains("options"), "{message}");
    let message = parse(&template.replace("\"random\"", "\"radnom\""), Path::new("."));
    let message = message.unwrap_err().to_string();
    assert!(
        message.contains("asperities") && message.contains("the nearest is \"random\""),
        "{message}"
    );
    let heights = template.replace("heights = \"gaussian\"", "heights = \"exponential\"");
    let (allowed, left_out) = read(&heights).models();
    assert!(allowed.is_empty() && left_out[0].reason.to_string().contains("Gaussian"));
}

#[test]
fn the_readme_names_the_models_of_random_asperities() {
    let readme = include_str!("../../README.md");
    let (_, list) = readme.split_once("With `asperities = \"random\"` in `[surface]`, ").unwrap();
    let (list, _) = list.split_once(" mean `gw-random`").unwrap();
    let named = list.split('`').skip(1).step_by(2).map(|id| format!("{id}-random"));
    let hardening: Vec<Model> = Model::hardening().iter().map(Model::random).collect();
    let known = Model::all_on(Asperities::Random).into_iter().chain(hardening);
    let known: Vec<String> = known.map(|model| model.id().to_string()).collect();
    assert_eq!(named.collect::<Vec<_>>(), known);
}
