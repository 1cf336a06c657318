//! The leak of a solved contact through the seal of its scene.

use asperity::bem::{self, BoundaryElements, Direction, Fluid, Gas, SealFlow, Solution};
use asperity::{At, Code, ContactError, Finding, Quantity, short};
use asperity_scene::{SceneFile, Seal};

use crate::Cell;
use crate::sheet::warning;

/// The least gap \[m\] for which laws of flow are known.
const NANOMETRE: f64 = 1e-9;

/// Why there is no gap on a path.
const CLOSED: &str =
    "contacts, and gaps smaller than a molecule, close every way through this scan";

/// A warning of a path through gaps in which no law of flow is known.
pub(crate) fn tight(field: String, gap: f64) -> Option<Finding> {
    let advice = "gaps below 1 nm, in which no law of flow is known, carry the leak: take it as an order of magnitude";
    let tight = Finding::warning(Code::Atomic, field, gap).unit("m").advice(advice);
    (gap < NANOMETRE).then(|| tight.usual([NANOMETRE, f64::INFINITY]))
}

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
            findings.extend(tightest_gap.and_then(|gap| self.finding(along, gap, solution)));
        }
        (cells, findings)
    }

    /// A warning of a flow through gaps where no law is known.
    fn finding(&self, along: Direction, gap: f64, solution: &Solution) -> Option<Finding> {
        let field = format!("tightest_gap_{along}");
        let at = At::Pressure(solution.mean_pressure);
        if let Some(tight) = tight(field.clone(), gap) {
            return Some(tight.at(at));
        }
        let Fluid::Gas(gas) = &self.seal.fluid else { return None };
        let inverse = gas.inverse_knudsen(gap, 0.5 * self.seal.pressures.iter().sum::<f64>());
        let fact = format!(
            "the tightest gap of the leak along {along}, {} m, is far below the free path",
            short(gap)
        );
        let advice =
            "the flow of free molecules grows with the length of the gap, by up to a half here";
        let free = Finding::warning(Code::BeyondFit, field, inverse).fact(fact).at(at);
        (inverse < Gas::LEAST).then(|| free.advice(advice))
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
