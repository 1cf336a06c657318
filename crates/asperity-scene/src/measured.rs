//! `[surface]` from measured files.

use std::path::PathBuf;

use asperity_topography::{
    Estimator, LengthUnit, Level, ReadOptions, Statistics, TopographyError, read,
};

use crate::SceneError;
use crate::document::{Entry, Section};
use crate::surface::Described;

const UNITS: [(&str, LengthUnit); 7] = [
    ("m", LengthUnit::Metre),
    ("cm", LengthUnit::Centimetre),
    ("mm", LengthUnit::Millimetre),
    ("um", LengthUnit::Micrometre),
    ("nm", LengthUnit::Nanometre),
    ("angstrom", LengthUnit::Angstrom),
    ("pm", LengthUnit::Picometre),
];
const ESTIMATORS: [(&str, Estimator); 2] =
    [("moments", Estimator::Moments), ("summits", Estimator::Summits)];
const LEVELS: [(&str, Level); 3] =
    [("plane", Level::Plane), ("quadratic", Level::Quadratic), ("none", Level::None)];

/// How a file is read and what is done to its heights.
struct Treatment {
    options: ReadOptions,
    level: Level,
    /// Cut-off wavelength \[m\].
    filter: Option<f64>,
    estimator: Estimator,
}

/// The surface of one measured file, or of two pressed together.
pub(crate) fn surface(section: &Section<'_>) -> Result<Described, SceneError> {
    if section.has("file") && section.has("files") {
        let needed = "file = \"a.x3p\" or files = [\"a.x3p\", \"b.x3p\"]";
        return Err(section.conflict("file", "files", needed));
    }
    let treatment = treatment(section)?;
    let (key, statistics) = match (section.entry("file"), section.entry("files")) {
        (Some(entry), _) => ("file", one(section, &entry, &treatment)?),
        (None, Some(entry)) => ("files", two(section, &entry, &treatment)?),
        (None, None) => return Err(section.missing("file", "the path of a measured surface")),
    };
    let surface = statistics.surface();
    surface.check().map_err(section.refused())?;
    let at = section.place(key);
    let notes = statistics.warnings.iter().map(|warning| format!("{at}: {warning}")).collect();
    Ok(Described { surface, notes })
}

fn treatment(section: &Section<'_>) -> Result<Treatment, SceneError> {
    let named = |key| section.entry(key);
    let mut options = ReadOptions {
        unit: named("unit").map(|entry| entry.one_of(&UNITS)).transpose()?,
        pixel_size: named("pixel_size").map(|entry| pixel_size(&entry)).transpose()?,
        ..ReadOptions::default()
    };
    if let Some(entry) = named("max_missing") {
        let share = entry.number()?;
        if !(0.0..=1.0).contains(&share) {
            return Err(entry.wrong("a share from 0 to 1"));
        }
        options.max_missing = share;
    }
    let filter = section.number("filter")?;
    if let Some(cutoff) = filter {
        asperity::positive("filter", cutoff).map_err(section.refused())?;
    }
    let level = named("level").map(|entry| entry.one_of(&LEVELS)).transpose()?;
    let estimator = named("estimator").map(|entry| entry.one_of(&ESTIMATORS)).transpose()?;
    let (level, estimator) = (level.unwrap_or_default(), estimator.unwrap_or_default());
    Ok(Treatment { options, level, filter, estimator })
}

/// One number for square pixels, or two: along a row and along a column.
fn pixel_size(entry: &Entry<'_>) -> Result<[f64; 2], SceneError> {
    let needed = "a length in the unit of the heights, or a list of two, along a row and a column,";
    let sizes = match entry.items() {
        None => [entry.number().map_err(|_| entry.wrong(needed))?; 2],
        Some(items) => match &items[..] {
            [x, y] => [x.number()?, y.number()?],
            _ => return Err(entry.wrong(needed)),
        },
    };
    if sizes.iter().all(|size| *size > 0.0 && size.is_finite()) {
        return Ok(sizes);
    }
    Err(entry.wrong("a finite length above 0"))
}

fn one(
    section: &Section<'_>,
    entry: &Entry<'_>,
    treatment: &Treatment,
) -> Result<Statistics, SceneError> {
    let path = path(section, entry)?;
    let refused = |error: TopographyError| {
        let reason = match error {
            // Reading names the file, what follows does not.
            TopographyError::File { .. } => error.to_string(),
            other => format!("{}: {other}", path.display()),
        };
        SceneError::Measured { at: entry.at.clone(), reason }
    };
    let topography = read(&path, &treatment.options).map_err(refused)?;
    let mut topography = topography.level(treatment.level).map_err(refused)?;
    if let Some(cutoff) = treatment.filter {
        topography = topography.filter(cutoff).map_err(refused)?;
    }
    topography.statistics(treatment.estimator).map_err(refused)
}

fn two(
    section: &Section<'_>,
    entry: &Entry<'_>,
    treatment: &Treatment,
) -> Result<Statistics, SceneError> {
    let items = entry.items().unwrap_or_default();
    let [first, second] = &items[..] else {
        return Err(entry.wrong("a list of two paths, of the two surfaces in contact,"));
    };
    if treatment.estimator == Estimator::Summits {
        let needed =
            "estimator = \"moments\" for two surfaces: their moments add, their summits do not,";
        return Err(section.conflict("estimator", "files", needed));
    }
    let (first, second) = (one(section, first, treatment)?, one(section, second, treatment)?);
    Statistics::combined(&first, &second)
        .map_err(|error| SceneError::Measured { at: entry.at.clone(), reason: error.to_string() })
}

fn path(section: &Section<'_>, entry: &Entry<'_>) -> Result<PathBuf, SceneError> {
    let text = entry.text().ok_or_else(|| entry.wrong("the path of a measured surface"))?;
    Ok(section.document().path(text))
}
