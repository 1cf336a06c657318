//! The leak of a solved contact through the seal of its scene.

use asperity::bem::{self, BoundaryElements, Direction, Fluid, Gas, SealFlow, Solution};
use asperity::{At, Code, ContactError, Finding, Quantity, short};
use asperity_scene::{SceneFile, Seal};

use crate::Cell;
use crate::sheet::warning;

/// The least gap \[m\] for which laws of flow are known.
const NANOMETRE: f64 = 1e-9;

/// A share of the pressures beyond the fit of the flow that changes a leak by less than 1 %.
const NEGLIGIBLE: f64 = 0.02;

/// Why there is no gap on a path.
const CLOSED: &str =
    "contacts, and gaps smaller than a molecule, close every way through this scan";

/// The seal of a scene whose leak is asked for.
#[derive(Debug)]
pub(crate) struct Leaking {
    keys: Seal,
    seal: bem::Seal,
}

impl Leaking {
    /// The seal of a scene, if its leak is among the quantities.
    pub(crate) fn of(
        file: &SceneFile,
        quantities: &[Quantity],
    ) -> Result<Option<Self>, ContactError> {
        if !quantities.contains(&Quantity::Leak) {
            return Ok(None);
        }
        let keys = file.needed_seal()?;
        Ok(Some(Self { keys, seal: keys.resolved()? }))
    }

    /// Its columns.
    pub(crate) fn heads(&self) -> Vec<String> {
        let flow = |along, (unit, _)| format!("leak_{along}_{unit}");
        let of = |along| {
            let units = self.keys.units(&self.seal).into_iter();
            units.map(move |one| flow(along, one)).chain([format!("tightest_gap_{along}_m")])
        };
        Direction::ALL.into_iter().flat_map(of).collect()
    }

    /// The leak of a contact in the cells of a row, and its findings.
    pub(crate) fn leak(
        &self,
        elements: &BoundaryElements,
        solution: &Solution,
    ) -> (Vec<Cell>, Vec<Finding>) {
        let flows = match elements.seal_flows(solution, &self.seal) {
            Ok(flows) => flows,
            Err(error) => {
                let reason = warning(Code::NoValue, format!("no leak: {error}"));
                return (vec![Cell::BLANK; self.heads().len()], vec![reason]);
            }
        };
        let at = At::Pressure(solution.mean_pressure);
        let (mut cells, mut findings) = (vec![], vec![]);
        for (along, SealFlow { flow, tightest_gap }) in Direction::ALL.into_iter().zip(flows) {
            let sizes = self.keys.units(&self.seal).into_iter();
            cells.extend(sizes.map(|(_, size)| Cell::from(size * flow)));
            let closed = || {
                Cell::Blank(Some(
                    ContactError::Missing { field: "open path", reason: CLOSED.into() }.into(),
                ))
            };
            cells.push(tightest_gap.map_or_else(closed, Cell::from));
            findings.extend(tightest_gap.and_then(|gap| self.finding(along, gap, at)));
        }
        (cells, findings)
    }

    /// A warning of a flow through gaps where no law is known.
    fn finding(&self, along: Direction, gap: f64, at: At) -> Option<Finding> {
        let field = format!("tightest_gap_{along}");
        if gap < NANOMETRE {
            let advice = "gaps below 1 nm, in which no law of flow is known, carry the leak: take it as an order of magnitude";
            let tight = Finding::warning(Code::Atomic, field, gap).unit("m").advice(advice);
            return Some(tight.usual([NANOMETRE, f64::INFINITY]).at(at));
        }
        let Fluid::Gas(gas) = &self.seal.fluid else { return None };
        let [upper, inverse] = self.seal.pressures.map(|p| gas.inverse_knudsen(gap, p));
        // The share of the pressures at which the flow is that of the least D.
        let share = ((Gas::LEAST - inverse) / (upper - inverse)).clamp(0.0, 1.0);
        let fact = format!(
            "the tightest gap of the leak along {along}, {} m, is far below the free path at {:.0} % of the pressures",
            short(gap),
            100.0 * share
        );
        let advice =
            "the flow of free molecules grows with the length of the gap, by up to a half there";
        let free = Finding::warning(Code::BeyondFit, field, inverse).fact(fact).at(at);
        (share > NEGLIGIBLE).then(|| free.advice(advice))
    }

    /// What the numbers of rows that end with these cells mean.
    pub(crate) fn results(&self, rows: &[&Vec<Cell>]) -> Vec<String> {
        let (width, count) = (self.heads().len(), rows.len());
        let of = |(along, k): (Direction, usize)| {
            let flow = |row: &&&Vec<Cell>| row[row.len() - width + k * width / 2].number();
            let closed = rows.iter().filter(|row| flow(row) == Some(0.0)).count();
            let size = short(self.seal.molecule * 1e9);
            (closed > 0).then(|| format!("no open path along {along} in {closed} of {count} rows: contacts, and gaps smaller than a molecule ({size} nm), close every way through this scan, and the leak is 0; other samples of the surface close at other loads"))
        };
        let mut texts = vec![self.keys.summary(&self.seal)];
        texts.extend(Direction::ALL.into_iter().zip(0..).filter_map(of));
        texts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(upstream: f64, downstream: f64, gap: f64) -> Option<Code> {
        let text = format!(
            "nominal_area = 1e-4\ninterface = {{ equivalent_modulus = 1e11, poissons_ratio = 0.3 }}\n\
             [surface]\nasperity_radius = 1e-5\nasperity_density = 1e9\n\
             asperity_height_std = 1e-6\n[seal]\nwidth = 0.1\nlength = 0.002\n\
             upstream_pressure = {upstream}\ndownstream_pressure = {downstream}\n\
             gas = \"helium\"\ntemperature = 293.15\n"
        );
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        let leaking = Leaking::of(&file, &[Quantity::Leak]).unwrap().unwrap();
        leaking.finding(Direction::X, gap, At::Pressure(1e6)).map(|found| found.code)
    }

    #[test]
    fn a_leak_beyond_the_fit_of_its_flow_is_warned_of() {
        // Against the BGK equation, 4.3 % low from 1000 Pa to a vacuum through 1 um.
        assert_eq!(found(1e3, 0.0, 1e-6), Some(Code::BeyondFit));
        assert_eq!(found(1e6, 0.0, 1e-6), None);
        assert_eq!(found(1e3, 9e2, 1e-6), None);
        assert_eq!(found(1.0, 0.9, 1e-6), Some(Code::BeyondFit));
        assert_eq!(found(1e6, 1e5, 5e-10), Some(Code::Atomic));
    }
}
