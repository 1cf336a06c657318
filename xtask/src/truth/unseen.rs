//! How often the intervals of the evidence hold contacts of surfaces that had no part in it: other
//! bandwidths, Hurst exponents, skewnesses, lays and plasticity indices.

use std::path::Path;

use anyhow::Result;
use asperity::{
    At, Compared, ContactModel, Evidence, Model, Quantity, Request, Scene, SurfaceShape,
    usual_reference,
};

use super::family::{Family, GRADIENT, MODULUS, scene, unit};
use super::kept::{Contact, Kept};
use super::plan::{Case, carried};
use super::rows::Bem;
use super::solve::are_kept;
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

/// Counts of values inside their interval.
#[derive(Debug, Clone, Default)]
struct Count {
    asked: usize,
    answered: usize,
    inside: usize,
    halves: Vec<f64>,
}

impl Count {
    fn add(&mut self, found: Option<[f64; 3]>, solved: f64) {
        self.asked += 1;
        let Some([value, low, high]) = found else { return };
        self.answered += 1;
        self.inside += usize::from((low..=high).contains(&solved));
        self.halves.push(0.5 * (high - low) / value);
    }

    fn cell(&mut self) -> String {
        let Self { asked, answered, inside, halves } = self;
        halves.sort_by(f64::total_cmp);
        match halves.get(halves.len() / 2) {
            Some(half) => format!(
                "{:.0} % of {answered} ({asked} asked), ±{:.0} %",
                100.0 * *inside as f64 / *answered as f64,
                100.0 * half
            ),
            None => NOTHING.into(),
        }
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

/// The number of contacts that the usual reference counts, as in advice.
fn contacts(scene: &Scene, pressure: f64) -> Result<f64> {
    let model: Model = usual_reference(scene).parse()?;
    let at = At::Pressure(pressure);
    let contact = model.compile(scene, &Request::new([Quantity::Contacts]).at([at]))?;
    Ok(contact.evaluate(Quantity::Contacts, at)?.value())
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
/// A text that is not evidence, a case that cannot be solved.
pub fn table(text: &str, folder: &Path, solve_missing: bool) -> Result<Option<String>> {
    let (evidence, kept) = (Evidence::parse(text)?, Kept::in_folder(folder)?);
    let mut counts: [[[Count; 2]; 4]; GROUPS.len()] = Default::default();
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
            let pressure = case.load * MODULUS * GRADIENT;
            let shape = SurfaceShape::new(family.skewness, [family.slope_ratio, 1.0]);
            let number = contacts(&scene, pressure)?;
            let singles: Vec<[f64; 4]> = seeds.iter().map(|one| mean(&[*one])).collect();
            // The mean of n surfaces is that of a surface with n times the contacts.
            let means = (number * seeds.len() as f64, vec![mean(&seeds)]);
            for (which, (number, solved)) in [means, (number, singles)].into_iter().enumerate() {
                let expected = evidence.expected(&scene, Some(shape), pressure, Some(number)).ok();
                for (k, quantity) in Compared::ALL.into_iter().enumerate() {
                    let unit = unit(quantity, &scene, sq);
                    let found = expected.as_ref().and_then(|all| all.estimate(quantity));
                    let found = found.map(|e| [e.value, e.low, e.high].map(|x| x / unit));
                    solved.iter().for_each(|solved| counts[group][k][which].add(found, solved[k]));
                }
            }
        }
    }
    let heads = ["surfaces", "quantity", "means of 6 surfaces", "single surfaces"];
    let mut out = markdown_head(&heads, 2);
    for (group, mut counts) in GROUPS.into_iter().zip(counts) {
        for (quantity, [mean, single]) in Compared::ALL.into_iter().zip(&mut counts) {
            out += &markdown_row(&[group, quantity.name(), &mean.cell(), &single.cell()]);
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
        let mut count = Count::default();
        for (found, solved) in [
            (Some([1.0, 0.9, 1.1]), 0.95),
            (Some([1.0, 0.8, 1.2]), 1.3),
            (Some([2.0, 1.0, 3.0]), 2.9),
            (None, 1.0),
        ] {
            count.add(found, solved);
        }
        assert_eq!(count.cell(), "67 % of 3 (4 asked), ±20 %");
        assert_eq!(Count::default().cell(), "–");
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
        assert!(table(Evidence::CSV, folder.path(), false)?.is_none());
        Ok(())
    }
}
