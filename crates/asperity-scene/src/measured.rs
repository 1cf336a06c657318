//! `[surface]` from measured files.

use std::path::PathBuf;

use asperity_topography::{
    Estimator, LengthUnit, Level, ReadOptions, Statistics, Topography, TopographyError, read,
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
    let (key, measured) = match (section.entry("file"), section.entry("files")) {
        (Some(entry), _) => ("file", one(section, &entry, &treatment)?),
        (None, Some(entry)) => ("files", two(section, &entry, &treatment)?),
        (None, None) => return Err(section.missing("file", "the path of a measured surface")),
    };
    let surface = measured.statistics.surface();
    surface.check().map_err(section.refused())?;
    let at = section.place(key);
    let warnings = measured.statistics.warnings.iter();
    let notes = warnings.map(|warning| format!("{at}: {warning}")).collect();
    Ok(Described { surface, mean_plane_offset: measured.mean_plane_offset, notes })
}

/// What becomes of one surface, or of the gap of two.
struct Measured {
    statistics: Statistics,
    /// Mean of the asperity heights above the mean plane \[m\].
    mean_plane_offset: f64,
}

impl Measured {
    /// The asperities of a Gaussian surface lie where its theory says.
    fn gaussian(statistics: Statistics) -> Self {
        let mean_plane_offset = statistics.surface().mean_plane_offset();
        Self { statistics, mean_plane_offset }
    }
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
) -> Result<Measured, SceneError> {
    let path = path(section, entry)?;
    let topography = read(&path, &treatment.options);
    topography.and_then(|topography| measure(topography, treatment)).map_err(|error| {
        let reason = match error {
            // Reading names the file, what follows does not.
            TopographyError::File { .. } => error.to_string(),
            other => format!("{}: {other}", path.display()),
        };
        SceneError::Measured { at: entry.at.clone(), reason }
    })
}

fn measure(topography: Topography, treatment: &Treatment) -> Result<Measured, TopographyError> {
    let mut topography = topography.level(treatment.level)?;
    if let Some(cutoff) = treatment.filter {
        topography = topography.filter(cutoff)?;
    }
    let statistics = topography.statistics(treatment.estimator)?;
    if treatment.estimator == Estimator::Moments {
        return Ok(Measured::gaussian(statistics));
    }
    // Summits that were found need no theory of where they lie.
    let summits = mean(&topography.summits()?.heights);
    Ok(Measured { statistics, mean_plane_offset: summits - mean(topography.heights()) })
}

/// Mean of the heights that are there.
fn mean(heights: &[f64]) -> f64 {
    let there = || heights.iter().filter(|height| !height.is_nan());
    there().sum::<f64>() / there().count() as f64
}

fn two(
    section: &Section<'_>,
    entry: &Entry<'_>,
    treatment: &Treatment,
) -> Result<Measured, SceneError> {
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
    Statistics::combined(&first.statistics, &second.statistics)
        .map(Measured::gaussian)
        .map_err(|error| SceneError::Measured { at: entry.at.clone(), reason: error.to_string() })
}

fn path(section: &Section<'_>, entry: &Entry<'_>) -> Result<PathBuf, SceneError> {
    let text = entry.text().ok_or_else(|| entry.wrong("the path of a measured surface"))?;
    Ok(section.document().path(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Waves in many directions: nearly a Gaussian surface.
    fn topography(count: usize) -> Topography {
        let waves: Vec<[f64; 3]> = (0..60)
            .map(|k| {
                let (turn, size) = (2.399_963 * f64::from(k), 0.1 + 0.25 * f64::from(k % 7) / 7.0);
                [size * turn.cos(), size * turn.sin(), 5.1 * f64::from(k * k)]
            })
            .collect();
        let height = |k: usize| {
            let (x, y) = ((k % count) as f64, (k / count) as f64);
            let wave = |[a, b, c]: &[f64; 3]| (a * x + b * y + c).cos();
            1e-7 * waves.iter().map(wave).sum::<f64>() + 3e-7 * (0.01 * x - 0.02 * y + 5.0)
        };
        Topography::new((0..count * count).map(height).collect(), count, [1e-6; 2]).unwrap()
    }

    fn measured(level: Level, filter: Option<f64>, estimator: Estimator) -> Measured {
        let options = ReadOptions::default();
        measure(topography(192), &Treatment { options, level, filter, estimator }).unwrap()
    }

    #[test]
    fn every_choice_changes_the_surface() {
        let std = |level, filter, estimator| {
            measured(level, filter, estimator).statistics.surface().asperity_height_std
        };
        let plain = std(Level::Plane, None, Estimator::Moments);
        // 60 waves of 1e-7 have a variance of 30e-14, (0.548e-6)²; asperities are less spread.
        assert!((0.35e-6..0.54e-6).contains(&plain), "{plain}");
        assert!(std(Level::None, None, Estimator::Moments) > 1.1 * plain);
        assert!(std(Level::Plane, Some(30e-6), Estimator::Moments) < 0.95 * plain);
        let summits = std(Level::Plane, None, Estimator::Summits);
        assert!((summits / plain - 1.0).abs() > 1e-3 && (summits / plain - 1.0).abs() < 0.3);
    }

    #[test]
    fn summits_lie_about_as_far_above_the_mean_plane_as_theory_says() {
        for level in [Level::Plane, Level::Quadratic] {
            let [theory, found] = [Estimator::Moments, Estimator::Summits]
                .map(|estimator| measured(level, None, estimator).mean_plane_offset);
            assert!(theory > 0.3e-6 && (found / theory - 1.0).abs() < 0.3, "{theory} {found}");
        }
    }
}
