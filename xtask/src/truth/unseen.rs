//! How often the intervals of the evidence hold contacts of surfaces that had no part in it: other
//! bandwidths, Hurst exponents, skewnesses, lays and plasticity indices.

use std::path::Path;

use anyhow::Result;
use asperity::{Compared, Evidence, Quantity, SurfaceShape, usual_reference};

use super::family::{Family, GRADIENT, MODULUS, pressure, scene, unit};
use super::kept::{Contact, Kept};
use super::plan::{Case, carried};
use super::rows::Bem;
use super::solve::are_kept;
use crate::figures::models::solve;
use crate::figures::report_csv::median;
use crate::figures::truth_ranges::NOTHING;
use crate::table::{markdown_head, markdown_row};

/// Surfaces of a case.
const SEEDS: u64 = 6;
/// Cases with fewer patches on all surfaces together are left out.
const LEAST_PATCHES: f64 = 30.0;
/// Mean values of light contacts are those of large surfaces.
const LOADS: [f64; 5] = [2e-4, 2e-3, 1.5e-2, 5e-2, 0.15];
const INDICES: [f64; 4] = [0.0, 1.2, 3.0, 5.0];
/// Materials of skewed surfaces and those with a lay.
const FEW_INDICES: [f64; 2] = [0.0, 1.5];

/// Families that are not solved for the table: name, bandwidth, Hurst exponent, skewness, ratio of
/// slopes, pixels.
const FAMILIES: [(&str, f64, f64, f64, f64, usize); 11] = [
    ("u5-h3", 5.0, 0.3, 0.0, 1.0, 512),
    ("u12-h3", 12.0, 0.3, 0.0, 1.0, 1024),
    ("u5-h9", 5.0, 0.9, 0.0, 1.0, 512),
    ("u12-h9", 12.0, 0.9, 0.0, 1.0, 512),
    ("u5-skew+1", 5.0, 0.8, 1.0, 1.0, 512),
    ("u12-skew+0.5", 12.0, 0.8, 0.5, 1.0, 512),
    ("u5-skew-1", 5.0, 0.8, -1.0, 1.0, 512),
    ("u12-skew-1.5", 12.0, 0.8, -1.5, 1.0, 512),
    ("u6-lay3", 6.0, 0.8, 0.0, 3.0, 512),
    ("u22-h9", 22.0, 0.9, 0.0, 1.0, 512),
    ("u50-h9", 50.0, 0.9, 0.0, 1.0, 1024),
];

/// A group of families with a row of its own in the table.
const GROUPS: [&str; 3] = ["isotropic, Gaussian", "skewed", "lay"];

/// A solved value beside its expected value, low and high ends, if there are such.
type Pair = (Option<[f64; 3]>, f64);

/// The share of solved values inside their interval, and half of its median width.
fn cell(pairs: &[Pair]) -> String {
    let answered: Vec<([f64; 3], f64)> =
        pairs.iter().filter_map(|(found, solved)| Some(((*found)?, *solved))).collect();
    let inside = |([_, low, high], solved): &&([f64; 3], f64)| (low..=high).contains(&solved);
    let share = 100.0 * answered.iter().filter(inside).count() as f64 / answered.len() as f64;
    let half = |([value, low, high], _): &([f64; 3], f64)| 50.0 * (high - low) / value;
    match median(answered.iter().map(half).collect()) {
        Some(half) => {
            format!("{share:.0} % of {} ({} asked), ±{half:.0} %", answered.len(), pairs.len())
        }
        None => NOTHING.into(),
    }
}

/// The families with their groups, materials and loads.
fn cases() -> Result<Vec<(usize, Family, Vec<Case>)>> {
    let of = |(name, alpha, hurst, skewness, slope_ratio, pixels)| {
        let plain = Family::of_bandwidth(alpha, hurst, pixels)?;
        let family = Family { name, skewness, slope_ratio, most_pixels: 1024, ..plain };
        let group = if slope_ratio > 1.0 { 2 } else { usize::from(f64::abs(skewness) > 0.0) };
        let indices = if group == 0 && alpha < 40.0 { &INDICES[..] } else { &FEW_INDICES };
        Ok((group, family, carried(family, indices, &LOADS, [SEEDS; 2])?))
    };
    FAMILIES.into_iter().map(of).collect()
}

/// The results in the order of [`Compared::ALL`], averaged.
fn mean(contacts: &[Contact]) -> [f64; 4] {
    Bem::of_seeds(contacts).numbers.map(|[mean, _]| mean)
}

/// The share of values inside their interval, of the means of all surfaces and of each surface.
/// Cases that this folder does not hold are solved; if none may be solved and one is not kept,
/// there is no table.
///
/// # Errors
/// A case that cannot be solved.
pub fn table(evidence: &Evidence, folder: &Path, solve_missing: bool) -> Result<Option<String>> {
    let kept = Kept::in_folder(folder)?;
    let mut pairs: [[[Vec<Pair>; 2]; 4]; GROUPS.len()] = Default::default();
    for (group, family, cases) in cases()? {
        if !are_kept(&cases, &kept, solve_missing)? {
            return Ok(None);
        }
        for case in cases {
            let seeds = kept.seeds(&case);
            if seeds.iter().map(|contact| contact.patches).sum::<f64>() < LEAST_PATCHES {
                continue;
            }
            let surface = family.surface(family.pixels_for(case.load))?;
            let (scene, sq) = (scene(&surface, case.index)?, surface.moments().m0.sqrt());
            let shape = SurfaceShape::new(family.skewness, [family.slope_ratio, 1.0]);
            // The number of contacts that the usual reference counts, as in advice.
            let (reference, at) = (usual_reference(&scene), [pressure(case.load)]);
            let number = solve(reference, &scene, &[Quantity::Contacts], at)?;
            let number = number.values(Quantity::Contacts)?[0];
            let singles: Vec<[f64; 4]> = seeds.iter().map(|one| mean(&[*one])).collect();
            // The mean of n surfaces is that of a surface with n times the contacts.
            let means = (number * seeds.len() as f64, vec![mean(&seeds)]);
            for (which, (number, solved)) in [means, (number, singles)].into_iter().enumerate() {
                let pressure = case.load * MODULUS * GRADIENT;
                let expected = evidence.expected(&scene, Some(shape), pressure, Some(number)).ok();
                for (k, quantity) in Compared::ALL.into_iter().enumerate() {
                    let unit = unit(quantity, &scene, sq);
                    let found = expected.as_ref().and_then(|all| all.estimate(quantity));
                    let found = found.map(|e| [e.value, e.low, e.high].map(|x| x / unit));
                    pairs[group][k][which].extend(solved.iter().map(|solved| (found, solved[k])));
                }
            }
        }
    }
    let mut out =
        markdown_head(&["surfaces", "quantity", "means of 6 surfaces", "single surfaces"], 2);
    for (group, pairs) in GROUPS.into_iter().zip(&pairs) {
        for (quantity, [means, singles]) in Compared::ALL.into_iter().zip(pairs) {
            out += &markdown_row(&[group, quantity.name(), &cell(means), &cell(singles)]);
        }
    }
    Ok(Some(out))
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::EvidenceCase;

    #[test]
    fn values_are_counted_where_they_have_an_interval() {
        let pairs = [
            (Some([1.0, 0.9, 1.1]), 0.95),
            (Some([1.0, 0.8, 1.2]), 1.3),
            (Some([2.0, 1.0, 3.0]), 2.9),
            (None, 1.0),
        ];
        assert_eq!(cell(&pairs), "67 % of 3 (4 asked), ±20 %");
        assert_eq!(cell(&[]), "–");
    }

    #[test]
    fn families_have_the_bandwidth_of_their_names_and_none_is_in_the_table() -> Result<()> {
        let evidence = Evidence::parse(Evidence::CSV)?;
        for ((_, family, cases), (_, alpha, ..)) in cases()?.into_iter().zip(FAMILIES) {
            let found = Family { slope_ratio: 1.0, skewness: 0.0, ..family };
            let found = found.surface(1024)?.moments().bandwidth();
            // Named by that of the integral over all waves; a map has a sum over some of them.
            assert!((found / alpha - 1.0).abs() < 0.08, "{} {found}", family.name);
            let near = |case: &EvidenceCase| {
                case.skewness == 0.0
                    && case.slope_ratio <= 1.0
                    && (case.alpha / found - 1.0).abs() < 0.1
            };
            assert!(!evidence.cases().iter().any(near), "{} {found}", family.name);
            assert!(cases.len() >= 8, "{}", family.name);
        }
        let folder = tempfile::tempdir()?;
        assert!(table(&evidence, folder.path(), false)?.is_none());
        Ok(())
    }
}
