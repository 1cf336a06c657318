//! Boundary elements: the contact of a rigid rough surface, given pixel by pixel, with an elastic
//! half-space with or without a hardness; no asperities, no statistics.
//!
//! # Equations
//! ```text
//! g = u - h - c,    p >= 0,  g >= 0,  p g = 0              elastic
//!                   0 <= p <= H,  g >= 0 where p = 0,  g = 0 between,  g <= 0 where p = H
//! mean of p = F/A_n                                        or mean of g = given
//! u^(q) = 2 p^(q)/(E |q|),  u^(0) = 0                      periodic
//! u = Σ p(x', y') K(x - x', y - y'),
//! π E K(x, y) = ∫∫ dx' dy'/√((x - x')² + (y - y')²)        free; the integral over a pixel in
//!                                                          closed form
//! ```
//! p pressure, g gap, u deflection, h height (towards the half-space), c position of the rigid
//! surface, E equivalent modulus, q wave vector. Frictionless. Where p = H the gap is negative: it
//! is the plastic depth.
//!
//! The solution has the least energy Σ p (u/2 - h); `iteration.rs` describes the method. 10 to 60
//! iterations of two to three transforms, on grids of any size.
//!
//! # Leaks
//! ```text
//! ∇·(g³ ∇P) = 0,  P falls by 1 along x,  g = 0 in contact        q = h_eff³/(12 μ) Δp/L
//! ```
//! [`BoundaryElements::hydraulic_gap`] is h_eff of the flow q per width through the gap of a
//! solution, along rows or columns: Reynolds' equation in finite volumes, the harmonic mean of g³
//! between two pixels, P even on both faces. Pixels meet over edges, and without an open path
//! h_eff is 0. Nested dissection takes the pixels out one by one, as resistors of a network: sums
//! and products of positive numbers, so that rounding stays near 1e-14 of h_eff over any range of
//! g, without iterations. \[derived\] Both directions share most of the work: on 512 x 512 pixels
//! they take together 1.9 times the time of the contact at 0.6 % of real area, 0.24 times at 37 %
//! (the random surface of `examples/timing.rs`). The flows through both faces are compared in every
//! answer.
//!
//! [`BoundaryElements::seal_flows`] is the leak of a liquid or a gas through a seal that continues
//! the map: gas by the local Knudsen number of every pixel, at four pressures between the sides;
//! \[derived\] within 1e-4 of the fit of its law for helium from 10 to 1 bar through 1 um.
//!
//! # Valid for
//! Small slopes. Resolved maps: [`Solution::notes`] reports waves and contacts of few pixels;
//! [`HeightMap::half_grid`] shows how much depends on the grid. A periodic map whose edges do not
//! match has steps there, real or not: see [`Continuation`].
//!
//! The hardness limits the pressure, which models a material of constant mean pressure H and
//! differs from elastic-plastic finite elements. A sphere starts to yield at Hertz' p_max = H.
//!
//! Memory for a contact of n x m pixels, in arrays of n x m `f64`: 9 if it is periodic, 13 if it
//! is free, and 2 in every answer. 2048 x 2048 periodic pixels take
//! 300 MB.
//!
//! # Source
//! Polonsky & Keer, Wear 231 (1999): conjugate gradients between bounds. \[recalled\] Stanley &
//! Kato (1997): the periodic kernel \[recalled\]; as tamaas and ContactMechanics use it \[seen\].
//! Love (1929): the free kernel. \[recalled\] Almqvist and others (2007): the hardness as a cap.
//! \[recalled\] The projection onto both bounds and the load: here.
//! \[derived\] Elastic contact pixels equal tamaas 2.9.0 and ContactMechanics 1.8.3 at every
//! load of `tests/reference/bem_codes.csv`, with a hardness areas are within 0.3 % of
//! ContactMechanics', and all equal the solutions of dense linear systems in
//! `tests/reference/bem_dense.csv`, as do stiffnesses at fixed contact. Leaks: dense systems,
//! layers, a square array of square obstacles (Obnosov 1999 \[recalled\]), Keller's duality, in the
//! tests.
//!
//! # Example
//! ```
//! use asperity_bem::{BoundaryElements, LoadCase, RandomSurface};
//!
//! // 100 µm square of steel-like roughness: rms gradient 0.1, 2 to 16 waves per side.
//! let surface = RandomSurface::new(2.0, 4.0, 16.0)?.side(1e-4)?.gradient(0.1)?.seed(1);
//! let elastic = BoundaryElements::new(surface.heights(128)?, 115e9)?;
//! let soft = elastic.clone().hardness(3e9)?;
//! for pressure in [20e6, 200e6] {
//!     let given = LoadCase::MeanPressure(pressure);
//!     let (elastic, soft) = (elastic.solve(given)?, soft.solve(given)?);
//!     assert!(soft.area > elastic.area && soft.mean_gap < elastic.mean_gap);
//!     println!("{:.2} % of the area in {} patches", 100.0 * soft.area, soft.patches.len());
//! }
//! # Ok::<(), asperity_bem::BemError>(())
//! ```

mod compliance;
mod continuation;
mod error;
mod front;
mod half_space;
mod height_map;
mod hydraulic;
mod iteration;
mod light;
mod model;
mod network;
mod note;
mod parallel;
mod projection;
mod random_surface;
mod seal;
mod sealing;
mod seam;
mod slip;
mod solution;
mod solver;
mod summary;
mod unloading;
mod unloading_path;

pub use continuation::{BemOptions, Continuation};
pub use error::BemError;
pub use half_space::{Boundary, HalfSpace};
pub use height_map::HeightMap;
pub use light::LightContact;
pub use model::Bem;
pub use network::Direction;
pub use random_surface::RandomSurface;
pub use seal::{Fluid, Gas, Rarefaction, Seal, SealFlow};
pub use sealing::Sealing;
pub use slip::ContactSlip;
pub use solution::{EDGE_SHARE, LoadCase, Solution};
pub use solver::{BoundaryElements, Progress};
pub use summary::ContactSummary;
pub use unloading::FixedContact;
pub use unloading_path::UnloadingPath;
