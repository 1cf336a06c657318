//! Asperities of two rough surfaces: what the keys of one surface and of a counterface mean.

use std::path::Path;

use asperity::{
    At, Code, ContactModel, Datum, Pair, Quantity, Request, Separation, SeparationUnit, Surface,
};
use asperity_scene::{SceneFile, parse};

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
fn greenwood_tripp_is_gw_of_pairs() {
    let file = scene(MOMENTS);
    assert_eq!(file.model("gt").unwrap().id(), "gw-pairs");
    same(force(&file, "gw-pairs", 1.0), force(&file, "gt", 1.0));
}

#[test]
fn every_key_describes_one_of_both_surfaces() {
    let Surface { asperity_radius, asperity_density, asperity_height_std: std, .. } =
        scene(MOMENTS).scene.surface;
    let asperities =
        format!("asperity_radius = {asperity_radius:e}\nasperity_density = {asperity_density:e}\n");
    let of = |std: f64| scene(&format!("{asperities}asperity_height_std = {std:e}"));
    let at = At::from(Separation::metres(2e-6));
    same(force(&scene(MOMENTS), "ke-pairs", at), force(&of(std), "ke-pairs", at));
    // Separations count in the standard deviation of the sum.
    let two = At::from(Separation::metres(2.0 * 2f64.sqrt() * std));
    same(force(&of(std), "ke-pairs", 2.0), force(&of(std), "ke-pairs", two));
    let surface_std = scene(&format!("{asperities}surface_height_std = 1e-6"));
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
    let other = "[surface.counterface]\nasperity_radius = 1e-4\nasperity_density = 3e8";
    let other = format!("{other}\nasperity_height_std = 5e-7");
    let file = scene(&format!("{MOMENTS}\n{other}"));
    let second = Surface::new(1e-4, 3e8, 5e-7);
    let mut wanted = scene(MOMENTS);
    wanted.scene.pair = Some(Pair::new(wanted.scene.surface, second));
    same(force(&file, "jg-pairs", 1.0), force(&wanted, "jg-pairs", 1.0));
    let models = ["gw", "gw-pairs"].map(|id| file.model(id).unwrap());
    assert!(file.other_joint(models.iter()).is_none());
    let note = scene(MOMENTS).other_joint(models.iter()).unwrap();
    assert_eq!((note.code, note.field.as_ref()), (Code::OtherJoint, "asperity_radius"));
    assert!(scene(MOMENTS).other_joint(models[1..].iter()).is_none());
    // The counterface stays where numbers of the first surface change.
    let m0 = file.inputs(["m0"]).unwrap()[0];
    let rougher = file.with_inputs([(m0, 4e-12)]).unwrap().scene.pair.unwrap();
    let first = scene(&MOMENTS.replace("m0 = 1e-12", "m0 = 4e-12")).scene.surface;
    assert_eq!(rougher.surfaces.map(|one| one.asperities), [first, second]);
}

/// A film of 3 um between two surfaces, of which one has a given offset.
#[test]
fn each_surface_has_its_own_mean_plane_offset() {
    let second =
        |m0: f64, more: &str| format!("counterface = {{ m0 = {m0:e}, m2 = 1e-4, m4 = 5e4{more} }}");
    let first = format!("{MOMENTS}\nmean_plane_offset = 6e-7");
    let film = Separation::metres(4e-6).from_surface_mean();
    let of = |text: &str| force(&scene(text), "gw-pairs", film);
    let at = |text: &str, d: f64| force(&scene(text), "gw-pairs", Separation::metres(d));
    let own = scene(MOMENTS).scene.surface.mean_plane_offset();
    let alike = format!("{first}\n{}", second(1e-12, ""));
    same(of(&alike), at(MOMENTS, 4e-6 - 6e-7 - own));
    let near = of(&format!("{first}\n{}", second(1.000_001e-12, "")));
    assert!((near / of(&alike) - 1.0).abs() < 1e-4, "{near}");
    let both = format!("{first}\n{}", second(1e-12, ", mean_plane_offset = 6e-7"));
    same(of(&both), of(&first));
    same(of(&both), at(MOMENTS, 4e-6 - 2.0 * 6e-7));
    let other = format!("{MOMENTS}\n{}", second(1e-12, ", mean_plane_offset = 6e-7"));
    same(of(&other), of(&alike));
    // The surface that is equivalent to both has √2 times the offset of each, and is written again.
    let file = scene(&both);
    same(file.scene.mean_plane_offset(), 2f64.sqrt() * 6e-7);
    let again = parse(&file.to_toml().unwrap(), Path::new(".")).unwrap();
    same(force(&again, "gw-pairs", film), of(&both));
    let inputs = file.inputs(["mean_plane_offset"]).unwrap();
    let set = file.with_inputs([(inputs[0], 1e-6)]).unwrap();
    assert_eq!(set.value_of(inputs[0]), Some(1e-6));
    same(force(&set, "gw-pairs", film), at(MOMENTS, 4e-6 - 1e-6 - 6e-7));
}

#[test]
fn a_reading_of_a_separation_under_a_load_is_that_of_the_pair() {
    use asperity::fit::{Data, Rig, predict};
    let file = scene(MOMENTS);
    let columns = [("load_N", 1.0), ("separation_m", 1e-6), ("separation_m_std", 1e-9)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    for from in [Datum::AsperityMean, Datum::SurfaceMean] {
        let data = Data::from_columns(&columns, from).unwrap();
        let model = file.model("ke-pairs").unwrap();
        let found = predict(&*model, &file.scene, Rig::default(), &data);
        let contact = model.compile(&file.scene, &Request::new([Quantity::Force])).unwrap();
        let wanted = contact.separation_in(SeparationUnit::Metres, from, At::Load(1.0)).unwrap();
        same(*found[0].as_ref().unwrap(), wanted);
    }
}

/// Correlations of conductance describe the joint of both surfaces: √2 times σ and m of one.
#[test]
fn the_gap_of_correlations_has_the_roughness_of_both() {
    let named = format!("{MOMENTS}\ncounterface = {{ {} }}", MOMENTS.replace('\n', ", "));
    let [one, both] = [MOMENTS, &named].map(|text| scene(text).gap_roughness());
    same(both.height_std / one.height_std, 2f64.sqrt());
    same(both.mean_slope / one.mean_slope, 2f64.sqrt());
}

#[test]
fn a_counterface_that_is_the_same_stays_so_until_it_has_a_number_of_its_own() {
    let of = |m0: &str| scene(&format!("{}\ncounterface = \"same\"", MOMENTS.replace("1e-12", m0)));
    let with = |file: &SceneFile, name: &str, value: f64| {
        let input = file.inputs([name]).unwrap()[0];
        file.with_inputs([(input, value)]).unwrap()
    };
    let (file, edited) = (of("1e-12"), of("2e-12"));
    let varied = with(&file, "m0", 2e-12);
    assert_eq!(varied.to_toml().unwrap(), edited.to_toml().unwrap());
    assert!(edited.to_toml().unwrap().contains("counterface = \"same\""));
    same(force(&varied, "ke-pairs", 2.0), force(&edited, "ke-pairs", 2.0));
    let own = with(&with(&file, "counterface_m0", 2e-12), "m0", 3e-12);
    let [first, second] = own.scene.pair.unwrap().surfaces.map(|one| one.asperities.moments().m0);
    same(first, 3e-12);
    same(second, 2e-12);
    // At one end of their ranges both are the same.
    let lower = of("[1e-12, 2e-12]").taken_at("lower").unwrap().0;
    let larger = with(&lower, "m0", 3e-12);
    assert_eq!(larger.to_toml().unwrap(), of("3e-12").to_toml().unwrap());
}
