//! The scans that a scene names.

use std::sync::Arc;

use asperity::{Code, Finding, outside};
use asperity_topography::{
    Estimator, HeightDensity, Statistics, Topography, TopographyError, read, read_bytes,
};
use toml::{Table, Value};

use crate::document::Document;
use crate::error::SceneError;
use crate::keys::{COUNTERFACE, Key, Subject, joined};
use crate::measured::{Measured, MeasuredKeys, Scan, Source, open_seam};
use crate::spec::SceneSpec;

/// What a scene file is read for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Models of asperities, among others.
    Asperities,
    /// Models without asperities, such as boundary elements, on a scan that is declared periodic if
    /// the file or the caller says so.
    Scan { periodic: bool },
}

/// Codes of warnings about a scan that describe the sum of two surfaces, not one of them.
const OF_SUM: [Code; 6] = [
    Code::Anisotropic,
    Code::EstimatorsDisagree,
    Code::NoAsperities,
    Code::NoSecondEstimator,
    Code::Outliers,
    Code::RoughnessParameter,
];

/// A scan of a section, before it is read.
struct Named<'d> {
    document: &'d Document<'d>,
    section: &'static str,
    source: Source,
}

impl<'d> Named<'d> {
    /// What a section says of its scan, if it names one.
    fn new(
        document: &'d Document<'d>,
        section: &'static str,
        asked: Asked,
    ) -> Result<Option<Self>, SceneError> {
        let mut keys = MeasuredKeys::read(document, section)?;
        keys.periodic |= asked == Asked::Scan { periodic: true };
        if keys.smooth.zip(keys.filter).is_some_and(|(smooth, filter)| smooth >= filter) {
            let reason =
                "not below filter, so that no wavelength is left: a smaller value was required";
            return Err(SceneError::wrong(
                document.place(&joined(section, "smooth")),
                reason.into(),
            ));
        }
        let Some(path) = keys.file.clone() else { return Ok(None) };
        let given = document.value(section).and_then(Value::as_table);
        let is_own =
            |name: &str| Key::find("surface", name).is_some_and(|key| key.subject == Subject::Scan);
        let own = given.into_iter().flatten().filter(|(name, _)| is_own(name));
        let mut written: Table = own.map(|(name, value)| (name.clone(), value.clone())).collect();
        written.insert("file".into(), (&*document.whole_path(&path).to_string_lossy()).into());
        Ok(Some(Self { document, section, source: Source { path, keys, written } }))
    }

    /// The scan as its keys prepare it.
    fn read(&self) -> Result<Topography, SceneError> {
        let Source { path: named, keys, .. } = &self.source;
        let path = self.document.path(named);
        let read = match self.document.handed(&joined(self.section, "file"), named)? {
            Some(bytes) => read_bytes(&path.to_string_lossy(), bytes, &keys.options),
            None => read(&path, &keys.options),
        };
        let clean = read.and_then(|read| keys.clean(read)).map_err(|error| self.refused(error))?;
        match self.likely_unit(&clean) {
            Some(error) => Err(error),
            None => keys.prepare(clean).map_err(|error| self.refused(error)),
        }
    }

    /// The error of a cut-off that another unit makes one of this scan.
    fn likely_unit(&self, scan: &Topography) -> Option<SceneError> {
        let ([dx, dy], keys) = (scan.pixel_size(), &self.source.keys);
        let usual = [2.0 * dx.max(dy), scan.columns() as f64 * dx];
        let odd = |(key, cut_off): (&'static str, Option<f64>)| {
            self.document.likely_unit(self.section, outside(key, cut_off?, usual))
        };
        [("smooth", keys.smooth), ("filter", keys.filter)].into_iter().find_map(odd)
    }

    /// The statistics of a scan by the keys of this one.
    fn measure(&self, scan: &Topography) -> Result<Measured, SceneError> {
        let [dx, dy] = scan.pixel_size();
        let statistics = scan.statistics(self.source.keys.estimator);
        let statistics = statistics.map_err(|error| self.refused(error))?;
        Ok(Measured { statistics, pixel_size: dx.max(dy) })
    }

    /// Errors of an option are at that option, all others at the file.
    fn refused(&self, error: TopographyError) -> SceneError {
        let option = |field: &str| self.document.place(&joined(self.section, field));
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
            TopographyError::Undecided { option: name, .. } => option(name),
            _ => option("file"),
        };
        SceneError::refused(at, format!("{}: {error}", self.source.path.display()))
    }
}

/// Scans, and the sum of two that are aligned.
type ScansAndSum = (Vec<Arc<Scan>>, Option<Arc<Scan>>);

/// The scans that a scene names, one or two, and the sum of two that are aligned; beside one of
/// them the other surface may be given by numbers, and the heights of the asperities may be theirs.
pub(crate) fn scans(
    document: &Document<'_>,
    are_measured: bool,
    asked: Asked,
    beside_numbers: bool,
) -> Result<ScansAndSum, SceneError> {
    let sections = ["surface", COUNTERFACE].into_iter().filter(|section| document.has(section));
    let named = sections.map(|section| Named::new(document, section, asked));
    let named = named.filter_map(Result::transpose).collect::<Result<Vec<_>, _>>()?;
    let is_pair = named.len() > 1 || beside_numbers;
    let alignment = MeasuredKeys::read(document, "surface")?.alignment();
    if alignment.is_some() && named.len() < 2 {
        let needed = "two scans, file and counterface.file,";
        let found = format_args!("for one scan");
        return Err(SceneError::value(document.place("surface.aligned"), found, needed));
    }
    if is_pair && alignment.is_none() {
        let by_summits = |one: &&Named<'_>| one.source.keys.estimator == Estimator::Summits;
        if let Some(one) = named.iter().find(by_summits) {
            let needed = "estimator = \"moments\" for two surfaces: moments add, summits do not,";
            return Err(document.conflict(&joined(one.section, "estimator"), COUNTERFACE, needed));
        }
        if are_measured {
            let needed = "one file or aligned scans: the heights of two surfaces do not add,";
            return Err(document.conflict("surface.heights", COUNTERFACE, needed));
        }
    }
    let read = named.iter().map(Named::read).collect::<Result<Vec<_>, _>>()?;
    let pressed = match (alignment, &read[..], named.first()) {
        (Some(alignment), [one, two, ..], Some(first)) => {
            let both = one.facing(two, alignment).map_err(|reason| {
                SceneError::refused(document.place(COUNTERFACE), reason.to_string())
            })?;
            let measured = first.measure(&both)?;
            Some(Arc::new(Scan::new(both, Some(measured))))
        }
        _ => None,
    };
    let scan = |(one, topography): (Named<'_>, Topography)| -> Result<_, SceneError> {
        let own = || one.measure(&topography);
        let measured = if alignment.is_some() { None } else { Some(own()?) };
        Ok(Arc::new(Scan { source: Some(one.source), ..Scan::new(topography, measured) }))
    };
    Ok((named.into_iter().zip(read).map(scan).collect::<Result<_, _>>()?, pressed))
}

/// The scans of a scene, each with its section.
fn scans_of(spec: &SceneSpec) -> Vec<(&'static str, &Scan)> {
    spec.surfaces().filter_map(|(section, one)| Some((section, &**one.scan()?))).collect()
}

/// The key at which findings of all scans are.
fn place_of_all(spec: &SceneSpec) -> String {
    match scans_of(spec)[..] {
        [(only, _)] => joined(only, "file"),
        _ => COUNTERFACE.into(),
    }
}

/// An error of the sum of both surfaces, or of the only one.
pub(crate) fn refused(
    document: &Document<'_>,
    spec: &SceneSpec,
    reason: &TopographyError,
) -> SceneError {
    let single = spec.surface.scan().filter(|_| spec.counterface.is_none());
    let reason = match single.and_then(|scan| scan.source.as_ref()) {
        Some(only) => format!("{}: {reason}", only.path.display()),
        None => reason.to_string(),
    };
    SceneError::refused(document.place(&place_of_all(spec)), reason)
}

/// The findings of the scans of a scene with these statistics.
pub(crate) fn notes(
    document: &Document<'_>,
    spec: &SceneSpec,
    together: &Statistics,
) -> Vec<Finding> {
    let from = |at: &str| {
        let at = document.place(at).to_string();
        move |found: Finding| found.from_origin(at.clone())
    };
    let (mut notes, scans) = (vec![], scans_of(spec));
    for (section, scan) in scans.iter().filter(|_| spec.counterface.is_some()) {
        let own = scan.measured.iter().flat_map(|own| &own.statistics.warnings);
        let own = own.filter(|found| !OF_SUM.contains(&found.code)).cloned();
        notes.extend(own.map(from(&joined(section, "file"))));
    }
    notes.extend(together.warnings.iter().cloned().map(from(&place_of_all(spec))));
    for (section, scan) in &scans {
        let tilted = scan.source.iter().filter_map(|Source { keys, .. }| {
            keys.level.and_then(|level| level.tilts(keys.periodic))
        });
        notes.extend(tilted.map(from(&joined(section, "level"))));
    }
    let seam = spec.single_scan().and_then(|scan| open_seam(&scan.topography));
    notes.extend(seam.map(from("surface.periodic")));
    notes
}

/// The density of the summits' heights above the mean plane.
pub(crate) fn density(topography: &Topography) -> Result<Vec<(f64, f64)>, TopographyError> {
    let summits = topography.summits()?;
    let offset = summits.mean() - topography.mean();
    let HeightDensity { heights_m, density_per_m, .. } = summits.height_density()?;
    Ok(heights_m.into_iter().map(|z| z + offset).zip(density_per_m).collect())
}
