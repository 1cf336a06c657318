//! Writer of scenes as text that reads back bit for bit.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::{Datum, HeightDistribution, TabulatedHeights};
use toml::{Table, Value};

use crate::document::{Document, Files};
use crate::kept::Read;
use crate::keys::{Key, Subject, joined, keys_of};
use crate::measured::Asked;
use crate::numbers::Written;
use crate::scene_file::scene_file;
use crate::{Place, SceneError, SceneFile, interface_of, parse, template, write_heights};

impl SceneFile {
    /// The files that the scene names: scans and a table of heights.
    #[must_use]
    pub fn files(&self) -> &[PathBuf] {
        self.read.as_ref().map_or(&[], |read| &read.files)
    }

    /// The text of a scene file that [`parse`] reads back bit for bit; `comments` are written at
    /// its head, one per line. A table of heights is part of the text, and paths of scans are
    /// absolute. For numbers changed since reading, the interface replaces the bodies, unless it
    /// still follows from them; the surface keeps the kind of its keys if these were
    /// changed, and else has its asperities.
    ///
    /// ```
    /// use asperity_inputs::{parse, template};
    /// use std::path::Path;
    ///
    /// let mut file = parse(template(), Path::new("."))?;
    /// file.scene.nominal_area = 2e-4;
    /// let again = parse(&file.to_toml(&["twice the area"])?, Path::new("."))?;
    /// assert_eq!(again.scene.nominal_area.to_bits(), 2e-4f64.to_bits());
    /// assert_eq!(again.scene.interface, file.scene.interface);
    /// # Ok::<(), asperity_inputs::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`parse`] if a number of the scene is out of its range, and
    /// [`SceneError::Unwritable`] for heights that a file cannot represent.
    pub fn to_toml(&self, comments: &[&str]) -> Result<String, SceneError> {
        let text = self.text(None, comments)?;
        // Scans are not read again.
        if self.names_no_scan() {
            let again = parse(&text, Path::new(""))?;
            if let Some(field) = self.differs_in(&again) {
                let reason = "a scene file cannot combine this value with the others";
                return Err(unwritable(Place::field(field), reason));
            }
        }
        Ok(text)
    }

    /// Writes [`to_toml`](Self::to_toml) to a file and returns the text. A table of heights is
    /// written to a CSV file in the same folder: `scene.csv` for `scene.toml`.
    ///
    /// # Errors
    /// Those of [`to_toml`](Self::to_toml), and [`SceneError::Unwritable`] with the system's
    /// reason.
    pub fn save(&self, path: &Path, comments: &[&str]) -> Result<String, SceneError> {
        let mut text = self.to_toml(comments)?;
        let written = |path: &Path, text: &str| {
            let at = || Place { file: Some(path.into()), ..Place::field("the scene file") };
            fs::write(path, text).map_err(|error| unwritable(at(), &error.to_string()))
        };
        if let Some(table) = self.table.as_ref().filter(|_| !self.has_heights_of_scan()) {
            let beside = path.with_extension("csv");
            let name = beside.file_name().and_then(|name| name.to_str()).filter(|_| beside != path);
            let name = name.ok_or_else(|| {
                let at = Place { file: Some(path.into()), ..Place::field("the scene file") };
                unwritable(at, "its name must be valid UTF-8 and must not end in .csv")
            })?;
            text = self.text(Some(name), comments)?;
            written(&beside, &write_heights(table.points()))?;
        }
        written(path, &text)?;
        Ok(text)
    }

    /// Bodies and area of this scene with the other sections that these keys describe: `surface`,
    /// `options`, `accept`.
    ///
    /// # Errors
    /// Those of [`parse`], without lines.
    pub fn with_keys(&self, keys: Table) -> Result<Self, SceneError> {
        let mut top = self.interface_keys();
        top.insert("nominal_area".into(), self.scene.nominal_area.into());
        top.extend(keys);
        let text = top.to_string();
        scene_file(&Document::new(None, Files::Nowhere, &text)?, Asked::Asperities)
    }

    /// The keys of `[surface]` of a surface that three numbers of its own do not describe: known
    /// within ranges, beside a counterface, or given with a plasticity index.
    #[must_use]
    pub fn keys_beyond_numbers(&self) -> Option<Table> {
        let is_written = !self.faces.is_empty()
            || self.written.len() > 1
            || self.written.first().is_some_and(Written::needs_interface);
        let keys = || self.kept_surface().cloned().unwrap_or_else(|| self.changed_keys());
        is_written.then(keys)
    }

    /// The text; a table of heights is in this file, or in the text.
    fn text(&self, heights: Option<&str>, comments: &[&str]) -> Result<String, SceneError> {
        let note = |line: &str| format!("# {}\n", line.replace(|c: char| c.is_control(), " "));
        let text: String = comments.iter().flat_map(|c| c.lines()).map(note).collect();
        let mut top = self.interface_keys();
        top.insert("nominal_area".into(), self.scene.nominal_area.into());
        top.insert("surface".into(), self.surface_keys(heights)?.into());
        if !self.accept.is_empty() {
            top.insert(
                "accept".into(),
                self.accept.iter().map(|code| code.name()).collect::<Vec<_>>().into(),
            );
        }
        if let Some(gas) = self.gas {
            top.insert("gap".into(), Table::try_from(gas).unwrap_or_default().into());
        }
        top.insert("options".into(), self.options.changed().into());
        let mut sections = String::new();
        for name in ["body", "interface", "surface", "gap", "options"] {
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
        Ok(text + &lines("", &top) + &sections)
    }

    /// The bodies as read if unchanged, the bodies from which the interface still follows, or else
    /// the interface.
    fn interface_keys(&self) -> Table {
        let interface = self.scene.interface;
        // The harder of two bodies may change beside the same interface.
        let is_same = |read: &&Arc<Read>| {
            read.interface == interface && (read.bodies == self.bodies || self.bodies.is_empty())
        };
        if let Some(read) = self.read.as_ref().filter(is_same) {
            let names = ["rigid_counterface", "work_of_adhesion", "interface", "body"];
            let kept = read.table.iter().filter(|(name, _)| names.contains(&name.as_str()));
            return kept.map(|(name, value)| (name.clone(), value.clone())).collect();
        }
        // No body has a pressure factor.
        let follows = interface_of(&self.bodies).is_ok_and(|made| {
            self.with_pair(made) == interface && interface.pressure_factor == made.pressure_factor
        });
        if follows {
            let bodies = self.bodies.iter().filter_map(|body| Table::try_from(body).ok());
            let mut keys = Table::from_iter([("body".into(), bodies.collect::<Vec<_>>().into())]);
            if self.bodies.len() == 1 {
                keys.insert("rigid_counterface".into(), true.into());
            }
            let work = interface.work_of_adhesion;
            keys.extend(work.map(|work| ("work_of_adhesion".into(), work.into())));
            return keys;
        }
        let interface = Table::try_from(interface).unwrap_or_default();
        Table::from_iter([("interface".into(), interface.into())])
    }

    /// The keys of `[surface]` as read, if they still describe this surface.
    fn kept_surface(&self) -> Option<&Table> {
        let read = self.read.as_ref().filter(|read| read.surface == self.scene.surface)?;
        let keys = read.table.get("surface")?.as_table()?;
        // The plasticity index depends on the interface, too, and other numbers may take its place.
        let is_written = self.written.first().is_some_and(|one| keys.contains_key(one.keys[0]));
        let is_same = read.interface == self.scene.interface && is_written;
        (is_same || !keys.contains_key("plasticity_index")).then_some(keys)
    }

    fn names_no_scan(&self) -> bool {
        let surface = self.kept_surface();
        let counterface = surface.and_then(|keys| keys.get("counterface")?.as_table());
        let names = |keys: &Table| keys.contains_key("file") || keys.contains_key("files");
        !surface.into_iter().chain(counterface).any(names)
    }

    /// Whether the heights are those of the summits of the scan that is named.
    fn has_heights_of_scan(&self) -> bool {
        let summits = self.read.as_ref().and_then(|read| read.summits.as_ref());
        let points = |table: &'_ TabulatedHeights| table.points().to_vec();
        summits.is_some()
            && self.kept_surface().is_some()
            && summits.map(points) == self.table.as_ref().map(points)
    }

    /// The keys that describe a surface whose numbers have changed since reading.
    fn changed_keys(&self) -> Table {
        let mut again = Self::from(self.scene.clone());
        let is_written = again.describe(self.written.clone()).is_ok()
            && again.scene.surface == self.scene.surface;
        let Some(first) = self.written.first().filter(|_| is_written) else {
            return Table::try_from(self.scene.surface).unwrap_or_default();
        };
        let read = self.read.as_ref().and_then(|read| read.table.get("surface")?.as_table());
        let mut keys = read.cloned().unwrap_or_default();
        keys.retain(|key, _| {
            let subject = Key::find("surface", key).map(|key| key.subject);
            !matches!(subject, Some(Subject::Roughness | Subject::Scan))
        });
        let numbers = first.keys.iter().zip(first.numbers);
        keys.extend(numbers.map(|(key, number)| ((*key).into(), number.into())));
        keys
    }

    fn surface_keys(&self, heights_in: Option<&str>) -> Result<Table, SceneError> {
        let scene = &self.scene;
        let mut keys = match self.kept_surface() {
            Some(keys) => keys.clone(),
            None => self.changed_keys(),
        };
        let named = |name: &str, value: Value| Table::from_iter([(name.into(), value)]).into();
        let heights: Option<Value> = match (&scene.heights, &self.table, heights_in) {
            (HeightDistribution::Gaussian, ..) => None,
            (HeightDistribution::Exponential, ..) => Some("exponential".into()),
            (HeightDistribution::Weibull(heights), ..) => {
                Some(named("skewness", heights.skewness().into()))
            }
            (_, Some(_), _) if self.has_heights_of_scan() => Some("measured".into()),
            (_, Some(_), Some(file)) => Some(named("file", file.into())),
            (_, Some(table), None) => {
                let (heights, densities): (Vec<f64>, Vec<f64>) =
                    table.points().iter().copied().unzip();
                let columns = [("height_m", heights), ("density_per_m", densities)];
                let column = |(name, column): (&str, Vec<f64>)| (name.into(), Value::from(column));
                Some(Table::from_iter(columns.map(column)).into())
            }
            _ => {
                let reason = format!("{}: a density that is not a table", scene.heights.name());
                return Err(unwritable(Place::field("surface.heights"), &reason));
            }
        };
        keys.extend(heights.map(|heights| ("heights".into(), heights)));
        if self.separation_from == Datum::SurfaceMean {
            keys.insert("separation_from".into(), "surface-mean".into());
        }
        let lay = self.peklenik_numbers[0];
        keys.extend(lay.map(|number| ("peklenik_number".into(), number.into())));
        let measured = self.measured.as_ref().filter(|_| !self.names_no_scan());
        let measured = measured.and_then(|measured| measured.statistics.mean_plane_offset);
        let known = self.table.as_ref().map(TabulatedHeights::mean).or(measured);
        let offset = scene.mean_plane_offset;
        if known.is_none() {
            let own = self.mean_plane_offsets()[0];
            keys.extend(own.map(|offset| ("mean_plane_offset".into(), offset.into())));
        } else if known.map(f64::to_bits) != offset.map(f64::to_bits) {
            let reason = "it differs from the offset of the measured heights";
            return Err(unwritable(Place::field("surface.mean_plane_offset"), reason));
        }
        Ok(keys)
    }

    /// The first part that differs, written with the digits that give the same bits back.
    fn differs_in(&self, other: &Self) -> Option<&'static str> {
        let written = |Self { scene, table, options, separation_from, accept, .. }: &Self| {
            let heights = match (table, &scene.heights) {
                (Some(table), _) => format!("{:?}", table.points()),
                // What is kept of skewed heights depends on what was asked of them.
                (_, HeightDistribution::Weibull(heights)) => format!("{:?}", heights.skewness()),
                (_, heights) => heights.name().into(),
            };
            let numbers = (scene.nominal_area, scene.interface, scene.surface);
            [
                ("the scene", format!("{numbers:?} {:?}", scene.mean_plane_offset)),
                ("surface.heights", heights),
                ("options", format!("{options:?} {separation_from:?} {accept:?}")),
            ]
        };
        let mut parts = written(self).into_iter().zip(written(other));
        parts.find(|(one, other)| one != other).map(|((part, _), _)| part)
    }
}

fn unwritable(at: Place, reason: &str) -> SceneError {
    SceneError::Unwritable { at: at.into(), reason: reason.into() }
}

/// The keys of a section, one per line, in the order of the template; numbers have a comment with
/// their unit.
fn lines(section: &str, table: &Table) -> String {
    let header = format!("[{section}]");
    let start = template().find(&header).filter(|_| !section.is_empty()).unwrap_or(0);
    let place = |name: &&str| template()[start..].find(&format!("{name} = ")).unwrap_or(usize::MAX);
    let mut names = keys_of(section);
    names.sort_by_key(place);
    let line = |name: &str| {
        let value = table.get(name)?;
        let meaning = match value {
            Value::Float(_) | Value::Integer(_) => Key::meaning(&joined(section, name)),
            _ => "",
        };
        let gap = if meaning.is_empty() { "" } else { "  # " };
        Some(format!("{name} = {}{gap}{meaning}\n", inline(value)))
    };
    names.into_iter().filter_map(line).collect()
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
