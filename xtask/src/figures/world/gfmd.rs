//! Area and mean gap of elastic surfaces beside Green's function molecular dynamics, and the
//! density of pressures beside the Contact Mechanics Challenge.

use anyhow::{Context, Result};
use asperity::{
    At, ContactModel, Datum, Interface, Model, Persson, ProfileMoments, Quantity, Request, Scene,
    SeparationUnit, Surface, Tolerance,
};
use asperity_plot::{Axis, Curve, Figure, Mark};

use super::rows;
use crate::figures::compared::equal;
use crate::figures::models::{self, TOLERANCE, beside, named, of, panel};
use crate::table::Table;

/// The ratio of the longest to the shortest wave.
pub const RATIO: f64 = 100.0;
/// The root mean square gradient.
pub const GRADIENT: f64 = 0.2766;
/// The Hurst exponent.
const HURST: f64 = 0.8;
/// Sums over its spectrum: h_rms = 6 µm, waves from 1e4 to 1e6 1/m.
const MOMENTS: ProfileMoments = ProfileMoments { m0: 3.6e-11, m2: 0.038_253_06, m4: 5.682e9 };
/// Panels of the csv.
pub(super) const PANELS: [&str; 3] = ["area", "gap", "pressure"];
/// The models drawn.
const MODELS: [&str; 4] = ["gw", "gw-random", "persson", "persson-fudge"];
/// Our own solutions, with their looks.
const OURS: [(&str, usize); 2] = [(PIXELS, 6), (BEM, 4)];
const BEM: &str = "bem";
const THEIRS: &str = "simulated";
const PIXELS: &str = "bem-pixels";
/// Mean gaps are drawn up to this p/(E g): the surfaces of a model of asperities overlap beyond.
const HEAVIEST: f64 = 0.4;

/// The columns of our own solutions: areas as estimated from the edges of patches, and as counted
/// in pixels.
pub const SOLVED: [&str; 5] =
    ["seed", "p_over_E", "area_fraction", "area_fraction_pixels", "mean_gap_over_h_rms"];

/// A simulated contact: p/E, area fraction, its standard deviation, mean gap over h_rms, and half
/// of a bin of that.
type Simulated = (f64, f64, f64, Option<f64>, Option<f64>);

/// The simulated pressures over E.
///
/// # Errors
/// A file that cannot be read.
pub fn pressures() -> Result<Vec<f64>> {
    Ok(rows::<Simulated>("gfmd.csv")?.into_iter().map(|row| row.0).collect())
}

/// Area fraction and mean gap over h_rms of a model, the latter as far as it has one.
fn predicted(id: &str, p: f64) -> Result<(f64, Option<f64>)> {
    let persson = |variance| {
        Model::new(Persson { variance, hurst_exponent: Some(HURST), ..Persson::default() })
    };
    let model = match Persson::variance_of(id) {
        Some(variance) => persson(variance),
        None => id.parse()?,
    };
    // The modulus and the area are 1.
    let scene = Scene::new(Interface::elastic(1.0, 0.0), Surface::from_moments(&MOMENTS)?, 1.0);
    let request =
        Request::new([Quantity::Force, Quantity::Area]).within(Tolerance::new(TOLERANCE)?);
    let contact = model.compile(&scene, &request)?;
    let area = contact.evaluate(Quantity::Area, At::Load(p))?.value();
    let separation = contact.separations_at(p).ok().and_then(|found| found.last().copied());
    let gap = separation
        .map(|s| s.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, &scene))
        .transpose()?;
    Ok((area, gap.map(|gap| gap.value / MOMENTS.m0.sqrt())))
}

/// Ratios of areas and mean gaps to the simulated ones, then densities of pressure.
///
/// # Errors
/// A file that cannot be read, a model that fails.
pub fn table() -> Result<Table> {
    let mut table = Table::new(&["panel", "curve", "x", "value"]);
    let solved: Vec<(u64, [f64; 4])> = rows("bem-area.csv")?;
    let simulated: Vec<Simulated> = rows("gfmd.csv")?;
    for id in MODELS.into_iter().chain([PIXELS, BEM]) {
        let mut gaps = vec![];
        for (p, area, _, gap, _) in &simulated {
            let own = solved.iter().find(|(_, row)| equal(row[0], *p));
            let (_, [_, own_area, own_pixels, own_gap]) = own.context("a solved pressure")?;
            let (own_area, own_gap) = match id {
                BEM => (*own_area, Some(*own_gap)),
                PIXELS => (*own_pixels, None),
                id => predicted(id, *p)?,
            };
            let load = p / GRADIENT;
            table.push(&[PANELS[0], id], [load, own_area / area])?;
            let both = own_gap.zip(*gap).filter(|_| load <= HEAVIEST);
            gaps.extend(both.map(|(own, gap)| [load, own / gap]));
        }
        for row in gaps {
            table.push(&[PANELS[1], id], row)?;
        }
    }
    for (file, key) in [("challenge.csv", THEIRS), ("bem-pressure.csv", BEM)] {
        for row in rows::<[f64; 2]>(file)? {
            table.push(&[PANELS[2], key], row)?;
        }
    }
    Ok(table)
}

/// Three panels.
///
/// # Errors
/// None.
pub fn style(_: &str) -> Result<Figure> {
    let ratio = |key, title, label, range: [f64; 2], curves: &[Curve]| {
        let x = Axis::new("x", "p/(E g)").log();
        let y = Axis::new("value", label).range(range[0], range[1]);
        let mut panel = of("panel", key, title, panel(&x, y, curves));
        panel.horizontals = vec![Mark::new(1.0, "")];
        panel
    };
    let curves = [models::curves(&MODELS)?, named(&OURS)].concat();
    let shown: Vec<Curve> = curves.iter().filter(|curve| curve.key != PIXELS).cloned().collect();
    let area = ratio(PANELS[0], "real area", "area/GFMD", [0.4, 1.2], &curves);
    let gap = ratio(PANELS[1], "mean gap", "mean gap/GFMD", [0.4, 1.8], &shown);
    let (x, y) = (Axis::new("x", "pressure/E"), Axis::new("value", "density of pressure/E"));
    let theirs = Curve::points(8, THEIRS, "Contact Mechanics Challenge, digitised");
    let density = panel(&x, y, &[curves[5].clone(), theirs]);
    Ok(beside(3, [area, gap, of("panel", PANELS[2], "pressures", density)]))
}
