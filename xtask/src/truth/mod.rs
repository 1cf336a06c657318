//! `cargo xtask truth`: every model compared with boundary elements on reproducible surfaces.
//!
//! Random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are solved elastically and
//! with several hardnesses, and kept under target/truth. The results are in
//! `crates/asperity/data/truth.csv`, which `asperity::Evidence` reads; the figures and the table of
//! the README follow from that text alone.

mod markdown;
mod picture;
pub mod plan;
pub mod solved;

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use asperity::bem::RandomSurface;
use asperity::{
    At, Compared, Contact, ContactError, ContactModel, Datum, Evidence, EvidenceCase, Model,
    Persson, PerssonVariance, Quantity, Request, SeparationUnit,
};
use indicatif::{ProgressBar, ProgressStyle};

pub use markdown::table as markdown;
pub use picture::{Shown, style, table};
pub use plan::{FULL, QUICK, SMALL, Scope};

use crate::folder::{figures_folder, save};
use solved::{Family, GRADIENT, Kept, MODULUS};

/// The committed evidence, in the crate that includes it.
#[must_use]
pub fn evidence_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("crates/asperity/data/truth.csv")
}

/// The folder of solved cases.
#[must_use]
pub fn kept_folder() -> PathBuf {
    figures_folder().with_file_name("target").join("truth")
}

/// Solves the cases that are not kept, or none of them, and writes the evidence and its figures;
/// returns the paths.
///
/// # Errors
/// A case that cannot be solved, a file that cannot be written.
pub fn write(figures: &Path, solve_missing: bool, anew: bool) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let mut kept = Kept::in_folder(&kept_folder())?;
    if !anew {
        kept = kept.with_rows(&Evidence::parse(&committed()?)?)?;
    }
    if solve_missing {
        solve(&FULL, &kept)?;
    }
    let mut paths = save(folder, [("truth.csv".to_owned(), evidence(&FULL, &kept)?)])?;
    paths.extend(draw(figures)?);
    Ok(paths)
}

/// Solves a sketch in two minutes and writes its evidence and table to target/truth-quick.
///
/// # Errors
/// Those of [`write()`].
pub fn write_quick() -> Result<Vec<PathBuf>> {
    let folder = kept_folder().with_file_name("truth-quick");
    let kept = Kept::in_folder(&folder.join("kept"))?.most_seeds(QUICK.most_seeds);
    solve(&QUICK, &kept)?;
    let text = evidence(&QUICK, &kept)?;
    let table = markdown(&text)?;
    save(&folder, [("truth.csv".to_owned(), text), ("truth.md".to_owned(), table)])
}

/// Solves the small case for the tests; returns its path.
///
/// # Errors
/// Those of [`write()`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    let folder = figures_folder().with_file_name("tests").join("reference");
    save(&folder, [("truth_small.csv".to_owned(), small()?)])
}

/// The small case as csv, solved anew.
///
/// # Errors
/// Those of [`write()`].
pub fn small() -> Result<String> {
    let folder = tempfile::tempdir()?;
    let kept = Kept::in_folder(folder.path())?.most_seeds(SMALL.most_seeds);
    solve(&SMALL, &kept)?;
    evidence(&SMALL, &kept)
}

/// Evaluates the models of the committed evidence anew, keeps its boundary elements, and draws it.
///
/// # Errors
/// Evidence that is missing or cannot be read.
pub fn update_models(figures: &Path) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let text = asked_anew(&committed()?, &FULL)?;
    let mut paths = save(folder, [("truth.csv".to_owned(), text)])?;
    paths.extend(draw(figures)?);
    Ok(paths)
}

fn committed() -> Result<String> {
    let path = evidence_file();
    std::fs::read_to_string(&path).with_context(|| path.display().to_string())
}

fn draw(figures: &Path) -> Result<Vec<PathBuf>> {
    let text = committed()?;
    let mut drawn = vec![("truth.md".to_owned(), markdown(&text)?)];
    for shown in Shown::ALL {
        let csv = table(&text, shown)?.into_text();
        let svg = asperity_plot::draw(&style(&csv, shown)?, &csv)?;
        drawn.extend([
            (format!("{}.csv", shown.name()), csv),
            (format!("{}.svg", shown.name()), svg),
        ]);
    }
    save(figures, drawn)
}

/// The models that are compared with boundary elements. Persson's spectrum is a power law, as that
/// of the solved surfaces beyond their roll-off.
#[must_use]
pub fn models() -> Vec<Model> {
    let hurst_exponent = Some(RandomSurface::HURST);
    let whole = PerssonVariance::ALL
        .map(|variance| Model::known(Persson { variance, hurst_exponent, spectrum: None }));
    let compared = |model: &Model| COMPARED.contains(&model.id());
    let of_asperities = Model::all().into_iter().chain(Model::all_random());
    of_asperities.filter(compared).chain(whole).collect()
}

/// Models of asperities in the table: each of the paper's once, and four with random asperities.
const COMPARED: [&str; 13] = [
    "gw",
    "ceb",
    "zmc",
    "ke",
    "etsion",
    "jg",
    "af",
    "gao",
    "at",
    "gw-random",
    "zmc-random",
    "ke-random",
    "jg-random",
];

/// A case: family, plasticity index, load.
type Case = (&'static Family, f64, f64);

/// The cases of a scope whose load is carried, in the order of the table.
fn cases(scope: &Scope) -> Result<Vec<Case>> {
    let mut all: Vec<Case> = vec![];
    for part in scope.parts {
        for family in part.families {
            let surface = family.surface(family.pixels)?;
            for &index in part.indices {
                let hardness = solved::scene(&surface, index)?.interface.hardness;
                let carried = part.loads.iter().filter(|load| solved::is_carried(hardness, **load));
                all.extend(carried.map(|load| (family, index, *load)));
            }
        }
    }
    let place = |(family, ..): &Case| solved::FAMILIES.iter().position(|f| f == *family);
    all.sort_by(|a, b| place(a).cmp(&place(b)).then(a.1.total_cmp(&b.1)).then(a.2.total_cmp(&b.2)));
    Ok(all)
}

/// Solves what is not kept, with the progress and the time left.
fn solve(scope: &Scope, kept: &Kept) -> Result<()> {
    let cases = cases(scope)?;
    let done = || cases.iter().filter(|(f, index, load)| kept.is_done(f, *index, *load)).count();
    let bar = ProgressBar::new(cases.len() as u64);
    bar.set_style(ProgressStyle::with_template("{wide_bar} {pos}/{len} cases, {eta} left, {msg}")?);
    let (before, start) = (done(), Instant::now());
    bar.set_position(before as u64);
    for part in scope.parts {
        for family in part.families {
            kept.solve(family, part.indices, part.loads, |surface| {
                let done = done();
                bar.set_position(done as u64);
                bar.set_message(surface.to_owned());
                if bar.is_hidden() {
                    let left = match done - before.min(done) {
                        0 => String::new(),
                        new => {
                            let each = start.elapsed().as_secs_f64() / new as f64;
                            let left = Duration::from_secs_f64(each * (cases.len() - done) as f64);
                            format!(", about {} s left", left.as_secs())
                        }
                    };
                    eprintln!("{done} of {} cases{left}: {surface}", cases.len());
                }
            })?;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

/// Mean and standard error of the surfaces, in the order of [`Compared::ALL`].
struct Bem {
    surfaces: usize,
    patches: f64,
    plastic_share: f64,
    numbers: [[f64; 2]; 4],
}

impl Bem {
    fn of_seeds(all: &[solved::Contact]) -> Self {
        let count = all.len() as f64;
        let mean = |of: &dyn Fn(&solved::Contact) -> f64| all.iter().map(of).sum::<f64>() / count;
        let number = |of: fn(&solved::Contact) -> f64| {
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
struct Asked {
    models: Vec<Option<Box<dyn Contact>>>,
    /// Sq \[m\].
    sq: f64,
}

impl Asked {
    /// All models; `None` for those that the scene does not allow. Larger surfaces of a family have
    /// the same moments within some per cent, and models the same ratios within one.
    fn new(family: &Family, index: f64) -> Result<Self> {
        let surface = family.surface(family.pixels)?;
        let scene = solved::scene(&surface, index)?;
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
    let four: f64 = format!("{number:.3e}").parse().unwrap_or(number);
    match four.abs() {
        small if small > 0.0 && small < 1e-3 => format!("{four:e}"),
        _ => four.to_string(),
    }
}

/// Rows of evidence, case by case.
struct Text {
    text: String,
    asked: Option<((&'static str, u64), Asked)>,
}

impl Text {
    fn new() -> Self {
        let mut head: Vec<String> = Evidence::COLUMNS.map(Into::into).to_vec();
        for model in models() {
            let id = model.id().to_string();
            head.push(id.clone());
            head.extend(["stiffness", "unloading", "gap"].map(|what| format!("{id}_{what}")));
        }
        Self { text: head.join(",") + "\n", asked: None }
    }

    fn push(&mut self, (family, index, load): Case, bem: &Bem) -> Result<()> {
        let key = (family.name, index.to_bits());
        let asked = match self.asked.take() {
            Some((known, asked)) if known == key => asked,
            _ => Asked::new(family, index)?,
        };
        let alpha = family.surface(family.pixels)?.moments().bandwidth();
        let mut row: Vec<String> =
            [alpha, family.skewness, family.slope_ratio, index, load].map(short).to_vec();
        row.extend([bem.surfaces.to_string(), bem.patches.round().to_string()]);
        row.push(short((1e3 * bem.plastic_share).round() / 1e3));
        row.extend(bem.numbers.iter().flatten().map(|number| short(*number)));
        for contact in &asked.models {
            let found = match contact {
                Some(contact) => asked.numbers(contact.as_ref(), load)?,
                None => [None; 4],
            };
            for ((quantity, found), [bem, _]) in Compared::ALL.iter().zip(found).zip(bem.numbers) {
                let relative = found.map(|found| Evidence::relative(*quantity, found, bem));
                row.push(relative.map_or_else(String::new, |x| x.round().to_string()));
            }
        }
        self.text += &(row.join(",") + "\n");
        self.asked = Some((key, asked));
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
    for case in cases(scope)? {
        let seeds = kept.seeds(case.0, case.1, case.2);
        if let Some(known) = kept.row(case.0, case.1, case.2) {
            text.push(case, &Bem::of_row(known)?)?;
        } else if seeds.len() as u64 >= solved::LEAST_SEEDS.min(scope.most_seeds) {
            text.push(case, &Bem::of_seeds(&seeds))?;
        }
    }
    Ok(text.text)
}

/// The same evidence with the models evaluated anew and its boundary elements unchanged.
///
/// # Errors
/// A text that is not the evidence of these surfaces.
pub fn asked_anew(text: &str, scope: &Scope) -> Result<String> {
    let mut anew = Text::new();
    let all = cases(scope)?;
    for known in Evidence::parse(text)?.cases() {
        let same = |case: &&Case| -> bool {
            let (family, index, load) = **case;
            let alpha = family.surface(family.pixels).map(|s| s.moments().bandwidth());
            let place = [index, load, family.skewness, family.slope_ratio];
            let known_place =
                [known.plasticity_index, known.load, known.skewness, known.slope_ratio];
            let equal = |(a, b): (&f64, &f64)| a.total_cmp(b).is_eq();
            place.iter().zip(&known_place).all(equal)
                && alpha.is_ok_and(|alpha| (alpha / known.alpha - 1.0).abs() < 1e-3)
        };
        let case = all.iter().find(same).context("a case of another scope")?;
        anew.push(*case, &Bem::of_row(known)?)?;
    }
    Ok(anew.text)
}

#[cfg(test)]
mod tests {
    use super::solved::{FAMILIES, scene};
    use super::*;

    #[test]
    fn surfaces_and_materials_have_the_moments_of_the_evidence() -> Result<()> {
        // Sums of C q² and C q⁴ over the waves of each spectrum, computed by another program: the
        // evidence was made by the functions under test.
        for (family, alpha) in FAMILIES.iter().zip([7.5, 3.0, 29.0, 77.0]) {
            for pixels in [family.pixels, 1024] {
                let found = family.surface(pixels)?.moments().bandwidth();
                assert!((found / alpha - 1.0).abs() < 0.1, "{} {found}", family.name);
            }
        }
        for index in [0.7, 2.0, 8.0] {
            let found = scene(&FAMILIES[0].surface(512)?, index)?.plasticity_index()?;
            assert!((found / index - 1.0).abs() < 1e-12, "{found}");
        }
        Ok(())
    }
}
