//! Three ways of giving skewed surfaces and those with a lay to models of isotropic surfaces.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use asperity::bem::HeightMap;
use asperity::{
    At, Compared, ContactModel, Evidence, EvidenceCase, HeightDistribution, Model, ProfileMoments,
    Quantity, Request, Scene, Surface, TabulatedHeights,
};
use asperity_topography::Topography;

use super::family::{FAMILIES, Family, GRADIENT, MODULUS, equal, scene};

/// The models that are compared: one law without and two with yielding, and the whole surface.
const SHOWN: [&str; 5] = ["gw", "ke", "jg", "jg-random", "persson-fudge"];
/// Maps whose differences are moments have 16 pixels per shortest wave, which leaves 2 % in m4.
const FINER: usize = 2;

/// What a user takes from the scan.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Way {
    /// Moments averaged over all directions, Gaussian heights.
    Mean,
    /// Moments of profiles across the lay.
    Across,
    /// Moments averaged over all directions, the heights of the summits.
    Measured,
}

impl Way {
    const ALL: [Self; 3] = [Self::Mean, Self::Across, Self::Measured];

    fn name(self) -> &'static str {
        match self {
            Self::Mean => "mean of all directions",
            Self::Across => "across the lay",
            Self::Measured => "mean, measured heights",
        }
    }

    /// The scene that a user makes; its hardness is that of the family.
    fn scene(self, family: &Family, index: f64) -> Result<Scene> {
        let surface = family.surface(family.pixels)?;
        let mut scene = scene(&surface, index)?;
        match self {
            Self::Mean => {}
            Self::Across => {
                let map = surface.seed(1).heights(FINER * family.pixels)?;
                scene.surface = Surface::from_moments(&across(&map))?;
            }
            Self::Measured => {
                let map = surface.seed(1).heights(family.pixels)?;
                let [_, columns] = map.shape();
                let scan = Topography::new(map.heights().to_vec(), columns, map.pixel())?;
                let summits = scan.with_periodic(true).summits()?;
                let offset = summits.mean();
                let density = summits.height_density()?;
                let heights = density.heights_m.into_iter().map(|z| z + offset);
                let points: Vec<(f64, f64)> = heights.zip(density.density_per_m).collect();
                let heights = TabulatedHeights::new("measured", &points)?;
                scene.heights = HeightDistribution::other(heights);
            }
        }
        Ok(scene)
    }
}

/// Moments of the columns of a periodic map; the lay is along the rows.
fn across(map: &HeightMap) -> ProfileMoments {
    let ([rows, columns], [dy, _]) = (map.shape(), map.pixel());
    let height = |i: usize, j: usize| map.heights()[(i % rows) * columns + j];
    let mean = |of: &dyn Fn(usize, usize) -> f64| {
        let all = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
        all.map(|(i, j)| of(i, j).powi(2)).sum::<f64>() / (rows * columns) as f64
    };
    let second = |i, j| (height(i, j) - 2.0 * height(i + 1, j) + height(i + 2, j)) / (dy * dy);
    ProfileMoments {
        m0: map.rms_height().powi(2),
        m2: mean(&|i, j| (height(i + 1, j) - height(i, j)) / dy),
        m4: mean(&second),
    }
}

/// Deviations of the area over the loads: lowest, highest.
type Ends = Option<[f64; 2]>;

fn deviations(family: &Family, index: f64, way: Way, cases: &[&EvidenceCase]) -> Result<Vec<Ends>> {
    let scene = way.scene(family, index)?;
    let places = cases.iter().map(|case| At::Pressure(case.load * MODULUS * GRADIENT));
    let request = Request::new([Quantity::AreaFraction]).at(places);
    let of = |id: &str| -> Result<Ends> {
        let model: Model = id.parse()?;
        // Random asperities are Gaussian.
        let Ok(contact) = model.compile(&scene, &request) else { return Ok(None) };
        let mut ends: Ends = None;
        for (case, at) in cases.iter().zip(&request.at) {
            let bem = case.bem.value(Compared::Area).context("an area")?;
            let Ok(found) = contact.evaluate(Quantity::AreaFraction, *at) else { continue };
            let off = 100.0 * (found.value() / bem - 1.0);
            ends = Some(ends.map_or([off; 2], |[low, high]| [low.min(off), high.max(off)]));
        }
        Ok(ends)
    };
    SHOWN.iter().map(|id| of(id)).collect()
}

/// A table of the ways for each material: rows are models and ways, columns families.
///
/// # Errors
/// A text that is not evidence, a family whose scene cannot be made.
pub fn table(text: &str) -> Result<String> {
    let evidence = Evidence::parse(text)?;
    let mut out = String::new();
    for (index, material) in [(0.0, "elastic"), (2.0, "psi 2")] {
        let mut heads = vec![];
        let mut columns: Vec<[Vec<Ends>; 3]> = vec![];
        for family in FAMILIES.iter().filter(|f| !equal(f.skewness, 0.0) || f.slope_ratio > 1.0) {
            let same = |case: &&EvidenceCase| {
                equal(case.skewness, family.skewness)
                    && equal(case.slope_ratio, family.slope_ratio)
                    && equal(case.plasticity_index, index)
            };
            let cases: Vec<&EvidenceCase> = evidence.cases().iter().filter(same).collect();
            if cases.is_empty() {
                continue;
            }
            heads.push(match family.slope_ratio > 1.0 {
                true => format!("lay {}", family.slope_ratio),
                false => format!("skewness {:+}", family.skewness),
            });
            let [a, b, c] = Way::ALL.map(|way| match (way, family.slope_ratio > 1.0) {
                // Without a lay all directions are alike.
                (Way::Across, false) => Ok(vec![None; SHOWN.len()]),
                _ => deviations(family, index, way, &cases),
            });
            columns.push([a?, b?, c?]);
        }
        writeln!(
            out,
            "{material}, by what models are given:\n\n| area, % off | {} |",
            heads.join(" | ")
        )?;
        writeln!(out, "|---|{}", "---:|".repeat(heads.len()))?;
        for (k, id) in SHOWN.iter().enumerate() {
            for (w, way) in Way::ALL.into_iter().enumerate() {
                let ends = |column: &[Vec<Ends>; 3]| match column[w][k] {
                    Some([low, high]) => format!("{low:+.0} to {high:+.0}"),
                    None => "–".into(),
                };
                let row: Vec<String> = columns.iter().map(ends).collect();
                if row.iter().any(|cell| cell != "–") {
                    writeln!(out, "| `{id}`, {} | {} |", way.name(), row.join(" | "))?;
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
        let [all, across] = [Way::Mean, Way::Across].map(|way| way.scene(&lay, 0.0));
        let (all, across) = (all?.surface.moments(), across?.surface.moments());
        assert!((all.m2 / mean.m2 - 1.0).abs() < 1e-9);
        // Of slopes 2:1 the mean square is 5/8 of that across.
        assert!((across.m2 / mean.m2 / 1.6 - 1.0).abs() < 0.03, "{}", across.m2 / mean.m2);
        assert!((across.m0 / mean.m0 - 1.0).abs() < 0.03 && across.m4 > mean.m4);
        let measured = Way::Measured.scene(&lay, 0.0)?;
        assert!(matches!(measured.heights, HeightDistribution::Other(_)));
        Ok(())
    }
}
