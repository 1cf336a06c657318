//! A scene file, read.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::{
    Body, ContactError, ContactModel, Datum, HeightDistribution, Interface, Model, Quantity,
    Request, Scene, Separation, SeparationUnit, Surface, TabulatedHeights, WeibullHeights,
};
use asperity_bem::Boundary;
use asperity_topography::Topography;
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::document::{Document, text_of};
use crate::heights::{HeightKeys, HeightsKey, compared};
use crate::interface::{InterfaceKeys, interface};
use crate::scan::{ScanSpectrum, height_map};
use crate::surface::surface;
use crate::write::Read;
use crate::{Asperities, Measured, ModelOptions, Place, SceneError};

/// All that a scene file says.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SceneFile {
    /// What is in contact.
    pub scene: Scene,
    /// What the ids of the models stand for.
    pub options: ModelOptions,
    /// What the separations of its users are measured from.
    pub separation_from: Datum,
    /// The table of heights, where there is one: what `scene.heights` was made of.
    pub table: Option<TabulatedHeights>,
    /// The bodies that the interface follows from, where they were given.
    pub bodies: Vec<Body>,
    /// What the scans say that the surface follows from, where there are any.
    pub measured: Option<Measured>,
    /// What was read, and still deserves a word.
    pub warnings: Vec<String>,
    /// The scan of the surface, levelled and filtered, where one file describes it.
    pub scan: Option<Arc<Topography>>,
    /// The keys of `[surface]` that the asperities follow from, where they are not given themselves.
    pub(crate) follows_from: &'static [&'static str],
    /// What was read, for writing it again.
    pub(crate) read: Option<Arc<Read>>,
    /// The spectrum of the scan, once it is needed.
    pub(crate) spectrum: Arc<OnceLock<ScanSpectrum>>,
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
    let named = || Place { file: Some(path.to_path_buf()), ..Place::field("the scene file") };
    let read = || {
        let text = text_of(path, named)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        scene_file(&Document::new(Some(path), Some(folder), &text)?)
    };
    read().map_err(|error| no_scene(path, error))
}

/// How scans are named, and scenes are not.
const SCANS: [&str; 8] = ["x3p", "sur", "npy", "txt", "xyz", "asc", "dat", "csv"];

/// That a file of another kind is a scan, rather than a scene with mistakes.
fn no_scene(path: &Path, error: SceneError) -> SceneError {
    let end = path.extension().unwrap_or_default().to_ascii_lowercase();
    if !path.is_file() || SCANS.iter().all(|scan| end != *scan) {
        return error;
    }
    let scan = |reason| {
        let name = path.display();
        format!(
            "a scene file in TOML was required, and a file of this name is a scan: `asperity surface {name} --scene scene.toml` makes a scene of it ({reason})"
        )
    };
    match error {
        SceneError::Syntax { at, reason } => SceneError::Syntax { at, reason: scan(reason) },
        SceneError::Unreadable { at, reason } => {
            SceneError::Unreadable { at, reason: scan(reason) }
        }
        other => other,
    }
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
    scene_file(&Document::new(None, Some(directory), text)?)
}

/// The keys of the file as a whole; what else it has is left to its readers.
#[derive(Deserialize)]
struct FileKeys {
    nominal_area: f64,
    /// That there is one.
    #[serde(rename = "surface")]
    _surface: IgnoredAny,
    #[serde(default)]
    options: ModelOptions,
}

/// The option that may stand in `[surface]`.
#[derive(Deserialize)]
struct AsperitiesKey {
    asperities: Option<Asperities>,
}

fn scene_file(document: &Document<'_>) -> Result<SceneFile, SceneError> {
    let table = document.table()?;
    let FileKeys { nominal_area, mut options, .. } = document.keys()?;
    options.check(document, "options.")?;
    let bodies: InterfaceKeys = document.keys()?;
    let (interface, interface_section) = interface(document, &bodies)?;
    let HeightKeys { heights, separation_from, mean_plane_offset } = document.surface()?;
    let AsperitiesKey { asperities } = document.surface()?;
    if let Some(asperities) = asperities {
        if document.has("options.asperities") {
            let needed = "one of the two";
            return Err(document.conflict("surface.asperities", "options.asperities", needed));
        }
        options.asperities = asperities;
    }
    asperity::positive("nominal_area", nominal_area).map_err(document.refused(""))?;

    let given = heights.table(document)?;
    let own_std = given.as_ref().map(TabulatedHeights::standard_deviation);
    let described = surface(document, &heights, &interface, own_std)?;
    let (surface, mut warnings) = (described.surface, described.notes);
    if let Some(table) = &given {
        warnings.extend(compared(document, table, surface.asperity_height_std)?);
    }
    let heights_table = given.or(described.heights);
    let measured = described.measured;
    let mut scene = Scene::new(interface, surface, nominal_area);
    scene.heights = match (&heights, &heights_table) {
        (HeightsKey::Exponential, _) => HeightDistribution::Exponential,
        (HeightsKey::Skewed { skewness }, _) => {
            let heights =
                WeibullHeights::new(*skewness).map_err(document.refused("surface.heights"));
            HeightDistribution::Weibull(heights?)
        }
        (_, Some(table)) => HeightDistribution::other(table.clone()),
        _ => HeightDistribution::Gaussian,
    };
    let offset = measured.as_ref().map(|measured| measured.statistics.mean_plane_offset);
    let offset = heights_table.as_ref().map(TabulatedHeights::mean).or(offset);
    if let (Some(_), Some(_)) = (mean_plane_offset, offset) {
        let known = if heights_table.is_some() { "surface.heights" } else { "surface.file" };
        let needed = "one of the two: the offset follows from measured heights";
        return Err(document.conflict("surface.mean_plane_offset", known, needed));
    }
    scene.mean_plane_offset = mean_plane_offset.or(offset);
    scene.asperity().map_err(|error| {
        let of_plane = scene.mean_plane_offset.is_some_and(|offset| !offset.is_finite());
        document.refused(if of_plane { "surface" } else { interface_section })(error)
    })?;
    if separation_from != Datum::AsperityMean
        && let Some(needed) = no_mean_plane(&scene, heights_table.as_ref())
    {
        return Err(document.conflict("surface.separation_from", "surface.heights", needed));
    }
    let scan = described.scan;
    if options.hurst_exponent.is_some() && scan.as_deref().is_some_and(|s| height_map(s).is_ok()) {
        let at = document.place("options.hurst_exponent");
        warnings.push(format!(
            "{at}: persson and persson-fudge use the power law with this exponent instead of the spectrum of the scan; leave hurst_exponent out to use the spectrum"
        ));
    }
    let read = Read::new(document, table, interface, surface, heights_table.as_ref());
    Ok(SceneFile {
        scene,
        options,
        separation_from,
        table: heights_table,
        bodies: bodies.body,
        measured,
        warnings,
        scan,
        follows_from: described.follows_from,
        read: Some(Arc::new(read)),
        spectrum: Arc::default(),
    })
}

/// What a scene needs before separations can be measured from the mean plane of its surface.
fn no_mean_plane(scene: &Scene, table: Option<&TabulatedHeights>) -> Option<&'static str> {
    match (&scene.heights, table) {
        (_, Some(table)) if table.mean().abs() < 1e-3 * table.standard_deviation() => Some(
            "a table whose heights are measured from the mean plane of the surface (the mean of this table is 0: its heights are measured from their own mean)",
        ),
        _ if scene.mean_plane_offset.is_some() => None,
        (HeightDistribution::Exponential, _) => Some(
            "separation_from = \"asperity-mean\" or mean_plane_offset (exponential heights begin at the lowest asperity; their mean plane is unknown)",
        ),
        (HeightDistribution::Weibull(_), _) => Some(
            "separation_from = \"asperity-mean\" or mean_plane_offset (the mean plane of skewed asperities is unknown)",
        ),
        _ => None,
    }
}

impl From<Scene> for SceneFile {
    /// A scene that no file describes, with the models' own options and separations from the mean
    /// of the asperity heights.
    fn from(scene: Scene) -> Self {
        Self {
            scene,
            options: ModelOptions::default(),
            separation_from: Datum::AsperityMean,
            table: None,
            bodies: vec![],
            measured: None,
            warnings: vec![],
            scan: None,
            follows_from: &[],
            read: None,
            spectrum: Arc::default(),
        }
    }
}

impl SceneFile {
    /// The model of an id, with the scene's options; `bem` for [boundary elements](Self::bem) on the
    /// scene's scan, repeated and with the hardness. `persson` takes its gaps from that scan's spectrum.
    ///
    /// # Errors
    /// [`SceneError::Contact`] for an unknown id, with a near match and all ids; those of
    /// [`bem`](Self::bem).
    pub fn model(&self, id: &str) -> Result<Model, SceneError> {
        self.model_with(&self.options, id)
    }

    /// [`model`](Self::model) with other options than the scene's.
    ///
    /// # Errors
    /// Those of [`model`](Self::model).
    pub fn model_with(&self, options: &ModelOptions, id: &str) -> Result<Model, SceneError> {
        match id.trim().to_lowercase().as_str() {
            "bem" => Ok(options.on_surface(Model::new(self.bem(Boundary::Periodic, false)?))),
            _ => options.model_beside(|| self.spectrum(), id),
        }
    }

    /// All models that the scene allows, with its options, simplest first; and those it does not,
    /// each with what it lacks.
    #[must_use]
    pub fn models(&self) -> (Vec<Model>, Vec<LeftOut>) {
        let (mut allowed, mut left_out) = (vec![], vec![]);
        for model in self.options.models() {
            match model.compile(&self.scene, &Request::new([Quantity::Force])) {
                Ok(_) => allowed.push(model),
                Err(reason) => left_out.push(LeftOut { id: model.id().into(), reason }),
            }
        }
        (allowed, left_out)
    }

    /// What can stand beside boundary elements on the scene's scan: [`models`](Self::models), and those
    /// of random asperities and of the whole surface, whatever it says of its asperities; and those
    /// that the scene does not allow, each with what it lacks.
    #[must_use]
    pub fn models_beside_bem(&self) -> (Vec<Model>, Vec<LeftOut>) {
        let (mut models, mut left_out) = self.models();
        let plain = ModelOptions { asperities: Asperities::Equal, ..self.options };
        let request = Request::new([Quantity::Area]);
        for other in [Model::all_random(), Model::whole_surface()].concat() {
            let known = models.iter().any(|model| model.id() == other.id());
            if known || left_out.iter().any(|model| model.id == other.id()) {
                continue;
            }
            let model = self.model_with(&plain, other.id()).unwrap_or(other);
            match model.compile(&self.scene, &request) {
                Ok(_) => models.push(model),
                Err(reason) => left_out.push(LeftOut { id: model.id().into(), reason }),
            }
        }
        (models, left_out)
    }

    /// The models that stick, where surfaces do.
    #[must_use]
    pub fn adhesive_models(&self) -> Vec<Model> {
        self.scene.interface.work_of_adhesion.map_or(vec![], |_| Model::adhesive())
    }

    /// A separation as the users of this scene count it.
    #[must_use]
    pub fn separation(&self, value: f64, unit: SeparationUnit) -> Separation {
        Separation { value, unit, from: self.separation_from }
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
        scene.heights = self.scene.heights.clone();
        // What was measured holds for the surface it was measured on.
        let measured = self.scene.mean_plane_offset.filter(|_| surface == self.scene.surface);
        scene.mean_plane_offset = self.table.as_ref().map(TabulatedHeights::mean).or(measured);
        let bodies = if interface == self.scene.interface { self.bodies.clone() } else { vec![] };
        let measured = self.measured.clone().filter(|_| surface == self.scene.surface);
        // Nor is a scan one of another surface.
        let scan = self.scan.clone().filter(|_| surface == self.scene.surface);
        Ok(Self { scene, bodies, measured, warnings: vec![], scan, ..self.clone() })
    }
}
