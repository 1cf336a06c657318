//! Pictures: curves of models, and the map of a contact.

use std::collections::{BTreeMap, BTreeSet};

use asperity::bem::{Bem, Solution};
use asperity::{Quantity, short};
use asperity_inputs::SceneFile;
use asperity_plot::{Axis, Between, Curve, Figure, Map, Mark, Panel, Scale, draw, draw_map};

use crate::answer::head;
use crate::message::{LoadShown, SEPARATION};
use crate::refusal::Refusal;
use crate::shown::shown;

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
    let place = |name: &str| head.iter().position(|known| known == name);
    let k = place(&column).ok_or_else(|| Refusal::new(format!("the scene has no {view}")))?;
    let in_pascals = load.unit == "Pa";
    let mut csv = head.join(",") + "\n";
    let mut ids: Vec<&str> = vec![];
    // The smallest and the largest value at each load.
    let mut band: BTreeMap<u64, (f64, f64, usize)> = BTreeMap::new();
    let (mut values, mut drawn) = (vec![], BTreeSet::new());
    // The values of all models at each load, for the pointer.
    let mut readings: BTreeMap<u64, Vec<String>> = BTreeMap::new();
    let unit = unit(view);
    for line in rows.iter().flat_map(|rows| rows.lines()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells.get(k).and_then(|cell| cell.parse::<f64>().ok());
        if cells.len() != head.len() {
            return Err(Refusal::new("rows of another scene"));
        }
        if ids.last() != Some(&cells[0]) {
            ids.push(cells[0]);
        }
        if let (Some(pressure), Some(value)) = (number(2), number(k)) {
            values.push(value);
            drawn.insert(cells[0]);
            // Positive numbers sort as their bits do.
            let found = band.entry(pressure.to_bits()).or_insert((value, value, 0));
            *found = (found.0.min(value), found.1.max(value), found.2 + 1);
            let reading = format!("{} {}", cells[0], shown(value, unit));
            readings.entry(pressure.to_bits()).or_default().push(reading);
        }
    }
    // The picture has no curve without a value, and its legend none either.
    let lines = rows.iter().flat_map(|rows| rows.lines());
    for line in lines.filter(|line| drawn.contains(line.split(',').next().unwrap_or_default())) {
        csv += line;
        csv.push('\n');
    }
    let row = |name: &str, pressure: f64, value: f64| {
        let given = |known: &String| match known.as_str() {
            "model" => name.to_string(),
            "load_N" => (pressure * file.scene.nominal_area).to_string(),
            "pressure_Pa" => pressure.to_string(),
            known if known == column => value.to_string(),
            _ => String::new(),
        };
        head.iter().map(given).collect::<Vec<_>>().join(",") + "\n"
    };
    let whole = band.iter().filter(|(_, found)| ids.len() > 1 && found.2 == ids.len());
    let whole: Vec<(f64, f64, f64)> =
        whole.map(|(bits, found)| (f64::from_bits(*bits), found.0, found.1)).collect();
    for (pressure, low, _) in &whole {
        csv += &row(LOWEST, *pressure, *low);
    }
    for (pressure, _, high) in &whole {
        csv += &row(HIGHEST, *pressure, *high);
    }
    for [pressure, value] in solved {
        csv += &row(BEM, *pressure, *value);
        let reading = format!("boundary elements {}", shown(*value, unit));
        readings.entry(pressure.to_bits()).or_default().push(reading);
    }

    if values.is_empty() && solved.is_empty() {
        let reason = match &ids[..] {
            [] => format!("no model is chosen: choose models to see their {}", name(view)),
            ids => {
                let has = if ids.len() == 1 { "has" } else { "have" };
                let ids = ids.join(", ");
                format!(
                    "{ids} {has} no {} here: choose other models or another quantity",
                    name(view)
                )
            }
        };
        return Err(Refusal::at("view", reason));
    }
    let x = if in_pascals {
        ("pressure_Pa", "mean pressure (MPa)", 1e-6)
    } else {
        ("load_N", "load (N)", 1.0)
    };
    let mut y = Axis::new(&column, &label(view, &values));
    y.multiply = unit_of(view, &values).0;
    if !view.parse::<Quantity>().is_ok_and(Quantity::is_absolute) {
        y.scale = Scale::fitting(&values);
    }
    let mut panel = Panel::new(Axis::new(x.0, x.1).times(x.2).log(), y);
    panel.curve_column = "model".into();
    // Black is left to boundary elements.
    let curves = ids.iter().zip(1..).filter(|(id, _)| drawn.contains(*id));
    panel.curves = curves.map(|(id, look)| Curve::new(look, id, id)).collect();
    if !solved.is_empty() {
        panel.curves.push(Curve::points(0, BEM, "boundary elements"));
    }
    if !whole.is_empty() {
        let (lower, upper) = (LOWEST.into(), HIGHEST.into());
        let label = "range of the models".into();
        panel.between.push(Between { lower, upper, look: 9, label });
    }
    let at = if in_pascals { load.pascals } else { load.newtons };
    let (low, high) = band.keys().next().zip(band.keys().last()).map_or((0.0, 0.0), |(a, b)| {
        let [a, b] = [*a, *b].map(f64::from_bits);
        if in_pascals { (a, b) } else { (a * file.scene.nominal_area, b * file.scene.nominal_area) }
    });
    if (low..=high).contains(&at) {
        panel.verticals.push(Mark::new(at, &load.text));
    }
    let reading = |(bits, lines): (u64, Vec<String>)| {
        let pascals = f64::from_bits(bits);
        let newtons = pascals * file.scene.nominal_area;
        let (at, name) = if in_pascals {
            (pascals, shown(pascals, "Pa"))
        } else {
            (newtons, shown(newtons, "N"))
        };
        Mark::new(at, &format!("{name}\n{}", lines.join("\n")))
    };
    panel.readings = readings.into_iter().map(reading).collect();
    Ok(draw(&Figure::new("", &[], vec![panel]), &csv)?)
}

/// The SI unit of a view.
fn unit(view: &str) -> &'static str {
    match view {
        SEPARATION => "m",
        view => view.parse::<Quantity>().map_or("", Quantity::unit),
    }
}

/// The unit in which a quantity of the picture is legible: a factor and a name.
fn unit_of(view: &str, values: &[f64]) -> (f64, String) {
    let unit = unit(view);
    let largest = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let text = shown(largest, unit);
    let name = text.split_once(' ').map_or("", |(_, name)| name).to_string();
    let factors = [("G", 1e-9), ("M", 1e-6), ("k", 1e-3), ("m", 1e3), ("µ", 1e6), ("n", 1e9)];
    let plain = unit.replace("m2", "m²");
    let prefix = name.strip_suffix(&plain).unwrap_or_default();
    let factor = factors.into_iter().find(|(known, _)| *known == prefix && !plain.is_empty());
    (factor.map_or(1.0, |(_, factor)| factor), name)
}

fn name(view: &str) -> &'static str {
    match view {
        SEPARATION => "separation",
        view => view.parse::<Quantity>().map_or("", Quantity::label),
    }
}

fn label(view: &str, values: &[f64]) -> String {
    let name = name(view);
    match unit_of(view, values).1.as_str() {
        "" => name.into(),
        unit => format!("{name} ({unit})"),
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
    let units = [(1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (1.0, "Pa")];
    let (scale, unit) = units.into_iter().find(|(scale, _)| top >= *scale).unwrap_or(units[3]);
    let lengths = [(1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")];
    let (length, of_length) =
        lengths.into_iter().find(|(scale, _)| size[0] >= *scale).unwrap_or(lengths[3]);
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
        unit: of_length.into(),
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
