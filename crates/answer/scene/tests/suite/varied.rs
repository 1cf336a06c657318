//! A scene with other numbers is its file with these numbers in the place of those written.

use std::path::Path;

use asperity::fit::Data;
use asperity::{ContactModel, Datum, Quantity, Request};
use asperity_scene::{
    BODY, Free, KEYS, Key, SceneFile, Subject, key_of_input, parse, read_measurements,
};

/// A section with its keys.
type Section = (&'static str, Vec<(&'static str, f64)>);

/// Every way to describe a surface by numbers; with `ra`, the finish is ground.
const WAYS: [&[(&str, f64)]; 10] = [
    &[("asperity_radius", 2e-4), ("asperity_density", 2e8), ("asperity_height_std", 1e-6)],
    &[("plasticity_index", 2.0), ("roughness_parameter", 0.04), ("asperity_height_std", 1e-6)],
    &[("asperity_radius", 2e-4), ("asperity_density", 2e8), ("surface_height_std", 1.1e-6)],
    &[("surface_height_std", 1.1e-6), ("mean_slope", 0.03), ("asperity_density", 2e8)],
    &[("m0", 1e-12), ("m2", 1e-4), ("m4", 5e4)],
    &[("sq", 1.1e-6), ("spd", 2e8), ("spc", 5e3)],
    &[("rq", 1.1e-6), ("rdq", 0.06), ("bandwidth", 8.0)],
    &[("rz", 5e-6), ("rsm", 1.2e-4), ("lambda_c", 8e-4), ("lambda_s", 2.5e-6)],
    &[("ra", 8e-7)],
    &[("ra", 8e-7), ("rdq", 0.06)],
];
const DRAWN: usize = 7;

/// Curved bodies in each way; the first flat.
const CURVED: [&[(&str, f64)]; 6] = [
    &[],
    &[("radius", 0.01)],
    &[("radius_x", 0.46), ("radius_y", 0.3)],
    &[("radius_x", 0.01), ("length", 0.02)],
    &[("radius_x", 0.01), ("length", 0.02), ("reference_length", 0.1)],
    &[("body1_radius_x", 0.01), ("body2_radius_x", -0.02), ("body2_radius_y", 0.3)],
];

/// A number of a key that is not written.
fn other(key: &str) -> Option<f64> {
    let mut lines = include_str!("others.csv").lines();
    lines.find_map(|line| line.strip_prefix(key)?.strip_prefix(' ')?.parse().ok())
}

fn text(sections: &[Section], more: &str) -> String {
    let mut text = String::new();
    for (section, keys) in sections {
        let header = if section.is_empty() { String::new() } else { format!("[{section}]\n") };
        text += &header;
        keys.iter().for_each(|(key, number)| text += &format!("{key} = {number:e}\n"));
        let is_surface = section.starts_with("surface");
        // A finish beside the other ways is refused.
        let is_ground = is_surface && keys.first().is_some_and(|(key, _)| *key == "ra");
        text += if is_ground { "finish = \"ground\"\n" } else { "" };
        text += if *section == "surface" { more } else { "" };
    }
    text
}

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Everything of a scene on which an answer depends, also at the ends of its ranges.
fn physics(file: &SceneFile) -> String {
    let mut scenes = vec![&file.scene];
    let unknowns = file.unknowns().len();
    let ends = [0.0, 0.3, 1.0].map(|share| file.at(&vec![share; unknowns]).unwrap());
    scenes.extend(ends.iter().map(|end| &end.scene));
    let lay = [Some(&file.spec.surface), file.spec.counterface.as_ref()];
    let lay = lay.map(|one| one.and_then(|one| one.peklenik_number));
    let shape = (file.spec.curvature, file.shape());
    format!("{scenes:?} {:?} {lay:?} {:?} {shape:?}", file.bodies(), file.spec.gas)
}

/// Bodies or an interface, a surface by `way`, and a counterface by another.
fn scenes(bodies: bool, way: usize, counterface: Option<usize>) -> Vec<Section> {
    let body = |modulus| {
        vec![("youngs_modulus", modulus), ("poissons_ratio", 0.3), ("hardness", modulus / 100.0)]
    };
    let interface = vec![("equivalent_modulus", 1e11), ("poissons_ratio", 0.3), ("hardness", 2e9)];
    let mut sections = vec![("", vec![("nominal_area", 1e-4)])];
    match bodies {
        true => sections.extend([("[body]", body(2.1e11)), ("[body]", body(7e10))]),
        false => sections.push(("interface", interface)),
    }
    let gas = vec![("gas_conductivity", 0.026), ("gas_parameter", 3.7e-7)];
    sections.push(("gap", gas));
    sections.push(("surface", WAYS[way].to_vec()));
    sections.extend(counterface.map(|way| ("surface.counterface", WAYS[way].to_vec())));
    sections
}

/// The sections with a number in the place of that of an input, or beside those that are written.
fn edited(sections: &[Section], name: &str, number: f64) -> Vec<Section> {
    let all_of = |name: &str| (0..sections.len()).filter(|k| sections[*k].0 == name).collect();
    let (bodies, curved): (Vec<usize>, Vec<usize>) = (all_of("[body]"), all_of("curvature"));
    let is_curved = |key: &Key| key.subject == Subject::Curvature && key.name == name;
    let (of, key) = match name.split_once('_') {
        _ if KEYS.iter().any(is_curved) => (curved, name),
        Some(("body1", key)) => (vec![bodies[0]], key),
        Some(("body2", key)) => (vec![bodies[1]], key),
        Some(("counterface", key)) => (vec![sections.len() - 1], key),
        _ => ((0..sections.len()).filter(|k| !sections[*k].0.contains("counter")).collect(), name),
    };
    let (mut found, mut is_written) = (sections.to_vec(), false);
    for k in &of {
        for (_, value) in found[*k].1.iter_mut().filter(|(other, _)| *other == key) {
            (*value, is_written) = (number, true);
        }
    }
    if is_written {
        return found;
    }
    let key = KEYS.iter().find(|known| known.name == key).unwrap();
    let is_drawn = |section: &Section| ["rq", "rz", "ra"].contains(&section.1[0].0);
    for k in of {
        let section = sections[k].0;
        let is_home = match key.subject {
            Subject::Body | Subject::Interface => ["[body]", "interface"].contains(&section),
            Subject::Scene => section == if bodies.is_empty() { "interface" } else { "" },
            Subject::Surface => section.starts_with("surface"),
            Subject::Curvature => true,
            _ => section.starts_with("surface") && is_drawn(&sections[k]),
        };
        if is_home {
            found[k].1.push((key.name, number));
        }
    }
    found
}

/// Each number that a scene takes, set in the scene and in its file: the same scene, or both
/// refuse.
#[test]
fn every_number_of_every_description_is_edited_where_it_was_written() {
    let (mut edits, mut refused) = (0, 0);
    let last = WAYS.len() - 1;
    for way in 0..WAYS.len() {
        let offset = "mean_plane_offset = 2e-6\n";
        for (counterface, bodies, more, curved) in [
            (None, false, "", CURVED[0]),
            (Some(last - way), true, offset, CURVED[0]),
            (None, true, "", CURVED[1 + way % (CURVED.len() - 1)]),
        ] {
            let mut sections = scenes(bodies, way, counterface);
            if !curved.is_empty() {
                sections[0].1.clear();
                sections.insert(1, ("curvature", curved.to_vec()));
            }
            let file = read(&text(&sections, more));
            for (name, input) in file.all_inputs() {
                let given = file.value_of(input);
                let Some(value) = given.or_else(|| other(key_of_input(&name))) else {
                    // Of two bodies, a number in which they differ.
                    assert!(BODY.iter().any(|field| field.name == name), "{name}");
                    continue;
                };
                let number = 1.02 * value;
                let context = format!("{name} of {}", text(&sections, more));
                let varied = file.with_inputs([(input, number)]);
                let more = if name == "mean_plane_offset" { "" } else { more };
                let edited = edited(&sections, &name, number);
                let (wanted, varied) = match (parse(&text(&edited, more), Path::new(".")), varied) {
                    (Ok(wanted), Ok(varied)) => (wanted, varied),
                    (wanted, varied) => {
                        assert!(wanted.is_err() && varied.is_err(), "{varied:?}\n{context}");
                        refused += 1;
                        continue;
                    }
                };
                edits += 1;
                assert_eq!(physics(&varied), physics(&wanted), "{context}");
                assert_eq!(varied.warnings.len(), wanted.warnings.len(), "{context}");
                // Written and read again.
                if edits % 4 == 0 {
                    let again = read(&varied.to_toml().unwrap());
                    assert_eq!(physics(&varied), physics(&again), "{context}");
                }
                // And back.
                let Some(value) = given else { continue };
                let input = varied.inputs([&*name]).unwrap()[0];
                let back = varied.with_inputs([(input, value)]).unwrap();
                let off = back.scene.surface.asperity_radius / file.scene.surface.asperity_radius;
                assert!((off - 1.0).abs() < 1e-12, "{context}");
            }
        }
    }
    assert!(edits > 500 && refused > 2, "{edits} {refused}");
}

/// What no edit of the file gives, the scene refuses as well.
#[test]
fn keys_of_other_descriptions_are_refused_as_in_the_file() {
    for way in 0..WAYS.len() {
        let sections = scenes(false, way, None);
        let file = read(&text(&sections, ""));
        let inputs = file.all_inputs();
        for key in KEYS.iter().filter(|key| key.subject == Subject::Roughness) {
            if key.name == "finish" || inputs.iter().any(|(name, _)| name == key.name) {
                continue;
            }
            let mut edited = sections.clone();
            edited[3].1.push((key.name, 1e-6));
            assert!(parse(&text(&edited, ""), Path::new(".")).is_err(), "{} {}", way, key.name);
            assert!(file.inputs([key.name]).is_err(), "{} {}", way, key.name);
        }
    }
}

#[test]
fn two_numbers_are_replaced_in_either_order_or_refused_together() {
    for way in 0..DRAWN {
        let sections = scenes(true, way, None);
        let file = read(&text(&sections, ""));
        let names: Vec<String> = file.all_inputs().into_iter().map(|(name, _)| name).collect();
        for (k, one) in names.iter().enumerate() {
            for other in &names[..k] {
                let found = file.inputs([&**one, &**other]);
                let turned = file.inputs([&**other, &**one]);
                assert_eq!(found.is_ok(), turned.is_ok(), "{one} {other}");
                let (Ok(found), Ok(turned)) = (found, turned) else { continue };
                let values = [0, 1].map(|k| file.value_of(found[k]));
                let [Some(a), Some(b)] = values.map(|v| v.map(|v| 1.02 * v)) else { continue };
                let made = file.with_inputs([(found[0], a), (found[1], b)]);
                let again = file.with_inputs([(turned[0], b), (turned[1], a)]);
                let scene = |made: Result<SceneFile, _>| made.map(|file| physics(&file));
                assert_eq!(scene(made), scene(again), "{one} {other}");
            }
        }
    }
    let file = read(&text(&scenes(true, 4, None), ""));
    for names in [["hardness", "body1_youngs_modulus"], ["hardness", "youngs_modulus"]] {
        assert!(file.inputs(names).is_ok(), "{names:?}");
    }
}

#[test]
fn of_two_surfaces_a_fit_finds_the_number_of_the_first() {
    let folder = tempfile::tempdir().unwrap();
    for (way, key) in [(0, "asperity_height_std"), (4, "m0")] {
        let mut sections = scenes(false, way, Some(0));
        let counterface = &mut sections[4].1;
        (counterface[0].1, counterface[1].1, counterface[2].1) = (1e-4, 1e9, 4e-7);
        let truth = read(&text(&sections, ""));
        let start = truth.inputs([key]).unwrap()[0];
        let value = truth.value_of(start).unwrap();
        for id in ["ke", "ke-pairs"] {
            let model = truth.model(id).unwrap();
            let loads = [1e5, 1e6, 1e7].map(|pressure| 1e-4 * pressure);
            let request = Request::new([Quantity::Area, Quantity::Tangent]).at_loads(loads);
            let answer = model.solve(&truth.scene, &request).unwrap();
            let columns = [Quantity::Area, Quantity::Tangent].map(|q| answer.values(q).unwrap());
            let mut rows = "load_N,area_m2,tangent_N_per_m\n".to_string();
            for (k, load) in loads.iter().enumerate() {
                rows += &format!("{load:e},{:e},{:e}\n", columns[0][k], columns[1][k]);
            }
            let path = folder.path().join("data.csv");
            std::fs::write(&path, rows).unwrap();
            let data = truth.data(&read_measurements(path).unwrap()).unwrap();
            let off = truth.with_inputs([(start, 1.2 * value)]).unwrap();
            let free: Free = key.parse().unwrap();
            let go_on = &mut |_: &_| std::ops::ControlFlow::Continue(());
            let fitted = off.fit(&model, &data, &[free], go_on).unwrap();
            let found = fitted.parameters[0].value;
            assert!((found / value - 1.0).abs() < 1e-6, "{id} {key}: {found} of {value}");
        }
    }
}

/// One value of both bodies would hide in which of them it was fitted.
#[test]
fn a_number_in_which_bodies_differ_is_fitted_for_one_of_them() {
    let columns = [("load_N", 1.0), ("area_m2", 1e-9), ("area_m2_std", 1e-11)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    let data = Data::from_columns(&columns, Datum::AsperityMean).unwrap();
    let file = read(&text(&scenes(true, 0, None), ""));
    for (name, is_free) in [
        ("hardness", false),
        ("hardness=1GPa:4GPa", false),
        ("body1_hardness", true),
        ("body2_hardness", true),
        ("poissons_ratio", true),
    ] {
        let found = file.free_parameters(&[name.parse().unwrap()], &data);
        assert_eq!(found.is_ok(), is_free, "{name}: {found:?}");
    }
}

/// Resolving is a function of numbers: many scenes are made in the time of one text.
#[test]
fn many_scenes_are_varied_without_reading() {
    let file = read(&text(&scenes(true, 4, Some(4)), ""));
    let names = ["hardness", "youngs_modulus", "m0", "counterface_m2", "nominal_area"];
    let inputs = file.inputs(names).unwrap();
    let started = std::time::Instant::now();
    let count = 10_000;
    for k in 0..count {
        let share = 1.0 + f64::from(k) / f64::from(count);
        let values = [2e9 * share, 2e11, 1e-12 * share, 1e-4, 1e-4];
        let made = file.with_inputs(inputs.iter().copied().zip(values)).unwrap();
        assert!(made.scene.pair.is_some());
    }
    let each = started.elapsed().as_secs_f64() / f64::from(count);
    println!("{:.2} us a scene", 1e6 * each);
    assert!(each < 1e-4, "{each} s");
}
