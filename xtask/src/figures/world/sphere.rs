//! The laws of one asperity beside finite elements: force and area of loading, and the work that
//! unloading returns.

use anyhow::{Error, Result};
use asperity::joints::{UnloadingLaw, restitution};
use asperity::{Asperity, Interface, Model, Quantity, Tolerance};
use asperity_plot::{Axis, Curve, Figure, Mark};
use serde::Deserialize;

use super::rows;
use crate::figures::compared::equal;
use crate::figures::models::{TOLERANCE, beside, curves, geometric, named, of, panel};
use crate::table::Table;

/// The laws, each beside elements without hardening but for the last.
pub const LAWS: [&str; 8] = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af", HARDENING];
const HARDENING: &str = "ghaednia";
/// The law of loading before unloading.
const LOADING: &str = "ke";
const UNLOADING: [(&str, usize); 3] = [("hertz", 2), ("brake", 4), ("etsion", 1)];
const ELEMENTS: &str = "elements";
/// The panels drawn, with this Poisson's ratio.
pub(super) const PANELS: [&str; 3] = ["force", "area", "work"];
const DRAWN_NU: f64 = 0.3;
/// Fewer elements on the contact radius do not resolve the force, and the area.
const LEAST: [f64; 2] = [10.0, 36.0];
/// E/H of the asperity: the elements have small slopes.
const STIFFNESS: f64 = 100.0;

/// A point of the finite elements: interference, force and area over those at first yield.
#[derive(Debug, Clone, Deserialize)]
struct Point {
    nu: f64,
    #[serde(rename = "Et_over_E")]
    hardening: f64,
    elements: f64,
    x_max: f64,
    phase: String,
    x: f64,
    force: f64,
    area: f64,
}

impl Point {
    fn is_loading(&self) -> bool {
        self.phase == "load"
    }

    fn elements(&self) -> f64 {
        self.elements * (self.x / self.x_max).sqrt()
    }

    fn is_of_run(&self, other: &Self) -> bool {
        [(self.nu, other.nu), (self.hardening, other.hardening), (self.x_max, other.x_max)]
            .into_iter()
            .all(|(a, b)| equal(a, b))
            && equal(self.elements, other.elements)
    }
}

/// An asperity of the material of the elements, with E = 1 and R = 1.
fn asperity(nu: f64, hardening: f64) -> Result<Asperity> {
    let mut interface = Interface::new(1.0, nu, 1.0 / STIFFNESS);
    interface.tangent_modulus = (hardening > 0.0).then_some(hardening * 2.0 * (1.0 - nu * nu));
    Ok(Asperity::new(&interface, 1.0)?)
}

/// Work of the points \[F_c w_c\]: between two of them the force is a power of the interference
/// while it rises, a line while it falls.
fn work(points: &[&Point]) -> f64 {
    let segment = |pair: &[&Point]| {
        let [from, to] = [pair[0], pair[1]];
        if !from.is_loading() {
            return 0.5 * (from.force + to.force) * (from.x - to.x);
        }
        let power = (to.force / from.force).ln() / (to.x / from.x).ln() + 1.0;
        (to.force * to.x - from.force * from.x) / power
    };
    // Up to the first point, the force is Hertz'.
    let first = points.first().filter(|point| point.is_loading());
    let hertz = first.map_or(0.0, |point| 0.4 * point.force * point.x);
    hertz + points.windows(2).map(segment).sum::<f64>()
}

/// Ratios of the laws to the elements, then shares of the work that is returned.
///
/// # Errors
/// A file that cannot be read, a law that fails.
pub fn table() -> Result<Table> {
    let points: Vec<Point> = rows("sphere.csv")?;
    let mut table = Table::new(&["panel", "curve", "x", "value"]);
    let tolerance = Tolerance::new(TOLERANCE)?;
    for id in LAWS {
        let model: Model = id.parse()?;
        let beside = |point: &&Point| (point.hardening > 0.0) == (id == HARDENING);
        let mut own: Vec<&Point> =
            points.iter().filter(|point| point.is_loading()).filter(beside).collect();
        own.sort_by(|a, b| a.nu.total_cmp(&b.nu).then(a.x.total_cmp(&b.x)));
        let asked = [(Quantity::Force, PANELS[0], LEAST[0]), (Quantity::Area, PANELS[1], LEAST[1])];
        for (quantity, panel, least) in asked {
            for point in own.iter().filter(|point| point.elements() >= least) {
                let asperity = asperity(point.nu, point.hardening)?;
                let law = model.law(&asperity, quantity, tolerance)?;
                let critical = asperity.critical_interference()?;
                let value = law.value(point.x * critical)?;
                let ratio = match quantity {
                    Quantity::Force => value / asperity.critical_force()? / point.force,
                    _ => value / (std::f64::consts::PI * critical) / point.area,
                };
                let panel = match equal(point.nu, DRAWN_NU) {
                    true => panel.to_owned(),
                    false => format!("{panel} at {}", point.nu),
                };
                table.push(&[&panel, id], [point.x, ratio])?;
            }
        }
    }
    let (loading, asperity): (Model, _) = (LOADING.parse()?, asperity(DRAWN_NU, 0.0)?);
    for (key, _) in UNLOADING {
        let law: UnloadingLaw = key.parse().map_err(Error::msg)?;
        for x in geometric(1.0, 200.0, 101) {
            let w = x * asperity.critical_interference()?;
            let returned = restitution(&loading, &asperity, w, law, tolerance)?.powi(2);
            table.push(&[PANELS[2], key], [x, returned])?;
        }
    }
    let last = |point: &&Point| {
        equal(point.nu, DRAWN_NU)
            && point.hardening == 0.0
            && point.is_loading()
            && equal(point.x, point.x_max)
    };
    for end in points.iter().filter(last) {
        let (up, mut down): (Vec<&Point>, Vec<&Point>) = points
            .iter()
            .filter(|point| point.is_of_run(end))
            .partition(|point| point.is_loading());
        down.insert(0, end);
        // The end of loading is where unloading begins.
        let down: Vec<Point> = down
            .into_iter()
            .map(|point| Point { phase: "unload".into(), ..point.clone() })
            .collect();
        let returned = work(&down.iter().collect::<Vec<_>>()) / work(&up);
        table.push(&[PANELS[2], ELEMENTS], [end.x_max, returned])?;
    }
    Ok(table)
}

/// Three panels.
///
/// # Errors
/// An unknown law.
pub fn style(_: &str) -> Result<Figure> {
    let x = || Axis::new("x", "interference w/w_c").log();
    let ratio = |key: &str, title: &str, label: &str| -> Result<_> {
        let y = Axis::new("value", label).range(0.6, 1.4);
        let mut panel = of("panel", key, title, panel(&x(), y, &curves(&LAWS)?));
        panel.horizontals = vec![Mark::new(1.0, "")];
        panel.verticals = [1.0, 6.0, 110.0].map(|at| Mark::new(at, &format!("{at}"))).to_vec();
        Ok(panel)
    };
    let mut laws = named(&UNLOADING);
    laws.push(Curve::points(8, ELEMENTS, "finite elements"));
    let y = Axis::new("value", "work returned/work spent").range(0.0, 1.0);
    let work = of("panel", PANELS[2], "work", panel(&x(), y, &laws));
    let force = ratio(PANELS[0], "force", "force/finite elements")?;
    Ok(beside(3, [force, ratio(PANELS[1], "area", "area/finite elements")?, work]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_elastic_below_first_yield_and_return_less_work_the_deeper_they_were()
    -> Result<()> {
        let points: Vec<Point> = rows("sphere.csv")?;
        let elastic = points.iter().filter(|p| p.is_loading() && p.x < 0.9 && p.elements() > 10.0);
        let off: Vec<f64> = elastic.map(|p| p.force / p.x.powf(1.5) - 1.0).collect();
        assert!(off.len() > 20 && off.iter().all(|off| off.abs() < 0.01), "{off:?}");
        let table = table()?.into_text();
        let work = |line: &str| {
            let (x, value) = line.strip_prefix("work,elements,")?.split_once(',')?;
            Some((x.parse::<f64>().ok()?, value.parse::<f64>().ok()?))
        };
        let mut work: Vec<(f64, f64)> = table.lines().filter_map(work).collect();
        work.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert!(work.len() == 9 && work.windows(2).all(|pair| pair[1].1 < pair[0].1 + 1e-3));
        Ok(())
    }

    /// The force within 2 %, the area within 7 % where 20 elements touch: of all pairs, at most.
    #[test]
    fn another_program_finds_the_same_force_and_area() -> Result<()> {
        let points: Vec<Point> = rows("sphere.csv")?;
        let others: Vec<Point> = rows("sphere-calculix.csv")?;
        assert_eq!(others.len(), 84);
        for other in others {
            // Of the run that ends next beyond it.
            let alike = |p: &&Point| equal(p.nu, other.nu) && equal(p.hardening, other.hardening);
            let beyond = points.iter().filter(alike).map(|p| p.x_max).filter(|x| *x >= other.x);
            let end = beyond.min_by(f64::total_cmp).unwrap_or(f64::NAN);
            let run = points.iter().filter(alike).filter(|p| p.is_loading() && equal(p.x_max, end));
            let run: Vec<&Point> = run.filter(|p| p.elements < 50.0).collect();
            let at = run.partition_point(|p| p.x < other.x).clamp(1, run.len() - 1);
            let (low, high) = (run[at - 1], run[at]);
            let share = (other.x / low.x).ln() / (high.x / low.x).ln();
            let off = |low: f64, high: f64, found: f64| {
                (found / (low * (high / low).powf(share)) - 1.0).abs()
            };
            let force = off(low.force, high.force, other.force);
            assert!(force < 0.021, "{other:?}: {force}");
            let area = off(low.area, high.area, other.area);
            assert!(area < 0.07 || other.elements() < 20.0, "{other:?}: {area}");
        }
        Ok(())
    }
}
