//! Unloading, cycles and partial slip of closed joints, and correlations of their thermal
//! conductance ([`conductance`]).
//!
//! # Unloading
//! At the closest approach each asperity has an interference w, force F and area A = π a². After a
//! retreat u, with δ the retreat at which the asperity loses contact, it carries
//! ```text
//! force F (1 - u/δ)ⁿ       area A' (1 - u/δ)       for u < δ, 0 beyond
//!
//! law       δ                                   n                A'
//! hertz     3F/(4 E a)                          1.5              A           [seen]
//! brake     F/((4/3) E √(R w))                  1.5              π R_b δ     [seen]
//! etsion    w [1 - (1-x^-.28)(1-x^-.69)]        1.5 x^-.0331     none        [recalled]
//! ```
//! x = w/w_c > 1 (Hertz otherwise), R_b = F²/[((4/3) E)² δ³]. For elastic asperities all three
//! equal the loading curve, except that Etsion's fit starts at w_c: where a loading law stays
//! Hertzian beyond w_c (JG, up to 1.9 w_c), Etsion's law dissipates up to 2 % of the work of such
//! an asperity. The slope of Hertz' law at u = 0 is 2 E a exactly; Brake's area jumps there;
//! Etsion's exponent of the area differs from finite elements by up to 12 % and is not used. The
//! sum over the heights is the usual integral at the closest approach, with another law of w.
//! Reloading retraces this curve to the closest approach and then follows the virgin curve;
//! shakedown of the spheres is ignored.
//!
//! # Cycles
//! The closest approach is the only state variable: a [`Joint`] follows turning points
//! ([`Joint::path`]; [`Joint::turning_points`] converts loads), and [`Joint::table`] returns force
//! and stiffness of a step in some tens of nanoseconds. Each asperity returns F δ/(n+1) of its work
//! of loading, so that the dissipated energy ([`Work::lost`]) is also an integral over the heights;
//! a cycle between fixed separations dissipates it once, in the first cycle. Where a loading law is
//! steeper than Hertz' (AF) or jumps up (CEB, KE), the asperity recovers by more than w and creates
//! energy, reported by [`Joint::energy_gain`]. Loss factors are the dissipated energy over 2π times
//! the energy supplied ([`Work::loss_factor`], [`PartialSlip::loss_factor`]). Unbounded heights
//! leave a finite average number of contacts at any retreat: contact ends where fewer than one
//! asperity is left ([`Unloading::last_contact`]). [`restitution`] of one asperity is
//! √(work returned/work spent). \[derived\]
//!
//! # Partial slip
//! For asperities with elastic tangential response, friction μ and constant separation, Cattaneo's
//! and Mindlin's contact gives the tangential force as the normal force released by a retreat s,
//! ```text
//! Q(u) = μ [F(0) - F(s)],     s = 4 G u/(μ E)
//! ```
//! and a cycle of amplitude ±D at constant separation dissipates W = 8 ∫₀ᴰ Q du - 4 Q(D) D
//! (Masing). \[derived\] Slip under a varying normal load is not covered: the state of each
//! asperity is then the whole history of its contact radius, a function of its height that no
//! number of the joint holds, and Masing's rule does not apply.
//!
//! Provenance of equations: \[seen\] in the source, \[recalled\] from memory, \[derived\] here.
//!
//! # Source
//! Hertz' unloading from public code that cites Jackson 2010; Brake 2015 from two public codes;
//! Etsion, Kligerman & Kadin 2005; Mindlin 1949.
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
mod correlation;
mod joint;
mod path;
#[cfg(test)]
mod published_tests;
mod retreat_model;
mod slip;
mod strips;
mod table;
mod tabulated_law;
mod unloading;
mod unloading_law;
mod work;

pub use asperity_laws::restitution;
pub use correlation::{Correlated, Correlation};
pub use joint::Joint;
pub use path::{Path, Point};
pub use slip::{PartialSlip, coefficient_of_friction};
pub use table::{JointTable, Reply};
pub use unloading::Unloading;
pub use unloading_law::UnloadingLaw;
pub use work::{EnergyGain, Work};
