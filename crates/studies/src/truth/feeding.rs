//! Skewed surfaces and those with a lay, described in three ways to models of isotropic Gaussian
//! surfaces.

use anyhow::{Context, Result};
use asperity::{
    Compared, Evidence, EvidenceCase, HeightDistribution, Model, ProfileMoments, Quantity, Scene,
    Surface, TabulatedHeights, Tolerance,
};
use asperity_topography::Topography;

use super::family::{FAMILIES, Family, pressure, scene};
use super::rows::compiled;
use crate::truth::ranges::{ends, shape_name};
use xtask::figures::compared::{NOTHING, equal};
use xtask::table::{markdown_head, markdown_row};

/// The models that are compared: one law without and two with yielding, and the whole surface.
const SHOWN: [&str; 6] = ["gw", "ke", "jg", "jg-random", "persson-fudge", "persson-plastic"];
/// Factor of the pixels of maps whose moments are differences: 16 per shortest wave, which leaves
/// an error of 2 % in m4.
const FINER: usize = 2;

/// What a user takes from the scan: moments averaged over all directions with Gaussian heights,
/// slopes of profiles across the lay, or the average with the heights of the summits.
const WAYS: [&str; 3] = ["mean of all directions", "across the lay", "mean, measured heights"];

/// The scenes that a user makes, in the order of [`WAYS`]; their hardness is the family's.
/// Without a lay all directions are alike.
fn scenes(family: &Family, index: f64) -> Result<[Option<Scene>; 3]> {
    let surface = family.surface(family.pixels)?;
    let mean = scene(&surface, index)?;
    let scan = |pixels: usize| -> Result<Topography> {
        let map = surface.seed(1).heights(pixels)?;
        let scan = Topography::new(map.heights().to_vec(), map.shape()[1], map.pixel())?;
        Ok(scan.with_periodic(true))
    };
    let mut across_lay = (family.slope_ratio > 1.0).then(|| mean.clone());
    if let Some(scene) = &mut across_lay {
        // The lay is along the rows.
        let found = scan(FINER * family.pixels)?.moments()?;
        let [m2, m4] = found.along_columns.context("a map of several rows")?;
        let m0 = found.profile.m0;
        scene.surface = Surface::from_moments(&ProfileMoments { m0, m2, m4 })?;
    }
    let summits = scan(family.pixels)?.summits()?;
    let (offset, density) = (summits.mean(), summits.height_density()?);
    let heights = density.heights_m.into_iter().map(|z| z + offset);
    let points: Vec<(f64, f64)> = heights.zip(density.density_per_m).collect();
    let mut measured = mean.clone();
    measured.heights = HeightDistribution::other(TabulatedHeights::new("measured", &points)?);
    Ok([Some(mean), across_lay, Some(measured)])
}

/// Deviations of the area of a model on a scene from the cases'.
fn deviations(model: &Model, scene: &Scene, cases: &[&EvidenceCase]) -> String {
    let known = [Quantity::AreaFraction];
    // Random asperities are Gaussian.
    let contact = compiled(model, scene, &known, 1, Tolerance::default());
    let off = |case: &&EvidenceCase| {
        let found = contact.as_ref()?.evaluate(known[0], pressure(case.load)).ok()?.value();
        Some(100.0 * (found / case.bem.value(Compared::Area)? - 1.0))
    };
    ends(cases.iter().filter_map(off))
}

/// A table of the ways for each material: rows are models and ways, columns families.
///
/// # Errors
/// A family whose scene cannot be made.
pub fn table(evidence: &Evidence) -> Result<String> {
    let mut out = String::new();
    for (index, material) in [(0.0, "elastic"), (2.0, "psi 2")] {
        let (mut heads, mut columns) = (vec!["area, % off".to_owned()], vec![]);
        for family in FAMILIES.iter().filter(|f| !equal(f.skewness, 0.0) || f.slope_ratio > 1.0) {
            let mut cases = family.cases(evidence)?;
            cases.retain(|case| equal(case.plasticity_index, index));
            if !cases.is_empty() {
                heads.push(shape_name(family.skewness, family.slope_ratio));
                columns.push((cases, scenes(family, index)?));
            }
        }
        out += &format!("{material}, by what models are given:\n\n");
        out += &markdown_head(&heads, columns.len());
        for id in SHOWN {
            let model: Model = id.parse()?;
            for (w, way) in WAYS.iter().enumerate() {
                let cell = |(cases, scenes): &(Vec<_>, [Option<Scene>; 3])| {
                    let off = scenes[w].as_ref().map(|scene| deviations(&model, scene, cases));
                    off.unwrap_or_else(|| NOTHING.into())
                };
                let cells: Vec<String> = columns.iter().map(cell).collect();
                if cells.iter().any(|cell| cell != NOTHING) {
                    out += &markdown_row(&[vec![format!("`{id}`, {way}")], cells].concat());
                }
            }
        }
        out.push('\n');
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_across_the_lay_are_steeper_than_their_mean() -> Result<()> {
        let lay = Family { slope_ratio: 2.0, pixels: 256, ..FAMILIES[1] };
        let mean = lay.surface(256)?.moments();
        let [Some(all), Some(across), Some(measured)] = scenes(&lay, 0.0)? else {
            anyhow::bail!("three scenes")
        };
        let (all, across) = (all.surface.moments(), across.surface.moments());
        assert!((all.m2 / mean.m2 - 1.0).abs() < 1e-9);
        // Of slopes 2:1 the mean square is 5/8 of that across.
        assert!((across.m2 / mean.m2 / 1.6 - 1.0).abs() < 0.03, "{}", across.m2 / mean.m2);
        assert!((across.m0 / mean.m0 - 1.0).abs() < 0.03 && across.m4 > mean.m4);
        assert!(matches!(measured.heights, HeightDistribution::Other(_)));
        Ok(())
    }
}
