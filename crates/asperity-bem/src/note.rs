//! Notes: what says that an answer is not resolved.

use std::f64::consts::TAU;
use std::fmt;
use std::mem::discriminant;

use crate::half_space::HalfSpace;
use crate::seam::LARGEST_STEP;
use crate::{Boundary, Given, HeightMap};

/// Least shortest wavelength \[pixels\].
const LEAST_WAVELENGTH: f64 = 8.0;
/// Least number of pixels in contact.
const LEAST_PIXELS: usize = 100;
/// Least number of patches: below it one realisation differs from the next by ten per cent and
/// more.
const LEAST_PATCHES: usize = 30;
/// Share of the mean square slope that waves below the shortest wavelength may hold.
const SHORT_SHARE: f64 = 0.01;
/// Classes of the frequency, from 0 to the diagonal of a pixel.
const CLASSES: usize = 1024;

/// Why an answer should be read with care: it is exact for the pixels, not for the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// The surface is rough down to waves of a few pixels: area and pressures change with the
    /// grid. Smooth it, take a finer grid, or solve [`HeightMap::half_grid`] beside it.
    ShortWaves {
        /// Wavelength below which one hundredth of the mean square slope lies \[pixels\].
        pixels: f64,
    },
    /// The map is repeated and its edges do not meet: the steps along the seam press as well, not
    /// the surface alone. Solve [`HeightMap::periodic_part`], or with
    /// [`Boundary::Free`].
    Seam {
        /// [Step over the seam](HeightMap::seam_step), in steps between neighbours.
        step: f64,
    },
    /// Few pixels carry the load: the area is a staircase.
    FewPixels {
        /// How many.
        found: usize,
    },
    /// Few patches carry the load: another piece of the same surface will differ. Average several.
    FewPatches {
        /// How many.
        found: usize,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ShortWaves { pixels } => write!(
                f,
                "the shortest waves are {pixels:.1} pixels long: at least {LEAST_WAVELENGTH} are needed for an answer that does not depend on the grid"
            ),
            Self::Seam { step } => write!(
                f,
                "the edges do not meet: the step over the seam is {step:.1} times that between neighbours, less than {LARGEST_STEP} is needed for a map that is repeated"
            ),
            Self::FewPixels { found } => write!(
                f,
                "{found} {} in contact: at least {LEAST_PIXELS} are needed for an area",
                if *found == 1 { "pixel is" } else { "pixels are" }
            ),
            Self::FewPatches { found } => write!(
                f,
                "{found} {} in contact: at least {LEAST_PATCHES} are needed for one map to stand for its surface",
                if *found == 1 { "patch is" } else { "patches are" }
            ),
        }
    }
}

impl Note {
    /// What the notes of many contacts come to: each kind once, as it was found last (that is at the
    /// lightest load, in the order in which lists are solved), and of how many.
    #[must_use]
    pub fn summary(notes: &[(Given, Self)]) -> Vec<String> {
        let mut kinds: Vec<(usize, Given, Self)> = vec![];
        for &(given, note) in notes {
            let kind = discriminant(&note);
            match kinds.iter_mut().find(|(.., known)| discriminant(known) == kind) {
                Some(known) => *known = (known.0 + 1, given, note),
                None => kinds.push((1, given, note)),
            }
        }
        let at = |given: Given| match given {
            Given::MeanPressure(pressure) => format!("at {pressure:e} Pa"),
            Given::Load(load) => format!("at {load:e} N"),
            Given::MeanGap(gap) => format!("at a mean gap of {gap:e} m"),
        };
        let told = |(count, given, note): (usize, Given, Self)| match (note, count) {
            (Self::ShortWaves { .. } | Self::Seam { .. }, _) => note.to_string(),
            (_, 1) => format!("{}: {note}", at(given)),
            _ => format!("{} ({count} places are like that): {note}", at(given)),
        };
        kinds.into_iter().map(told).collect()
    }

    pub(crate) fn of_contact(pixels: usize, patches: usize) -> impl Iterator<Item = Self> {
        let few_pixels = (pixels < LEAST_PIXELS).then_some(Self::FewPixels { found: pixels });
        let few_patches = (patches < LEAST_PATCHES).then_some(Self::FewPatches { found: patches });
        few_pixels.into_iter().chain(few_patches)
    }

    pub(crate) fn of_map(map: &HeightMap, boundary: Boundary, space: &mut HalfSpace) -> Vec<Self> {
        let meet = boundary == Boundary::Periodic && map.edges_meet();
        let pixels = shortest_wavelength(map, !meet, space).filter(|p| *p < LEAST_WAVELENGTH);
        let short = pixels.map(|pixels| Self::ShortWaves { pixels });
        let step = map.seam_step();
        let seam = (boundary == Boundary::Periodic && !meet).then_some(Self::Seam { step });
        seam.into_iter().chain(short).collect()
    }
}

/// Wavelength \[pixels\] below which [`SHORT_SHARE`] of the mean square slope lies; none for a
/// flat map. Edges that do not meet are faded out (Hann), or their steps would
/// pass for short waves.
fn shortest_wavelength(map: &HeightMap, fades: bool, space: &mut HalfSpace) -> Option<f64> {
    let [rows, columns] = map.shape();
    let mut heights = map.heights().to_vec();
    if fades {
        let fade = |i: usize, n: usize| 0.5 - 0.5 * (TAU * (i as f64 + 0.5) / n as f64).cos();
        for (i, row) in heights.chunks_mut(columns).enumerate() {
            for (j, height) in row.iter_mut().enumerate() {
                *height *= fade(i, rows) * fade(j, columns);
            }
        }
    }
    let [dy, dx] = map.pixel();
    let per_frequency = CLASSES as f64 / 0.5_f64.hypot(0.5);
    let columns = space.spectrum(
        &heights,
        || vec![0.0; CLASSES],
        |classes, [along_rows, along_columns], square| {
            let class = (along_rows.hypot(along_columns) * per_frequency) as usize;
            let slope = (along_rows / dy).powi(2) + (along_columns / dx).powi(2);
            classes[class.min(CLASSES - 1)] += slope * square;
        },
    );
    let slopes: Vec<f64> =
        (0..CLASSES).map(|class| columns.iter().map(|column| column[class]).sum()).collect();
    let mut left = SHORT_SHARE * slopes.iter().sum::<f64>();
    let class = slopes.iter().rposition(|slope| {
        left -= slope;
        left < 0.0
    })?;
    // The middle of the class.
    Some(per_frequency / (class as f64 + 0.5))
}
