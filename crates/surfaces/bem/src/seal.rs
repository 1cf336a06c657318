//! Leak through a seal whose faces a solved map stands for.
//!
//! The map is small against the seal, which continues it: the flow is width over length times the
//! integral, over the pressures from side to side, of the conductance of the map. That of a liquid
//! is h³/(12 μ) at any pressure; that of a gas follows from a flow at each of four pressures.

use std::collections::BinaryHeap;

use crate::gas::Gas;
use crate::height_map::positive;
use crate::network::Direction;
use crate::{BemError, Boundary, BoundaryElements, Solution};

/// Nodes and weights of the Gauss-Legendre rule with four points on 0 to 1.
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_87, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];

/// What leaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fluid {
    /// A liquid of a viscosity \[Pa s\].
    Liquid(f64),
    /// A gas.
    Gas(Gas),
}

/// A seal: its outline, the pressures on both sides and the fluid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seal {
    /// Its width across the flow over its length along it.
    pub width_over_length: f64,
    /// Absolute pressures \[Pa\] up and down the flow; of a gas, a vacuum is 0.
    pub pressures: [f64; 2],
    /// What leaks.
    pub fluid: Fluid,
    /// The smallest gap \[m\] that a molecule passes; smaller ones are closed.
    pub molecule: f64,
}

/// The flow through a seal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SealFlow {
    /// Mass flow of a gas \[kg/s\], volume flow of a liquid \[m³/s\]; 0 without an open path.
    pub flow: f64,
    /// The tightest gap \[m\] on the widest path from side to side, over edges of pixels; `None`
    /// where contacts and gaps smaller than a molecule close every path.
    pub tightest_gap: Option<f64>,
}

impl Seal {
    /// The conductance of an even gap \[m\] at a pressure \[Pa\]: flow per width over the gradient
    /// of the pressure.
    fn conductance(&self, gap: f64, pressure: f64) -> f64 {
        match &self.fluid {
            _ if gap < self.molecule => 0.0,
            Fluid::Liquid(viscosity) => gap.powi(3) / (12.0 * viscosity),
            Fluid::Gas(gas) => gas.conductance(gap, pressure),
        }
    }
}

impl BoundaryElements {
    /// The flows through a seal with the gap of `solution` along x and along y.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for pressures that do not fall, or no outline; the errors of
    /// [`hydraulic_gap`](Self::hydraulic_gap).
    pub fn seal_flows(&self, solution: &Solution, seal: &Seal) -> Result<[SealFlow; 2], BemError> {
        let [from, to] = seal.pressures;
        let drop = positive("pressure drop", from - to)?;
        let driven = drop * positive("width over length", seal.width_over_length)?;
        let [x, y] = Direction::ALL.map(|along| self.tightest_gap(solution, along));
        let open = [x?, y?].map(|gap| gap.map(|(gap, _)| gap).filter(|gap| *gap >= seal.molecule));
        let mut flows = open.map(|tightest_gap| SealFlow { flow: 0.0, tightest_gap });
        let nodes = match seal.fluid {
            Fluid::Liquid(_) => &[[0.5, 1.0]],
            Fluid::Gas(_) => &GAUSS[..],
        };
        for [node, weight] in nodes {
            let of = |gap: f64| seal.conductance(gap, to + node * drop);
            // Where the largest is closed, all are.
            let share = |gap, largest| of(gap) / of(largest).max(f64::MIN_POSITIVE);
            let map = self.gap_map_by(solution, share)?;
            for (found, along) in flows.iter_mut().zip(Direction::ALL) {
                found.flow += weight * driven * of(map.largest) * map.conductance(along)?;
            }
        }
        Ok(flows)
    }

    /// The tightest gap \[m\] on the path from face to face whose tightest gap is largest, and its
    /// place in the map; `None` where no path of open pixels leads there.
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size.
    pub fn tightest_gap(
        &self,
        solution: &Solution,
        direction: Direction,
    ) -> Result<Option<(f64, usize)>, BemError> {
        let gaps: Vec<f64> = self.open_gaps(solution)?.collect();
        let ([_, columns], count) = (self.map().shape(), gaps.len());
        let is_periodic = self.boundary_condition() == Boundary::Periodic;
        // Along the flow and across it.
        let place = |at: usize| match direction {
            Direction::X => [at % columns, at / columns],
            Direction::Y => [at / columns, at % columns],
        };
        let are_beside = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
            a.abs_diff(c) <= 1 && (is_periodic || b.abs_diff(d) <= 1)
        };
        let mut is_new: Vec<bool> = gaps.iter().map(|gap| *gap > 0.0).collect();
        // Bits of positive numbers have their order.
        let mut reached = BinaryHeap::new();
        let mut reach = |reached: &mut BinaryHeap<_>, at: usize| {
            if std::mem::take(&mut is_new[at]) {
                reached.push((gaps[at].to_bits(), at));
            }
        };
        let inlet = (0..count).filter(|at| place(*at)[0] == 0);
        inlet.for_each(|at| reach(&mut reached, at));
        let ([end, _], mut tightest) = (place(count - 1), (u64::MAX, 0));
        while let Some((gap, at)) = reached.pop() {
            tightest = tightest.min((gap, at));
            if place(at)[0] == end {
                return Ok(Some((f64::from_bits(tightest.0), tightest.1)));
            }
            let (row, column) = (at - at % columns, at % columns + columns);
            let aside = [column - 1, column + 1].map(|column| row + column % columns);
            let others = [at + columns, at + count - columns].map(|other| other % count);
            for other in others.into_iter().chain(aside) {
                if are_beside(place(at), place(other)) {
                    reach(&mut reached, other);
                }
            }
        }
        Ok(None)
    }
}
