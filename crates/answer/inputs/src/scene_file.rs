//! Scene files.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::{
    Body, Code, ContactError, Datum, Finding, Findings, HeightDistribution, Scene, Separation,
    SeparationUnit, Surface, TabulatedHeights, WeibullHeights,
};
use asperity_topography::Topography;

use crate::document::{Document, Files, HandedFiles};
use crate::gap::{Gas, gas};
use crate::heights::{HeightsKey, compare_std};
use crate::interface::interface;
use crate::kept::Read;
use crate::keys::{COUNTERFACE, joined};
use crate::measured::Asked;
use crate::numbers::Written;
use crate::scan::{ScanSpectrum, height_map};
use crate::surface::surface;
use crate::text_file::read_text;
use crate::unknowns::Face;
use crate::{Measured, ModelOptions, Place, Roughness, SceneError, accept};

/// A scene with the options of its models, as a scene file describes it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SceneFile {
    /// The surfaces in contact; those of numbers with ranges in the middle of these.
    pub scene: Scene,
    /// The variants of the models.
    pub options: ModelOptions,
    /// The gas in the gap, if there is one.
    pub gas: Option<Gas>,
    /// The plane from which separations are measured.
    pub separation_from: Datum,
    /// The table of heights of `scene.heights`, if there is one.
    pub table: Option<TabulatedHeights>,
    /// The bodies from which the interface follows, if given.
    pub bodies: Vec<Body>,
    /// Statistics of the scans of the surface, if there are any.
    pub measured: Option<Measured>,
    /// The keys of numbers in a unit that is not decimal, such as psi or HV, and these in one:
    /// `200 HV is 2.115 GPa`.
    pub converted: Vec<(String, String)>,
    /// Warnings about the file.
    pub warnings: Findings,
    /// Codes of accepted warnings and notes, which are not shown.
    pub accept: Vec<Code>,
    /// The scan of the surface, levelled and filtered, if there is exactly one.
    pub scan: Option<Arc<Topography>>,
    /// Of two surfaces, the scan with the larger m4, if one of them has.
    pub(crate) rougher: Option<Arc<Topography>>,
    /// The reason why the scan has no asperities, in a scene from [`load_scan`].
    pub(crate) no_asperities: Option<String>,
    /// Why models of pairs do not know each of its two surfaces.
    pub(crate) no_pair: Option<&'static str>,
    /// The keys of `[surface]` from which the asperities follow, if they are not given directly.
    pub(crate) follows_from: &'static [&'static str],
    /// The numbers from which the asperities follow, if they are not given directly or measured.
    pub roughness: Option<Roughness>,
    /// The numbers that were written of each surface, of which all are given by numbers without
    /// ranges.
    pub(crate) written: Vec<Written>,
    /// The rough surfaces whose numbers are known within ranges; their middles make
    /// `scene.surface`.
    pub(crate) faces: Vec<Face>,
    /// The number of the surface that explains findings about the asperities.
    pub(crate) odd_number: Option<Finding>,
    /// The place of the hardness of the interface or of the first body.
    pub(crate) hardness_at: Option<Box<Place>>,
    /// Of two scans, or of a scan and a surface by numbers, the mean square of the heights of the
    /// second \[m²\], where `scene.pair` may lack each by itself; 0 of others.
    pub(crate) counter_variance: f64,
    /// The Peklenik number of each surface, where it is given.
    pub(crate) peklenik_numbers: [Option<f64>; 2],
    /// The keys that were given with a unit.
    pub(crate) stated: Vec<String>,
    /// The file as read, for writing it again.
    pub(crate) read: Option<Arc<Read>>,
    /// The spectrum of the scan, computed on first use.
    pub(crate) spectrum: Arc<OnceLock<ScanSpectrum>>,
    /// The Hurst exponent of the scan, fitted on first use.
    pub(crate) hurst: Arc<OnceLock<Option<f64>>>,
}

/// Reads a scene file and the files that it names.
///
/// # Errors
/// [`SceneError`] with the file, the line, the field, the value found and the value needed.
pub fn load(path: impl AsRef<Path>) -> Result<SceneFile, SceneError> {
    load_with(path.as_ref(), Asked::Asperities)
}

/// [`load`] for [boundary elements](SceneFile::bem) and `persson`, which need no asperities: of a
/// sphere, a wave or a step, for example. The surface of such a scene only has the rms height and
/// slope of the scan, and [`SceneFile::model`] refuses models of asperities with the reason. With
/// `periodic` the scan is declared periodic, whatever the file says.
///
/// # Errors
/// Those of [`load`], except that of a scan without asperities.
pub fn load_scan(path: impl AsRef<Path>, periodic: bool) -> Result<SceneFile, SceneError> {
    load_with(path.as_ref(), Asked::Scan { periodic })
}

fn load_with(path: &Path, asked: Asked) -> Result<SceneFile, SceneError> {
    let named = || Place { file: Some(path.to_path_buf()), ..Place::field("the scene file") };
    let advice = format!(
        "`asperity init` writes a scene, and `asperity surface {} --scene scene.toml` makes one of a scan",
        path.display()
    );
    let read = || {
        let text = read_text(path, &advice, named)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        scene_file(&Document::new(Some(path), Files::In(folder), &text)?, asked)
    };
    read().map_err(|error| match error {
        SceneError::Refused { at, reason } if path.extension().is_none_or(|end| end != "toml") => {
            SceneError::Refused { at, reason: format!("{reason}; {advice}") }
        }
        error => error,
    })
}

/// Reads a scene from its text; relative paths in it are relative to `directory`.
///
/// ```
/// use asperity::{ContactModel, Quantity, Request};
/// use asperity_inputs::{parse, template};
///
/// let file = parse(template(), std::path::Path::new("."))?;
/// let answer = file.model("ke")?.solve(&file.scene, &Request::new([Quantity::Force]).at([2.0]));
/// assert!(answer.is_ok());
/// let mistyped = template().replace("nominal_area", "nominal_aera");
/// let error = parse(&mistyped, std::path::Path::new(".")).unwrap_err().to_string();
/// assert!(error.contains("the nearest is \"nominal_area\""));
/// # Ok::<(), asperity_inputs::SceneError>(())
/// ```
///
/// # Errors
/// Those of [`load`], without a file's name.
pub fn parse(text: &str, directory: &Path) -> Result<SceneFile, SceneError> {
    scene_file(&Document::new(None, Files::In(directory), text)?, Asked::Asperities)
}

/// Reads a scene from its text and the bytes of the files that it names: where there is no file
/// system, as in a browser.
///
/// # Errors
/// Those of [`parse`]; [`SceneError::Unreadable`] for a file that is not among `files`.
pub fn parse_handed(text: &str, files: &HandedFiles) -> Result<SceneFile, SceneError> {
    scene_file(&Document::new(None, Files::Handed(files), text)?, Asked::Asperities)
}

pub(crate) fn scene_file(document: &Document<'_>, asked: Asked) -> Result<SceneFile, SceneError> {
    document.check_sections()?;
    let options = ModelOptions::default().with_keys(document, "options")?;
    let nominal_area = document.needed_number("nominal_area")?;
    let accept: Vec<String> = document.get("accept")?.unwrap_or_default();
    let accept = accept::codes(document, &accept)?;
    let (interface, interface_section, bodies) = interface(document)?;
    let heights: HeightsKey = document.get("surface.heights")?.unwrap_or_default();
    let separation_from: Datum = document.get("surface.separation_from")?.unwrap_or_default();
    asperity::positive("nominal_area", nominal_area).map_err(document.refused(""))?;

    let given = heights.table(document)?;
    let own_std = given.as_ref().map(TabulatedHeights::standard_deviation);
    let pair = Scene::new(interface, Surface::new(0.0, 0.0, 0.0), nominal_area);
    let (mut file, mut notes) = surface(document, &heights, pair, own_std, asked)?;
    if let Some(table) = &given {
        notes.extend(compare_std(document, table, file.scene.surface.asperity_height_std)?);
    }
    file.table = given.or(file.table);
    let table = file.table.as_ref();
    let scene = &mut file.scene;
    scene.heights = match (&heights, table) {
        (HeightsKey::Exponential, _) => HeightDistribution::Exponential,
        (HeightsKey::Skewed { skewness }, _) => {
            let heights =
                WeibullHeights::new(*skewness).map_err(document.refused("surface.heights"));
            HeightDistribution::Weibull(heights?)
        }
        (_, Some(table)) => HeightDistribution::other(table.clone()),
        _ => HeightDistribution::Gaussian,
    };
    let offset = file.measured.as_ref().and_then(|found| found.statistics.mean_plane_offset);
    let offset = table.map(TabulatedHeights::mean).or(offset);
    let mut given = [None; 2];
    for (section, given) in ["surface", COUNTERFACE].iter().zip(&mut given) {
        let key = joined(section, "mean_plane_offset");
        *given = document.number(&key)?;
        if given.is_some() && offset.is_some() {
            let source = if table.is_some() { "surface.heights" } else { "surface.file" };
            let needed = "one of the two: the offset follows from measured heights";
            return Err(document.conflict(&key, source, needed));
        }
    }
    file.set_heights(offset, given);
    for (section, number) in ["surface", COUNTERFACE].iter().zip(&mut file.peklenik_numbers) {
        *number = document.positive(section, "peklenik_number")?;
    }
    file.options = options;
    let (scene, table) = (&file.scene, file.table.as_ref());
    scene.asperity().map_err(|error| {
        let of_plane = scene.mean_plane_offset.is_some_and(|offset| !offset.is_finite());
        document.refused(if of_plane { "surface" } else { interface_section })(error)
    })?;
    if separation_from != Datum::AsperityMean
        && let Some(needed) = no_mean_plane(scene, table)
    {
        return Err(document.conflict("surface.separation_from", "surface.heights", needed));
    }
    let is_map = file.scan.as_deref().is_some_and(|scan| height_map(scan).is_ok());
    if let Some(exponent) = options.hurst_exponent.filter(|_| is_map) {
        let at = document.place("options.hurst_exponent");
        let found = Finding::warning(Code::HurstExponent, "hurst_exponent", exponent)
            .fact("persson and persson-fudge use a power law instead of the spectrum of the scan")
            .advice("remove hurst_exponent to use the spectrum of the scan");
        notes.push(found.from_origin(at.to_string()));
    }
    let gas = gas(document)?;
    file.read = Some(Arc::new(Read::new(document, (interface, &bodies), scene.surface, table)));
    Ok(SceneFile {
        gas,
        separation_from,
        bodies,
        warnings: notes.into_iter().collect::<Findings>().silenced(&accept),
        accept,
        hardness_at: Some(document.place(&joined(interface_section, "hardness"))),
        stated: document.stated.clone(),
        converted: document.converted.clone(),
        ..file
    })
}

/// The missing requirement for separations from the mean plane of the surface, if any.
fn no_mean_plane(scene: &Scene, table: Option<&TabulatedHeights>) -> Option<&'static str> {
    match (&scene.heights, table) {
        (_, Some(table)) if table.mean().abs() < 1e-3 * table.standard_deviation() => Some(
            "a table whose heights are measured from the mean plane of the surface (the mean of this table is 0: its heights are measured from their own mean)",
        ),
        _ if scene.mean_plane_offset.is_some() => None,
        (HeightDistribution::Exponential | HeightDistribution::Weibull(_), _) => Some(
            "separation_from = \"asperity-mean\" or mean_plane_offset (the mean plane of such heights is unknown)",
        ),
        _ => None,
    }
}

impl From<Scene> for SceneFile {
    /// A scene without a file: default options, and separations from the mean of the asperity
    /// heights.
    fn from(scene: Scene) -> Self {
        Self {
            scene,
            options: ModelOptions::default(),
            gas: None,
            separation_from: Datum::AsperityMean,
            table: None,
            bodies: vec![],
            measured: None,
            converted: vec![],
            warnings: Findings::default(),
            accept: vec![],
            scan: None,
            rougher: None,
            no_asperities: None,
            no_pair: None,
            follows_from: &[],
            roughness: None,
            written: vec![],
            faces: vec![],
            odd_number: None,
            hardness_at: None,
            counter_variance: 0.0,
            peklenik_numbers: [None; 2],
            stated: vec![],
            read: None,
            spectrum: Arc::default(),
            hurst: Arc::default(),
        }
    }
}

impl SceneFile {
    /// A separation measured from the plane of this scene.
    #[must_use]
    pub fn separation(&self, value: f64, unit: SeparationUnit) -> Separation {
        Separation { value, unit, from: self.separation_from }
    }

    /// The name of the plane from which separations are measured.
    #[must_use]
    pub fn plane(&self) -> &'static str {
        self.separation_from.name(&self.scene.heights)
    }

    /// A missing hardness as an error at its place in the file.
    ///
    /// # Errors
    /// Any other error as it is, and any error of a scene without a file.
    pub fn at_its_key(&self, error: ContactError) -> Result<SceneError, ContactError> {
        match (&self.hardness_at, &error) {
            (Some(at), ContactError::Missing { field: "hardness", .. }) => {
                Ok(SceneError::from_contact(error, |_| at.clone()))
            }
            _ => Err(error),
        }
    }

    /// The scene's bodies and options with another scan and its asperities, under Gaussian heights.
    #[must_use]
    pub fn with_scan(&self, surface: Surface, scan: Topography) -> Self {
        let scene = Scene::new(self.scene.interface, surface, self.scene.nominal_area);
        let (options, separation_from) = (self.options, self.separation_from);
        Self { options, separation_from, scan: Some(Arc::new(scan)), ..Self::from(scene) }
    }
}
