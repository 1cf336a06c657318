//! Writer of scenes as text that reads back bit for bit.

use asperity::{Body, Datum, HeightDistribution};
use serde::Serialize;
use toml::{Table, Value};

use crate::document::{Document, Files};
use crate::error::{Place, SceneError};
use crate::input::OWN;
use crate::keys::{BODY, Field, Key, joined, keys_of};
use crate::materials::Material;
use crate::read::scene_file;
use crate::scans::Asked;
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SAME, SMOOTH, SceneSpec, SurfaceSpec};
use crate::unknown::Unknown;

impl SceneFile {
    /// The text of a scene file that [`parse`](crate::parse) reads back bit for bit, with what was
    /// written of the scene or changed since. Numbers are in SI units, a table of heights is part
    /// of the text, and paths of scans are absolute.
    ///
    /// ```
    /// use asperity_scene::{parse, template};
    /// use std::path::Path;
    ///
    /// let file = parse(template(), Path::new("."))?;
    /// let area = file.inputs(["nominal_area"])?[0];
    /// let twice = file.with_inputs([(area, 2e-4)]).unwrap();
    /// let again = parse(&twice.to_toml()?, Path::new("."))?;
    /// assert_eq!(again.scene.nominal_area.to_bits(), 2e-4f64.to_bits());
    /// assert_eq!(again.scene.interface, file.scene.interface);
    /// # Ok::<(), asperity_scene::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// [`SceneError::Refused`] for heights that a file cannot represent.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        let spec = &self.spec;
        let mut top = spec.bodies.keys();
        let mut surface = spec.surface.keys();
        let second = match spec.counterface_word {
            Some(word) if word == SMOOTH || spec.is_same() => Some(word.into()),
            _ => spec.counterface.as_ref().map(|second| second.keys().into()),
        };
        surface.extend(second.map(|second| ("counterface".into(), second)));
        surface.extend(self.heights_key()?.map(|key| ("heights".into(), key)));
        if spec.separation_from == Datum::SurfaceMean {
            surface.insert("separation_from".into(), "surface-mean".into());
        }
        top.insert("surface".into(), surface.into());
        let accept: Vec<&str> = spec.accept.iter().map(|code| code.name()).collect();
        top.extend((!accept.is_empty()).then(|| ("accept".into(), accept.into())));
        top.extend(spec.gas.map(|gas| ("gap".into(), written(gas))));
        top.extend(spec.seal.map(|seal| ("seal".into(), written(seal))));
        top.extend(Some(match spec.curvature {
            None => ("nominal_area".into(), spec.nominal_area.into()),
            Some(bodies) => ("curvature".into(), written(bodies)),
        }));
        top.insert("options".into(), spec.options.changed().into());
        for (input, Unknown { ends, .. }) in &self.ranges {
            let table = section_mut(&mut top, input.section);
            table.map(|table| table.insert(input.key.into(), ends.to_vec().into()));
        }
        let mut sections = String::new();
        for name in ["body", "interface", "surface", "curvature", "gap", "seal", "options"] {
            let header = if name == "body" { "[[body]]" } else { &format!("[{name}]") };
            let all = match top.remove(name) {
                Some(Value::Array(bodies)) => bodies,
                section => section.into_iter().collect(),
            };
            let tables = all.iter().filter_map(Value::as_table).filter(|keys| !keys.is_empty());
            for keys in tables {
                sections += &format!("\n{header}\n{}", lines(name, keys));
            }
        }
        Ok(lines("", &top) + &sections)
    }

    /// The scene of these bodies with the other keys and sections: `nominal_area` or `curvature`,
    /// `surface`, `options`, `accept`.
    ///
    /// # Errors
    /// The errors of [`parse`](crate::parse), without lines.
    pub fn with_keys(bodies: &Bodies, keys: Table) -> Result<Self, SceneError> {
        let mut top = bodies.keys();
        top.extend(keys);
        let text = top.to_string();
        scene_file(&Document::new(None, Files::Nowhere, &text)?, Asked::Asperities)
    }

    /// `heights`; none of Gaussian ones.
    fn heights_key(&self) -> Result<Option<Value>, SceneError> {
        let named = |name: &str, value: Value| Table::from_iter([(name.into(), value)]).into();
        Ok(match (&self.spec.heights.distribution, self.table()) {
            (HeightDistribution::Gaussian, _) => None,
            (HeightDistribution::Exponential, _) => Some("exponential".into()),
            (HeightDistribution::Weibull(heights), _) => {
                Some(named("skewness", heights.skewness().into()))
            }
            (_, Some(_)) if self.spec.heights.is_measured => Some("measured".into()),
            (_, Some(table)) => {
                let (heights, densities): (Vec<f64>, Vec<f64>) =
                    table.points().iter().copied().unzip();
                let columns = [("height_m", heights), ("density_per_m", densities)];
                let column = |(name, column): (&str, Vec<f64>)| (name.into(), Value::from(column));
                Some(Table::from_iter(columns.map(column)).into())
            }
            (heights, None) => {
                let reason = "cannot be written: a density that is not a table";
                let reason = format!("{}: {reason}", heights.name());
                return Err(SceneError::refused(Place::field("surface.heights"), reason));
            }
        })
    }
}

impl Bodies {
    /// The keys of the bodies or of their interface.
    fn keys(&self) -> Table {
        let Self::Each { bodies, materials, work_of_adhesion } = self else {
            let Self::Interface(interface) = self else { return Table::new() };
            return Table::from_iter([("interface".into(), written(interface))]);
        };
        let each = bodies.iter().zip(materials);
        let each: Vec<Table> = each.map(|(body, material)| keys_of_body(body, *material)).collect();
        let mut keys = Table::from_iter([("body".into(), each.into())]);
        if bodies.len() == 1 {
            keys.insert("rigid_counterface".into(), true.into());
        }
        keys.extend(work_of_adhesion.map(|work| ("work_of_adhesion".into(), work.into())));
        keys
    }
}

/// The keys of a body: its material and what differs from it.
fn keys_of_body(body: &Body, material: Option<&Material>) -> Table {
    let id = material.map(|material| ("material".into(), Value::from(&*material.id)));
    let differs = |value: &f64, get: fn(&Body) -> Option<f64>| {
        let listed = material.and_then(|material| get(&material.body));
        listed.is_none_or(|listed| listed.to_bits() != value.to_bits())
    };
    let own = BODY.iter().filter_map(|field| {
        let value = (field.get)(body).filter(|value| differs(value, field.get))?;
        Some((field.name.into(), value.into()))
    });
    id.into_iter().chain(own).collect()
}

impl SceneSpec {
    /// Whether the second surface is written as the first, and is like it.
    pub(crate) fn is_same(&self) -> bool {
        let is_like = |second: &SurfaceSpec| second.keys() == self.surface.keys();
        self.counterface_word == Some(SAME) && self.counterface.as_ref().is_some_and(is_like)
    }
}

impl SurfaceSpec {
    /// The keys that describe the surface.
    fn keys(&self) -> Table {
        let number = |(key, value): (&str, f64)| (key.to_string(), Value::from(value));
        let mut keys: Table = match &self.by {
            Description::Numbers(roughness) => roughness.by_key().map(number).collect(),
            Description::Drawing(drawing) => {
                let finish = drawing.finish.map(|word| ("finish".into(), word.into()));
                drawing.by_key().map(number).chain(finish).collect()
            }
            Description::Scan(scan) => {
                scan.source.as_ref().map_or_else(Table::new, |source| source.written.clone())
            }
        };
        let own = |field: &Field<Self>| Some((field.name.into(), (field.get)(self)?.into()));
        keys.extend(OWN.iter().filter_map(own));
        keys
    }
}

fn written(section: impl Serialize) -> Value {
    Table::try_from(section).unwrap_or_default().into()
}

/// The table of a section, such as `body[1]`.
fn section_mut<'t>(top: &'t mut Table, section: &str) -> Option<&'t mut Table> {
    section.split('.').filter(|name| !name.is_empty()).try_fold(top, |table, name| {
        let (name, k) = name.trim_end_matches(']').split_once('[').unwrap_or((name, ""));
        match table.get_mut(name)? {
            Value::Array(all) => all.get_mut(k.parse::<usize>().ok()?.checked_sub(1)?)?,
            one => one,
        }
        .as_table_mut()
    })
}

/// The keys of a section, one per line, in the order of the table of keys; numbers have a comment
/// with their unit.
fn lines(section: &str, table: &Table) -> String {
    let line = |name: &str| {
        let value = table.get(name)?;
        let meaning = match value {
            Value::Float(_) | Value::Integer(_) => Key::meaning(&joined(section, name)),
            _ => "",
        };
        let gap = if meaning.is_empty() { "" } else { "  # " };
        Some(format!("{name} = {}{gap}{meaning}\n", inline(value)))
    };
    keys_of(section).into_iter().filter_map(line).collect()
}

/// A value on one line: numbers with the shortest digits that read back.
fn inline(value: &Value) -> String {
    let joined = |parts: Vec<String>| parts.join(", ");
    match value {
        Value::Float(number) if number.is_nan() => "nan".into(),
        Value::Float(number) => format!("{number:e}"),
        Value::Array(items) => format!("[{}]", joined(items.iter().map(inline).collect())),
        Value::Table(table) => {
            let pair = |(name, value): (&String, &Value)| format!("{name} = {}", inline(value));
            format!("{{ {} }}", joined(table.iter().map(pair).collect()))
        }
        other => other.to_string(),
    }
}
