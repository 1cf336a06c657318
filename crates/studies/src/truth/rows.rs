//! Rows of the evidence: boundary elements averaged over surfaces, and the models beside them.

use anyhow::{Result, bail};
use asperity::{
    At, Compared, Contact, ContactError, ContactModel, Evidence, EvidenceCase, Model, Quantity,
    Request, Scene,
};

use super::family::{FAMILIES, pressure, scene, unit};
use super::kept::{self, Kept};
use super::plan::{Case, Scope, cases};
use xtask::figures::compared::{equal, models};

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
    fn of_row(known: &EvidenceCase) -> Option<Self> {
        let mut numbers = [[0.0; 2]; 4];
        for (number, quantity) in numbers.iter_mut().zip(Compared::ALL) {
            *number = [known.bem.value(quantity)?, known.bem.error(quantity)?];
        }
        let (patches, plastic_share) = (known.patches as f64, known.plastic_share);
        Some(Self { surfaces: known.surfaces, patches, plastic_share, numbers })
    }

    /// Of a case, unless fewer surfaces than required are kept.
    fn of(case: &Case, kept: &Kept) -> Option<Self> {
        if let Some(known) = kept.row(case) {
            return Self::of_row(known);
        }
        let seeds = kept.seeds(case);
        (seeds.len() as u64 >= case.seeds[0]).then(|| Self::of_seeds(&seeds))
    }
}

/// The lines of cases of one family and material, with all models; those that the scene does not
/// allow are blank. Larger surfaces of a family have the same moments within some per cent, and
/// models the same ratios within one.
fn lines(rows: &[(Case, Bem)]) -> Result<String> {
    let Some((Case { family, index, .. }, _)) = rows.first() else { return Ok(String::new()) };
    let surface = family.surface(family.pixels)?;
    let (scene, moments) = (scene(&surface, *index)?, surface.moments());
    let contacts: Vec<_> = models().iter().map(|model| compiled(model, &scene)).collect();
    let four = |number| short(number, 3);
    let mut text = String::new();
    for (case, bem) in rows {
        let shape = [moments.bandwidth(), family.skewness, family.slope_ratio];
        let mut row: Vec<String> =
            shape.into_iter().chain([case.index, case.load]).map(four).collect();
        row.extend([bem.surfaces.to_string(), bem.patches.round().to_string()]);
        row.push(four((1e3 * bem.plastic_share).round() / 1e3));
        for [mean, error] in bem.numbers {
            row.extend([four(mean), short(error, 1)]);
        }
        // Models are relative to the numbers in the line, which can be written again from itself.
        let in_row = bem.numbers.map(|[mean, _]| four(mean).parse().unwrap_or(mean));
        for contact in &contacts {
            for (quantity, bem) in Compared::ALL.into_iter().zip(in_row) {
                let found = match contact {
                    Some(contact) => {
                        value(quantity, contact.as_ref(), case.load, moments.m0.sqrt())?
                    }
                    None => None,
                };
                let relative = found.map(|found| Evidence::relative(quantity, found, bem).round());
                row.push(relative.map_or_else(String::new, |x| x.to_string()));
            }
        }
        text += &(row.join(",") + "\n");
    }
    Ok(text)
}

/// A quantity of a model, over its unit on a surface of this Sq; `None` where it has none.
fn value(quantity: Compared, contact: &dyn Contact, load: f64, sq: f64) -> Result<Option<f64>> {
    use ContactError::{Integral, NotRequested, Unsupported};
    match quantity.of_contact(contact, pressure(load)) {
        Ok(found) => Ok(Some(found / unit(quantity, contact.scene(), sq))),
        // Gao and AT miss their tolerance at some loads, and have no contact radii.
        Err(Integral { .. } | NotRequested { .. } | Unsupported { .. }) => Ok(None),
        Err(_) if quantity == Compared::MeanGap => Ok(None),
        Err(error) => bail!("{} at p/(E g) = {load}: {error}", contact.model()),
    }
}

/// A model compiled for what is compared; some have no contact radii, and no unloading stiffness.
fn compiled(model: &Model, scene: &Scene) -> Option<Box<dyn Contact>> {
    let all = [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness];
    [&all[..], &all[..2]].iter().find_map(|known| {
        let request = Request::new(known.iter().copied()).at([At::Pressure(1.0)]);
        model.compile(scene, &request).ok()
    })
}

/// A number with so many decimals of its first digit.
fn short(number: f64, decimals: usize) -> String {
    let number: f64 = format!("{number:.decimals$e}").parse().unwrap_or(number);
    match number.abs() {
        small if small > 0.0 && small < 1e-3 => format!("{number:e}"),
        _ => number.to_string(),
    }
}

/// The head of the evidence.
fn head() -> String {
    let mut head: Vec<String> = Evidence::COLUMNS.split(',').map(Into::into).collect();
    for model in models() {
        head.extend(
            ["", "_stiffness", "_unloading", "_gap"].map(|end| format!("{}{end}", model.id())),
        );
    }
    head.join(",") + "\n"
}

/// The evidence of a scope from the kept cases, as csv; cases with fewer surfaces than required are
/// left out.
///
/// # Errors
/// A model that fails.
pub fn evidence(scope: Scope, kept: &Kept) -> Result<String> {
    let (mut text, mut all) = (head(), cases(scope)?);
    let place = |case: &Case| FAMILIES.iter().position(|family| *family == case.family);
    all.sort_by(|a, b| {
        let index = a.index.total_cmp(&b.index);
        place(a).cmp(&place(b)).then(index).then(a.load.total_cmp(&b.load))
    });
    for group in all.chunk_by(|a, b| a.family == b.family && equal(a.index, b.index)) {
        let rows = group.iter().filter_map(|case| Some((*case, Bem::of(case, kept)?)));
        text += &lines(&rows.collect::<Vec<_>>())?;
    }
    Ok(text)
}
