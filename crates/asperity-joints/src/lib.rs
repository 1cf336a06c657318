//! What a joint does after it was closed: unloading, cycles, and partial slip under a tangential
//! force; and the correlations of its thermal conductance ([`conductance`]).
//!
//! # Unloading
//! Each asperity has been pressed to its own w, with force F, area A = π a². When the flat has gone
//! back by u, the asperity carries, with δ the way back to where its contact is lost,
//! ```text
//! force F (1 - u/δ)ⁿ       area A' (1 - u/δ)       for u < δ, nothing beyond
//!
//! law       δ                                   n                A'
//! hertz     3F/(4 E a)                          1.5              A           [seen]
//! brake     F/((4/3) E √(R w))                  1.5              π R_b δ     [seen]
//! etsion    w [1 - (1-x^-.28)(1-x^-.69)]        1.5 x^-.0331     none        [recalled]
//! ```
//! x = w/w_c > 1 (Hertz otherwise), R_b = F²/[((4/3) E)² δ³]. Where the asperity is elastic, all of
//! them are its loading curve; but Etsion's fit counts from w_c, and where a loading law stays
//! Hertz' for longer (JG, up to 1.9 w_c) it loses up to 2 % of the work of such an asperity. Hertz'
//! slope at u = 0 is 2 E a exactly; with Brake's the area jumps there; Etsion's own exponent of the
//! area misses finite elements by up to 12 % and is left out. The sum over the heights at the
//! closest approach is the usual integral, with another law of w in it. Coming closer again
//! retraces this to the closest approach, and then follows the virgin curve; that spheres shake
//! down within cycles is ignored.
//!
//! # Cycles
//! All that the contact remembers is its closest approach: a [`Joint`] goes through turning points
//! ([`Joint::path`]; loads become such by [`Joint::turning_points`]), and [`Joint::table`] answers
//! force and slope of a step in some tens of nanoseconds. The asperity gives back F δ/(n+1) of the
//! work that pressed it to w, so that what yielding has taken for good ([`Work::lost`]) is again an
//! integral over the heights, and a cycle between fixed separations loses it once. Where a loading
//! law is steeper than Hertz' (AF) or jumps up (CEB, KE), the asperity recovers by more than w and
//! creates energy: [`Joint::energy_gain`] is the finding. Loss factors are what is lost over 2π
//! times what was put in ([`Work::loss_factor`], [`PartialSlip::loss_factor`]). Heights without an
//! end touch at any retreat, in numbers: contact ends where fewer than one asperity is left
//! ([`Unloading::last_contact`]). √(work back/work spent) of one asperity is its [`restitution`].
//! \[derived\]
//!
//! # Partial slip
//! Asperities that answer elastically, friction μ, constant separation: Cattaneo's and Mindlin's
//! contact makes the tangential force the part of the normal one that a retreat by s releases,
//! ```text
//! Q(u) = μ [F(0) - F(s)],     s = 4 G u/(μ E)
//! ```
//! and amplitudes ±D at constant separation lose W = 8 ∫₀ᴰ Q du - 4 Q(D) D a cycle (Masing).
//! \[derived\] Varying normal loads are not covered: there, Masing's rule fails.
//!
//! # Source
//! Hertz' unloading as code that cites Jackson 2010 has it; Brake 2015 in two public codes; Etsion,
//! Kligerman & Kadin 2005; Mindlin 1949.
//!
//! # Example
//! ```
//! use asperity_core::{At, Interface, Scene, Surface, Tolerance};
//! use asperity_joints::{PartialSlip, Unloading, UnloadingLaw};
//! use asperity_ke::KogutEtsion;
//!
//! let mut interface = Interface::new(116e9, 0.31, 1.12e9);
//! interface.equivalent_shear_modulus = Some(41e9);
//! let scene = Scene::new(interface, Surface::new(3.6e-4, 1.11e8, 1e-6), 3e-5);
//! let closest = At::Pressure(5e6);
//! let joint = Unloading::new(&KogutEtsion, &scene, closest, UnloadingLaw::Hertz, Tolerance::default())?;
//! assert!((joint.force(0.0)?.value() - 150.0).abs() < 1e-6);
//! let slip = PartialSlip::new(&joint, 0.2)?;
//! let (small, large) = (slip.force(1e-9)?.value(), slip.force(1e-4)?.value());
//! assert!(small < large && (large / 30.0 - 1.0).abs() < 1e-6, "gross slip at μ F: {large}");
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

mod asperity_laws;
pub mod conductance;
mod contact_range;
mod energy_gain;
mod joint;
mod path;
mod remaining;
mod root;
mod slip;
mod strips;
mod table;
mod unloading;
mod work;

pub use asperity_laws::restitution;
pub use energy_gain::EnergyGain;
pub use joint::Joint;
pub use path::{Path, Point};
pub use slip::{PartialSlip, coefficient_of_friction};
pub use table::{JointTable, Memory, Reply};
pub use unloading::{Unloading, UnloadingLaw};
pub use work::Work;
