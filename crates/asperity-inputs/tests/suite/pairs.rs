//! Asperities of two rough surfaces: what the keys of one surface and of a counterface mean.

use std::path::Path;

use asperity::{Asperities, At, ContactModel, Model, Pair, Quantity, Request, Separation, Surface};
use asperity_inputs::{SceneFile, parse};

const MOMENTS: &str = "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4";

fn scene(surface: &str) -> SceneFile {
    let head = "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\n\
                poissons_ratio = 0.3\nhardness = 2e9\n[surface]\n";
    parse(&format!("{head}{surface}\n"), Path::new(".")).unwrap()
}

fn force(file: &SceneFile, id: &str, at: impl Into<At>) -> f64 {
    let request = Request::new([Quantity::Force]);
    let contact = file.model(id).unwrap().compile(&file.scene, &request).unwrap();
    contact.evaluate(Quantity::Force, at).unwrap().value()
}

fn same(a: f64, b: f64) {
    assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
}

#[test]
fn the_key_the_id_and_greenwood_tripp_are_one() {
    let pairs = scene(&format!("{MOMENTS}\nasperities = \"pairs\""));
    let equal = scene(MOMENTS);
    assert_eq!(pairs.options.asperities, Asperities::Pairs);
    let ids: Vec<String> = pairs.models().0.iter().map(ToString::to_string).collect();
    let wanted = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"].map(|id| format!("{id}-pairs"));
    assert_eq!(ids, wanted);
    same(force(&pairs, "gw", 1.0), force(&equal, "gt", 1.0));
    same(force(&pairs, "ke", 1.0), force(&equal, "ke-pairs", 1.0));
    assert_eq!(pairs.model("gt").unwrap().id(), "gw-pairs");
    assert_eq!(pairs.model("ke-random").unwrap().id(), "ke-random");
}

#[test]
fn heights_of_asperities_are_those_of_both_and_of_a_surface_those_of_one() {
    let Surface { asperity_radius, asperity_density, asperity_height_std: std, .. } =
        scene(MOMENTS).scene.surface;
    let of = |std: f64| {
        scene(&format!(
            "asperity_radius = {asperity_radius:e}\nasperity_density = {asperity_density:e}\n\
             asperity_height_std = {std:e}"
        ))
    };
    let at = At::from(Separation::metres(2e-6));
    same(force(&scene(MOMENTS), "ke-pairs", at), force(&of(2f64.sqrt() * std), "ke-pairs", at));
    let surface_std = scene(&format!(
        "asperity_radius = {asperity_radius:e}\nasperity_density = {asperity_density:e}\n\
         surface_height_std = 1e-6"
    ));
    let found = force(&surface_std, "ke-pairs", at) / force(&scene(MOMENTS), "ke-pairs", at);
    assert!((found - 1.0).abs() < 1e-5, "{found}");
    // From the mean planes of both.
    let offset = 2.0 * scene(MOMENTS).scene.surface.mean_plane_offset();
    let film = Separation::metres(4e-6).from_surface_mean();
    let wanted = force(&scene(MOMENTS), "ke-pairs", Separation::metres(4e-6 - offset));
    same(force(&scene(MOMENTS), "ke-pairs", film), wanted);
    let measured = scene(&format!("{MOMENTS}\nmean_plane_offset = 1e-6"));
    let wanted = force(&scene(MOMENTS), "ke-pairs", Separation::metres(2e-6));
    same(force(&measured, "ke-pairs", film), wanted);
}

#[test]
fn a_counterface_has_asperities_of_its_own() {
    let other = "[surface.counterface]\nasperity_radius = 1e-4\nasperity_density = 3e8\n\
                 asperity_height_std = 5e-7";
    let file = scene(&format!("{MOMENTS}\n{other}"));
    let second = Surface::new(1e-4, 3e8, 5e-7);
    let mut wanted = scene(MOMENTS);
    wanted.scene.pair = Some(Pair::new(wanted.scene.surface, second));
    same(force(&file, "jg-pairs", 1.0), force(&wanted, "jg-pairs", 1.0));
    let models = ["gw", "gw-pairs"].map(|id| file.model(id).unwrap());
    assert!(file.other_joint(models.iter()).is_none());
    let note = scene(MOMENTS).other_joint(models.iter()).unwrap();
    assert_eq!((note.code, note.field.as_ref()), ("other-joint", "asperity_radius"));
    assert!(scene(MOMENTS).other_joint(models[1..].iter()).is_none());
    // Rougher together: both surfaces by the same factor.
    let mut surface = file.scene.surface;
    surface.asperity_height_std *= 2.0;
    let area = file.scene.nominal_area;
    let rougher = file.with_numbers(file.scene.interface, surface, area).unwrap();
    let ratio = |k: usize| {
        let of = |file: &SceneFile| file.scene.pair.unwrap().surfaces[k].asperity_height_std;
        of(&rougher) / of(&file)
    };
    same(ratio(0), 2.0);
    same(ratio(1), 2.0);
}

#[test]
fn a_surface_smoother_than_its_asperities_is_refused_by_its_keys() {
    let text = "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\npoissons_ratio = 0.3\n\
                [surface]\nasperity_radius = 1e-5\nasperity_density = 1e9\n\
                surface_height_std = 1e-6\nasperities = \"pairs\"\n";
    let refused = parse(text, Path::new(".")).unwrap_err().to_string();
    let keys = "(asperity_density times asperity_radius times surface_height_std)";
    assert!(refused.contains("roughness_parameter is 0.01") && refused.contains(keys), "{refused}");
}
