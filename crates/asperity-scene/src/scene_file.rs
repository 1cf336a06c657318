//! A scene file, read.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::{
    Body, ContactError, ContactModel, Datum, Diagnostic, Diagnostics, HeightDistribution,
    Interface, Model, Quantity, Request, Scene, Separation, SeparationUnit, Surface,
    TabulatedHeights, WeibullHeights,
};
use asperity_bem::Boundary;
use asperity_topography::Topography;

use crate::document::{Document, text_of};
use crate::heights::{compared, read_heights};
use crate::interface::interface;
use crate::keys::{HeightsKey, SceneKeys};
use crate::scan::{ScanSpectrum, height_map};
use crate::surface::surface;
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
    /// Diagnostics of the files that were read.
    pub warnings: Diagnostics,
    /// Codes of the warnings and notes that are accepted, and not shown.
    pub accept: Vec<String>,
    /// The scan of the surface, levelled and filtered, where one file describes it.
    pub scan: Option<Arc<Topography>>,
    /// The keys of `[surface]` that the asperities follow from, where they are not given themselves.
    pub(crate) follows_from: &'static [&'static str],
    /// Its spectrum, once it was asked for.
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
        scene_file(Document::read(Some(path), Some(folder), &text)?)
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
    scene_file(Document::read(None, Some(directory), text)?)
}

fn scene_file((ref document, keys): (Document<'_>, SceneKeys)) -> Result<SceneFile, SceneError> {
    keys.options.check(document, "options.")?;
    let (interface, of_interface) = interface(document, &keys)?;
    let SceneKeys { mut options, surface: keys, nominal_area, body: bodies, accept, .. } = keys;
    if let Some(asperities) = keys.asperities {
        if document.has("options.asperities") {
            let needed = "the asperities of the surface, once,";
            return Err(document.conflict("surface.asperities", "options.asperities", needed));
        }
        options.asperities = asperities;
    }
    asperity::positive("nominal_area", nominal_area).map_err(document.refused(""))?;

    let table = match &keys.heights {
        HeightsKey::Table { file } => Some(read_heights(document, file)?),
        _ => None,
    };
    let own_std = table.as_ref().map(TabulatedHeights::standard_deviation);
    let described = surface(document, &keys, &interface, own_std)?;
    let (surface, mut warnings) = (described.surface, described.notes);
    let std = surface.asperity_height_std;
    if let Some(table) = &table {
        warnings.extend(compared(document, table, std)?);
    }
    let table = table.or(described.heights);
    let from = keys.separation_from;
    let impossible = match (&keys.heights, &table) {
        _ if from == Datum::AsperityMean => None,
        (HeightsKey::Exponential, _) => Some(
            "separation_from = \"asperity-mean\" (exponential heights begin at the lowest asperity, and no mean plane belongs to them)",
        ),
        (HeightsKey::Skewed { .. }, _) => Some(
            "separation_from = \"asperity-mean\" (how far the mean of skewed asperities lies above that of their surface is not known)",
        ),
        (_, Some(table)) if table.mean().abs() < 1e-3 * table.standard_deviation() => Some(
            "a table whose heights are measured from the mean plane of the surface (this one's mean is 0, as if from its own mean)",
        ),
        _ => None,
    };
    if let Some(needed) = impossible {
        return Err(document.conflict("surface.separation_from", "surface.heights", needed));
    }
    let mut scene = Scene::new(interface, surface, nominal_area);
    scene.heights = match (&keys.heights, &table) {
        (HeightsKey::Exponential, _) => HeightDistribution::Exponential,
        (HeightsKey::Skewed { skewness }, _) => {
            let heights =
                WeibullHeights::new(*skewness).map_err(document.refused("surface.heights"));
            HeightDistribution::Weibull(heights?)
        }
        (_, Some(table)) => HeightDistribution::other(table.clone()),
        _ => HeightDistribution::Gaussian,
    };
    scene.asperity().map_err(document.refused(of_interface))?;
    let measured = described.measured;
    let offset = measured.as_ref().map(|measured| measured.statistics.mean_plane_offset);
    scene.mean_plane_offset = table.as_ref().map(TabulatedHeights::mean).or(offset);
    let (scan, separation_from) = (described.scan, from);
    let follows_from = described.follows_from;
    if options.hurst_exponent.is_some() && scan.as_deref().is_some_and(|s| height_map(s).is_ok()) {
        let at = document.place("options.hurst_exponent");
        let exponent = options.hurst_exponent.unwrap_or(f64::NAN);
        let found = Diagnostic::warning("hurst-exponent", "hurst_exponent", exponent)
            .fact("persson and persson-fudge use a power law in place of the spectrum of the scan")
            .advice("leave it out for the spectrum of the scan");
        warnings.push(found.from_origin(at.to_string()));
    }
    let spectrum = Arc::default();
    Ok(SceneFile {
        scene,
        options,
        separation_from,
        table,
        bodies,
        measured,
        warnings: warnings.into_iter().collect::<Diagnostics>().silenced(&accept),
        accept,
        scan,
        follows_from,
        spectrum,
    })
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
            warnings: Diagnostics::default(),
            accept: vec![],
            scan: None,
            follows_from: &[],
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
        Ok(Self { scene, bodies, measured, warnings: Diagnostics::default(), scan, ..self.clone() })
    }
}
