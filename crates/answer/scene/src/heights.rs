//! `heights`: the distribution of the asperity heights.

use asperity::{ContactError, HeightDistribution, TabulatedHeights, WeibullHeights};
use serde::Deserialize;

use crate::document::Document;
use crate::error::{Place, SceneError};
use crate::spec::HeightsSpec;

/// The largest number of points in a table of heights; each costs time in every evaluation.
const MOST_POINTS: usize = 10_000;
/// `heights`.
#[derive(Debug, Default, Deserialize)]
#[serde(
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"gaussian\" or \"exponential\" or \"measured\" or { skewness = -0.5 } or { height_m = [-1e-6, 0, 2e-6], density_per_m = [0, 6e5, 0] }"
)]
enum HeightsKey {
    #[default]
    Gaussian,
    Exponential,
    Measured,
    #[serde(untagged)]
    Skewed {
        skewness: f64,
    },
    #[serde(untagged)]
    Points {
        height_m: Vec<f64>,
        density_per_m: Vec<f64>,
    },
}

/// The distribution that is written; of measured heights without its table.
pub(crate) fn heights(document: &Document<'_>) -> Result<HeightsSpec, SceneError> {
    Ok(match document.get("surface.heights")?.unwrap_or_default() {
        HeightsKey::Gaussian => HeightsSpec::default(),
        HeightsKey::Exponential => HeightDistribution::Exponential.into(),
        HeightsKey::Measured => HeightsSpec { is_measured: true, ..HeightsSpec::default() },
        HeightsKey::Skewed { skewness } => {
            let heights = WeibullHeights::new(skewness);
            let heights = heights.map_err(document.refused("surface.heights"))?;
            HeightDistribution::Weibull(heights).into()
        }
        HeightsKey::Points { height_m, density_per_m } => {
            HeightsSpec::of_table(inline_heights(document, &height_m, &density_per_m)?)
        }
    })
}

/// The table of `heights = { height_m = [...], density_per_m = [...] }`.
fn inline_heights(
    document: &Document<'_>,
    heights: &[f64],
    densities: &[f64],
) -> Result<TabulatedHeights, SceneError> {
    let at = "surface.heights";
    if heights.len() != densities.len() || heights.len() > MOST_POINTS {
        let found =
            format!("a table of {} heights and {} densities", heights.len(), densities.len());
        let needed = format!("one density for each height, at most {MOST_POINTS},");
        let at = document.place(at);
        return Err(SceneError::of_names(at, &found, None, &needed));
    }
    let points: Vec<(f64, f64)> = heights.iter().copied().zip(densities.iter().copied()).collect();
    TabulatedHeights::new("table", &points).map_err(|source| match source {
        ContactError::InTable { row, field, value, required } => {
            let place = document.place(&format!("{at}.{field}"));
            let place = Place { field: format!("{}[{row}]", place.field), ..*place };
            SceneError::value(place, value, required)
        }
        other => document.refused(at)(other),
    })
}

/// Refuses a table whose standard deviation is far from that of the scene.
pub(crate) fn compare_std(
    document: &Document<'_>,
    table: &TabulatedHeights,
    std: f64,
) -> Result<(), SceneError> {
    let own = table.standard_deviation();
    let (at, ratio) = (document.place("surface.heights"), own / std);
    // At such a ratio one of the two is not in metres.
    if !(0.1..=10.0).contains(&ratio) {
        let found = format_args!(
            "a table with a standard deviation of {own:e} m, {ratio:.3e} times the asperity_height_std of {std:e} m"
        );
        return Err(SceneError::value(at, found, "heights in metres (a ratio within 10)"));
    }
    Ok(())
}
