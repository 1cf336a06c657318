//! Pictures: curves of models, and the map of a contact.

use std::collections::BTreeMap;

use asperity::bem::{Bem, Solution};
use asperity::{Quantity, short};
use asperity_inputs::SceneFile;
use asperity_plot::{Axis, Between, Curve, Figure, Map, Mark, Panel, Scale, draw, draw_map};

use crate::answer::head;
use crate::message::{LoadShown, SEPARATION};
use crate::refusal::Refusal;
use crate::shown::{legible, shown};

/// Largest side of a drawn map, in pixels.
const DRAWN: usize = 384;
/// Names of the band and of boundary elements among the curves.
const LOWEST: &str = "lowest";
const HIGHEST: &str = "highest";
const BEM: &str = "bem";

/// Curves of rows against the load, with the load marked, the spread of the models shaded and
/// boundary elements as points.
pub(crate) fn curves(
    file: &SceneFile,
    rows: &[String],
    view: &str,
    load: &LoadShown,
    solved: &[[f64; 2]],
) -> Result<String, Refusal> {
    let head = head(file);
    let column = match view {
        SEPARATION => "separation_m".to_string(),
        _ => view.parse::<Quantity>()?.column(),
    };
    let k = head.iter().position(|known| *known == column);
    let k = k.ok_or_else(|| Refusal::new(format!("the scene has no {view}")))?;
    let mut found: Vec<(&str, f64, Option<f64>)> = vec![];
    for line in rows.iter().flat_map(|rows| rows.lines()) {
        let cells: Vec<&str> = line.split(',').collect();
        match (cells.get(2).and_then(|cell| cell.parse().ok()), cells.get(k)) {
            (Some(pressure), Some(cell)) if cells.len() == head.len() => {
                found.push((cells[0], pressure, cell.parse().ok()));
            }
            _ => return Err(Refusal::new("rows of another scene")),
        }
    }
    let mut ids: Vec<&str> = found.iter().map(|(id, ..)| *id).collect();
    ids.dedup();
    // The values of all models at each load; positive numbers sort as their bits do.
    let mut at_loads: BTreeMap<u64, Vec<(&str, f64)>> = BTreeMap::new();
    for (id, pressure, value) in &found {
        if let Some(value) = value {
            at_loads.entry(pressure.to_bits()).or_default().push((id, *value));
        }
    }
    let values: Vec<f64> = found.iter().filter_map(|(.., value)| *value).collect();
    if values.is_empty() && solved.is_empty() {
        return Err(Refusal::at("view", without_curves(&ids, name(view))));
    }

    let area = file.scene.nominal_area;
    let mut csv = format!("model,load_N,pressure_Pa,{column}\n");
    let mut add = |name: &str, pressure: f64, value: Option<f64>| {
        let value = value.map_or(String::new(), |value| value.to_string());
        csv += &format!("{name},{},{pressure},{value}\n", pressure * area);
    };
    // The picture has no curve without a value, and its legend none either.
    let has_value = |row: &&(&str, f64, Option<f64>)| row.2.is_some();
    let mut drawn: Vec<&str> = found.iter().filter(has_value).map(|(id, ..)| *id).collect();
    drawn.dedup();
    for (id, pressure, value) in found.iter().filter(|(id, ..)| drawn.contains(id)) {
        add(id, *pressure, *value);
    }
    let whole = |values: &Vec<(&str, f64)>| ids.len() > 1 && values.len() == ids.len();
    let has_band = at_loads.values().any(whole);
    for (name, worst) in [(LOWEST, f64::min as fn(f64, f64) -> f64), (HIGHEST, f64::max)] {
        for (bits, values) in at_loads.iter().filter(|(_, values)| whole(values)) {
            add(name, f64::from_bits(*bits), values.iter().map(|found| found.1).reduce(worst));
        }
    }
    let range = at_loads.keys().next().zip(at_loads.keys().last());
    let range = range.map(|(low, high)| [*low, *high].map(f64::from_bits));
    for [pressure, value] in solved {
        add(BEM, *pressure, Some(*value));
        at_loads.entry(pressure.to_bits()).or_default().push(("boundary elements", *value));
    }

    let (x, at, of_load) = match load.unit {
        "Pa" => (Axis::new("pressure_Pa", "mean pressure (MPa)").times(1e-6), load.pascals, 1.0),
        _ => (Axis::new("load_N", "load (N)"), load.newtons, area),
    };
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let label = match legible(largest, unit(view)) {
        (_, unit) if unit.is_empty() => name(view).into(),
        (_, unit) => format!("{} ({unit})", name(view)),
    };
    let mut y = Axis::new(&column, &label);
    y.multiply = 1.0 / legible(largest, unit(view)).0;
    if !view.parse::<Quantity>().is_ok_and(Quantity::is_absolute) {
        y.scale = Scale::fitting(&values);
    }
    let mut panel = Panel::new(x.log(), y);
    panel.curve_column = "model".into();
    // Black is left to boundary elements.
    let curves = ids.iter().zip(1..).filter(|(id, _)| drawn.contains(id));
    panel.curves = curves.map(|(id, look)| Curve::new(look, id, id)).collect();
    if !solved.is_empty() {
        panel.curves.push(Curve::points(0, BEM, "boundary elements"));
    }
    if has_band {
        let (lower, upper) = (LOWEST.into(), HIGHEST.into());
        let label = "range of the models".into();
        panel.between.push(Between { lower, upper, look: 9, label });
    }
    if range.is_some_and(|[low, high]| (low * of_load..=high * of_load).contains(&at)) {
        panel.verticals.push(Mark::new(at, &load.text));
    }
    let reading = |(bits, values): (u64, Vec<(&str, f64)>)| {
        let at = f64::from_bits(bits) * of_load;
        let value = |(name, value): &(&str, f64)| format!("\n{name} {}", shown(*value, unit(view)));
        Mark::new(at, &(shown(at, load.unit) + &values.iter().map(value).collect::<String>()))
    };
    panel.readings = at_loads.into_iter().map(reading).collect();
    Ok(draw(&Figure::new("", &[], vec![panel]), &csv)?)
}

/// Why there is no curve.
fn without_curves(ids: &[&str], name: &str) -> String {
    let has = if ids.len() == 1 { "has" } else { "have" };
    match ids {
        [] => format!("no model is chosen: choose models to see their {name}"),
        ids => format!(
            "{} {has} no {name} here: choose other models or another quantity",
            ids.join(", ")
        ),
    }
}

/// The SI unit of a view.
fn unit(view: &str) -> &'static str {
    match view {
        SEPARATION => "m",
        view => view.parse::<Quantity>().map_or("", Quantity::unit),
    }
}

fn name(view: &str) -> &'static str {
    match view {
        SEPARATION => "separation",
        view => view.parse::<Quantity>().map_or("", Quantity::label),
    }
}

/// The map of a solved contact.
pub(crate) fn contact(
    bem: &Bem,
    solution: &Solution,
    hardness: Option<f64>,
) -> Result<String, Refusal> {
    let [rows, columns] = bem.map().shape();
    let [dy, dx] = bem.map().pixel();
    let size = [columns as f64 * dx, rows as f64 * dy];
    let top = hardness.unwrap_or_else(|| solution.pressures.iter().copied().fold(0.0, f64::max));
    let ((scale, unit), (length, of_length)) = (legible(top, "Pa"), legible(size[0], "m"));
    let step = rows.max(columns).div_ceil(DRAWN);
    let (values, columns) = largest_of(&solution.pressures, columns, step);
    let mut caption = vec![format!(
        "Mean pressure {}: {} % of the area in {} patches, mean gap {}.",
        shown(solution.mean_pressure, "Pa"),
        short(100.0 * solution.area),
        solution.patches.len(),
        shown(solution.mean_gap, "m"),
    )];
    if hardness.is_some() {
        let share = short(100.0 * solution.plastic_area);
        caption.push(format!("Black is plastic: {share} % of the area carries the hardness."));
    }
    Ok(draw_map(&Map {
        title: "Contact pressure".into(),
        caption,
        values: values.into_iter().map(|pressure| pressure / scale).collect(),
        columns,
        size: size.map(|side| side / length),
        unit: of_length,
        label: format!("pressure ({unit})"),
        top: top / scale,
        white: "blank: no contact".into(),
        ..Map::default()
    })?)
}

/// The largest of every `step` x `step` values, so that no contact disappears, and their number in
/// a row.
pub(crate) fn largest_of(values: &[f64], columns: usize, step: usize) -> (Vec<f64>, usize) {
    if step <= 1 {
        return (values.to_vec(), columns);
    }
    let wide = columns.div_ceil(step);
    let rows: Vec<&[f64]> = values.chunks(columns).collect();
    let of = |block: &[&[f64]]| -> Vec<f64> {
        let mut most = vec![0.0_f64; wide];
        for (x, value) in block.iter().flat_map(|row| row.iter().enumerate()) {
            most[x / step] = most[x / step].max(*value);
        }
        most
    };
    (rows.chunks(step).flat_map(of).collect(), wide)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::{compile, rows};

    fn file() -> SceneFile {
        asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new(".")).unwrap()
    }

    #[test]
    fn curves_have_band_mark_and_points() {
        let file = file();
        let pressures = [1e5, 1e6, 1e7, 1e8];
        let rows = ["gw", "ke"].map(|id| rows(&file, id, &compile(&file, id).unwrap(), &pressures));
        let keys = crate::message::LoadKeys { text: "100 N".into(), ..Default::default() };
        let (_, load) = crate::span::load(&keys, &file.scene).unwrap();
        let svg = curves(&file, &rows, "area-fraction", &load, &[[1e6, 1e-3]]).unwrap();
        for text in ["range of the models", "100 N", "boundary elements", ">ke<", "load (N)"] {
            assert!(svg.contains(text), "{text}");
        }
        assert!(!svg.contains("style="));
        // The load at 1 MPa, with the values of both models and of boundary elements.
        let reading = svg.split("<title>").find(|part| part.starts_with("100 N\n")).unwrap();
        let lines: Vec<&str> = reading.split("</title>").next().unwrap().lines().collect();
        assert_eq!((lines.len(), lines[3]), (4, "boundary elements 0.001"), "{lines:?}");
        assert!(lines[1] == "gw 3.868e-4" && lines[2] == "ke 6.645e-4", "{lines:?}");
        let keys = crate::message::LoadKeys { text: "1 MPa".into(), ..Default::default() };
        let (_, load) = crate::span::load(&keys, &file.scene).unwrap();
        let alone = curves(&file, &rows[..1], "separation", &load, &[]).unwrap();
        assert!(alone.contains("separation (µm)") && alone.contains("mean pressure (MPa)"));
        assert!(curves(&file, &["x,1\n".into()], "tangent", &load, &[]).is_err());
        assert!(curves(&file, &rows, "speed", &load, &[]).is_err());
    }

    #[test]
    fn a_picture_without_a_curve_has_the_reason_and_one_with_some_names_these() {
        let file = file();
        let keys = crate::message::LoadKeys { text: "100 N".into(), ..Default::default() };
        let (_, load) = crate::span::load(&keys, &file.scene).unwrap();
        let rows = ["persson-fudge", "gw"]
            .map(|id| rows(&file, id, &compile(&file, id).unwrap(), &[1e5, 1e6, 1e7]));
        let refused = curves(&file, &rows[..1], "unloading-stiffness", &load, &[]).unwrap_err();
        assert!(refused.message.starts_with("persson-fudge has no unloading stiffness here: "));
        assert_eq!(refused.field.as_deref(), Some("view"));
        let svg = curves(&file, &rows, "unloading-stiffness", &load, &[]).unwrap();
        assert!(svg.contains(">gw<") && !svg.contains(">persson-fudge<"));
        let none = curves(&file, &[], "unloading-stiffness", &load, &[]).unwrap_err();
        let wanted = "no model is chosen: choose models to see their unloading stiffness";
        assert_eq!((&*none.message, none.field.as_deref()), (wanted, Some("view")));
        assert!(curves(&file, &[], "area-fraction", &load, &[[1e6, 1e-3]]).is_ok());
    }

    #[test]
    fn no_contact_is_lost_in_a_smaller_map() {
        let mut values = vec![0.0; 35];
        (values[6], values[34]) = (2.0, 3.0);
        let (small, wide) = largest_of(&values, 7, 3);
        assert_eq!((wide, small.len()), (3, 6));
        assert!(small[2] > 1.0 && small[5] > 2.0);
    }
}
