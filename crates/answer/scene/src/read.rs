//! Scene files: from a text to what was written, and to its scene.

use std::path::Path;
use std::sync::Arc;

use asperity::{Code, Datum, Findings, TabulatedHeights};

use crate::curvature::Curvature;
use crate::document::{Document, Files, HandedFiles};
use crate::error::{Place, SceneError};
use crate::heights::{compare_std, heights};
use crate::input::SceneInput;
use crate::interface::bodies;
use crate::keys::{COUNTERFACE, joined, keys_of};
use crate::measured::Scan;
use crate::options::ModelOptions;
use crate::resolve::resolve;
use crate::scans::{self, Asked, density, notes};
use crate::scene_file::SceneFile;
use crate::seal::{Gas, Seal};
use crate::spec::{HeightsSpec, SAME, SceneSpec};
use crate::surface::{refused, smooth_counterface, surfaces};
use crate::text_file::read_text;
use crate::unknown::Unknown;

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
/// The errors of [`load`], except that of a scan without asperities.
pub fn load_scan(path: impl AsRef<Path>, periodic: bool) -> Result<SceneFile, SceneError> {
    load_with(path.as_ref(), Asked::Scan { periodic })
}

fn load_with(path: &Path, asked: Asked) -> Result<SceneFile, SceneError> {
    let named = || Place { file: Some(path.to_path_buf()), ..Place::field("") };
    let advice = format!(
        "`asperity init` writes a scene, and `asperity surface {} --scene scene.toml` makes one of a scan",
        path.display()
    );
    let text = read_text(path, &advice, named)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let is_toml = path.extension().is_some_and(|end| end == "toml");
    let document = Document::new(Some(path), Files::In(folder), &text);
    let document = document.map_err(|error| match error {
        SceneError::Refused { at, link: ": ", reason } if !is_toml => {
            SceneError::refused(at, format!("{reason}; {advice}"))
        }
        error => error,
    });
    scene_file(&document?, asked)
}

/// Reads a scene from its text; relative paths in it are relative to `directory`.
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
/// assert!(error.contains("the nearest is \"nominal_area\""));
/// # Ok::<(), asperity_scene::SceneError>(())
/// ```
///
/// # Errors
/// The errors of [`load`], without a file's name.
pub fn parse(text: &str, directory: &Path) -> Result<SceneFile, SceneError> {
    scene_file(&Document::new(None, Files::In(directory), text)?, Asked::Asperities)
}

/// Reads a scene from its text and the bytes of the files that it names: where there is no file
/// system, as in a browser.
///
/// # Errors
/// The errors of [`parse`]; [`SceneError::Refused`] for a file that is not among `files`.
pub fn parse_handed(text: &str, files: &HandedFiles) -> Result<SceneFile, SceneError> {
    scene_file(&Document::new(None, Files::Handed(files), text)?, Asked::Asperities)
}

/// What a document says of its scene.
fn spec(document: &Document<'_>, asked: Asked) -> Result<SceneSpec, SceneError> {
    document.check_sections()?;
    let options = ModelOptions::default().with_keys(document, "options")?;
    let curvature: Option<Curvature> = document.section("curvature")?;
    let seal: Option<Seal> = document.section("seal")?;
    let of_seal = seal.and_then(|seal| seal.area());
    let nominal_area = match curvature {
        // Without an area, the seal is refused when it is resolved.
        None if seal.is_some() && !document.has("nominal_area") => of_seal.unwrap_or(1.0),
        None => document.needed_number("nominal_area")?,
        Some(_) if document.has("nominal_area") => {
            let needed =
                "one of the two (curved bodies meet at a patch, which follows from the load)";
            return Err(document.conflict("nominal_area", "curvature", needed));
        }
        Some(_) => 1.0,
    };
    let names: Vec<String> = document.get("accept")?.unwrap_or_default();
    let accept = names.iter().map(|name| Code::named(name)).collect::<Result<_, _>>();
    let accept =
        accept.map_err(|reason: String| SceneError::refused(document.place("accept"), reason))?;
    let bodies = bodies(document)?;
    let separation_from: Datum = document.get("surface.separation_from")?.unwrap_or_default();
    let heights = heights(document)?;
    let surfaces = surfaces(document, bodies, nominal_area, &heights, asked)?;
    let number = |key| document.needed_number(key);
    let gas = match document.has("gap") {
        true => Some(Gas {
            gas_conductivity: number("gap.gas_conductivity")?,
            gas_parameter: number("gap.gas_parameter")?,
        }),
        false => None,
    };
    let mut spec =
        SceneSpec { heights, separation_from, curvature, gas, seal, options, accept, ..surfaces };
    let has_asperities = |scan: &&Arc<Scan>| {
        scan.measured.as_ref().is_some_and(|own| own.statistics.surface().is_ok())
    };
    let scan = spec.single_scan().filter(has_asperities).filter(|_| spec.heights.is_measured);
    if let Some(scan) = scan {
        let points = density(&scan.topography);
        let points = points.map_err(|why| scans::refused(document, &spec, &why))?;
        let table = TabulatedHeights::new("measured", &points);
        let table = HeightsSpec::of_table(table.map_err(document.refused("surface"))?);
        spec.heights = HeightsSpec { is_measured: true, ..table };
    }
    Ok(spec)
}

pub(crate) fn scene_file(document: &Document<'_>, asked: Asked) -> Result<SceneFile, SceneError> {
    let spec = spec(document, asked)?;
    let (scene, measured) = resolve(&spec).map_err(|fault| refused(document, &spec, fault))?;
    let mut found = vec![];
    if let Some(together) = &measured {
        let no_asperities = together.statistics.surface().err();
        // Only models without asperities are valid for it.
        if let Some(reason) = no_asperities.as_ref().filter(|_| asked == Asked::Asperities) {
            return Err(scans::refused(document, &spec, reason));
        }
        found.extend(notes(document, &spec, &together.statistics));
    }
    found.extend(smooth_counterface(&spec));
    if let (Some(table), false) = (&spec.heights.table, spec.heights.is_measured) {
        compare_std(document, table, scene.surface.asperity_height_std)?;
    }
    let offset = measured.as_ref().and_then(|found| found.statistics.mean_plane_offset);
    let of_table = spec.heights.table.is_some();
    for section in ["surface", COUNTERFACE].into_iter().filter(|_| of_table || offset.is_some()) {
        let key = joined(section, "mean_plane_offset");
        if document.has(&key) {
            let source = if of_table { "surface.heights" } else { "surface.file" };
            let needed = "one of the two: the offset follows from measured heights";
            return Err(document.conflict(&key, source, needed));
        }
    }
    let warnings = found.into_iter().collect::<Findings>().silenced(&spec.accept);
    let mut origin = document.origin.clone();
    let scans = spec.surfaces().filter_map(|(_, one)| one.scan()?.source.as_ref());
    origin.files = scans.map(|scan| document.whole_path(&scan.path)).collect();
    let mut file = SceneFile {
        warnings,
        origin: Some(Arc::new(origin)),
        ..SceneFile::new(spec, scene, measured)
    };
    file.ranges = ranges(document, &file)?;
    match file.no_mean_plane() {
        Some(needed) => {
            Err(document.conflict("surface.separation_from", "surface.heights", needed))
        }
        None => Ok(file),
    }
}

/// The numbers that were written as ranges; each end is that of a scene.
fn ranges(
    document: &Document<'_>,
    file: &SceneFile,
) -> Result<Vec<(SceneInput, Unknown)>, SceneError> {
    let inputs = if document.ranges.is_empty() { vec![] } else { file.all_inputs() };
    let range = |(path, ends): &(String, [f64; 2])| {
        let of_path = inputs.iter().find(|(_, input)| input.path() == *path);
        let Some((name, input)) = of_path else {
            return Err(document.wrong(path, "a single number"));
        };
        for end in ends {
            let made = file.with_inputs([(*input, *end)]);
            made.map_err(document.refused(input.section))?;
        }
        Ok((*input, Unknown::written(name.clone(), *ends)))
    };
    let mut all = document.ranges.clone();
    // Of a surface that is the same, each number has the range of the other.
    if file.spec.counterface_word == Some(SAME) {
        let own = document.ranges.iter().filter_map(|(path, ends)| {
            let key = path.strip_prefix("surface.")?;
            keys_of(COUNTERFACE).contains(&key).then(|| (joined(COUNTERFACE, key), *ends))
        });
        all.extend(own);
    }
    all.iter().map(range).collect()
}
