//! The quantities of a solved contact, by the names that all models share.

use asperity_core::{
    ATOMIC_DISTANCE, At, Code, ContactError, Evaluation, Finding, Quantity, Scene,
};

use crate::error::refused;
use crate::hydraulic::GapMap;
use crate::{BemError, BoundaryElements, Direction, Solution};

/// Relative error at the usual tolerance, of a contact of pixels; the error of the grid is not part
/// of it.
const ERROR: f64 = 1e-6;
/// Relative error of the slope of loading, which is a difference where pixels yield.
const SLOPE_ERROR: f64 = 2e-3;

/// The numbers of a contact from which its quantities follow.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ContactSummary {
    /// Mean pressure on the area of the map \[Pa\].
    pub mean_pressure: f64,
    /// Real area of contact over the area of the map.
    pub area: f64,
    /// Mean gap \[m\].
    pub mean_gap: f64,
    /// Mean gap \[m\] of the pixels out of contact; `None` where every pixel touches.
    pub mean_open_gap: Option<f64>,
    /// [Separation](Solution::separation) \[m\].
    pub separation: f64,
    /// Stiffness at [fixed contact](BoundaryElements::fixed_contact) \[Pa/m\]; `None` if no
    /// quantity needs it.
    pub stiffness: Option<Result<f64, BemError>>,
    /// [Slope of first loading](BoundaryElements::loading_stiffness) \[Pa/m\]; `None` if no
    /// quantity needs it.
    pub loading_stiffness: Option<Result<f64, BemError>>,
    /// The hydraulic gaps \[m\] that are required.
    pub gaps: Vec<(Quantity, Result<f64, BemError>)>,
}

impl BoundaryElements {
    /// The numbers of a solution of this map that `quantities` need.
    #[must_use]
    pub fn summary(&self, solution: &Solution, quantities: &[Quantity]) -> ContactSummary {
        let fixed = || self.fixed_contact(solution).map(|fixed| fixed.stiffness);
        let Solution { mean_pressure, area, mean_gap, mean_open_gap, separation, .. } = *solution;
        let stiffness = quantities.iter().any(|quantity| quantity.is_of_joint()).then(fixed);
        let loading = || self.loading_stiffness(solution);
        let loading_stiffness = quantities.iter().any(|quantity| is_slope(*quantity)).then(loading);
        let gap_map = || self.gap_map(solution);
        let gaps = hydraulic(quantities, gap_map);
        ContactSummary {
            mean_pressure,
            area,
            mean_gap,
            mean_open_gap,
            separation,
            stiffness,
            loading_stiffness,
            gaps,
        }
    }

    /// The numbers of surfaces that do not touch, apart by this mean gap \[m\].
    pub(crate) fn open_summary(&self, mean_gap: f64, quantities: &[Quantity]) -> ContactSummary {
        let gaps = hydraulic(quantities, || Ok(self.open_gap_map(mean_gap)));
        ContactSummary { gaps, ..ContactSummary::open(mean_gap) }
    }
}

/// The quantities that need the map of the gap.
fn hydraulic<'m>(
    quantities: &[Quantity],
    gap_map: impl FnOnce() -> Result<GapMap<'m>, BemError>,
) -> Vec<(Quantity, Result<f64, BemError>)> {
    let wanted: Vec<Quantity> = quantities.iter().copied().filter(|q| q.is_of_map()).collect();
    let Some(map) = (!wanted.is_empty()).then(gap_map) else { return vec![] };
    let of = |map: &GapMap<'_>, quantity| match quantity {
        Quantity::HydraulicGapX => map.hydraulic_gap(Direction::X),
        Quantity::HydraulicGapY => map.hydraulic_gap(Direction::Y),
        _ => Ok(map.effective_medium()),
    };
    let of = |quantity| map.as_ref().map_err(Clone::clone).and_then(|map| of(map, quantity));
    wanted.into_iter().map(|quantity| (quantity, of(quantity))).collect()
}

/// Whether this is the slope of first loading: the stiffness of a model is its tangent where no
/// paper defines another.
fn is_slope(quantity: Quantity) -> bool {
    matches!(quantity, Quantity::Tangent | Quantity::Stiffness)
}

/// Whether boundary elements give a quantity: force, area and what follows from them; the slope of
/// loading; stiffnesses and conductances of joints; hydraulic gaps.
pub(crate) fn known(quantity: Quantity) -> bool {
    quantity.follows_from_totals()
        || quantity.is_of_joint()
        || is_slope(quantity)
        || quantity.is_of_map()
}

impl ContactSummary {
    /// Surfaces apart by this mean gap \[m\].
    pub(crate) fn open(mean_gap: f64) -> Self {
        Self {
            mean_pressure: 0.0,
            area: 0.0,
            mean_gap,
            mean_open_gap: Some(mean_gap),
            separation: mean_gap,
            stiffness: Some(Ok(0.0)),
            loading_stiffness: Some(Ok(0.0)),
            gaps: vec![],
        }
    }

    /// A note of the smallest gap, if it is open and smaller than an atom.
    #[must_use]
    pub fn finding(&self) -> Option<Finding> {
        let gaps =
            self.gaps.iter().filter_map(|(of, gap)| Some((of.to_string(), *gap.as_ref().ok()?)));
        let gaps = gaps.chain([("mean-gap".into(), self.mean_gap)]);
        let small = gaps.filter(|(_, gap)| *gap > 0.0 && *gap < ATOMIC_DISTANCE);
        let (name, gap) = small.min_by(|(_, one), (_, other)| one.total_cmp(other))?;
        let found = Finding::note(Code::Atomic, name, gap).usual([ATOMIC_DISTANCE, f64::INFINITY]);
        let advice = "a gap below the distance of two atoms (0.3 nm) is closed to any fluid";
        Some(found.unit("m").at(At::Pressure(self.mean_pressure)).advice(advice))
    }

    /// A quantity on the nominal area of `scene`, for which the map stands. Stiffness and tangent
    /// are the slope of first loading against the mean gap. Stiffnesses and conductances of joints
    /// follow from the stiffness at fixed contact: interaction included, contacts of any shape;
    /// shear in stick as if they were circles. `None` for a quantity that boundary elements lack.
    ///
    /// # Errors
    /// [`ContactError::Missing`] for a property of the interface that the quantity needs,
    /// [`ContactError::Refused`] where the stiffness or the hydraulic gap was not found.
    pub fn evaluate(
        &self,
        quantity: Quantity,
        scene: &Scene,
    ) -> Result<Option<Evaluation>, ContactError> {
        let nominal = scene.nominal_area;
        match (&self.stiffness, &self.loading_stiffness) {
            (_, Some(slope)) if is_slope(quantity) => {
                let slope = slope.clone().map_err(refused)?;
                Ok(Some(Evaluation::new(slope * nominal, SLOPE_ERROR)))
            }
            (Some(stiffness), _) if quantity.is_of_joint() => {
                let stiffness = stiffness.clone().map_err(refused)?;
                let sum = stiffness * nominal / (2.0 * scene.interface.equivalent_modulus);
                Evaluation::of_contact_radii(quantity, sum, scene, ERROR)
            }
            _ if quantity.is_of_map() => {
                let gap = self.gaps.iter().find(|(known, _)| *known == quantity);
                let gap = gap.map(|(_, gap)| gap.clone().map_err(refused)).transpose()?;
                Ok(gap.map(|gap| Evaluation::new(gap, ERROR)))
            }
            _ => {
                let totals = (self.mean_pressure * nominal, self.area * nominal);
                Ok(Evaluation::of_totals(quantity, totals, nominal, ERROR))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_gap_below_an_atom_has_a_note() {
        let contact = |gaps: [f64; 3]| ContactSummary {
            gaps: vec![
                (Quantity::HydraulicGapX, Ok(gaps[0])),
                (Quantity::EffectiveMediumGap, Ok(gaps[1])),
            ],
            ..ContactSummary::open(gaps[2])
        };
        let note = contact([1.6e-10, 4e-10, 2e-10]).finding().unwrap();
        assert_eq!((note.code, &*note.field), (Code::Atomic, "hydraulic-gap-x"));
        assert!((note.value / 1.6e-10 - 1.0).abs() < 1e-15);
        // A hardness leaves mean gaps below 0, and a sealed gap is 0.
        assert_eq!(contact([0.0, 4e-10, -2e-10]).finding(), None);
    }
}
