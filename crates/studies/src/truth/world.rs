//! Boundary elements on the spectra of other people's simulations, and fits to other people's
//! measurements: xtask/data/world/bem-*.csv and closure-fits.csv.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::bem::{BoundaryElements, RandomSurface, Solution};
use asperity::fit::{Data, Fit, Parameter};
use asperity::{Datum, Model};

use super::solve::solve_each;
use xtask::figures::world::{closure, folder, gfmd};
use xtask::folder::save;
use xtask::table::Table;

/// Pixels per side.
const PIXELS: usize = 4096;
/// Longest waves on the side of the surface beside GFMD: 8.2 pixels for the shortest wave.
const LONGEST: f64 = 5.0;
/// The surface of each spectrum.
const SEED: u64 = 1;
/// Longest, roll-off and shortest wave of the Contact Mechanics Challenge \[m\].
const CHALLENGE: [f64; 3] = [100e-6, 20e-6, 0.1e-6];
/// Half of the Challenge's side \[m\], which leaves 8.2 pixels for the shortest wave.
const SIDE: f64 = 50e-6;
/// The Challenge's mean pressure over the equivalent modulus; its rms gradient is 1.
const PRESSURE: f64 = 0.01;
/// Width of the bins of pressure over the equivalent modulus.
const BIN: f64 = 0.05;
/// Number of bins.
const BINS: usize = 30;

/// Solves both surfaces, and fits the closures; returns the paths.
///
/// # Errors
/// A contact that cannot be solved, a fit that fails, a file that cannot be written.
pub fn write() -> Result<Vec<PathBuf>> {
    let mut paths = save(&folder(), [(closure::FITS.to_owned(), fits()?.into_text())])?;
    let mut area = Table::new(&gfmd::SOLVED);
    // In waves on the side; the modulus is 1.
    let surface = RandomSurface::new(LONGEST, LONGEST, LONGEST * gfmd::RATIO)?;
    let surface = surface.gradient(gfmd::GRADIENT)?.seed(SEED);
    let sq = surface.moments().m0.sqrt();
    let pressures = gfmd::pressures()?;
    for (p, found) in pressures.iter().zip(solved(&surface, &pressures, of_gap)?) {
        let [fraction, pixels, gap] = found;
        area.push(&[&SEED.to_string()], [*p, fraction, pixels, gap / sq])?;
    }
    let [longest, roll_off, shortest] = CHALLENGE;
    let surface =
        RandomSurface::of_wavelengths([longest.min(SIDE), roll_off, shortest], [SIDE; 2])?
            .gradient(1.0)?
            .seed(SEED);
    let density = solved(&surface, &[PRESSURE], densities)?.pop().context("a density")?;
    let mut table = Table::new(&["p_over_E", "density"]);
    for (k, value) in density.into_iter().enumerate() {
        table.push(&[], [(k as f64 + 0.5) * BIN, value])?;
    }
    let files = [("bem-area.csv", area), ("bem-pressure.csv", table)];
    paths.extend(save(&folder(), files.map(|(name, table)| (name.to_owned(), table.into_text())))?);
    Ok(paths)
}

/// Models fitted to the loading of each specimen, with their 95 % intervals.
fn fits() -> Result<Table> {
    let mut table = Table::new(&closure::FIT_COLUMNS.split(',').collect::<Vec<_>>());
    for specimen in closure::SPECIMENS {
        let loading = closure::loading(specimen)?;
        let columns = [("separation_m", 0), ("pressure_Pa", 1)].map(|(name, k)| {
            (name.to_owned(), loading.iter().map(|row| Some(row[k])).collect::<Vec<_>>())
        });
        let data = Data::from_columns(&columns, Datum::AsperityMean)?;
        for (id, hardness) in closure::MODELS {
            let free = [
                Parameter::new("asperity_height_std", "m", 3e-5, [3e-6, 3e-4], 1e-5)?,
                Parameter::new("asperity_density", "1/m^2", 1e5, [1e3, 1e9], 1e5)?,
                Parameter::new("separation_offset", "m", -1e-4, [-1e-3, 1e-3], 1e-5)?,
            ];
            let scene = |numbers: &[f64]| closure::scene(hardness, numbers[0], numbers[1]);
            let fitted = Fit::new(&data, free.to_vec(), &scene)?.run(&id.parse::<Model>()?)?;
            let rms = fitted.rms.context("a misfit")?;
            let numbers = fitted
                .parameters
                .iter()
                .flat_map(|found| [Some(found.value), found.lower, found.upper]);
            let numbers = [Some(hardness), Some(rms)].into_iter().chain(numbers);
            table.push(&[&specimen.to_string(), id], numbers)?;
        }
    }
    Ok(table)
}

fn of_gap(found: &Solution) -> [f64; 3] {
    [found.area, found.pixel_area, found.mean_gap]
}

/// Shares of the surface by pressure, over the widths of the bins.
fn densities(found: &Solution) -> [f64; BINS] {
    let mut counts = [0.0; BINS];
    for pressure in found.pressures.iter().filter(|p| **p > 0.0) {
        if let Some(count) = counts.get_mut((pressure / BIN) as usize) {
            *count += 1.0 / (BIN * found.pressures.len() as f64);
        }
    }
    counts
}

/// The elastic contact at each pressure; the modulus is 1.
fn solved<T>(
    surface: &RandomSurface,
    pressures: &[f64],
    of: impl Fn(&Solution) -> T,
) -> Result<Vec<T>> {
    let elements = BoundaryElements::new(surface.heights(PIXELS)?, 1.0)?;
    solve_each(&elements, pressures, |at, found| {
        eprintln!("p/E = {}", pressures[at]);
        Ok(of(found))
    })
}
