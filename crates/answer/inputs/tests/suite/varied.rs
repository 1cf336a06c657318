//! A scene with other numbers is its file with these numbers in the place of those written.

use std::path::Path;

use asperity::{ContactModel, Quantity, Request};
use asperity_inputs::{Free, SceneFile, parse, read_measurements};

/// A section with its keys.
type Section = (&'static str, Vec<(&'static str, f64)>);

const WAYS: [[(&str, f64); 3]; 7] = [
    [("asperity_radius", 2e-4), ("asperity_density", 2e8), ("asperity_height_std", 1e-6)],
    [("plasticity_index", 2.0), ("roughness_parameter", 0.04), ("asperity_height_std", 1e-6)],
    [("asperity_radius", 2e-4), ("asperity_density", 2e8), ("surface_height_std", 1.1e-6)],
    [("surface_height_std", 1.1e-6), ("mean_slope", 0.03), ("asperity_density", 2e8)],
    [("m0", 1e-12), ("m2", 1e-4), ("m4", 5e4)],
    [("sq", 1.1e-6), ("spd", 2e8), ("spc", 5e3)],
    [("sq", 1.1e-6), ("spd", 2e8), ("sdq", 0.058)],
];

fn text(sections: &[Section], more: &str) -> String {
    let mut text = String::new();
    for (section, keys) in sections {
        let header = if section.is_empty() { String::new() } else { format!("[{section}]\n") };
        text += &header;
        keys.iter().for_each(|(key, number)| text += &format!("{key} = {number:e}\n"));
        text += if *section == "surface" { more } else { "" };
    }
    text
}

fn read(text: &str) -> SceneFile {
    parse(text, Path::new(".")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Everything of a scene on which an answer depends.
fn physics(file: &SceneFile) -> String {
    let flow = ["gw", "gw-pairs"].map(|id| {
        let model = file.model(id).unwrap();
        file.flow(&model).map_err(|error| error.to_string())
    });
    format!("{:?} {:?} {flow:?}", file.scene, file.bodies)
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
    sections.push(("surface", WAYS[way].to_vec()));
    sections.extend(counterface.map(|way| ("surface.counterface", WAYS[way].to_vec())));
    sections
}

/// The sections with a number in the place of that of an input; `None` if none has its key.
fn edited(sections: &[Section], name: &str, number: f64) -> Option<Vec<Section>> {
    let bodies: Vec<usize> = (0..sections.len()).filter(|k| sections[*k].0 == "[body]").collect();
    let (of, key) = match name.split_once('_') {
        Some(("body1", key)) => (vec![bodies[0]], key),
        Some(("body2", key)) => (vec![bodies[1]], key),
        _ => ((0..sections.len()).filter(|k| !sections[*k].0.contains("counter")).collect(), name),
    };
    let (mut found, mut is_written) = (sections.to_vec(), false);
    for k in of {
        for (_, value) in found[k].1.iter_mut().filter(|(other, _)| *other == key) {
            (*value, is_written) = (number, true);
        }
    }
    is_written.then_some(found)
}

#[test]
fn every_number_of_every_description_is_edited_where_it_was_written() {
    let (mut edits, mut others) = (0, 0);
    for way in 0..WAYS.len() {
        for (counterface, bodies, more) in [
            (None, false, ""),
            (Some(0), true, "mean_plane_offset = 2e-6\n"),
            (Some(4), false, ""),
            (None, true, ""),
        ] {
            let sections = scenes(bodies, way, counterface);
            let file = read(&text(&sections, more));
            for (name, input) in file.all_inputs() {
                let Some(value) = file.value_of(input) else { continue };
                let number = 1.02 * value;
                let varied = file.with_inputs([(input, number)]).unwrap();
                let wanted = match edited(&sections, &name, number) {
                    Some(edited) => {
                        edits += 1;
                        read(&text(&edited, more))
                    }
                    // Another description of the surface, or a number that has no key yet.
                    None => {
                        others += 1;
                        let again = varied.inputs([&*name]).unwrap()[0];
                        let found = varied.value_of(again).unwrap();
                        assert!((found / number - 1.0).abs() < 1e-12, "{name}: {found}");
                        read(&varied.to_toml(&[]).unwrap())
                    }
                };
                let context = format!("{name} of {}", text(&sections, more));
                assert_eq!(physics(&varied), physics(&wanted), "{context}");
                // The harder body changes beside the same interface.
                if name.starts_with("body1") {
                    let again = read(&varied.to_toml(&[]).unwrap());
                    assert_eq!(physics(&varied), physics(&again), "{context}");
                }
                // And back.
                let input = varied.inputs([&*name]).unwrap()[0];
                let back = varied.with_inputs([(input, value)]).unwrap();
                let off = back.scene.surface.asperity_radius / file.scene.surface.asperity_radius;
                assert!((off - 1.0).abs() < 1e-12, "{context}");
            }
        }
    }
    assert!(edits > 120 && others > 60, "{edits} {others}");
}

#[test]
fn two_numbers_are_replaced_in_either_order_or_refused_together() {
    for way in 0..WAYS.len() {
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
    // What a refusal is for: one number twice, or a surface in two ways.
    let file = read(&text(&scenes(true, 4, None), ""));
    for names in [
        ["hardness", "body1_hardness"],
        ["equivalent_modulus", "youngs_modulus"],
        ["equivalent_modulus", "body2_poissons_ratio"],
        ["asperity_radius", "plasticity_index"],
        ["m0", "asperity_radius"],
    ] {
        assert!(file.inputs(names).is_err(), "{names:?}");
    }
    for names in [["hardness", "body1_youngs_modulus"], ["hardness", "youngs_modulus"]] {
        assert!(file.inputs(names).is_ok(), "{names:?}");
    }
}

#[test]
fn of_two_surfaces_a_fit_finds_the_number_of_the_first() {
    let folder = tempfile::tempdir().unwrap();
    for (way, key) in [(0, "asperity_height_std"), (4, "m0"), (4, "asperity_radius")] {
        let mut sections = scenes(false, way, Some(0));
        let counterface = &mut sections[3].1;
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
