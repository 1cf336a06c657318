//! Flow of a fluid through the gap of a contact: div(g³ ∇P) = 0 between two faces of the map.
//!
//! P falls by 1 from the first column to the last (along y: row); contact pixels are closed. A
//! periodic map is continued across the flow, nothing flows through the sides of a free one. Finite
//! volumes: an edge of two pixels has the harmonic mean of their g³.
//!
//! A flow per width q = h³ Δp/(12 μ L) defines the hydraulic gap h. Beside it, the effective medium
//! of Bruggeman depends on the distribution of the gap alone: the mean of (g³ - K)/(g³ + K) is 0.

use asperity_quadrature::bracketed_root;

use crate::network::{Direction, Network};
use crate::parallel::inside;
use crate::{BemError, Boundary, BoundaryElements, HeightMap, Solution};

/// Largest difference of the flows through both faces, relative to them.
const BALANCE: f64 = 1e-6;

/// The gap map of a contact.
pub(crate) struct GapMap<'a> {
    map: &'a HeightMap,
    /// The largest gap \[m\].
    pub(crate) largest: f64,
    /// Of conductivities relative to the largest gap, of a liquid g³; 0 in contact.
    network: Network,
}

impl BoundaryElements {
    /// The hydraulic gap \[m\] of `solution`; 0 where no path of open pixels leads from face to
    /// face.
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size, [`BemError::Unbalanced`]
    /// where the flows through both faces differ by more than 1e-6 of them.
    pub fn hydraulic_gap(
        &self,
        solution: &Solution,
        direction: Direction,
    ) -> Result<f64, BemError> {
        self.gap_map(solution)?.hydraulic_gap(direction)
    }

    /// The flow through every pixel per width, over its mean over the width of the map: 1
    /// everywhere in an even gap, 0 where the path is closed.
    ///
    /// # Errors
    /// The errors of [`hydraulic_gap`](Self::hydraulic_gap).
    pub fn flux(&self, solution: &Solution, direction: Direction) -> Result<Vec<f64>, BemError> {
        Ok(self.gap_map(solution)?.flux(direction))
    }

    /// The hydraulic gap \[m\] of the effective medium (Bruggeman), which depends on the
    /// distribution of the gap alone; 0 where half of the area or more is closed.
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size.
    pub fn effective_medium_gap(&self, solution: &Solution) -> Result<f64, BemError> {
        Ok(self.gap_map(solution)?.effective_medium())
    }

    pub(crate) fn gap_map(&self, solution: &Solution) -> Result<GapMap<'_>, BemError> {
        Ok(self.gap_map_of(self.open_gaps(solution)?, cube))
    }

    /// The gap of every pixel \[m\], 0 in contact.
    pub(crate) fn open_gaps<'s>(
        &self,
        solution: &'s Solution,
    ) -> Result<impl Iterator<Item = f64> + use<'s>, BemError> {
        self.pixels_of(solution)?;
        let gaps = solution.gaps.iter().zip(&solution.pressures);
        Ok(gaps.map(|(gap, pressure)| if *pressure > 0.0 { 0.0 } else { gap.max(0.0) }))
    }

    /// The gap map of surfaces that do not touch, apart by this mean gap \[m\].
    pub(crate) fn open_gap_map(&self, mean_gap: f64) -> GapMap<'_> {
        self.gap_map_of(self.map.heights().iter().map(|height| mean_gap - height), cube)
    }

    /// The map of these gaps \[m\], each of which conducts this share of the largest.
    pub(crate) fn gap_map_of(
        &self,
        gaps: impl Iterator<Item = f64>,
        share: impl Fn(f64, f64) -> f64,
    ) -> GapMap<'_> {
        let mut shares: Vec<f64> = gaps.map(|gap| gap.max(0.0)).collect();
        let largest = shares.iter().copied().fold(0.0, f64::max);
        if largest > 0.0 {
            shares.iter_mut().for_each(|gap| *gap = share(*gap, largest));
        }
        let periodic = self.boundary_condition() == Boundary::Periodic;
        let map = &self.map;
        GapMap { map, largest, network: Network::new(shares, map.shape(), map.pixel(), periodic) }
    }
}

/// The share of a gap of a liquid.
fn cube(gap: f64, largest: f64) -> f64 {
    (gap / largest).powi(3)
}

impl GapMap<'_> {
    /// The conductivity of an even gap that lets as much pass, relative to the largest gap.
    pub(crate) fn conductance(&self, direction: Direction) -> Result<f64, BemError> {
        let [length, width] = outline(self.map, direction);
        let flows = inside(|| self.network.flows(direction));
        let [inlet, outlet] = flows.map(|flow| flow * length / width);
        match (inlet - outlet).abs() <= BALANCE * outlet {
            true => Ok(outlet),
            false => Err(BemError::Unbalanced { inlet, outlet }),
        }
    }

    pub(crate) fn hydraulic_gap(&self, direction: Direction) -> Result<f64, BemError> {
        Ok(self.largest * self.conductance(direction)?.cbrt())
    }

    fn flux(&self, direction: Direction) -> Vec<f64> {
        let ([_, columns], [height, width]) = (self.map.shape(), self.map.pixel());
        let flows = inside(|| self.network.pixel_flows(direction));
        let total: f64 = match direction {
            Direction::X => flows.chunks(columns).map(|row| row[columns - 1][3]).sum(),
            Direction::Y => flows[flows.len() - columns..].iter().map(|flow| flow[1]).sum(),
        };
        if total == 0.0 {
            return vec![0.0; flows.len()];
        }
        let mean = total / outline(self.map, direction)[1];
        let of = |[above, below, left, right]: &[f64; 4]| {
            (0.5 * (right - left) / height).hypot(0.5 * (below - above) / width) / mean
        };
        flows.iter().map(of).collect()
    }

    pub(crate) fn effective_medium(&self) -> f64 {
        let cubes = self.network.conductivities();
        let open: Vec<f64> = cubes.iter().copied().filter(|cube| *cube > 0.0).collect();
        let lowest = open.iter().copied().fold(1.0, f64::min).ln();
        let closed = (cubes.len() - open.len()) as f64;
        let mean = |logarithm: f64| {
            let medium = logarithm.exp();
            open.iter().map(|cube| 1.0 - 2.0 / (cube / medium + 1.0)).sum::<f64>() - closed
        };
        // With closed pixels the medium may conduct less than the smallest open gap.
        let mut low = lowest;
        while open.len() as f64 > closed && mean(low) < 0.0 && low > f64::MIN_POSITIVE.ln() {
            low = 2.0 * low - 1.0;
        }
        let found = bracketed_root(mean, low, 0.0);
        found.map_or(0.0, |logarithm| self.largest * (logarithm / 3.0).exp())
    }
}

/// Length and width of a map along a flow.
pub(crate) fn outline(map: &HeightMap, direction: Direction) -> [f64; 2] {
    let ([rows, columns], [height, width]) = (map.shape(), map.pixel());
    let sides = [columns as f64 * width, rows as f64 * height];
    if direction == Direction::X { sides } else { [sides[1], sides[0]] }
}
