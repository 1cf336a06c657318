//! Leak through a seal whose faces a solved map stands for.
//!
//! The map is small against the seal, which continues it: the flow is width over length times the
//! integral, over the pressures from side to side, of the conductance of the map. That of a liquid
//! is h³/(12 μ) at any pressure; that of a gas follows from a flow at each of four pressures.
//!
//! A gas, isothermal, from a continuum to free molecules, flows with the mass ṁ' = -(h²/v) Q(D)
//! dp/dx per width, with v = √(2 R T) and the inverse Knudsen number D = p h/(μ v), which differs
//! from pixel to pixel and along the pressure.

use std::collections::BinaryHeap;
use std::f64::consts::PI;

use asperity_quadrature::legendre;

use crate::height_map::positive;
use crate::network::Direction;
use crate::{BemError, Boundary, BoundaryElements, Solution};

/// How a gas meets the walls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rarefaction {
    /// No slip: D/6. The hydraulic gap of a liquid holds.
    Continuum,
    /// Slip of first order, 1 + 6 Kn: D/6 + √π/2.
    Slip,
    /// Diffuse walls at any D: the fit of Fukui and Kaneko (1990) \[recalled\], within 0.9 % of a
    /// solution of the BGK equation for D from 0.01 to 30.
    #[default]
    Transition,
}

impl Rarefaction {
    /// Q(D): the mass flow per width over h² (-dp/dx)/v.
    #[must_use]
    pub fn flow(self, d: f64) -> f64 {
        let least = d.max(Gas::LEAST);
        match self {
            Self::Continuum => d / 6.0,
            Self::Slip => d / 6.0 + 0.5 * PI.sqrt(),
            Self::Transition if d >= 5.0 => d / 6.0 + 1.0162 + 1.0653 / d - 2.1354 / (d * d),
            Self::Transition if d >= 0.15 => {
                0.138_52 * d + 1.250_87 + 0.156_53 / d - 0.009_69 / (d * d)
            }
            Self::Transition => {
                -2.229_19 * least + 2.106_73 + 0.016_53 / least - 0.000_069_4 / (least * least)
            }
        }
    }
}

/// A gas at a temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gas {
    viscosity: f64,
    /// √(2 R T) \[m/s\].
    speed: f64,
    rarefaction: Rarefaction,
}

impl Gas {
    /// Viscosity \[Pa s\], molar mass \[kg/mol\] and temperature \[K\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for one that is not a positive number.
    pub fn new(
        viscosity: f64,
        molar_mass: f64,
        temperature: f64,
        rarefaction: Rarefaction,
    ) -> Result<Self, BemError> {
        const MOLAR: f64 = 8.314_462_618_153_24;
        let gas_constant = MOLAR / positive("molar mass", molar_mass)?;
        let speed = (2.0 * gas_constant * positive("temperature", temperature)?).sqrt();
        Ok(Self { viscosity: positive("viscosity", viscosity)?, speed, rarefaction })
    }

    /// Conductance h² Q(D)/v of an even gap \[m\] at a pressure \[Pa\]: mass flow per width over
    /// the gradient of the pressure \[s\].
    #[must_use]
    pub fn conductance(&self, gap: f64, pressure: f64) -> f64 {
        let d = self.inverse_knudsen(gap, pressure);
        if d > 0.0 { gap * gap / self.speed * self.rarefaction.flow(d) } else { 0.0 }
    }

    /// D = p h/(μ v), the gap \[m\] over the free path up to a factor; free molecules below
    /// [`LEAST`](Self::LEAST).
    #[must_use]
    pub fn inverse_knudsen(&self, gap: f64, pressure: f64) -> f64 {
        pressure * gap / (self.viscosity * self.speed)
    }

    /// R T \[J/kg\]: the pressure over the density.
    #[must_use]
    pub fn pressure_over_density(&self) -> f64 {
        0.5 * self.speed * self.speed
    }

    /// The least D of the fit, below which Q keeps its value here, that of a gap some 100 times as
    /// long as high. Q would grow as ln(1/D) until molecules fly along the whole gap, which depends
    /// on the length of the gap.
    pub const LEAST: f64 = 0.01;
}

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
        // Of a liquid nothing depends on the pressure.
        let rule = legendre(if matches!(seal.fluid, Fluid::Liquid(_)) { 1 } else { 4 });
        for (node, weight) in rule.nodes.iter().zip(&rule.weights) {
            let of = |gap: f64| seal.conductance(gap, to + node * drop);
            // Where the largest is closed, all are.
            let share = |gap, largest| of(gap) / of(largest).max(f64::MIN_POSITIVE);
            let map = self.gap_map_of(self.open_gaps(solution)?, share);
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
        let ([_, columns], count) = (self.map.shape(), gaps.len());
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
