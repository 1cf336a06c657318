//! Models compared with boundary elements at the same share of yielded contacts, not the same ψ.
//!
//! In boundary elements a contact yields at a Hertz peak pressure of H, in the models at S H. Here
//! the hardness of a model is changed until its yielding asperities carry the share of the force
//! that pixels at the hardness carry in boundary elements.

use std::fmt::Write as _;

use anyhow::Result;
use asperity::{
    At, Compared, ContactModel, Evidence, EvidenceCase, Model, Quantity, Request, Scene, Tolerance,
};

use super::family::{FAMILIES, Family, GRADIENT, MODULUS, equal, scene};

/// The models that are compared.
const SHOWN: [&str; 5] = ["ceb", "zmc", "ke", "jg", "ke-random"];
/// Shares of the force at which something and not all yields.
const SHARES: std::ops::RangeInclusive<f64> = 0.02..=0.98;
/// Steps of a bisection of the logarithm of the hardness, to 0.6 %: areas are 0.2 % off.
const STEPS: usize = 10;
/// Relative tolerance; random asperities are averaged anew for each hardness.
const TOLERANCE: f64 = 1e-4;

/// The share of the force on pixels at the hardness.
fn yielded(case: &EvidenceCase, hardness: f64) -> Option<f64> {
    let area = case.bem.value(Compared::Area)?;
    Some(case.plastic_share * area * hardness / (case.load * MODULUS * GRADIENT))
}

/// The area of a model and the share of the force on its yielding asperities.
fn answer(model: &Model, scene: &Scene, at: At) -> Option<[f64; 2]> {
    let value = |quantity| {
        let request = Request::new([quantity]).within(Tolerance::new(TOLERANCE).ok()?);
        let contact = model.compile(scene, &request.at([at])).ok()?;
        let value = contact.evaluate(quantity, at).ok()?.value();
        Some((contact, value))
    };
    let (contact, area) = value(Quantity::AreaFraction)?;
    // Asperities of different radii yield at different interferences.
    let yielded = match contact.shares_beyond(at, &[1.0]).ok()? {
        Some(shares) => *shares.first()?,
        None => 1.0 - value(Quantity::ElasticShare)?.1,
    };
    Some([area, yielded])
}

/// Area of a model over that of boundary elements, at equal ψ and at an equal yielded share.
fn ratios(family: &Family, case: &EvidenceCase, model: &Model) -> Result<Option<[f64; 2]>> {
    let surface = family.surface(family.pixels)?;
    let at = At::Pressure(case.load * MODULUS * GRADIENT);
    let mut here = scene(&surface, case.plasticity_index)?;
    let Some(bem) = case.bem.value(Compared::Area) else { return Ok(None) };
    let hardness = here.interface.hardness.unwrap_or(f64::INFINITY);
    let Some(share) = yielded(case, hardness).filter(|share| SHARES.contains(share)) else {
        return Ok(None);
    };
    let Some([area, _]) = answer(model, &here, at) else { return Ok(None) };
    // Soft yields, hard does not.
    let (mut soft, mut hard) = ((0.05 * hardness).ln(), (20.0 * hardness).ln());
    for _ in 0..STEPS {
        let middle = 0.5 * (soft + hard);
        here.interface.hardness = Some(middle.exp());
        match answer(model, &here, at) {
            Some([_, found]) if found > share => soft = middle,
            Some(_) => hard = middle,
            None => return Ok(None),
        }
    }
    here.interface.hardness = Some((0.5 * (soft + hard)).exp());
    Ok(answer(model, &here, at).map(|[equal_share, _]| [area / bem, equal_share / bem]))
}

/// Ranges of the deviations of areas of isotropic surfaces, at equal ψ and at equal shares.
///
/// # Errors
/// A text that is not evidence, a scene that cannot be made.
pub fn table(text: &str) -> Result<String> {
    let evidence = Evidence::parse(text)?;
    let mut out = String::from(
        "| area, % off | at equal ψ | at an equal yielded share of the force | cases |\n|---|---:|---:|---:|\n",
    );
    for id in SHOWN {
        let model: Model = id.parse()?;
        let mut found: Vec<[f64; 2]> = vec![];
        for family in FAMILIES.iter().filter(|f| equal(f.skewness, 0.0) && f.slope_ratio <= 1.0) {
            let alpha = family.surface(family.pixels)?.moments().bandwidth();
            let of_family = |case: &&EvidenceCase| {
                (case.alpha / alpha - 1.0).abs() < 1e-3
                    && equal(case.skewness, 0.0)
                    && case.slope_ratio <= 1.0
                    && case.plasticity_index > 0.0
            };
            for case in evidence.cases().iter().filter(of_family) {
                found.extend(ratios(family, case, &model)?);
            }
        }
        let ends = |k: usize| {
            let off = found.iter().map(|pair| 100.0 * (pair[k] - 1.0));
            let low = off.clone().fold(f64::INFINITY, f64::min);
            format!("{low:+.0} to {:+.0}", off.fold(f64::NEG_INFINITY, f64::max))
        };
        writeln!(out, "| `{id}` | {} | {} | {} |", ends(0), ends(1), found.len())?;
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where boundary elements have a model's own yielded share, the hardness is found again.
    #[test]
    fn an_equal_share_is_that_of_the_same_hardness() -> Result<()> {
        let family = &FAMILIES[0];
        let surface = family.surface(family.pixels)?;
        let (scene, load) = (scene(&surface, 2.0)?, 0.01);
        let at = At::Pressure(load * MODULUS * GRADIENT);
        let model: Model = "ke".parse()?;
        let Some([area, share]) = answer(&model, &scene, at) else { anyhow::bail!("no answer") };
        let hardness = scene.interface.hardness.unwrap_or(0.0);
        // The share of the area whose pixels carry that share of the force; twice the area.
        let bem = 2.0 * area;
        let plastic = share * load * MODULUS * GRADIENT / (bem * hardness);
        let alpha = surface.moments().bandwidth();
        let text = format!(
            "{},ke,a,b,c\n{alpha},0,1,2,{load},4,200,{plastic},{bem},0,1,0,1,0,1,0,500,,,\n",
            Evidence::COLUMNS.join(",")
        );
        let evidence = Evidence::parse(&text)?;
        let found = ratios(family, &evidence.cases()[0], &model)?;
        assert!(found.is_some_and(|r| r.iter().all(|r| (r - 0.5).abs() < 3e-3)), "{found:?}");
        Ok(())
    }
}
