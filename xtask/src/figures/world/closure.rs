//! Closure of three fractures: models fitted to loading, and unloading that they predict, beside
//! the measured one.

use anyhow::{Context, Error, Result};
use asperity::joints::{Unloading, UnloadingLaw};
use asperity::{
    At, Body, ContactError, Interface, Model, Quantity, Scene, Separation, Surface, Tolerance,
    linspace,
};
use asperity_plot::{Axis, Curve, Figure};

use super::rows;
use crate::figures::models::{TOLERANCE, beside, named, of, panel, solve};
use crate::table::Table;

/// The specimens.
pub const SPECIMENS: [u32; 3] = [1, 2, 3];
/// The models that are fitted, with assumed hardnesses \[Pa\], which GW ignores.
pub const MODELS: [(&str, f64); 3] = [(ELASTIC, 1e9), ("ke", 1e9), ("ke", 3e8)];
const ELASTIC: &str = "gw";
/// Pressure at which curves of unloading end \[Pa\].
const LOWEST: f64 = 1e5;
/// The file of the fits.
pub const FITS: &str = "closure-fits.csv";
/// Its columns.
pub const FIT_COLUMNS: &str = "specimen,model,hardness_Pa,rms,\
    asperity_height_std_m,asperity_height_std_lower_m,asperity_height_std_upper_m,\
    asperity_density_per_m2,asperity_density_lower_per_m2,asperity_density_upper_per_m2,\
    separation_offset_m,separation_offset_lower_m,separation_offset_upper_m";
/// E of the rock \[Pa\], measured; Poisson's ratio is assumed.
const ROCK: (f64, f64) = (11e9, 0.25);
/// Assumed \[m\]: loading determines η √R only.
const RADIUS: f64 = 1e-3;
/// The specimens' diameter \[m\].
const DIAMETER: f64 = 0.122;
const LAWS: [(&str, usize); 3] = [("hertz", 2), ("brake", 4), ("etsion", 1)];
const MEASURED: [&str; 2] = ["measured loading", "measured unloading"];
const LOADING: &str = "loading";

/// A row of [`FITS`]: specimen, model, hardness, rms, and three parameters with their ends.
type Fitted = (u32, String, f64, f64, [Option<f64>; 9]);

/// The scene of a fracture.
///
/// # Errors
/// A number that is out of range.
pub fn scene(hardness: f64, height_std: f64, density: f64) -> Result<Scene, ContactError> {
    let rock = Body::new(ROCK.0, ROCK.1, hardness);
    let area = 0.25 * std::f64::consts::PI * DIAMETER * DIAMETER;
    let surface = Surface::new(RADIUS, density, height_std);
    Ok(Scene::new(Interface::between(&rock, &rock)?, surface, area))
}

/// Readings of a specimen: minus the closure \[m\], and the pressure \[Pa\].
fn readings(specimen: u32) -> Result<Vec<[f64; 2]>> {
    let all: Vec<(u32, f64, f64)> = rows("closure.csv")?;
    let own = all.into_iter().filter(|row| row.0 == specimen);
    Ok(own.map(|(_, closure, pressure)| [-1e-3 * closure, 1e6 * pressure]).collect())
}

/// The place of the highest pressure.
fn turn(readings: &[[f64; 2]]) -> usize {
    let highest = readings.iter().enumerate().max_by(|a, b| a.1[1].total_cmp(&b.1[1]));
    highest.map_or(0, |(place, _)| place)
}

/// The readings of loading.
///
/// # Errors
/// A file that cannot be read.
pub fn loading(specimen: u32) -> Result<Vec<[f64; 2]>> {
    let mut readings = readings(specimen)?;
    readings.truncate(turn(&readings) + 1);
    Ok(readings)
}

/// Measured readings, the fitted loading of KE with the lower hardness, and what three laws predict
/// for unloading from its highest pressure.
///
/// # Errors
/// A file that cannot be read, a model that fails.
pub fn table() -> Result<Table> {
    let mut table = Table::new(&["case", "curve", "closure_m", "pressure_Pa"]);
    let fits: Vec<Fitted> = rows(FITS)?;
    for fit in fits.iter().filter(|fit| fit.1 != ELASTIC) {
        let key = case(fit.0, fit.2);
        let readings = readings(fit.0)?;
        let turn = turn(&readings);
        for (k, [minus, pressure]) in readings.iter().enumerate() {
            table.push(&[&key, MEASURED[usize::from(k > turn)]], [-minus, *pressure])?;
        }
        let fitted = |k: usize| fit.4[3 * k].context("a fitted value");
        let (scene, offset) = (scene(fit.2, fitted(0)?, fitted(1)?)?, fitted(2)?);
        let (last, highest) = (readings[turn][0].abs(), readings[turn][1]);
        let closures = linspace(0.0, last, 61);
        let places = closures.iter().map(|closure| Separation::metres(-closure - offset));
        let forces = solve(&fit.1, &scene, &[Quantity::Force], places)?;
        for (closure, force) in closures.iter().zip(forces.values(Quantity::Force)?) {
            table.push(&[&key, LOADING], [*closure, force / scene.nominal_area])?;
        }
        let model: Model = fit.1.parse()?;
        for (name, _) in LAWS {
            let law: UnloadingLaw = name.parse().map_err(Error::msg)?;
            let (at, tolerance) = (At::Pressure(highest), Tolerance::new(TOLERANCE)?);
            let unloading = Unloading::new(&model, &scene, at, law, tolerance)?;
            for retreat in linspace(0.0, last, 121) {
                let pressure = unloading.force(retreat)?.value() / scene.nominal_area;
                if pressure >= LOWEST {
                    table.push(&[&key, name], [last - retreat, pressure])?;
                }
            }
        }
    }
    Ok(table)
}

/// A panel for each specimen and hardness.
///
/// # Errors
/// None.
pub fn style(_: &str) -> Result<Figure> {
    let mut curves = vec![
        Curve::points(0, MEASURED[0], MEASURED[0]),
        Curve::points(3, MEASURED[1], MEASURED[1]),
    ];
    curves.push(Curve::new(8, LOADING, "KE fitted to loading"));
    curves.extend(named(&LAWS));
    let hardnesses = MODELS.iter().filter(|model| model.0 != ELASTIC).map(|model| model.1);
    let cases = hardnesses.flat_map(|hardness| SPECIMENS.map(|specimen| case(specimen, hardness)));
    let panels = cases.map(|case| {
        let x = Axis::new("closure_m", "closure (µm)").times(1e6);
        let y = Axis::new("pressure_Pa", "pressure (MPa)").times(1e-6).log();
        of("case", &case, &case, panel(&x, y, &curves))
    });
    Ok(beside(3, panels.collect::<Vec<_>>()))
}

/// The name of a panel.
fn case(specimen: u32, hardness: f64) -> String {
    format!("specimen {specimen}; {} GPa", hardness / 1e9)
}
