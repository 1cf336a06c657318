//! Models compared with boundary elements at the same share of yielded contacts, not the same ψ.
//!
//! In boundary elements a contact yields at a Hertz peak pressure of H, in the models at S H. Here
//! the hardness of a model is changed until its yielding asperities carry the share of the force
//! that pixels at the hardness carry in boundary elements.

use std::collections::BTreeMap;

use anyhow::Result;
use asperity::{At, Compared, Contact, Evidence, EvidenceCase, Model, Quantity, Scene, Tolerance};

use super::family::{FAMILIES, Family, GRADIENT, MODULUS, pressure, scene};
use super::rows::compiled;
use crate::truth::ranges::ends;
use xtask::figures::compared::is_plain;
use xtask::table::{markdown_head, markdown_row};

/// The models that are compared.
const SHOWN: [&str; 6] = ["ceb", "zmc", "ke", "jg", "ke-random", "persson-plastic"];
/// Shares of the force at which some contacts yield and not all.
const SHARES: std::ops::RangeInclusive<f64> = 0.02..=0.98;
/// Logarithmic step of the hardness; areas and shares are interpolated between steps, 0.6 % off.
/// Compiled contacts are shared by the cases of a family: random asperities take long to average.
const STEP: f64 = 0.1;
/// Steps to either side of the hardness of a case: a factor of 20.
const MOST_STEPS: i32 = 30;
/// Relative tolerance.
const TOLERANCE: f64 = 1e-4;

/// A model on a family, at any number of steps of the hardness from ψ = 1.
struct Hardnesses<'m> {
    model: &'m Model,
    /// The scene with ψ = 1.
    scene: Scene,
    contacts: BTreeMap<i32, Option<Box<dyn Contact>>>,
}

impl Hardnesses<'_> {
    /// The area and the share of the force on yielding asperities.
    fn answer(&mut self, step: i32, at: At) -> Option<[f64; 2]> {
        let Self { model, scene, contacts } = self;
        let at_hardness = || {
            let mut here = scene.clone();
            let factor = (STEP * f64::from(step)).exp();
            here.interface.hardness = scene.interface.hardness.map(|hardness| hardness * factor);
            let known = [Quantity::AreaFraction, Quantity::ElasticShare];
            // Random asperities have shares beyond an interference only.
            compiled(model, &here, &known, 1, Tolerance::new(TOLERANCE).ok()?)
        };
        let contact = contacts.entry(step).or_insert_with(at_hardness).as_ref()?;
        let value = |quantity| Some(contact.evaluate(quantity, at).ok()?.value());
        // Asperities of different radii yield at different interferences.
        let yielded = match contact.shares_beyond(at, &[1.0]).ok()? {
            Some(shares) => *shares.first()?,
            None => 1.0 - value(Quantity::ElasticShare)?,
        };
        Some([value(Quantity::AreaFraction)?, yielded])
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

/// Areas of a model over boundary elements', at equal ψ and at an equal yielded share, in
/// the cases of a family.
fn ratios(family: &Family, cases: &[&EvidenceCase], model: &Model) -> Result<Vec<[f64; 2]>> {
    let scene = scene(&family.surface(family.pixels)?, 1.0)?;
    let hardness = scene.interface.hardness.unwrap_or(f64::INFINITY);
    let mut of_model = Hardnesses { model, scene, contacts: BTreeMap::new() };
    let ratio = |case: &&EvidenceCase| {
        let bem = case.bem.value(Compared::Area)?;
        // The share of the force on pixels at the hardness; ψ is inversely proportional to it.
        let share = case.plastic_share * bem * hardness
            / (case.plasticity_index * case.load * MODULUS * GRADIENT);
        let at = SHARES.contains(&share).then(|| pressure(case.load))?;
        Some(of_model.areas(case.plasticity_index, share, at)?.map(|area| area / bem))
    };
    Ok(cases.iter().filter_map(ratio).collect())
}

/// Ranges of the deviations of areas of isotropic surfaces, at equal ψ and at equal shares.
///
/// # Errors
/// A scene that cannot be made.
pub fn table(evidence: &Evidence) -> Result<String> {
    let heads = ["area, % off", "at equal ψ", "at an equal yielded share of the force", "cases"];
    let mut out = markdown_head(&heads, 3);
    for id in SHOWN {
        let (model, mut found): (Model, Vec<[f64; 2]>) = (id.parse()?, vec![]);
        for family in &FAMILIES {
            let mut cases = family.cases(evidence)?;
            cases.retain(|case| is_plain(case) && case.plasticity_index > 0.0);
            found.extend(ratios(family, &cases, &model)?);
        }
        let ends = |k: usize| ends(found.iter().map(|pair| 100.0 * (pair[k] - 1.0)));
        out += &markdown_row(&[format!("`{id}`"), ends(0), ends(1), found.len().to_string()]);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::{ContactModel, Request};

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
            Evidence::COLUMNS
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
