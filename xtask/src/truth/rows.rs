//! Rows of the evidence: boundary elements averaged over surfaces, and the models beside them.

use anyhow::{Context, Result, bail};
use asperity::{
    At, Compared, Contact, ContactError, ContactModel, Datum, Evidence, EvidenceCase, Model,
    Quantity, Request, SeparationUnit,
};

use super::family::{Family, GRADIENT, MODULUS, scene};
use super::kept::{self, Kept};
use super::plan::{Case, Scope};
use crate::figures::truth_ranges::models;

/// Mean and standard error of the surfaces, in the order of [`Compared::ALL`].
pub struct Bem {
    surfaces: usize,
    patches: f64,
    /// Share of the contact at the hardness.
    pub plastic_share: f64,
    /// Mean and standard error of each quantity.
    pub numbers: [[f64; 2]; 4],
}

impl Bem {
    /// Of the contacts of several surfaces.
    #[must_use]
    pub fn of_seeds(all: &[kept::Contact]) -> Self {
        let count = all.len() as f64;
        let mean = |of: &dyn Fn(&kept::Contact) -> f64| all.iter().map(of).sum::<f64>() / count;
        let number = |of: fn(&kept::Contact) -> f64| {
            let center = mean(&of);
            let square = mean(&|contact| (of(contact) - center).powi(2));
            [center, (square / (count - 1.0).max(1.0)).sqrt()]
        };
        Self {
            surfaces: all.len(),
            patches: count * mean(&|contact| contact.patches),
            plastic_share: mean(&|contact| contact.plastic_area) / mean(&|contact| contact.area),
            numbers: [
                number(|contact| contact.area),
                number(|contact| contact.stiffness),
                number(|contact| contact.unloading_stiffness),
                number(|contact| contact.gap),
            ],
        }
    }

    /// Of a row of the table.
    fn of_row(known: &EvidenceCase) -> Result<Self> {
        let number = |quantity| {
            let [mean, error] = [known.bem.value(quantity), known.bem.error(quantity)];
            Ok([mean.context("a number of bem")?, error.context("an error of bem")?])
        };
        let numbers: Vec<[f64; 2]> =
            Compared::ALL.into_iter().map(number).collect::<Result<_>>()?;
        let (patches, plastic_share) = (known.patches as f64, known.plastic_share);
        let numbers = numbers.try_into().map_err(|_| anyhow::anyhow!("four quantities"))?;
        Ok(Self { surfaces: known.surfaces, patches, plastic_share, numbers })
    }
}

/// The models on a scene.
struct ModelContacts {
    models: Vec<Option<Box<dyn Contact>>>,
    /// Sq \[m\].
    sq: f64,
}

impl ModelContacts {
    /// All models; `None` for those that the scene does not allow. Larger surfaces of a family have
    /// the same moments within some per cent, and models the same ratios within one.
    fn new(family: &Family, index: f64) -> Result<Self> {
        let surface = family.surface(family.pixels)?;
        let scene = scene(&surface, index)?;
        let compiled = |model: Model| {
            let known = [Quantity::AreaFraction, Quantity::Tangent, Quantity::UnloadingStiffness];
            // Some have no contact radii.
            [&known[..], &known[..2]].iter().find_map(|known| {
                let request = Request::new(known.iter().copied());
                model.compile(&scene, &request.at([At::Pressure(1.0)])).ok()
            })
        };
        let models = models().into_iter().map(compiled).collect();
        Ok(Self { models, sq: surface.moments().m0.sqrt() })
    }

    /// Area, stiffness, unloading stiffness and mean gap of a model.
    fn numbers(&self, contact: &dyn Contact, load: f64) -> Result<[Option<f64>; 4]> {
        let at = At::Pressure(load * MODULUS * GRADIENT);
        let unit = MODULUS * contact.scene().nominal_area / self.sq;
        let gap = contact.separation(at).and_then(|separation| {
            let (metres, mean) = (SeparationUnit::Metres, Datum::SurfaceMean);
            separation.measured_in(metres, mean, contact.scene())
        });
        let value = |quantity| match contact.evaluate(quantity, at) {
            Ok(found) => Ok(Some(found.value())),
            // Gao and AT miss their tolerance at some loads, and have no contact radii.
            Err(
                ContactError::Integral { .. }
                | ContactError::NotRequested { .. }
                | ContactError::Unsupported { .. },
            ) => Ok(None),
            Err(error) => bail!("{} at p/(E g) = {load}: {error}", contact.model()),
        };
        Ok([
            value(Quantity::AreaFraction)?,
            value(Quantity::Tangent)?.map(|stiffness| stiffness / unit),
            value(Quantity::UnloadingStiffness)?.map(|stiffness| stiffness / unit),
            gap.ok().map(|gap| gap.value / self.sq),
        ])
    }
}

/// A number with four significant digits.
fn short(number: f64) -> String {
    written(format!("{number:.3e}").parse().unwrap_or(number))
}

/// An error with two.
fn shorter(error: f64) -> String {
    written(format!("{error:.1e}").parse().unwrap_or(error))
}

fn written(number: f64) -> String {
    match number.abs() {
        small if small > 0.0 && small < 1e-3 => format!("{number:e}"),
        _ => number.to_string(),
    }
}

/// Rows of evidence, case by case.
struct Text {
    text: String,
    contacts: Option<((&'static str, u64), ModelContacts)>,
}

impl Text {
    fn new() -> Self {
        let mut head: Vec<String> = Evidence::COLUMNS.map(Into::into).to_vec();
        for model in models() {
            let id = model.id().to_string();
            head.push(id.clone());
            head.extend(["stiffness", "unloading", "gap"].map(|what| format!("{id}_{what}")));
        }
        Self { text: head.join(",") + "\n", contacts: None }
    }

    fn push(&mut self, case: &Case, bem: &Bem) -> Result<()> {
        let Case { family, index, load, .. } = *case;
        let key = (family.name, index.to_bits());
        let contacts = match self.contacts.take() {
            Some((known, contacts)) if known == key => contacts,
            _ => ModelContacts::new(&family, index)?,
        };
        let alpha = family.surface(family.pixels)?.moments().bandwidth();
        let mut row: Vec<String> =
            [alpha, family.skewness, family.slope_ratio, index, load].map(short).to_vec();
        row.extend([bem.surfaces.to_string(), bem.patches.round().to_string()]);
        row.push(short((1e3 * bem.plastic_share).round() / 1e3));
        for [mean, error] in bem.numbers {
            row.extend([short(mean), shorter(error)]);
        }
        // Models are relative to the numbers in the row, so that it can be written again from
        // itself.
        let in_row = bem.numbers.map(|[mean, _]| short(mean).parse().unwrap_or(mean));
        for contact in &contacts.models {
            let found = match contact {
                Some(contact) => contacts.numbers(contact.as_ref(), load)?,
                None => [None; 4],
            };
            for ((quantity, found), bem) in Compared::ALL.iter().zip(found).zip(in_row) {
                let relative = found.map(|found| Evidence::relative(*quantity, found, bem));
                row.push(relative.map_or_else(String::new, |x| x.round().to_string()));
            }
        }
        self.text += &(row.join(",") + "\n");
        self.contacts = Some((key, contacts));
        Ok(())
    }
}

/// The evidence of a scope from the kept cases, as csv; cases with fewer surfaces than required are
/// left out.
///
/// # Errors
/// A model that fails.
pub fn evidence(scope: &Scope, kept: &Kept) -> Result<String> {
    let mut text = Text::new();
    for case in scope.cases()? {
        let seeds = kept.seeds(&case);
        if let Some(known) = kept.row(&case) {
            text.push(&case, &Bem::of_row(known)?)?;
        } else if seeds.len() as u64 >= case.seeds[0] {
            text.push(&case, &Bem::of_seeds(&seeds))?;
        }
    }
    Ok(text.text)
}

#[cfg(test)]
mod tests {
    use super::super::family::FAMILIES;
    use super::*;

    #[test]
    fn a_row_is_written_again_from_itself() -> Result<()> {
        let contact = |area: f64| kept::Contact {
            load: 0.03,
            area,
            gap: 0.123_456_7 / area,
            stiffness: 9.876_543 * area,
            unloading_stiffness: 11.222_222 * area,
            patches: 40.0,
            ..kept::Contact::default()
        };
        let case = Case { family: FAMILIES[0], index: 2.0, load: 0.03, seeds: [2, 2] };
        let mut text = Text::new();
        let mut written = |bem: &Bem| -> Result<String> {
            text.push(&case, bem)?;
            Ok(text.text.lines().last().unwrap_or_default().to_owned())
        };
        let head = Text::new().text;
        // Of some of these pairs the mean is far from its four digits.
        for third in 0..8 {
            let area = 0.100_04 + 1e-5 * f64::from(third);
            let row = written(&Bem::of_seeds(&[contact(area), contact(area + 1e-5)]))?;
            let read = Evidence::parse(&format!("{head}{row}\n"))?;
            assert_eq!(written(&Bem::of_row(&read.cases()[0])?)?, row);
        }
        Ok(())
    }
}
