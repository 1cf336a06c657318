//! Boundary elements on random surfaces, kept by surface, material and load.
//!
//! Numbers are dimensionless: areas over the nominal one, gaps over Sq, stiffnesses -dp/d(gap)
//! Sq/E. Light loads are solved on large surfaces with the highest pixels as unknowns.

use std::fs;
use std::io::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, anyhow, bail};
use asperity::bem::{BemError, BoundaryElements, HeightMap, LoadCase, RandomSurface, Solution};
use asperity::{Evidence, EvidenceCase, Interface, Scene, Surface};

/// Pixels per shortest wave.
pub const PIXELS_PER_WAVE: f64 = 8.0;
/// Root mean square gradient. E g is the unit of pressures, so that neither E nor g changes a
/// result.
pub const GRADIENT: f64 = 0.05;
/// E \[Pa\].
pub const MODULUS: f64 = 1e11;
const POISSON: f64 = 0.3;
/// Patches of fewer pixels do not count.
const LEAST_PATCH: usize = 12;
/// Patches behind a row, if the most seeds give as many.
const ENOUGH_PATCHES: usize = 200;
/// Above this share of the area patches merge, and their number tells nothing.
const MERGED: f64 = 0.05;
/// Number of seeds behind every row.
pub const LEAST_SEEDS: u64 = 4;
/// Most seeds of a case.
pub const MOST_SEEDS: u64 = 16;
/// Most seeds of a case under a light load, which costs little.
pub const MOST_LIGHT_SEEDS: u64 = 64;
/// Loads to this p/(E g) are solved with the highest pixels as unknowns.
const LIGHT: f64 = 3e-4;
/// Stiffnesses of first loading are differences between pressures this share to either side.
const STEP: f64 = 0.05;
/// Heavier ones are iterated to this residual, which leaves 1e-4 in differences of gaps.
const HEAVY_TOLERANCE: f64 = 1e-6;
/// Loads above this share of the hardness are left out.
const MOST_OF_HARDNESS: f64 = 0.7;

/// Pressures over E g.
pub const LOADS: [f64; 10] = [1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3];

/// Surfaces with the same moments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Family {
    /// Name of its files.
    pub name: &'static str,
    /// The longest waves and the roll-off in waves on 512 pixels.
    pub waves: [f64; 2],
    /// Of the heights.
    pub skewness: f64,
    /// Slope across the lay over that along it; the lay is along the rows.
    pub slope_ratio: f64,
    /// Pixels per side under loads that are not light.
    pub pixels: usize,
    /// Pixels per side under the lightest loads: the most asperities for their cost.
    pub most_pixels: usize,
}

const ISOTROPIC: Family = Family {
    name: "a8",
    waves: [4.0, 8.0],
    skewness: 0.0,
    slope_ratio: 1.0,
    pixels: 512,
    most_pixels: 2048,
};
/// Skewed surfaces take ten times as long to make.
const SKEWED: Family = Family { most_pixels: 1024, ..ISOTROPIC };

/// Every family of the evidence: bandwidths, skewnesses, lays.
pub const FAMILIES: [Family; 10] = [
    ISOTROPIC,
    Family { name: "a3", waves: [14.0, 14.0], pixels: 256, ..ISOTROPIC },
    Family { name: "a30", waves: [2.0, 2.4], ..ISOTROPIC },
    Family { name: "a100", waves: [1.0, 1.2], pixels: 1024, ..ISOTROPIC },
    Family { name: "a8-skew-1", skewness: -1.0, ..SKEWED },
    Family { name: "a8-skew-2", skewness: -2.0, ..SKEWED },
    Family { name: "a8-skew+1", skewness: 1.0, ..SKEWED },
    Family { name: "a8-lay2", slope_ratio: 2.0, ..SKEWED },
    Family { name: "a8-lay4", slope_ratio: 4.0, pixels: 1024, ..SKEWED },
    Family { name: "a8-lay8", slope_ratio: 8.0, pixels: 1024, ..SKEWED },
];

impl Family {
    /// Pixels per side for a load.
    #[must_use]
    pub fn pixels_for(&self, load: f64) -> usize {
        match load {
            light if light < 0.5 * LIGHT => self.most_pixels,
            light if light <= LIGHT => 1024,
            _ => self.pixels,
        }
    }

    /// The surface on n x n pixels; a seed determines its heights.
    ///
    /// # Errors
    /// Waves that these pixels cannot carry.
    pub fn surface(&self, pixels: usize) -> Result<RandomSurface> {
        let n = pixels as f64;
        let [longest, roll_off] = self.waves.map(|waves| waves * n / 512.0);
        let surface = RandomSurface::new(longest, roll_off, n / PIXELS_PER_WAVE)?;
        let surface = surface.side(1e-4)?.gradient(GRADIENT)?.lay(self.slope_ratio, 0.0)?;
        Ok(if self.skewness == 0.0 { surface } else { surface.skewness(self.skewness)? })
    }
}

/// The scene of a surface and a plasticity index, which determines the hardness: steel on steel.
///
/// # Errors
/// Moments of no surface.
pub fn scene(surface: &RandomSurface, index: f64) -> Result<Scene> {
    let mut interface = Interface::elastic(MODULUS, POISSON);
    // Two equal materials.
    interface.equivalent_shear_modulus = Some(MODULUS * (1.0 - POISSON) / (2.0 * (2.0 - POISSON)));
    let surface = Surface::from_moments(&surface.moments())?;
    let mut scene = Scene::new(interface, surface, 1e-8);
    if index > 0.0 {
        // ψ is inversely proportional to the hardness.
        scene.interface.hardness = Some(1e9);
        scene.interface.hardness = Some(1e9 * scene.plasticity_index()? / index);
    }
    Ok(scene)
}

/// The contact of one surface under one load.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Contact {
    /// p/(E g).
    pub load: f64,
    /// Real over nominal area.
    pub area: f64,
    /// Share of the surface at the hardness.
    pub plastic_area: f64,
    /// Mean gap with plastic pixels counted as 0.
    pub gap: f64,
    /// Of first loading.
    pub stiffness: f64,
    /// At the start of unloading.
    pub unloading_stiffness: f64,
    /// Patches of at least 12 pixels.
    pub patches: f64,
    /// Pixels in contact.
    pub pixels: f64,
}

const HEAD: &str = "load,area,plastic_area,gap,stiffness,unloading_stiffness,patches,pixels";

impl Contact {
    fn line(&self) -> String {
        let Self { load, area, plastic_area, gap, stiffness, .. } = self;
        let Self { unloading_stiffness, patches, pixels, .. } = self;
        format!(
            "{load:e},{area:.8e},{plastic_area:.8e},{gap:.8e},{stiffness:.8e},{unloading_stiffness:.8e},{patches},{pixels}"
        )
    }

    fn parse(line: &str) -> Option<Self> {
        let numbers: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        match numbers.ok()?[..] {
            [load, area, plastic_area, gap, stiffness, unloading_stiffness, patches, pixels] => {
                let solid = Self { load, area, plastic_area, gap, stiffness, ..Self::default() };
                Some(Self { unloading_stiffness, patches, pixels, ..solid })
            }
            _ => None,
        }
    }
}

/// Cases in a folder: a file for a surface and a material, a line for a load.
#[derive(Debug, Clone)]
pub struct Kept {
    folder: PathBuf,
    most_seeds: u64,
    /// Rows of an earlier table with the names of their families.
    rows: Vec<(&'static str, EvidenceCase)>,
}

impl Kept {
    /// Cases in this folder, which is made.
    ///
    /// # Errors
    /// A folder that cannot be made.
    pub fn in_folder(folder: &Path) -> Result<Self> {
        fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
        Ok(Self { folder: folder.to_owned(), most_seeds: MOST_LIGHT_SEEDS, rows: vec![] })
    }

    /// Cases that this table holds count as solved.
    ///
    /// # Errors
    /// A family without moments.
    pub fn with_rows(mut self, table: &Evidence) -> Result<Self> {
        for family in &FAMILIES {
            let alpha = family.surface(family.pixels)?.moments().bandwidth();
            let same = |case: &&EvidenceCase| {
                equal(case.skewness, family.skewness)
                    && equal(case.slope_ratio, family.slope_ratio)
                    && (case.alpha / alpha - 1.0).abs() < 1e-3
            };
            self.rows.extend(table.cases().iter().filter(same).cloned().map(|c| (family.name, c)));
        }
        Ok(self)
    }

    /// The row of a case in the earlier table.
    #[must_use]
    pub fn row(&self, family: &Family, index: f64, load: f64) -> Option<&EvidenceCase> {
        let same = |(name, case): &&(&str, EvidenceCase)| {
            *name == family.name && equal(case.plasticity_index, index) && equal(case.load, load)
        };
        self.rows.iter().find(same).map(|(_, case)| case)
    }

    /// At most this many surfaces for a case.
    #[must_use]
    pub fn most_seeds(mut self, most_seeds: u64) -> Self {
        self.most_seeds = most_seeds;
        self
    }

    fn path(&self, family: &Family, pixels: usize, index: f64, seed: u64) -> PathBuf {
        self.folder.join(format!("{}-{pixels}-psi{index}-seed{seed}.csv", family.name))
    }

    /// The contacts of a surface and a material that are kept.
    #[must_use]
    pub fn contacts(&self, family: &Family, pixels: usize, index: f64, seed: u64) -> Vec<Contact> {
        let text = fs::read_to_string(self.path(family, pixels, index, seed)).unwrap_or_default();
        text.lines().filter_map(Contact::parse).collect()
    }

    /// The contacts of seeds 1, 2, ... under a load, as far as they are kept.
    #[must_use]
    pub fn seeds(&self, family: &Family, index: f64, load: f64) -> Vec<Contact> {
        let pixels = family.pixels_for(load);
        let of = |seed| {
            let all = self.contacts(family, pixels, index, seed);
            all.into_iter().find(|contact| (contact.load / load - 1.0).abs() < 1e-9)
        };
        (1..=self.most_for(load)).map_while(of).collect()
    }

    fn most_for(&self, load: f64) -> u64 {
        let most = if load <= LIGHT { MOST_LIGHT_SEEDS } else { MOST_SEEDS };
        most.min(self.most_seeds)
    }

    /// Whether no more seeds are needed.
    #[must_use]
    pub fn is_done(&self, family: &Family, index: f64, load: f64) -> bool {
        if self.row(family, index, load).is_some() {
            return true;
        }
        let found = self.seeds(family, index, load);
        let patches: f64 = found.iter().map(|contact| contact.patches).sum();
        let count = found.len() as u64;
        let merged = found.iter().all(|contact| contact.area > MERGED);
        count >= self.most_for(load)
            || count >= LEAST_SEEDS && (merged || patches >= ENOUGH_PATCHES as f64)
    }

    fn add(
        &self,
        family: &Family,
        pixels: usize,
        index: f64,
        seed: u64,
        all: &[Contact],
    ) -> Result<()> {
        let path = self.path(family, pixels, index, seed);
        let mut text = fs::read_to_string(&path).unwrap_or_else(|_| format!("{HEAD}\n"));
        all.iter().for_each(|contact| text += &format!("{}\n", contact.line()));
        let mut file = fs::File::create(&path).with_context(|| path.display().to_string())?;
        Ok(file.write_all(text.as_bytes())?)
    }

    /// Solves what a family with these materials still needs; `progress` gets a line for each
    /// surface.
    ///
    /// # Errors
    /// A case that cannot be solved or kept.
    pub fn solve(
        &self,
        family: &Family,
        indices: &[f64],
        loads: &[f64],
        mut progress: impl FnMut(&str),
    ) -> Result<()> {
        let mut sizes: Vec<usize> = loads.iter().map(|load| family.pixels_for(*load)).collect();
        sizes.sort_unstable();
        sizes.dedup();
        for pixels in sizes {
            let surface = family.surface(pixels)?;
            for seed in 1..=self.most_seeds {
                let mut map = None;
                for &index in indices {
                    let hardness = scene(&surface, index)?.interface.hardness;
                    let needed = |load: &&f64| {
                        family.pixels_for(**load) == pixels
                            && self.seeds(family, index, **load).len() as u64 == seed - 1
                            && !self.is_done(family, index, **load)
                    };
                    let loads: Vec<f64> = loads
                        .iter()
                        .filter(|load| is_carried(hardness, **load))
                        .filter(needed)
                        .copied()
                        .collect();
                    if loads.is_empty() {
                        continue;
                    }
                    progress(&format!(
                        "{}, {pixels} pixels, psi {index}, seed {seed}",
                        family.name
                    ));
                    let map: &HeightMap = match &mut map {
                        Some(map) => map,
                        none => none.insert(surface.seed(seed).heights(pixels)?),
                    };
                    let elements = BoundaryElements::new(map.clone(), MODULUS)?;
                    let elements = match hardness {
                        Some(hardness) => elements.hardness(hardness)?,
                        None => elements,
                    };
                    let sq = surface.moments().m0.sqrt();
                    let (light, heavy): (Vec<f64>, Vec<f64>) =
                        loads.iter().partition(|load| **load <= LIGHT);
                    let mut found = light_contacts(&elements, &light, sq)?;
                    found.extend(heavy_contacts(elements, &heavy, sq)?);
                    self.add(family, pixels, index, seed, &found)?;
                }
            }
        }
        Ok(())
    }
}

/// Numbers of the table are equal digit by digit.
fn equal(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

/// Whether a load is well below the hardness.
#[must_use]
pub fn is_carried(hardness: Option<f64>, load: f64) -> bool {
    hardness.is_none_or(|hardness| load * MODULUS * GRADIENT < MOST_OF_HARDNESS * hardness)
}

/// What is kept of a solution: mean gap, then the numbers of a [`Contact`].
struct Solved {
    mean_gap: f64,
    contact: Contact,
}

/// The pressures to solve for each load: for stiffnesses of first loading also to either side;
/// elastic contacts unload as they load.
fn around(elements: &BoundaryElements) -> &'static [f64] {
    match elements.limit() {
        None => &[1.0],
        Some(_) => &[1.0 - STEP, 1.0, 1.0 + STEP],
    }
}

fn pressures(loads: &[f64], around: &[f64]) -> Vec<f64> {
    let of = |load: &f64| around.iter().map(move |k| k * load * MODULUS * GRADIENT).collect();
    loads.iter().flat_map(|load| -> Vec<f64> { of(load) }).collect()
}

fn count_patches(sizes: &[usize]) -> f64 {
    sizes.iter().filter(|size| **size >= LEAST_PATCH).count() as f64
}

/// Contacts with the highest pixels as unknowns.
fn light_contacts(elements: &BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let around = around(elements);
    let solved = match elements.solve_light(&pressures(loads, around)) {
        Err(BemError::NotLight { .. }) => return heavy_contacts(elements.clone(), loads, sq),
        solved => solved?,
    };
    let solved = solved.iter().map(|found| Solved {
        mean_gap: found.mean_gap,
        contact: Contact {
            area: found.area,
            plastic_area: found.plastic_area,
            gap: found.mean_open_gap,
            unloading_stiffness: found.unloading_stiffness,
            patches: count_patches(&found.patches),
            pixels: found.pressures.len() as f64,
            ..Contact::default()
        },
    });
    dimensionless(loads, &solved.collect::<Vec<_>>(), sq)
}

/// Contacts of the whole map.
fn heavy_contacts(elements: BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let around = around(&elements);
    let elements = elements.tolerance(HEAVY_TOLERANCE)?;
    let pressures = pressures(loads, around);
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let of = |found: &Solution, middle: bool| -> Result<Solved> {
        let fixed = if middle { elements.fixed_contact(found)?.stiffness } else { 0.0 };
        let contact = Contact {
            area: found.area,
            plastic_area: found.plastic_area,
            gap: found.mean_open_gap,
            unloading_stiffness: fixed,
            patches: count_patches(&found.patches),
            pixels: found.patches.iter().sum::<usize>() as f64,
            ..Contact::default()
        };
        Ok(Solved { mean_gap: found.mean_gap, contact })
    };
    let mut solved: Vec<Result<Solved>> =
        given.iter().map(|_| Err(anyhow!("a load was not solved"))).collect();
    elements.solve_each(
        &given,
        |_| ControlFlow::Continue(()),
        |at, found| {
            let middle = at % around.len() == around.len() / 2;
            solved[at] = found.map_err(Into::into).and_then(|found| of(&found, middle));
        },
    );
    let solved: Vec<Solved> = solved.into_iter().collect::<Result<_>>()?;
    dimensionless(loads, &solved, sq)
}

/// The contacts of the loads from the solutions around each.
fn dimensionless(loads: &[f64], solved: &[Solved], sq: f64) -> Result<Vec<Contact>> {
    let unit = MODULUS / sq;
    let around = solved.len() / loads.len().max(1);
    let of = |(load, solved): (&f64, &[Solved])| {
        let (stiffness, mut contact) = match solved {
            [here] => (here.contact.unloading_stiffness, here.contact),
            [less, here, more] => {
                let force = 2.0 * STEP * load * MODULUS * GRADIENT;
                (force / (less.mean_gap - more.mean_gap), here.contact)
            }
            _ => bail!("a load was not solved"),
        };
        contact.load = *load;
        contact.gap /= sq;
        contact.stiffness = stiffness / unit;
        contact.unloading_stiffness /= unit;
        Ok(contact)
    };
    loads.iter().zip(solved.chunks(around.max(1))).map(of).collect()
}
