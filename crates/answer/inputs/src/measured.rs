//! The surface of a scene from measured files.

use std::path::PathBuf;
use std::sync::Arc;

use asperity::{
    Code, ContactError, Finding, Pair, ProfileMoments, Scene, Surface, TabulatedHeights,
};
use asperity_topography::{
    Estimator, HeightDensity, Statistics, Topography, TopographyError, read, read_bytes,
};

use crate::document::Document;
use crate::heights::HeightsKey;
use crate::keys::COUNTERFACE;
use crate::measured_keys::MeasuredKeys;
use crate::scan::open_seam;
use crate::small_scan::long_wavelength;
use crate::{Measured, SceneError, SceneFile};

/// What a scene file is read for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Models of asperities, among others.
    Asperities,
    /// Models without asperities, such as boundary elements, on a scan that is declared periodic if
    /// the file or the caller says so.
    Scan { periodic: bool },
}

/// The bandwidth α of the surface that stands in where a scan has no asperities.
const BANDWIDTH: f64 = 3.0;

/// Codes of warnings about a scan that describe the sum of two surfaces, not one of them.
const OF_SUM: [Code; 6] = [
    Code::Anisotropic,
    Code::EstimatorsDisagree,
    Code::NoAsperities,
    Code::NoSecondEstimator,
    Code::Outliers,
    Code::RoughnessParameter,
];

/// A scan of a scene.
struct Scan {
    /// The section of its keys.
    section: &'static str,
    /// The key of its path.
    at: String,
    path: PathBuf,
    keys: MeasuredKeys,
}

impl Scan {
    /// The scan as its keys prepare it.
    fn read(&self, document: &Document<'_>) -> Result<Topography, SceneError> {
        let (path, options) = (document.path(&self.path), &self.keys.options());
        let read = match document.handed(&self.at, &self.path)? {
            Some(bytes) => read_bytes(&path.to_string_lossy(), bytes, options),
            None => read(&path, options),
        };
        let prepared =
            read.and_then(|read| self.keys.clean(read)).and_then(|clean| self.keys.prepare(clean));
        prepared.map_err(|error| self.refused(document, error))
    }

    /// The statistics of a scan by the keys of this one.
    fn measure(&self, document: &Document<'_>, scan: &Topography) -> Result<Measured, SceneError> {
        let [dx, dy] = scan.pixel_size();
        let statistics = scan.statistics(self.keys.estimator);
        let statistics = statistics.map_err(|error| self.refused(document, error))?;
        let long_wavelength = long_wavelength(scan);
        Ok(Measured { statistics, pixel_size: dx.max(dy), long_wavelength })
    }

    /// Errors of an option are at that option, all others at the file.
    fn refused(&self, document: &Document<'_>, error: TopographyError) -> SceneError {
        let option = |field: &str| document.place(&format!("{}.{field}", self.section));
        // Only errors of reading have the name of the file.
        let error = match error {
            TopographyError::File { source, .. } => *source,
            other => other,
        };
        let at = match error {
            TopographyError::OutOfRange { field, value, required } => {
                return SceneError::value(option(field), value, &required);
            }
            TopographyError::TooManyMissing { .. } => option("max_missing"),
            _ => document.place(&self.at),
        };
        SceneError::Refused { at, reason: format!("{}: {error}", self.path.display()) }
    }
}

/// The scans of a scene: one or two.
fn scans(document: &Document<'_>, asked: Asked) -> Result<Vec<Scan>, SceneError> {
    let mut scans = vec![];
    let sections = ["surface", COUNTERFACE].into_iter().filter(|section| document.has(section));
    for section in sections {
        let mut keys = MeasuredKeys::read(document, section)?;
        keys.periodic |= asked == Asked::Scan { periodic: true };
        if keys.smooth.zip(keys.filter).is_some_and(|(smooth, filter)| smooth >= filter) {
            let needed = "a value of smooth below filter, which keeps some wavelengths,";
            let [smooth, filter] = ["smooth", "filter"].map(|key| format!("{section}.{key}"));
            return Err(document.conflict(&smooth, &filter, needed));
        }
        let mut one = |at: String, path: &PathBuf| {
            scans.push(Scan { section, at, path: path.clone(), keys: keys.clone() });
        };
        match (&keys.file, keys.files.as_deref()) {
            (None, None) => {}
            (Some(file), None) => one(format!("{section}.file"), file),
            (None, Some(files @ [_, _])) if !document.has(COUNTERFACE) => {
                (1..).zip(files).for_each(|(k, file)| one(format!("surface.files[{k}]"), file));
            }
            (_, Some(files)) => {
                let needed = "a list of two paths, without file and counterface,";
                let found = format_args!("a list of {}", files.len());
                return Err(SceneError::value(document.place("surface.files"), found, needed));
            }
        }
    }
    Ok(scans)
}

/// The scene of `pair` with the surface of one scan, of two in contact, or of one and a surface
/// with these moments, and what is to be said about it.
pub(crate) fn measured(
    document: &Document<'_>,
    heights: &HeightsKey,
    asked: Asked,
    pair: Scene,
    other: Option<ProfileMoments>,
) -> Result<(SceneFile, Vec<Finding>), SceneError> {
    let measured_heights = matches!(heights, HeightsKey::Measured);
    let scans = scans(document, asked)?;
    let (first, second) = match &scans[..] {
        [] => return Err(document.missing("surface.file", "a measured file")),
        [first, rest @ ..] => (first, rest.first()),
    };
    let two = if document.has(COUNTERFACE) { COUNTERFACE } else { "surface.files" };
    let alignment = MeasuredKeys::read(document, "surface")?.alignment();
    let is_pair = second.is_some() || other.is_some();
    if alignment.is_some() && second.is_none() {
        let needed = "two scans, files or a file and counterface.file,";
        let found = format_args!("for one scan");
        return Err(SceneError::value(document.place("surface.aligned"), found, needed));
    }
    if is_pair && alignment.is_none() {
        let by_summits = |scan: &&Scan| scan.keys.estimator == Estimator::Summits;
        if let Some(scan) = scans.iter().find(by_summits) {
            let needed = "estimator = \"moments\" for two surfaces: moments add, summits do not,";
            return Err(document.conflict(&format!("{}.estimator", scan.section), two, needed));
        }
        if measured_heights {
            let needed = "one file or aligned scans: the heights of two surfaces do not add,";
            return Err(document.conflict("surface.heights", two, needed));
        }
    }
    // Moments of numbers beside a scan are isotropic and Gaussian.
    let at = if second.is_some() { two } else { &first.at };
    let refused = |reason: TopographyError| {
        let reason = match is_pair {
            true => reason.to_string(),
            false => format!("{}: {reason}", first.path.display()),
        };
        SceneError::Refused { at: document.place(at), reason }
    };
    let from = |at: &str| {
        let at = document.place(at).to_string();
        move |found: Finding| found.from_origin(at.clone())
    };
    let mut notes = vec![];
    let mut alone = |of: &Scan| {
        let scan = of.read(document)?;
        let found = of.measure(document, &scan)?;
        let own = found.statistics.warnings.iter().filter(|found| !OF_SUM.contains(&found.code));
        notes.extend(own.cloned().map(from(&of.at)));
        Ok::<_, SceneError>((found, scan))
    };
    let sum = |one: Measured, two: Statistics, pixel: f64| {
        let statistics = Statistics::combined(&one.statistics, &two).map_err(refused)?;
        let pixel_size = one.pixel_size.max(pixel);
        Ok::<_, SceneError>(Measured { statistics, pixel_size, long_wavelength: None })
    };
    let (mut rougher, mut counter_variance) = (None, 0.0);
    // A single scan may be that of the counterface.
    let is_second = first.section == COUNTERFACE;
    let each = |one: &Statistics, two: Option<Surface>| match (one.surface(), two) {
        (Ok(one), Some(two)) if is_second => Ok(Some(Pair::new(two, one))),
        (Ok(one), Some(two)) => Ok(Some(Pair::new(one, two))),
        _ => Err("models of pairs need the asperities of each surface, and one has none"),
    };
    let mut facing = Err("models of pairs need two independent surfaces, not aligned scans");
    let (measured, scan) = match (second, alignment, other) {
        (Some(second), Some(alignment), _) => {
            let (one, two) = (first.read(document)?, second.read(document)?);
            let both = one.facing(&two, alignment).map_err(refused)?;
            (first.measure(document, &both)?, Some(both))
        }
        (Some(second), None, _) => {
            let ((one, scan), (two, other)) = (alone(first)?, alone(second)?);
            counter_variance = two.statistics.m0;
            rougher = Some(if one.statistics.m4 < two.statistics.m4 { other } else { scan });
            facing = each(&one.statistics, two.statistics.surface().ok());
            (sum(one, two.statistics, two.pixel_size)?, None)
        }
        (None, _, Some(moments)) => {
            let (one, scan) = alone(first)?;
            counter_variance = if is_second { one.statistics.m0 } else { moments.m0 };
            rougher = (one.statistics.m4 > moments.m4).then_some(scan);
            facing = each(&one.statistics, Surface::from_moments(&moments).ok());
            (sum(one, Statistics::gaussian(moments), 0.0)?, None)
        }
        (None, _, None) => {
            let scan = first.read(document)?;
            facing = Ok(None);
            (first.measure(document, &scan)?, Some(scan))
        }
    };
    let statistics = &measured.statistics;
    let (surface, no_asperities) = match statistics.surface() {
        Ok(surface) => (surface, None),
        // Only models without asperities are valid for it.
        Err(reason) if asked != Asked::Asperities => {
            (alike(statistics).map_err(document.refused("surface"))?, Some(reason.to_string()))
        }
        Err(reason) => return Err(refused(reason)),
    };
    surface.check().map_err(document.refused("surface"))?;
    notes.extend(statistics.warnings.iter().cloned().map(from(at)));
    for Scan { section, keys, .. } in &scans {
        let tilted = keys.level.and_then(|level| level.tilts(keys.periodic));
        notes.extend(tilted.map(from(&format!("{section}.level"))));
    }
    let seam = scan.as_ref().and_then(open_seam);
    notes.extend(seam.map(from(&format!("{}.periodic", first.section))));
    let of_summits = scan.as_ref().filter(|_| measured_heights && no_asperities.is_none());
    let heights = of_summits.map(|scan| {
        let points = density(scan).map_err(refused)?;
        TabulatedHeights::new("measured", &points).map_err(document.refused("surface"))
    });
    let mut file = SceneFile::from(pair);
    file.scene.surface = surface;
    (file.scene.pair, file.no_pair) = (facing.ok().flatten(), facing.err());
    file.table = heights.transpose()?;
    file.measured = Some(measured);
    file.scan = scan.map(Arc::new);
    file.rougher = rougher.map(Arc::new);
    file.no_asperities = no_asperities;
    file.counter_variance = counter_variance;
    Ok((file, notes))
}

/// A Gaussian surface with the rms height and slope of a scan without asperities.
fn alike(statistics: &Statistics) -> Result<Surface, ContactError> {
    let Statistics { m0, m2, .. } = *statistics;
    Surface::from_moments(&ProfileMoments { m0, m2, m4: BANDWIDTH * m2 * m2 / m0 })
}

/// The density of the summits' heights above the mean plane.
fn density(topography: &Topography) -> Result<Vec<(f64, f64)>, TopographyError> {
    let summits = topography.summits()?;
    let offset = summits.mean() - topography.mean();
    let HeightDensity { heights_m, density_per_m, .. } = summits.height_density()?;
    Ok(heights_m.into_iter().map(|z| z + offset).zip(density_per_m).collect())
}
