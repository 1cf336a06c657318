//! The scans that a scene names.

use std::path::PathBuf;
use std::sync::Arc;

use asperity::{Code, Finding};
use asperity_topography::{
    Estimator, HeightDensity, Statistics, Topography, TopographyError, read, read_bytes,
};
use toml::{Table, Value};

use crate::document::Document;
use crate::error::SceneError;
use crate::height_map::open_seam;
use crate::keys::{COUNTERFACE, Key, Subject};
use crate::measured::{Measured, Scan};
use crate::measured_keys::MeasuredKeys;

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

/// What was written of a scan.
struct Source {
    /// The section of its keys.
    section: &'static str,
    /// The key of its path.
    at: String,
    path: PathBuf,
    keys: MeasuredKeys,
}

impl Source {
    /// The scan as its keys prepare it.
    fn read(&self, document: &Document<'_>) -> Result<Topography, SceneError> {
        let (path, options) = (document.path(&self.path), &self.keys.options);
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
        Ok(Measured { statistics, pixel_size: dx.max(dy) })
    }

    /// Its file for a scene elsewhere, and its keys.
    fn written(&self, document: &Document<'_>) -> (PathBuf, Table) {
        let given = document.value(self.section).and_then(Value::as_table);
        let is_own = |name: &str| {
            let key = Key::find("surface", name);
            let is_scan = key.is_some_and(|key| key.subject == Subject::Scan);
            is_scan && !["file", "aligned"].contains(&name)
        };
        let own = given.into_iter().flatten().filter(|(name, _)| is_own(name));
        let keys = own.map(|(name, value)| (name.clone(), value.clone())).collect();
        (document.whole_path(&self.path), keys)
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
            TopographyError::Undecided { option: name, .. } => option(name),
            _ => document.place(&self.at),
        };
        SceneError::Refused { at, reason: format!("{}: {error}", self.path.display()) }
    }
}

/// What was written of the scans of a scene: one or two.
fn sources(document: &Document<'_>, asked: Asked) -> Result<Vec<Source>, SceneError> {
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
        if let Some(path) = keys.file.clone() {
            scans.push(Source { section, at: format!("{section}.file"), path, keys });
        }
    }
    Ok(scans)
}

/// The scans of a scene, with what was written of each, and the sum of two that are aligned.
pub(crate) struct Scans {
    each: Vec<(Source, Arc<Scan>)>,
    pub(crate) sum: Option<Arc<Scan>>,
    /// Whether there is another rough surface beside the first scan.
    is_pair: bool,
}

impl Scans {
    /// Reads the scans that a scene names; beside one of them the other surface may be given by
    /// numbers, and the heights of the asperities may be theirs.
    pub(crate) fn read(
        document: &Document<'_>,
        are_measured: bool,
        asked: Asked,
        beside_numbers: bool,
    ) -> Result<Self, SceneError> {
        let sources = sources(document, asked)?;
        let [first, rest @ ..] = &sources[..] else {
            return Err(document.missing("surface.file", "a measured file"));
        };
        let second = rest.first();
        let alignment = MeasuredKeys::read(document, "surface")?.alignment();
        let is_pair = second.is_some() || beside_numbers;
        if alignment.is_some() && second.is_none() {
            let needed = "two scans, file and counterface.file,";
            let found = format_args!("for one scan");
            return Err(SceneError::value(document.place("surface.aligned"), found, needed));
        }
        if is_pair && alignment.is_none() {
            let by_summits = |one: &&Source| one.keys.estimator == Estimator::Summits;
            if let Some(one) = sources.iter().find(by_summits) {
                let needed =
                    "estimator = \"moments\" for two surfaces: moments add, summits do not,";
                return Err(document.conflict(
                    &format!("{}.estimator", one.section),
                    COUNTERFACE,
                    needed,
                ));
            }
            if are_measured {
                let needed = "one file or aligned scans: the heights of two surfaces do not add,";
                return Err(document.conflict("surface.heights", COUNTERFACE, needed));
            }
        }
        let read = |one: &Source| -> Result<Scan, SceneError> {
            let topography = one.read(document)?;
            let measured = match alignment {
                Some(_) => None,
                None => Some(one.measure(document, &topography)?),
            };
            let written = Some(one.written(document));
            Ok(Scan { source: written, ..Scan::new(topography, measured) })
        };
        let each = sources.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let sum = match (alignment, &each[..]) {
            (Some(alignment), [one, two, ..]) => {
                let both = one.topography.facing(&two.topography, alignment);
                let both = both.map_err(|reason| SceneError::Refused {
                    at: document.place(COUNTERFACE),
                    reason: reason.to_string(),
                })?;
                let measured = first.measure(document, &both)?;
                Some(Arc::new(Scan::new(both, Some(measured))))
            }
            _ => None,
        };
        let each = each.into_iter().map(Arc::new);
        Ok(Self { each: sources.into_iter().zip(each).collect(), sum, is_pair })
    }

    /// The scans of the sections.
    pub(crate) fn list(&self) -> impl Iterator<Item = &Arc<Scan>> {
        self.each.iter().map(|(_, scan)| scan)
    }

    /// The key at which findings of all scans are.
    fn at(&self) -> &str {
        match &self.each[..] {
            [(only, _)] => &only.at,
            _ => COUNTERFACE,
        }
    }

    /// An error of the sum of both surfaces, or of the only one.
    pub(crate) fn refused(&self, document: &Document<'_>, reason: &TopographyError) -> SceneError {
        let reason = match &self.each[..] {
            [(only, _)] if !self.is_pair => format!("{}: {reason}", only.path.display()),
            _ => reason.to_string(),
        };
        SceneError::Refused { at: document.place(self.at()), reason }
    }

    /// The findings of the scans of a scene with these statistics.
    pub(crate) fn notes(&self, document: &Document<'_>, together: &Statistics) -> Vec<Finding> {
        let from = |at: &str| {
            let at = document.place(at).to_string();
            move |found: Finding| found.from_origin(at.clone())
        };
        let mut notes = vec![];
        for (source, scan) in self.each.iter().filter(|_| self.is_pair) {
            let own = scan.measured.iter().flat_map(|own| &own.statistics.warnings);
            let own = own.filter(|found| !OF_SUM.contains(&found.code)).cloned();
            notes.extend(own.map(from(&source.at)));
        }
        notes.extend(together.warnings.iter().cloned().map(from(self.at())));
        for (Source { section, keys, .. }, _) in &self.each {
            let tilted = keys.level.and_then(|level| level.tilts(keys.periodic));
            notes.extend(tilted.map(from(&format!("{section}.level"))));
        }
        let single = self.each.first().filter(|_| !self.is_pair).map(|(_, scan)| scan);
        let seam = self.sum.as_ref().or(single).and_then(|scan| open_seam(&scan.topography));
        let section = self.each.first().map_or("surface", |(source, _)| source.section);
        notes.extend(seam.map(from(&format!("{section}.periodic"))));
        notes
    }
}

/// The density of the summits' heights above the mean plane.
pub(crate) fn density(topography: &Topography) -> Result<Vec<(f64, f64)>, TopographyError> {
    let summits = topography.summits()?;
    let offset = summits.mean() - topography.mean();
    let HeightDensity { heights_m, density_per_m, .. } = summits.height_density()?;
    Ok(heights_m.into_iter().map(|z| z + offset).zip(density_per_m).collect())
}
