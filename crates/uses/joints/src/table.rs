//! Force and stiffness for time-stepping codes: one state variable, some tens of nanoseconds.
//!
//! The unloading curves are tabulated (`strips`); the virgin curve is the compiled contact.

use asperity_core::{At, ContactError, Separation};
use serde::{Deserialize, Serialize};

use crate::joint::Joint;

/// Terms in each direction.
pub(crate) const TERMS: usize = 8;

/// A range of closest approaches.
#[derive(Debug, Clone)]
pub(crate) struct Strip {
    /// Start of the range \[m\], and 2 over its length \[1/m\].
    pub(crate) from: f64,
    pub(crate) scale: f64,
    /// Ascending in u.
    pub(crate) cells: Vec<StripCell>,
}

/// Retreats from `from` to `to`.
#[derive(Debug, Clone)]
pub(crate) struct StripCell {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Coefficients of Tᵢ(c) Tⱼ(u), `terms[i][j]`.
    pub(crate) terms: [[f64; TERMS]; TERMS],
    /// Lower limit of the force \[N\]: 0, or minus infinity if the model has tensile forces.
    pub(crate) least: f64,
}

/// A joint, tabulated for many steps. The closest approach is all that a contact must remember.
///
/// A mass that falls on a rough surface and rebounds:
/// ```
/// use asperity_core::{Interface, Scene, Surface, Tolerance};
/// use asperity_joints::{Joint, UnloadingLaw};
/// use asperity_ke::KogutEtsion;
///
/// let surface = Surface::new(3.6e-4, 1.11e8, 1e-6);
/// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), surface, 3e-5);
/// let joint = Joint::new(&KogutEtsion, &scene, UnloadingLaw::Hertz, Tolerance::default())?;
/// let table = joint.table((-0.5e-6, 4e-6), 1e-6)?;
/// let mut closest = f64::INFINITY; // of a contact that has never been closed
/// let (mass, gravity, dt) = (0.1, 9.81, 1e-7);
/// let (mut separation, mut speed) = (8e-6, -0.01_f64); // m, m/s
/// let (mut energies, mut before) = (vec![], speed);
/// for _ in 0..200_000 {
///     let reply = table.at(separation, closest)?;
///     closest = reply.closest;
///     speed += dt * (reply.force / mass - gravity);
///     separation += dt * speed;
///     if before > 0.0 && speed <= 0.0 {
///         energies.push(mass * gravity * separation); // at rest, at the top
///     }
///     before = speed;
/// }
/// // The first impact dissipates energy; later ones are elastic, as they are less deep.
/// let start = mass * (gravity * 8e-6 + 0.5 * 0.01 * 0.01);
/// assert!(energies.len() > 2 && energies[0] < 0.6 * start, "{energies:?}");
/// assert!((energies[1] / energies[0] - 1.0).abs() < 1e-2, "{energies:?}");
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone)]
pub struct JointTable {
    joint: Joint,
    /// Ascending in c.
    strips: Vec<Strip>,
    /// The smallest c \[m\].
    deepest: f64,
    /// The largest c that is tabulated \[m\].
    open: f64,
    /// The highest asperity \[m\].
    highest: f64,
    /// 1/σ_z, as the virgin curve is fastest for multiples of σ_z.
    per_metre: f64,
}

/// The response of a step; its closest approach is all that must be saved of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Reply {
    /// The force \[N\].
    pub force: f64,
    /// -dF/dd \[N/m\] of the present curve: the exact slope of [`force`](Self::force) as tabulated,
    /// as Newton's method needs. It differs from the slope of the joint's own curve by about 1e-3
    /// of the stiffness at the closest approach for a table with a tolerance of 1e-6.
    pub stiffness: f64,
    /// The closest approach \[m\], this step included.
    pub closest: f64,
}

impl JointTable {
    pub(crate) fn new(
        joint: Joint,
        strips: Vec<Strip>,
        (deepest, open, highest): (f64, f64, f64),
    ) -> Self {
        let per_metre = joint.scene().surface.asperity_height_std.recip();
        Self { joint, strips, deepest, open, highest, per_metre }
    }

    /// Force and stiffness at a separation \[m\] of a contact with the closest approach `closest`
    /// \[m\], infinite for a new contact; the reply contains `closest` for the next step.
    ///
    /// # Errors
    /// [`ContactError::BelowTable`] for a separation or a closest approach that is NaN or below the
    /// deepest of the table.
    #[inline]
    pub fn at(&self, separation: f64, closest: f64) -> Result<Reply, ContactError> {
        if separation < closest || closest >= self.open {
            let closest = separation.min(closest);
            if closest < self.deepest || separation.is_nan() {
                return Err(self.below_table(separation, closest));
            }
            if separation >= self.highest {
                return Ok(Reply { force: 0.0, stiffness: 0.0, closest });
            }
            let (force, tangent) =
                self.joint.virgin().force_and_tangent(At::sigmas(separation * self.per_metre))?;
            return Ok(Reply { force: force.value(), stiffness: tangent.value(), closest });
        }
        let after = self.strips.partition_point(|strip| strip.from <= closest);
        let strip = after.checked_sub(1).map(|k| &self.strips[k]);
        let strip = strip.filter(|_| separation >= closest);
        let strip = strip.ok_or_else(|| self.below_table(separation, closest))?;
        let retreat = separation - closest;
        let cell = strip.cells.partition_point(|cell| cell.to <= retreat);
        let (force, stiffness) = match strip.cells.get(cell) {
            Some(cell) => cell.at((closest - strip.from) * strip.scale - 1.0, retreat),
            None => (0.0, 0.0),
        };
        Ok(Reply { force, stiffness, closest })
    }

    /// The error for a separation if it is the new closest approach, otherwise for `closest`.
    fn below_table(&self, separation: f64, closest: f64) -> ContactError {
        let is_step = separation.is_nan() || separation <= closest;
        let (field, value) =
            if is_step { ("separation", separation) } else { ("closest", closest) };
        let deepest = Separation::metres(self.deepest);
        ContactError::BelowTable { field, separation: Separation::metres(value), deepest }
    }
}
