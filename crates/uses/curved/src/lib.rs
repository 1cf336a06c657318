//! Curved bodies with rough surfaces: a sphere, an ellipse or a cylinder on a flat, with any model
//! of rough surfaces between them.
//!
//! The bodies deflect as half spaces under the pressure that the model gives at each place:
//!
//! ```text
//! d(x, y) = d₀ + x²/(2 R_x) + y²/(2 R_y) + u(x, y)      p = P(d)
//! u = ∫ p dx' dy'/(π E r)                                F = ∫ p dx dy
//! ```
//!
//! and for cylinders, per length, u = (2/(π E)) ∫ p ln(L/|x - s|) ds with a reference length L
//! (Greenwood & Tripp 1967). P contains the compliance of the asperities, u adds the bodies'
//! under the mean pressure: a correction of P for interaction has no place in it. Newton's method
//! solves for the separations d on a regular grid, with spectral accuracy.
//!
//! ```
//! use asperity_core::{ContactError, Interface, Scene, Surface, Tolerance};
//! use asperity_curved::{Curved, Shape};
//! use asperity_ke::KogutEtsion;
//!
//! let interface = Interface::new(115.4e9, 0.3, 4e9); // E, ν, H
//! let surface = Surface::new(1e-4, 1e9, 0.5e-6); // R, η, σ_z of the asperities
//! let scene = Scene::new(interface, surface, 1e-6); // the nominal area does not matter
//! let ball = Shape::Point { radius_x: 6.35e-3, radius_y: 6.35e-3 };
//! let curved = Curved::new(&KogutEtsion, &scene, ball, &[], Tolerance::new(1e-6)?)?;
//! let found = curved.at_load(30.0)?;
//! assert!((found.peak_pressure() / 827.580574767e6 - 1.0).abs() < 1e-6);
//! assert!(found.peak_pressure() < 0.8 * found.hertz.peak_pressure);
//! # Ok::<(), ContactError>(())
//! ```

mod hertz;
mod kernel;
mod layer;
mod model;
mod solution;
mod solve;

use std::f64::consts::PI;

use asperity_core::{ContactError, ContactModel, Quantity, Scene, Tolerance, positive};

pub use hertz::Hertz;
pub use model::BetweenCurved;
pub use solution::Solution;

use kernel::quick;
use layer::Layer;
use solve::State;

/// The share of the peak pressure at the edge of the grid.
const EDGE: f64 = 1e-9;
/// The most by which the grid is widened where the pressure at its edge is larger.
const WIDEST: f64 = 6.0;
/// Loads below this share of E σ_z² are those of bodies that do not touch.
const FREE: f64 = 1e-30;
/// The smallest tolerance: the pressure at the edge of the grid is 1e-9 of its peak.
const FINEST: f64 = 1e-8;
/// The tolerance where the default one is asked for, which would take ten times as long.
const USUAL: f64 = 1e-6;
/// The tolerance with which the load of an approach is searched until a step changes it by less
/// than the second number.
const SEARCH: f64 = 1e-3;
const NEAR: f64 = 0.03;
/// The last step of the search over the tolerance.
const LAST: f64 = 0.1;
/// The largest number of points along a side.
const MOST: usize = 768;

/// The undeformed bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Contact at a point.
    Point {
        /// Relative radius of curvature along x \[m\], 1/R = 1/R₁ + 1/R₂, above 0.
        radius_x: f64,
        /// The same along y, above 0.
        radius_y: f64,
    },
    /// Contact along a line.
    Line {
        /// Relative radius of curvature \[m\], above 0.
        radius: f64,
        /// Length of the contact \[m\], above 0.
        length: f64,
        /// The length L in the deflection \[m\], on which the approach depends.
        reference_length: Option<f64>,
    },
}

impl Shape {
    /// Of a line, its length; 1 of a point.
    fn length(&self) -> f64 {
        match *self {
            Self::Point { .. } => 1.0,
            Self::Line { length, .. } => length,
        }
    }
}

/// The points at which a contact is solved; of a line one row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Grid {
    /// Points along x and y.
    n: [usize; 2],
    /// Their distances \[m\], 1 across a line.
    steps: [f64; 2],
}

impl Grid {
    /// A coordinate of a point, from the middle of the patch \[m\].
    fn place(&self, k: usize, axis: usize) -> f64 {
        let i = if axis == 0 { k % self.n[0] } else { k / self.n[0] };
        (i as f64 - (self.n[axis] / 2) as f64) * self.steps[axis]
    }

    fn centre(&self) -> usize {
        self.n[1] / 2 * self.n[0] + self.n[0] / 2
    }

    /// The reference length of a line, with which all deflections are positive; approaches are
    /// converted.
    fn reference(&self) -> f64 {
        4.0 * self.n[0] as f64 * self.steps[0]
    }
}

/// A model between curved bodies, for many loads.
#[derive(Debug)]
pub struct Curved {
    layer: Layer,
    shape: Shape,
    tolerance: f64,
}

fn refused<T>(reason: &'static str) -> Result<T, ContactError> {
    let model = "a contact of curved bodies".into();
    Err(ContactError::Refused { model, reason: reason.into() })
}

impl Curved {
    /// Compiles a model for these bodies: for pressures, and for the quantities asked for (area,
    /// contacts, unloading stiffness). The numbers of solutions are right to the tolerance, from
    /// 1e-8, relative to the value, lengths to the larger of value and σ_z; to 1e-6 where the
    /// default tolerance is asked for, as finer ones take longer here.
    ///
    /// # Errors
    /// Radii and lengths that are not above 0, a tolerance below 1e-8 other than the default,
    /// models with adhesion, and the errors of the model.
    pub fn new(
        model: &dyn ContactModel,
        scene: &Scene,
        shape: Shape,
        asked: &[Quantity],
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        match shape {
            Shape::Point { radius_x, radius_y } => {
                positive("radius_x", radius_x)?;
                positive("radius_y", radius_y)?;
            }
            Shape::Line { radius, length, reference_length } => {
                positive("radius", radius)?;
                positive("length", length)?;
                positive("reference_length", reference_length.unwrap_or(1.0))?;
            }
        }
        let tolerance = match tolerance {
            unasked if unasked == Tolerance::default() => Tolerance::new(USUAL)?,
            finer if finer.relative() < FINEST => {
                let (field, value) = ("tolerance", finer.relative());
                let required = "at least 1e-8 between curved bodies, where the default is 1e-6";
                return Err(ContactError::OutOfRange { field, value, required });
            }
            asked => asked,
        };
        let of_layer = Tolerance::new((0.01 * tolerance.relative()).max(1e-12))?;
        let layer = Layer::new(model, scene, asked, of_layer)?;
        Ok(Self { layer, shape, tolerance: tolerance.relative() })
    }

    /// The contact at a load \[N\].
    ///
    /// # Errors
    /// A load that is not above 0 or under which the roughness does not matter, a model whose
    /// pressure rises with the separation or does not vanish beside the patch, and a search that
    /// does not converge.
    pub fn at_load(&self, load: f64) -> Result<Solution<'_>, ContactError> {
        self.at(positive("load", load)?, self.tolerance)
    }

    /// The contact at a load \[N\] to a tolerance.
    fn at(&self, load: f64, tolerance: f64) -> Result<Solution<'_>, ContactError> {
        let hertz = Hertz::new(&self.shape, self.layer.modulus, load);
        if self.points(&hertz, tolerance) > MOST {
            return refused(
                "the bodies approach by more than 2000 times the roughness: take them as smooth, by Hertz",
            );
        }
        let mut wider = 1.0;
        loop {
            let state = self.solve(&hertz, load, wider, tolerance)?;
            let edge = state.edge() / state.peak();
            if edge <= 10.0 * EDGE {
                return Ok(Solution { of: self, state, load, hertz });
            }
            wider *= 1.3;
            if wider > WIDEST {
                return refused("the pressure does not vanish beside the patch");
            }
        }
    }

    fn solve(
        &self,
        hertz: &Hertz,
        load: f64,
        wider: f64,
        tolerance: f64,
    ) -> Result<State, ContactError> {
        let (modulus, load) = (self.layer.modulus, load / self.shape.length());
        let (radii, gap): (_, fn(f64) -> f64) = match self.shape {
            Shape::Point { radius_x, radius_y } => ([radius_x, radius_y], gap_of_sphere),
            Shape::Line { radius, .. } => ([radius, f64::INFINITY], gap_of_cylinder),
        };
        // The start: a wider patch, with the pressure of Hertz.
        let widened = |k: usize| hertz.axes[k].hypot((1.5 * radii[k] * self.layer.sigma).sqrt());
        let axes = [0, 1].map(widened);
        let is_line = axes[1].is_infinite();
        let peak = match is_line {
            true => 2.0 * load / (PI * axes[0]),
            false => 1.5 * load / (PI * axes[0] * axes[1]),
        };
        // How far the bodies part beyond the patch, from the peak to the edge of the grid.
        let apart = self.layer.separation(EDGE * peak)? - self.layer.separation(peak)?;
        let half = |k: usize| wider * axes[k] * reach(apart * radii[k] / axes[k].powi(2), gap);
        let n = self.points(hertz, tolerance);
        let grid = match is_line {
            true => Grid { n: [n, 1], steps: [2.0 * half(0) / n as f64, 1.0] },
            false => Grid { n: [n, n], steps: [0, 1].map(|k| 2.0 * half(k) / n as f64) },
        };
        let square = |k: usize, over: [f64; 2]| -> f64 {
            (0..2).map(|axis| grid.place(k, axis).powi(2) / over[axis]).sum()
        };
        let points = 0..grid.n[0] * grid.n[1];
        let shape = points.clone().map(|k| square(k, radii.map(|radius| 2.0 * radius))).collect();
        let within = |k| 1.0 - square(k, axes.map(|axis| axis * axis));
        let pressures: Vec<f64> = points.map(|k| peak * within(k).max(0.0).sqrt()).collect();
        let kernel = match is_line {
            true => kernel::of_line(n, grid.steps[0], modulus, grid.reference()),
            false => kernel::of_area(n, grid.steps, modulus),
        };
        let mut state = State::new(&self.layer, kernel, grid, shape, &pressures, load)?;
        state.solve(&self.layer, load, tolerance)?;
        Ok(state)
    }

    /// Points along a side: the pressure falls to 0 over a length that shrinks with the root of
    /// α = σ/(approach of Hertz), and the error by 100 with 2.2 more points in it.
    fn points(&self, hertz: &Hertz, tolerance: f64) -> usize {
        let alpha = match self.shape {
            Shape::Point { .. } => self.layer.sigma / hertz.approach.unwrap_or(f64::NAN),
            Shape::Line { radius, .. } => self.layer.sigma * radius / hertz.axes[0].powi(2),
        };
        let of_length = (12.0 - 2.2 * (tolerance.log10() + 6.0)).max(6.0);
        // Infinitely many of smooth bodies.
        let n = (of_length / alpha.sqrt()).max(2.6 * of_length).min(2.0 * MOST as f64);
        quick(n.ceil() as usize)
    }

    /// The contact at an approach \[m\].
    ///
    /// # Errors
    /// The errors of [`at_load`](Self::at_load), and an approach of a line without a reference
    /// length.
    pub fn at_approach(&self, approach: f64) -> Result<Solution<'_>, ContactError> {
        if matches!(self.shape, Shape::Line { reference_length: None, .. }) {
            return refused("the approach of a line contact needs a reference length");
        }
        // Smooth bodies, at the approach of which asperities have only just been met.
        let reach = approach.max(0.0) + 3.0 * self.layer.sigma;
        let unit = Hertz::new(&self.shape, self.layer.modulus, 1.0);
        let mut load = match self.shape {
            Shape::Point { .. } => (reach / unit.approach.unwrap_or(f64::NAN)).powf(1.5),
            Shape::Line { length, .. } => reach * self.layer.modulus * length,
        };
        let mut tolerance = self.tolerance.max(SEARCH);
        for _ in 0..60 {
            let mut found = self.at(load, tolerance)?;
            let missing = approach - found.approach().unwrap_or(f64::NAN);
            // Newton's method for the logarithm of the load, which never leaves it positive.
            let change = found.tangent_within(tolerance)? * missing / load;
            if tolerance <= self.tolerance && change.abs() < LAST * self.tolerance {
                return Ok(found);
            }
            load *= change.clamp(-4.0, 4.0).exp();
            if load < FREE * self.layer.modulus * self.layer.sigma.powi(2) {
                return refused("the bodies do not touch at this approach");
            }
            if change.abs() < NEAR {
                tolerance = self.tolerance;
            }
        }
        refused("no load has this approach")
    }

    /// How much larger an approach is than with the reference length of a grid, at a unit of load
    /// per length; `None` of a line without a reference length.
    fn beyond_grid(&self, grid: &Grid) -> Option<f64> {
        match self.shape {
            Shape::Point { .. } => Some(0.0),
            Shape::Line { reference_length, .. } => reference_length
                .map(|l| 2.0 / (PI * self.layer.modulus) * (l / grid.reference()).ln()),
        }
    }
}

/// The multiple of a half axis at which a gap beyond the patch, over a²/R, is this large.
fn reach(apart: f64, gap: fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (1.0, 2.0);
    while gap(high) < apart {
        high *= 2.0;
    }
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        if gap(middle) < apart { low = middle } else { high = middle }
    }
    high
}

/// Gap beside Hertz' contact of a sphere over a²/R, at a multiple of the radius.
fn gap_of_sphere(t: f64) -> f64 {
    let root = (t * t - 1.0).max(0.0).sqrt();
    (root + (t * t - 2.0) * (1.0 / t).acos()) / PI
}

/// The same of a cylinder.
fn gap_of_cylinder(t: f64) -> f64 {
    let root = (t * t - 1.0).max(0.0).sqrt();
    0.5 * (t * root - (t + root).ln())
}
