//! Pictures: curves of models, and the map of a contact.

use std::collections::BTreeMap;

use asperity_plot::{
    Axis, Between, Curve, Figure, MEASURED, Map, Mark, Panel, Scale, draw, draw_map, legible,
    look_of,
};
use asperity_scene::SceneFile;
use serde_json::{Value, json};

use crate::answer::{Column, columns};
use crate::message::Draw;
use crate::refusal::Refusal;
use crate::shown::{ranged, shown};
use crate::span::Load;

/// Largest side of a drawn map, in pixels.
const DRAWN: usize = 384;
/// Width of a map, as on a phone.
const SMALL: f64 = 340.0;
/// Names of the band and of boundary elements among the curves.
const LOWEST: &str = "lowest";
const HIGHEST: &str = "highest";
const BEM: &str = "boundary elements";

/// A model at a load, its value there, and the ends of that.
type Found<'r> = (&'r str, Option<f64>, Option<[f64; 2]>);

/// Curves of rows against the load, with the load marked, the spread of the models shaded and
/// boundary elements as points.
pub(crate) fn curves(file: &SceneFile, asked: &Draw) -> Result<String, Refusal> {
    let load = Load::of(&asked.load, file)?;
    let columns = columns(Some(file));
    let heads: Vec<String> =
        columns.iter().flat_map(|column| column.heads(!file.unknowns().is_empty())).collect();
    let width = 3 + heads.len();
    let k = columns.iter().position(|known| known.id == asked.view);
    let k = k.ok_or_else(|| Refusal::new(format!("the scene has no {}", asked.view)))?;
    let column = &columns[k];
    let Column { head, unit, label: name, .. } = column;
    // The values of all models at each load; positive numbers sort as their bits do.
    let mut at_loads: BTreeMap<u64, Vec<Found<'_>>> = BTreeMap::new();
    let (mut ids, mut values) = (vec![], vec![]);
    let (place, named) =
        (3 + k * heads.len() / columns.len(), column.heads(!file.unknowns().is_empty()));
    for line in asked.rows.iter().flat_map(|rows| rows.lines()) {
        let cells: Vec<&str> = line.split(',').collect();
        let pressure = cells.get(2).and_then(|cell| cell.parse::<f64>().ok());
        let pressure = pressure.filter(|_| cells.len() == width);
        let pressure = pressure.ok_or_else(|| Refusal::new("rows of another scene"))?;
        let number = |k: usize| cells.get(place + k)?.parse::<f64>().ok();
        let ends = number(1).zip(number(2)).filter(|_| named.len() > 1);
        let (value, ends) = (number(0), ends.map(|(lower, upper)| [lower, upper]));
        at_loads.entry(pressure.to_bits()).or_default().push((cells[0], value, ends));
        values.extend(value.map(|value| (cells[0], pressure, value)));
        ids.push(cells[0]);
    }
    ids.dedup();
    if values.is_empty() && asked.solved.is_empty() {
        let has = if ids.len() == 1 { "has" } else { "have" };
        let reason = match ids.join(", ") {
            _ if ids.is_empty() => format!("no model is chosen: choose models to see their {name}"),
            ids => format!("{ids} {has} no {name} here: choose other models or another quantity"),
        };
        return Err(Refusal::at("view", reason));
    }
    // The picture has no curve without a value, and its legend none either.
    let mut drawn: Vec<&str> = values.iter().map(|(id, ..)| *id).chain([BEM]).collect();
    drawn.dedup();
    for [pressure, value] in &asked.solved {
        at_loads.entry(pressure.to_bits()).or_default().push((BEM, Some(*value), None));
    }

    let area = file.scene.nominal_area;
    let (x, at, of_load) = match load.unit {
        "Pa" => (Axis::new("pressure_Pa", "mean pressure (MPa)").times(1e-6), load.pascals, 1.0),
        _ => (Axis::new("load_N", "load (N)"), load.newtons, area),
    };
    let numbers: Vec<f64> = values.iter().map(|(.., value)| *value).collect();
    let largest = numbers.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let (factor, of_axis) = legible(largest, unit);
    let of_axis = if of_axis.is_empty() { of_axis } else { format!(" ({of_axis})") };
    let mut y = Axis::new(head, &format!("{name}{of_axis}")).times(1.0 / factor);
    y.scale = Scale::fitting(&numbers);
    let mut panel = Panel::new(x.log(), y);
    panel.curve_column = "model".into();
    let look = |id: &&str| look_of(id).unwrap_or(0);
    let curves = ids.iter().filter(|id| drawn.contains(id));
    panel.curves = curves.map(|id| Curve::new(look(id), id, id)).collect();
    if !asked.solved.is_empty() {
        panel.curves.push(Curve::points(MEASURED, BEM, BEM));
    }
    let is_any = |is_beside: fn(&f64, &f64) -> bool| {
        values.iter().any(|(_, pressure, _)| is_beside(pressure, &load.pascals))
    };
    if is_any(f64::le) && is_any(f64::ge) {
        panel.verticals.push(Mark::new(at, &load.text));
    }
    let mut valid = ids.clone();
    valid.retain(|id| asked.outside.iter().all(|known| known != id));
    let mut csv = format!("model,load_N,pressure_Pa,{}\n", named.join(","));
    for (pressure, found) in at_loads.iter().map(|(bits, found)| (f64::from_bits(*bits), found)) {
        let mut add = |name: &str, value: Option<f64>, ends: Option<[f64; 2]>| {
            let ends = [0, 1].map(|k| ends.map(|ends| ends[k]));
            let numbers = [value].into_iter().chain(ends).take(named.len());
            let cells = numbers.map(|value| value.map_or(String::new(), |value| value.to_string()));
            let cells = cells.collect::<Vec<_>>().join(",");
            csv += &format!("{name},{},{pressure},{cells}\n", pressure * area);
        };
        let mut reading = shown(pressure * of_load, load.unit);
        for (id, value, ends) in found.iter().filter(|(id, ..)| drawn.contains(id)) {
            add(id, *value, *ends);
            reading.extend(value.map(|value| format!("\n{id} {}", ranged(value, *ends, unit))));
        }
        if reading.contains('\n') {
            panel.readings.push(Mark::new(pressure * of_load, &reading));
        }
        // Within ranges each model has a band of its own.
        let of_models = found.iter().filter(|(id, ..)| valid.contains(id) && named.len() == 1);
        let of_models: Vec<f64> = of_models.filter_map(|(_, value, _)| *value).collect();
        if of_models.len() == valid.len() && valid.len() > 1 {
            add(LOWEST, of_models.iter().copied().reduce(f64::min), None);
            add(HIGHEST, of_models.iter().copied().reduce(f64::max), None);
            let (lower, upper) = (LOWEST.into(), HIGHEST.into());
            let label = "range of models".into();
            panel.between = vec![Between { lower, upper, look: 9, label }];
        }
    }
    let mut figure = Figure::new("", &[], vec![panel]);
    figure.size =
        asked.size.map(|[width, height]| [width.clamp(280.0, 2000.0), height.clamp(220.0, 1500.0)]);
    Ok(draw(&figure, &csv)?)
}

/// The picture of a map of a contact, as on a phone, with a line about it.
pub(crate) fn map(map: Map, caption: String) -> Result<Value, Refusal> {
    let svg = draw_map(&Map { width: Some(SMALL), ..map.coarser(DRAWN) })?;
    Ok(json!({ "svg": svg, "caption": caption }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{Scenes, compile, rows};
    use crate::span::LoadKeys;

    fn file() -> SceneFile {
        asperity_scene::parse(asperity_scene::template(), std::path::Path::new(".")).unwrap()
    }

    fn asked(rows: &[String], view: &str, load: &str, solved: &[[f64; 2]]) -> Draw {
        let load = LoadKeys { text: load.into(), ..LoadKeys::default() };
        let (rows, view, solved) = (rows.to_vec(), view.into(), solved.to_vec());
        Draw { rows, view, load, solved, ..Draw::default() }
    }

    #[test]
    fn curves_have_band_mark_and_points() {
        let file = file();
        let pressures = [1e5, 1e6, 1e7, 1e8];
        let scenes = Scenes::of(&file).unwrap();
        let of = |id| rows(&scenes, &compile(&scenes, id).unwrap(), &pressures);
        let (rows, file) = (["gw", "ke"].map(of), &scenes[0]);
        let draw = |rows: &[String], view: &str, load: &str, solved: &[[f64; 2]]| {
            curves(file, &asked(rows, view, load, solved))
        };
        let svg = draw(&rows, "area-fraction", "100 N", &[[1e6, 1e-3]]).unwrap();
        for text in ["range of models", "100 N", "boundary elements", ">ke<", "load (N)"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("style="));
        // The load at 1 MPa, with the values of both models and of boundary elements.
        let reading = svg.split("<title>").find(|part| part.starts_with("100 N\n")).unwrap();
        let lines: Vec<&str> = reading.split("</title>").next().unwrap().lines().collect();
        assert_eq!((lines.len(), lines[3]), (4, "boundary elements 0.001"), "{lines:?}");
        assert!(lines[1] == "gw 3.868e-4" && lines[2] == "ke 6.645e-4", "{lines:?}");
        let alone = draw(&rows[..1], "separation", "1 MPa", &[]).unwrap();
        assert!(alone.contains("separation (µm)") && alone.contains("mean pressure (MPa)"));
        let asked = asked(&rows, "area-fraction", "1 MPa", &[]);
        let (outside, size) = (vec!["gw".into()], Some([340.0, 300.0]));
        let small = curves(file, &Draw { outside, size, ..asked }).unwrap();
        assert!(small.contains("viewBox=\"0 0 340 300\"") && !small.contains("range of models"));
        assert!(draw(&["x,1\n".into()], "tangent", "1 MPa", &[]).is_err());
        assert!(draw(&rows, "speed", "1 MPa", &[]).is_err());
    }

    #[test]
    fn models_within_ranges_have_a_band_each_and_their_ends_under_the_pointer() {
        let ground = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
            poissons_ratio = 0.3\nhardness = 2e9\n[surface]\nra = 8e-7\nfinish = \"ground\"\n";
        let file = asperity_scene::parse(ground, std::path::Path::new(".")).unwrap();
        let scenes = Scenes::of(&file).unwrap();
        let of = |id| rows(&scenes, &compile(&scenes, id).unwrap(), &[1e5, 1e6, 1e7]);
        let all = ["gw", "ke"].map(of);
        let svg = curves(&file, &asked(&all, "tangent", "100 N", &[])).unwrap();
        assert_eq!(svg.matches(">lower to upper end<").count(), 1);
        assert!(!svg.contains("range of models"));
        // Each model is drawn once, in a band.
        for id in ["gw", "ke"] {
            assert_eq!(svg.matches(&format!(">{id}<")).count(), 1);
        }
        let reading = svg.split("<title>").find(|part| part.starts_with("100 N\n")).unwrap();
        let line = reading.lines().find(|line| line.starts_with("ke ")).unwrap();
        assert!(line.contains("N/m (") && line.contains(" to "), "{line}");
    }

    #[test]
    fn a_picture_without_a_curve_has_the_reason_and_one_with_some_names_these() {
        let file = file();
        let scenes = Scenes::of(&file).unwrap();
        let of = |id| rows(&scenes, &compile(&scenes, id).unwrap(), &[1e5, 1e6, 1e7]);
        let (rows, file) = (["persson-fudge", "gw"].map(of), &scenes[0]);
        let draw = |rows: &[String], view: &str, solved: &[[f64; 2]]| {
            curves(file, &asked(rows, view, "100 N", solved))
        };
        let refused = draw(&rows[..1], "unloading-stiffness", &[]).unwrap_err();
        assert_eq!(refused.field.as_deref(), Some("view"));
        let svg = draw(&rows, "unloading-stiffness", &[]).unwrap();
        assert!(svg.contains(">gw<") && !svg.contains(">persson-fudge<"));
        let none = draw(&[], "unloading-stiffness", &[]).unwrap_err();
        assert_eq!(none.field.as_deref(), Some("view"));
        assert!(draw(&[], "area-fraction", &[[1e6, 1e-3]]).is_ok());
    }
}
