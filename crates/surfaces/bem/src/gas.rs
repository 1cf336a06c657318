//! Flow of a gas through the gap of a contact: isothermal, from a continuum to free molecules.
//!
//! A gas flows with the mass ṁ' = -(h²/v) Q(D) dp/dx per width, with v = √(2 R T) and the inverse
//! Knudsen number D = p h/(μ v), which differs from pixel to pixel and along the pressure. The map
//! is small against the seal, so that one pressure holds on it: its conductance k(p) follows from a
//! linear flow with the conductivities h² Q(D)/v, and the flow is W/L ∫ k dp between the pressures.

use std::f64::consts::PI;

use crate::height_map::positive;
use crate::network::Direction;
use crate::{BemError, BoundaryElements, Solution};

/// Nodes and weights of the Gauss-Legendre rule with four points on 0 to 1.
const GAUSS: [[f64; 2]; 4] = [
    [0.069_431_844_202_973_71, 0.173_927_422_568_726_93],
    [0.330_009_478_207_571_87, 0.326_072_577_431_273_07],
    [0.669_990_521_792_428_1, 0.326_072_577_431_273_07],
    [0.930_568_155_797_026_3, 0.173_927_422_568_726_93],
];

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
        match self {
            Self::Continuum => d / 6.0,
            Self::Slip => d / 6.0 + 0.5 * PI.sqrt(),
            Self::Transition if d >= 5.0 => d / 6.0 + 1.0162 + 1.0653 / d - 2.1354 / (d * d),
            Self::Transition if d >= 0.15 => {
                0.138_52 * d + 1.250_87 + 0.156_53 / d - 0.009_69 / (d * d)
            }
            Self::Transition => -2.229_19 * d + 2.106_73 + 0.016_53 / d - 0.000_069_4 / (d * d),
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

    /// Mass flow \[kg/s\] between two absolute pressures \[Pa\] through a seal whose width is
    /// `width_over_length` times its length, from its conductance at a pressure.
    fn between(
        [from, to]: [f64; 2],
        width_over_length: f64,
        conductance: impl Fn(f64) -> Result<f64, BemError>,
    ) -> Result<f64, BemError> {
        let [from, to] = [positive("pressure", from)?, positive("pressure", to)?];
        let mut flow = 0.0;
        for [node, weight] in GAUSS {
            flow += weight * conductance(to + node * (from - to))?;
        }
        Ok(width_over_length * flow * (from - to))
    }

    /// Conductance h² Q(D)/v of an even gap \[m\] at a pressure \[Pa\]: mass flow per width over
    /// the gradient of the pressure \[s\].
    #[must_use]
    pub fn conductance(&self, gap: f64, pressure: f64) -> f64 {
        let d = pressure * gap / (self.viscosity * self.speed);
        if d > 0.0 { gap * gap / self.speed * self.rarefaction.flow(d) } else { 0.0 }
    }

    /// Mass flow \[kg/s\] through an even gap \[m\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for pressures that are not positive.
    pub fn flow(
        &self,
        gap: f64,
        pressures: [f64; 2],
        width_over_length: f64,
    ) -> Result<f64, BemError> {
        Self::between(pressures, width_over_length, |p| Ok(self.conductance(gap, p)))
    }
}

impl BoundaryElements {
    /// Mass flow \[kg/s\] of a gas through the gap of `solution` between two absolute pressures
    /// \[Pa\], through a seal whose width is `width_over_length` times its length and that
    /// continues this map; 0 where no path of open pixels leads from face to face.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for pressures that are not positive; the errors of
    /// [`hydraulic_gap`](Self::hydraulic_gap).
    pub fn gas_flow(
        &self,
        solution: &Solution,
        gas: &Gas,
        pressures: [f64; 2],
        direction: Direction,
        width_over_length: f64,
    ) -> Result<f64, BemError> {
        Gas::between(pressures, width_over_length, |pressure| {
            let of = |gap: f64| gas.conductance(gap, pressure);
            let map = self.gap_map_by(solution, |gap, largest| of(gap) / of(largest))?;
            Ok(of(map.largest) * map.conductance(direction)?)
        })
    }
}
