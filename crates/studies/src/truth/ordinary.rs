//! Scenes of engineers, solved on surfaces of their own bandwidth, plasticity index and load.
//!
//! They are not part of the evidence: they show how well it holds between solved families.

use anyhow::{Context, Result};
use asperity::{At, Body, Compared, Evidence, Interface, Quantity, Scene, Surface};

use super::family::{Family, GRADIENT, MODULUS, scene};
use super::kept::Kept;
use super::plan::{Case, LEAST_SEEDS};
use super::rows::Bem;
use xtask::figures::compared::NOTHING;
use xtask::figures::models::solve;
use xtask::table::{markdown_head, markdown_row};

/// The models that are compared.
const SHOWN: [&str; 6] = ["gw", "zmc", "ke", "jg", "persson-fudge", "persson-plastic"];
/// Surfaces of a case.
const SEEDS: u64 = 8;

/// A scene and its mean pressures \[Pa\].
type Ordinary = (&'static str, Scene, Vec<f64>);

/// Machined metals of the papers and examples under 0.1 to 10 MPa, and a wheel on a rail.
fn scenes() -> Result<Vec<Ordinary>> {
    let steel = Body::new(210e9, 0.3, 2e9);
    let aluminium = Body::yielding(69e9, 0.33, 275e6);
    let rail = Interface::between(&Body::new(210e9, 0.3, 2.75e9), &Body::new(210e9, 0.3, 2.45e9))?;
    let template =
        Scene::new(Interface::between(&steel, &steel)?, Surface::new(2e-4, 2e8, 1e-6), 1e-4);
    let bolt = Interface::between(&aluminium, &steel)?;
    let bolt = Scene::new(bolt, Surface::new(6e-5, 3e8, 2e-6), 6.1e-4);
    let rail = Scene::new(rail, Surface::new(3e-5, 1.53e9, 9e-7), 1.2e-4);
    let paper = Interface::new(116e9, 0.31, 1.12e9);
    let paper = Scene::new(paper, Surface::new(3.59e-4, 1.114e8, 1e-6), 3e-5);
    let decades = || vec![1e5, 1e6, 1e7];
    let wheel = vec![1200.0 / rail.nominal_area];
    Ok(vec![
        ("steel on steel (template)", template, decades()),
        ("bolted aluminium on steel", bolt, decades()),
        ("wheel on rail, 1200 N", rail, wheel),
        ("steel of the AT paper", paper, decades()),
    ])
}

/// A share in per cent with three digits.
fn percent(share: f64) -> String {
    let three: f64 = format!("{:.2e}", 100.0 * share).parse().unwrap_or(100.0 * share);
    three.to_string()
}

/// The cases of all scenes.
///
/// # Errors
/// A scene without a surface of its bandwidth.
pub fn all() -> Result<Vec<Case>> {
    let of = |(name, scene, pressures): &Ordinary| cases(name, scene, pressures);
    Ok(scenes()?.iter().map(of).collect::<Result<Vec<_>>>()?.concat())
}

/// The cases of a scene, in the order of its pressures.
fn cases(name: &'static str, actual: &Scene, pressures: &[f64]) -> Result<Vec<Case>> {
    let moments = actual.surface.moments();
    let asperity = actual.asperity()?;
    let unit = asperity.equivalent_modulus * (2.0 * moments.m2).sqrt();
    let family = Family::of_bandwidth(name, moments.bandwidth())?;
    let hardness = asperity.hardness.context("a hardness")? / unit * MODULUS * GRADIENT;
    let case = |pressure: &f64| -> Result<Case> {
        let load = pressure / unit;
        // Moments change with the number of pixels, and with them the index of a hardness.
        let surface = family.surface(family.pixels_for(load))?;
        let one = scene(&surface, 1.0)?.interface.hardness.context("a hardness")?;
        Ok(Case { family, index: one / hardness, load, seeds: [LEAST_SEEDS, SEEDS] })
    };
    pressures.iter().map(case).collect()
}

/// The table of the scenes beside the evidence; `None` where a case is not kept.
///
/// # Errors
/// A case that cannot be solved, a model that fails.
pub fn table(evidence: &Evidence, kept: &Kept) -> Result<Option<String>> {
    let mut heads =
        ["scene", "α", "ψ", "MPa", "p/(E g)", "area, %", "yielded, %"].map(str::to_owned).to_vec();
    heads.extend(SHOWN.map(|id| format!("`{id}`")));
    heads.push("area by the table, %".into());
    let mut out = markdown_head(&heads, heads.len() - 1);
    for (name, actual, pressures) in scenes()? {
        let cases = cases(name, &actual, &pressures)?;
        if !cases.iter().all(|case| kept.is_done(case)) {
            return Ok(None);
        }
        for (case, pressure) in cases.iter().zip(&pressures) {
            let bem = Bem::of_seeds(&kept.seeds(case));
            let [area, error] = bem.numbers[0];
            let mut row = vec![
                name.to_owned(),
                format!("{:.1}", actual.surface.moments().bandwidth()),
                format!("{:.1}", actual.plasticity_index()?),
                (pressure / 1e6).to_string(),
                format!("{:.1e}", case.load),
                format!("{} ± {:.1} %", percent(area), 100.0 * error / area),
                format!("{:.0}", 100.0 * bem.plastic_share),
            ];
            for id in SHOWN {
                let at = [At::Pressure(*pressure)];
                let found = solve(id, &actual, &[Quantity::AreaFraction], at)?;
                let found = found.values(Quantity::AreaFraction)?[0];
                row.push(format!("{:+.0}", 100.0 * (found / area - 1.0)));
            }
            let expected = evidence.expected(&actual, None, *pressure, None).ok();
            let ends = expected.and_then(|found| found.estimate(Compared::Area)?.ends);
            let text = |[low, high]: [f64; 2]| format!("{} to {}", percent(low), percent(high));
            row.push(ends.map_or(NOTHING.into(), text));
            out += &markdown_row(&row);
        }
    }
    Ok(Some(out))
}

#[cfg(test)]
mod tests {
    use super::super::kept::Contact;
    use super::*;

    /// With the hardness of its scene; cases that are not kept are not solved.
    #[test]
    fn kept_cases_are_shown_beside_the_given_evidence() -> Result<()> {
        let (folder, evidence) = (tempfile::tempdir()?, Evidence::committed()?);
        let kept = Kept::in_folder(folder.path())?;
        assert!(table(evidence, &kept)?.is_none());
        for (name, actual, pressures) in scenes()? {
            for (case, pressure) in cases(name, &actual, &pressures)?.iter().zip(&pressures) {
                let surface = case.family.surface(case.family.pixels_for(case.load))?;
                let solved =
                    scene(&surface, case.index)?.interface.hardness.context("a hardness")?;
                let share = case.load * MODULUS * GRADIENT / solved;
                let wanted = pressure / actual.asperity()?.hardness.context("a hardness")?;
                assert!((share / wanted - 1.0).abs() < 1e-9, "{name}: {share} is not {wanted}");
                let contact = Contact { load: case.load, area: 1e-3, ..Contact::default() };
                kept.add(case, &[contact; SEEDS as usize])?;
            }
        }
        let found = table(evidence, &kept)?.context("a table")?;
        assert_eq!(found.matches("| 0.1 ± 0.0 % |").count(), 10, "{found}");
        // All are within the evidence.
        assert_eq!(found.matches(" to ").count(), 10, "{found}");
        Ok(())
    }
}
