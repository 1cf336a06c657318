//! Findings of the resolution: results are exact for the pixels, not for the surface.

use std::f64::consts::TAU;

use asperity_core::{At, Code, Finding, Severity, short};

use crate::half_space::HalfSpace;
use crate::seam::LARGEST_STEP;
use crate::{Boundary, HeightMap};

/// Least shortest wavelength \[pixels\].
const LEAST_WAVELENGTH: f64 = 8.0;
/// Cut-off of a Gaussian filter that leaves such waves, of any spectrum \[pixels\].
const SMOOTHED: f64 = 16.0;
/// Least number of pixels in contact.
const LEAST_PIXELS: usize = 100;
/// Least number of patches: with fewer, realisations differ by ten per cent and more.
const LEAST_PATCHES: usize = 30;
/// Share of the pixels in contact above which patches merge, so that a larger load leaves fewer.
const MERGED: f64 = 0.25;
/// Share of the mean square slope that waves below the shortest wavelength may hold.
const SHORT_SHARE: f64 = 0.01;
/// Classes of the frequency, from 0 to the diagonal of a pixel.
const CLASSES: usize = 1024;

/// Findings of a contact at this place: few of the pixels touch, whose area is coarse, or they make
/// few patches, so that one map does not represent its surface. A single patch on a free half-space
/// belongs to a single body, such as a ball.
pub(crate) fn of_contact(
    at: At,
    [touching, pixels]: [usize; 2],
    patches: usize,
    boundary: Boundary,
) -> impl Iterator<Item = Finding> {
    let is_body = patches == 1 && boundary == Boundary::Free;
    let few = |code, field, found: usize, (one, many): (&str, &str), least: usize, advice| {
        let names = if found == 1 { one } else { many };
        let few = Finding::warning(code, field, found as f64)
            .usual([least as f64, f64::INFINITY])
            .at(at)
            .fact(format!("{found} {names} in contact"))
            .advice(format!("at least {least} are needed {advice}"));
        (found < least).then_some(few)
    };
    let names = ("pixel is", "pixels are");
    let advice = "to resolve the area; refine the grid or raise the load";
    let few_pixels = few(Code::FewPixels, "pixels", touching, names, LEAST_PIXELS, advice);
    let names = ("patch is", "patches are");
    let advice = match touching as f64 > MERGED * pixels as f64 {
        _ if is_body => "of a rough surface; a single body has one",
        true => {
            "for one map to represent its surface, and patches have merged; average several maps or use a larger one"
        }
        false => "for one map to represent its surface; average several maps or raise the load",
    };
    let few_patches = few(Code::FewPatches, "patches", patches, names, LEAST_PATCHES, advice);
    let few_patches = few_patches.map(|found| match is_body {
        true => found.severity(Severity::Note),
        false => found,
    });
    few_pixels.into_iter().chain(few_patches)
}

/// Findings of a map: waves of a few pixels, and edges that do not match where no boundary is
/// declared.
pub(crate) fn of_map(
    map: &HeightMap,
    boundary: Option<Boundary>,
    space: &mut HalfSpace,
) -> Vec<Finding> {
    let open = boundary.is_none() && !map.edges_meet();
    let fades = open || boundary == Some(Boundary::Free);
    let pixels = shortest_wavelength(map, fades, space).filter(|p| *p < LEAST_WAVELENGTH);
    let short = pixels.map(|pixels| {
        Finding::warning(Code::ShortWaves, "shortest_wavelength", pixels)
            .usual([LEAST_WAVELENGTH, f64::INFINITY])
            .fact(format!("the shortest waves are {} pixels long", below(pixels, LEAST_WAVELENGTH)))
            .advice(format!(
                "at least {LEAST_WAVELENGTH} are needed, or results depend on the grid; set smooth, the shortest wave kept, to {} m ({SMOOTHED} pixels) or more, or refine the grid",
                short(SMOOTHED * map.pixel()[0].max(map.pixel()[1]))
            ))
    });
    let step = map.seam_step();
    let seam = Finding::warning(Code::OpenSeam, "seam_step", step)
        .usual([0.0, LARGEST_STEP])
        .fact(format!(
            "the edges of the map do not match (step {step:.1} times that between neighbours)"
        ))
        .advice(
            "a map that is not periodic needs its periodic component or a free boundary; declare boundary Periodic if the step is real",
        );
    let seam = open.then_some(seam);
    seam.into_iter().chain(short).collect()
}

/// A number below a limit with as many decimals, at least one, as show that.
fn below(number: f64, limit: f64) -> String {
    let written = (1..=15).map(|decimals| format!("{number:.decimals$}"));
    let shows = |text: &String| text.parse().is_ok_and(|written: f64| written < limit);
    written.clone().find(shows).unwrap_or_else(|| number.to_string())
}

/// Wavelength \[pixels\] below which [`SHORT_SHARE`] of the mean square slope lies; none for a
/// flat map. Edges that are not repeated are faded out (Hann), or their steps would
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_below_the_limit_never_looks_like_it() {
        let texts = [7.4, 7.96, 7.98, 7.9996].map(|pixels| below(pixels, LEAST_WAVELENGTH));
        assert_eq!(texts, ["7.4", "7.96", "7.98", "7.9996"].map(|text| text.to_string()));
    }
}
