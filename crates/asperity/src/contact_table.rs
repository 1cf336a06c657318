//! Pressure against separation as a table that a finite-element code can interpolate.

use crate::table_builder::Builder;
use crate::{At, ContactModel, Scene, TableError, Tolerance};

/// More nodes than this are not added to meet an error.
const MOST_NODES: usize = 100_000;

/// What a finite-element code makes of the space between two nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines: the pressure is continuous, its slope is not.
    Linear,
    /// Cubics through pressures and stiffnesses (Hermite): both are continuous, as Newton's method
    /// needs.
    Hermite,
}

/// One node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactNode {
    /// d/σ_z, from the mean of the asperity heights.
    pub separation: f64,
    /// Force over nominal area \[Pa\].
    pub pressure: f64,
    /// -dp/dd \[Pa/m\], jumps of the law included.
    pub stiffness: f64,
}

/// Pressure and stiffness at nodes, and how far what is interpolated between them is off.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTable {
    /// Ascending separations; pressure falls, all pressures and stiffnesses are positive.
    pub nodes: Vec<ContactNode>,
    /// How it is meant to be read between the nodes.
    pub interpolation: Interpolation,
    /// Largest relative error of the pressure, measured at seven points between any two nodes.
    pub pressure_error: f64,
    /// Largest relative error of the stiffness, measured at the same points.
    pub stiffness_error: f64,
    /// σ_z \[m\].
    pub asperity_height_std: f64,
}

impl ContactTable {
    /// From one separation, load or pressure to another, larger one, with `count` ≥ 2 nodes at
    /// equal distances of separation.
    ///
    /// # Errors
    /// [`TableError`]; the integrals are done to `tolerance`.
    pub fn even<A: Into<At>>(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        (first, last, count): (A, A, usize),
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        let builder = Builder::new(model, scene, tolerance, interpolation)?;
        builder.table(builder.even(first.into(), last.into(), count)?)
    }

    /// As [`even`](Self::even), with nodes added between those until no interpolated pressure is
    /// off by more than a relative `error`.
    ///
    /// ```
    /// use asperity::{ContactTable, Interface, Interpolation, Scene, Surface, Tolerance};
    ///
    /// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
    /// let (range, cubic) = ((0.0, 4.0, 2), Interpolation::Hermite);
    /// let table =
    ///     ContactTable::within(&asperity::KogutEtsion, &scene, Tolerance::default(), range, 1e-6, cubic)?;
    /// assert!(table.pressure_error <= 1e-6 && table.nodes.len() < 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TableError`]; the integrals are done to `tolerance`, below which `error` cannot be met.
    pub fn within<A: Into<At>>(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        (first, last, count): (A, A, usize),
        error: f64,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        crate::positive("error", error)?;
        let builder = Builder::new(model, scene, tolerance, interpolation)?;
        let even = builder.even(first.into(), last.into(), count)?;
        let mut nodes = vec![even[0]];
        // Intervals still to be looked at, the next one on top.
        let mut ahead: Vec<ContactNode> = even[1..].iter().rev().copied().collect();
        while let (Some(&from), Some(&to)) = (nodes.last(), ahead.last()) {
            if builder.monotone(&from, &to) && builder.errors(&from, &to)?.0 <= error {
                nodes.push(to);
                ahead.pop();
                continue;
            }
            let middle = 0.5 * (from.separation + to.separation);
            if nodes.len() + ahead.len() >= MOST_NODES || middle <= from.separation {
                return Err(TableError::TooFine { error });
            }
            ahead.push(builder.node(middle)?);
        }
        builder.table(nodes)
    }

    /// The separation over σ_z at which the tangent of the last node reaches pressure 0: a table
    /// that ends there has no kink at the last node. The model's own pressure beyond the last node
    /// is below that node's.
    #[must_use]
    pub fn cut_off(&self) -> Option<f64> {
        let last = self.nodes.last()?;
        Some(last.separation + last.pressure / last.stiffness / self.asperity_height_std)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, KogutEtsion, Model, Surface};

    fn scene() -> Scene {
        let mut interface = Interface::new(116e9, 0.31, 1.12e9);
        interface.equivalent_shear_modulus = Some(41e9);
        Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5)
    }

    fn even(count: usize, interpolation: Interpolation) -> ContactTable {
        let (model, tolerance) = (KogutEtsion, Tolerance::default());
        ContactTable::even(&model, &scene(), tolerance, (0.0, 4.0, count), interpolation).unwrap()
    }

    #[test]
    fn errors_fall_as_the_interpolation_promises() {
        // Halving the intervals divides the error by 2² for lines and by 2⁴ for cubics.
        for (interpolation, order) in [(Interpolation::Linear, 4.0), (Interpolation::Hermite, 16.0)]
        {
            let (coarse, fine) = (even(81, interpolation), even(161, interpolation));
            let ratio = coarse.pressure_error / fine.pressure_error;
            assert!((ratio / order - 1.0).abs() < 0.15, "{interpolation:?}: {ratio}");
        }
    }

    #[test]
    fn an_asked_error_is_met_with_few_nodes() {
        let (model, tolerance) = (KogutEtsion, Tolerance::default());
        for (interpolation, most) in [(Interpolation::Linear, 700), (Interpolation::Hermite, 90)] {
            let range = (-1.0, 4.0, 2);
            let within = |error| {
                ContactTable::within(&model, &scene(), tolerance, range, error, interpolation)
            };
            let table = within(1e-4).unwrap();
            assert!(
                table.pressure_error <= 1e-4 && table.nodes.len() <= most,
                "{}",
                table.nodes.len()
            );
            assert!(
                table
                    .nodes
                    .is_sorted_by(|a, b| a.separation < b.separation && a.pressure > b.pressure)
            );
            assert!(within(1e-17).is_err());
        }
    }

    #[test]
    fn loads_and_pressures_are_ends_like_any_other() {
        let (model, tolerance, scene) = (KogutEtsion, Tolerance::default(), scene());
        let of = |a, b| {
            let cubic = Interpolation::Hermite;
            ContactTable::even(&model, &scene, tolerance, (a, b, 9), cubic).unwrap().nodes
        };
        let nodes = of(At::Pressure(1e4), At::Pressure(1e6));
        assert!((nodes[0].pressure / 1e6 - 1.0).abs() < 1e-9);
        assert!((nodes[8].pressure / 1e4 - 1.0).abs() < 1e-9);
        assert_eq!(nodes, of(At::Load(1e4 * 3e-5), At::Load(1e6 * 3e-5)));
        let metres = of(At::metres(1e-6), At::metres(3e-6));
        assert!((metres[8].separation - 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_tangent_of_the_last_node_ends_the_table() {
        let table = even(41, Interpolation::Linear);
        let (last, end) = (table.nodes[40], table.cut_off().unwrap());
        let slope = last.pressure / ((end - last.separation) * 1e-6);
        assert!(end > 4.0 && (slope / last.stiffness - 1.0).abs() < 1e-9);
    }

    #[test]
    fn what_a_solver_cannot_use_is_refused() {
        let interface = scene().interface;
        let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
        let mut odd = scene();
        odd.surface = surface;
        let table = |scene: &Scene, id: &str, range| {
            let (model, cubic) = (id.parse::<Model>().unwrap(), Interpolation::Hermite);
            ContactTable::even(&model, scene, Tolerance::default(), range, cubic)
        };
        let message = table(&odd, "at", (0.0, 4.0, 9)).unwrap_err().to_string();
        assert!(message.starts_with("AT: at a separation of") && message.contains("required"));
        let message = table(&scene(), "ke", (0.0, 6.0, 2)).unwrap_err().to_string();
        assert!(message.starts_with("2 nodes are too few"), "{message}");
        assert!(table(&scene(), "ke", (1.0, 1.0, 5)).is_err());
    }
}
