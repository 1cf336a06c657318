//! Models compared with boundary elements at the same share of yielded contacts, not the same ψ.
//!
//! In boundary elements a contact yields at a Hertz peak pressure of H, in the models at S H. Here
//! the hardness of a model is changed until its yielding asperities carry the share of the force
//! that pixels at the hardness carry in boundary elements.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use anyhow::Result;
use asperity::{
    At, Compared, Contact, ContactModel, Evidence, EvidenceCase, Model, Quantity, Request, Scene,
    Tolerance,
};

use super::family::{FAMILIES, Family, GRADIENT, MODULUS, equal, scene};

/// The models that are compared.
const SHOWN: [&str; 5] = ["ceb", "zmc", "ke", "jg", "ke-random"];
/// Shares of the force at which something and not all yields.
const SHARES: std::ops::RangeInclusive<f64> = 0.02..=0.98;
/// Logarithmic step of the hardness, between which areas and shares are interpolated: 0.6 % off.
/// All cases of a family share the contacts, as random asperities are averaged for each hardness.
const STEP: f64 = 0.1;
/// Hardnesses reach so many steps, a factor of 20, from that of a case.
const MOST_STEPS: i32 = 30;
/// Relative tolerance.
const TOLERANCE: f64 = 1e-4;

/// A model on a family, at any number of steps of the hardness from that of ψ = 1.
struct Hardnesses<'m> {
    model: &'m Model,
    /// ψ = 1.
    scene: Scene,
    contacts: BTreeMap<i32, Option<Box<dyn Contact>>>,
}

impl Hardnesses<'_> {
    /// The area and the share of the force on yielding asperities.
    fn answer(&mut self, step: i32, at: At) -> Option<[f64; 2]> {
        let Self { model, scene, contacts } = self;
        let compiled = || {
            let mut here = scene.clone();
            here.interface.hardness =
                scene.interface.hardness.map(|hardness| hardness * (STEP * f64::from(step)).exp());
            let known = [Quantity::AreaFraction, Quantity::ElasticShare];
            // Random asperities have shares beyond an interference only.
            [&known[..], &known[..1]].iter().find_map(|known| {
                let request = Request::new(known.iter().copied());
                let request = request.within(Tolerance::new(TOLERANCE).ok()?);
                model.compile(&here, &request.at([At::Pressure(1.0)])).ok()
            })
        };
        let contact = contacts.entry(step).or_insert_with(compiled).as_ref()?;
        let area = contact.evaluate(Quantity::AreaFraction, at).ok()?.value();
        // Asperities of different radii yield at different interferences.
        let yielded = match contact.shares_beyond(at, &[1.0]).ok()? {
            Some(shares) => *shares.first()?,
            None => 1.0 - contact.evaluate(Quantity::ElasticShare, at).ok()?.value(),
        };
        Some([area, yielded])
    }

    /// The area at the hardness of ψ = `index`, and at the one with this yielded share.
    fn areas(&mut self, index: f64, share: f64, at: At) -> Option<[f64; 2]> {
        let exact = -index.ln() / STEP;
        let here = exact.floor() as i32;
        let [[soft, _], [hard, _]] = [self.answer(here, at)?, self.answer(here + 1, at)?];
        let same_index = soft + (exact - f64::from(here)) * (hard - soft);
        // Soft yields, hard does not.
        let [mut soft, mut hard] = [here - MOST_STEPS, here + MOST_STEPS];
        while hard - soft > 1 {
            let middle = (soft + hard).div_euclid(2);
            match self.answer(middle, at)? {
                [_, found] if found > share => soft = middle,
                _ => hard = middle,
            }
        }
        let [[area, more], [less_area, less]] = [self.answer(soft, at)?, self.answer(hard, at)?];
        let part = ((more - share) / (more - less)).clamp(0.0, 1.0);
        Some([same_index, area + part * (less_area - area)])
    }
}

/// The share of the force on pixels at the hardness.
fn yielded(case: &EvidenceCase, hardness: f64) -> Option<f64> {
    let area = case.bem.value(Compared::Area)?;
    Some(case.plastic_share * area * hardness / (case.load * MODULUS * GRADIENT))
}

/// Areas of a model over those of boundary elements, at equal ψ and at an equal yielded share, in
/// the cases of a family.
fn ratios(family: &Family, cases: &[&EvidenceCase], model: &Model) -> Result<Vec<[f64; 2]>> {
    let scene = scene(&family.surface(family.pixels)?, 1.0)?;
    let hardness = scene.interface.hardness.unwrap_or(f64::INFINITY);
    let mut of_model = Hardnesses { model, scene, contacts: BTreeMap::new() };
    let ratio = |case: &&EvidenceCase| {
        let at = At::Pressure(case.load * MODULUS * GRADIENT);
        // ψ is inversely proportional to the hardness.
        let share = yielded(case, hardness / case.plasticity_index);
        let share = share.filter(|share| SHARES.contains(share))?;
        let areas = of_model.areas(case.plasticity_index, share, at)?;
        let bem = case.bem.value(Compared::Area)?;
        Some(areas.map(|area| area / bem))
    };
    Ok(cases.iter().filter_map(ratio).collect())
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
            let cases: Vec<&EvidenceCase> = evidence.cases().iter().filter(of_family).collect();
            found.extend(ratios(family, &cases, &model)?);
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
        let known = Request::new([Quantity::AreaFraction, Quantity::ElasticShare]);
        let contact = model.compile(&scene, &known.at([at]))?;
        let area = contact.evaluate(Quantity::AreaFraction, at)?.value();
        let share = 1.0 - contact.evaluate(Quantity::ElasticShare, at)?.value();
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
        let cases: Vec<&EvidenceCase> = evidence.cases().iter().collect();
        let found = ratios(family, &cases, &model)?;
        let [found] = &found[..] else { anyhow::bail!("{found:?}") };
        // Linear between steps of the hardness.
        assert!(found.iter().all(|ratio| (ratio - 0.5).abs() < 3e-3), "{found:?}");
        Ok(())
    }
}
