//! A scene file, read.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use asperity::{
    ContactError, HeightDistribution, Interface, Model, Quantity, Scene, Surface, TabulatedHeights,
    Tolerance,
};

use crate::document::{Document, Section};
use crate::heights::{Spread, spread};
use crate::interface::interface;
use crate::options::OptionValue;
use crate::surface::surface;
use crate::{ModelOptions, Place, SceneError};

/// No scene needs more bytes than this.
const MOST_BYTES: u64 = 1 << 20;
/// A table of heights whose standard deviation is this many times off is in the wrong unit.
const WRONG_UNIT: f64 = 10.0;

/// One that is this much off deserves a word; the bins of a histogram alone add some per cent.
const DIFFERENT: f64 = 0.05;

/// What the separations of a scene's requests are measured from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SeparationFrom {
    /// The mean of the asperity heights (the lowest asperity, for exponential heights), as in the
    /// library.
    #[default]
    AsperityMean,
    /// The mean plane of the rough surface.
    SurfaceMean,
}

/// All that a scene file says.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SceneFile {
    /// What is in contact.
    pub scene: Scene,
    /// What the ids of the models stand for.
    pub options: ModelOptions,
    /// What separations are measured from.
    pub separation_from: SeparationFrom,
    /// How far the library's zero of separation lies above the plane of `separation_from` \[m\];
    /// 0 for [`SeparationFrom::AsperityMean`].
    pub separation_offset: f64,
    /// The table of heights, where there is one: what `scene.heights` was made of.
    pub table: Option<TabulatedHeights>,
    /// What was read, and still deserves a word.
    pub warnings: Vec<String>,
}

/// A model that a scene does not allow.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// The model's id.
    pub id: String,
    /// What it needs, or why its laws mean nothing here.
    pub reason: ContactError,
}

/// Reads a scene file and the files that it names.
///
/// # Errors
/// [`SceneError`] with the file, the line, the field, what was found and what is needed.
pub fn load(path: &Path) -> Result<SceneFile, SceneError> {
    let at = || {
        Box::new(Place {
            file: Some(path.to_path_buf()),
            line: None,
            field: "the scene file".into(),
        })
    };
    let unreadable = |reason: String| SceneError::Unreadable { at: at(), reason };
    let file = File::open(path).map_err(|error| unreadable(error.to_string()))?;
    let mut bytes = vec![];
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|e| unreadable(e.to_string()))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(unreadable(format!("it has more than {MOST_BYTES} bytes")));
    }
    let text = String::from_utf8(bytes).map_err(|error| unreadable(error.to_string()))?;
    let directory = path.parent().unwrap_or(Path::new(""));
    read(Document { file: Some(path), directory, text: &text })
}

/// Reads a scene from its text; relative paths in it begin at `directory`.
///
/// ```
/// use asperity::{ContactModel, Quantity, Request};
/// use asperity_scene::{parse, template};
///
/// let file = parse(template(), std::path::Path::new("."))?;
/// let answer = file.model("ke")?.solve(&file.scene, &Request::new([Quantity::Force]).at([2.0]));
/// assert!(answer.is_ok());
/// let mistyped = template().replace("nominal_area", "nominal_aera");
/// let error = parse(&mistyped, std::path::Path::new(".")).unwrap_err().to_string();
/// assert!(error.contains("did you mean \"nominal_area\"?"));
/// # Ok::<(), asperity_scene::SceneError>(())
/// ```
///
/// # Errors
/// Those of [`load`], without a file's name.
pub fn parse(text: &str, directory: &Path) -> Result<SceneFile, SceneError> {
    read(Document { file: None, directory, text })
}

fn read(document: Document<'_>) -> Result<SceneFile, SceneError> {
    let table = document.table()?;
    let top = Section::top(document, &table)?;
    let mut options = ModelOptions::default();
    // Sections first: a mistyped key anywhere is better news than what is missing for want of it.
    if let Some(section) = top.section("options")? {
        for (name, entry) in section.entries() {
            let value = match entry.text() {
                Some(word) => word.into(),
                None if entry.is_table() => OptionValue::Numbers(
                    entry.numbers()?.into_iter().map(|(name, v)| (name.into(), v)).collect(),
                ),
                None => return Err(entry.wrong("a word in quotes, or a table of numbers,")),
            };
            options.set_at(&entry.at, name, &value)?;
        }
    }
    let needed = "[surface] says what the asperities are";
    let described = top.section("surface")?.ok_or_else(|| top.missing("surface", needed))?;
    let (interface, interface_section) = interface(&top)?;
    let nominal_area = top.required("nominal_area", "the apparent area of contact in m^2")?;
    asperity::positive("nominal_area", nominal_area).map_err(top.refused())?;

    let spread = spread(&described)?;
    let measured_std = match &spread {
        Spread::Table(table) => Some(table.standard_deviation()),
        _ => None,
    };
    let read = surface(&described, &interface, measured_std)?;
    let mut warnings = read.notes;
    let std = read.surface.asperity_height_std;
    if let Spread::Table(table) = &spread {
        compare(table, std, &described, &mut warnings)?;
    }
    let separation_from = separation_from(&described, &spread)?;
    if let (SeparationFrom::SurfaceMean, Spread::Table(table)) = (separation_from, &spread)
        && table.mean().abs() < 1e-3 * table.standard_deviation()
    {
        let needed = "a table whose heights are measured from the mean plane of the surface (this one's mean is 0, as if from its own mean)";
        return Err(described.conflict("separation_from", "heights", needed));
    }
    let separation_offset = offset(separation_from, read.mean_plane_offset, spread.table());
    let mut scene = Scene::new(interface, read.surface, nominal_area);
    let table = spread.table().cloned();
    scene.heights = spread.distribution(std).map_err(described.refused())?;
    scene.asperity().map_err(interface_section.refused())?;
    Ok(SceneFile { scene, options, separation_from, separation_offset, table, warnings })
}

fn separation_from(section: &Section<'_>, spread: &Spread) -> Result<SeparationFrom, SceneError> {
    let words = [
        ("asperity-mean", SeparationFrom::AsperityMean),
        ("surface-mean", SeparationFrom::SurfaceMean),
    ];
    let from = section.entry("separation_from").map(|entry| entry.one_of(&words)).transpose()?;
    let from = from.unwrap_or_default();
    if from == SeparationFrom::SurfaceMean && matches!(spread, Spread::Exponential) {
        let needed = "separation_from = \"asperity-mean\" (exponential heights begin at the lowest asperity, and no mean plane belongs to them)";
        return Err(section.conflict("separation_from", "heights", needed));
    }
    Ok(from)
}

/// A table's own standard deviation against the scene's.
fn compare(
    table: &asperity::TabulatedHeights,
    std: f64,
    section: &Section<'_>,
    warnings: &mut Vec<String>,
) -> Result<(), SceneError> {
    let (own, integral) = (table.standard_deviation(), table.integral());
    let ratio = own / std;
    if !(1.0 / WRONG_UNIT..=WRONG_UNIT).contains(&ratio) {
        return Err(SceneError::Value {
            at: section.place("heights"),
            found: format!(
                "a table with a standard deviation of {own:e} m, {ratio:.3e} times the asperity_height_std of {std:e} m"
            ),
            near: None,
            needed: format!("heights in metres (a ratio within {WRONG_UNIT})"),
        });
    }
    if (ratio - 1.0).abs() > DIFFERENT {
        warnings.push(format!(
            "{}: the table's standard deviation is {own:.4e} m, asperity_height_std is {std:.4e} m: the table's heights are used as they are, in metres; the other is the unit of separations only",
            section.place("heights")
        ));
    }
    if (integral - 1.0).abs() > 0.01 {
        warnings.push(format!(
            "{}: the table's integral is {integral:.4e}, not 1: it was normalised",
            section.place("heights")
        ));
    }
    Ok(())
}

impl From<Scene> for SceneFile {
    /// A scene that no file describes, with the models' own options and separations from the mean
    /// of the asperity heights.
    fn from(scene: Scene) -> Self {
        Self {
            scene,
            options: ModelOptions::default(),
            separation_from: SeparationFrom::AsperityMean,
            separation_offset: 0.0,
            table: None,
            warnings: vec![],
        }
    }
}

impl SceneFile {
    /// The model of an id, with the scene's options.
    ///
    /// # Errors
    /// [`SceneError::Contact`] for an unknown id, with a near match and all ids.
    pub fn model(&self, id: &str) -> Result<Model, SceneError> {
        self.options.model(id)
    }

    /// All models that the scene allows, with its options, simplest first; and those it does not,
    /// each with what it lacks.
    #[must_use]
    pub fn models(&self) -> (Vec<Model>, Vec<LeftOut>) {
        let (mut allowed, mut left_out) = (vec![], vec![]);
        for model in self.options.models() {
            let law = |asperity| model.law(&asperity, Quantity::Force, Tolerance::default());
            match self.scene.asperity().and_then(law) {
                Ok(_) => allowed.push(model),
                Err(reason) => left_out.push(LeftOut { id: model.id().into(), reason }),
            }
        }
        (allowed, left_out)
    }

    /// A separation from the plane that the scene file chose, over σ_z, as the library takes it:
    /// from the mean of the asperity heights.
    #[must_use]
    pub fn to_asperity_mean(&self, separation: f64) -> f64 {
        separation - self.separation_offset / self.scene.surface.asperity_height_std
    }

    /// The way back: the library's separation over σ_z, from the plane that the scene file chose.
    #[must_use]
    pub fn from_asperity_mean(&self, separation: f64) -> f64 {
        separation + self.separation_offset / self.scene.surface.asperity_height_std
    }

    /// A length \[m\] as a multiple of σ_z.
    #[must_use]
    pub fn over_height_std(&self, length: f64) -> f64 {
        length / self.scene.surface.asperity_height_std
    }

    /// A multiple of σ_z as a length \[m\].
    #[must_use]
    pub fn in_metres(&self, multiple: f64) -> f64 {
        multiple * self.scene.surface.asperity_height_std
    }

    /// The same options, heights and plane of separations with other numbers: a table of heights
    /// keeps its metres, and the mean plane follows the surface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_numbers(
        &self,
        interface: Interface,
        surface: Surface,
        nominal_area: f64,
    ) -> Result<Self, ContactError> {
        let mut scene = Scene::new(interface, surface, nominal_area);
        scene.asperity()?;
        scene.heights = match &self.table {
            Some(table) => {
                HeightDistribution::other(table.clone().in_units_of(surface.asperity_height_std)?)
            }
            None => self.scene.heights.clone(),
        };
        let separation_offset = if surface == self.scene.surface {
            self.separation_offset
        } else {
            offset(self.separation_from, surface.mean_plane_offset(), self.table.as_ref())
        };
        Ok(Self { scene, separation_offset, warnings: vec![], ..self.clone() })
    }
}

/// How far the library's zero of separation lies above the plane chosen \[m\]; `mean_plane` is the
/// mean of the asperity heights above the mean plane, where no table tells it.
fn offset(from: SeparationFrom, mean_plane: f64, table: Option<&TabulatedHeights>) -> f64 {
    match from {
        SeparationFrom::AsperityMean => 0.0,
        SeparationFrom::SurfaceMean => table.map_or(mean_plane, TabulatedHeights::mean),
    }
}
