//! Integrals that many scenes share: parts of laws that recur, up to their units and a factor.

use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

use asperity_quadrature::AnyScale;

use crate::{Part, Tolerance};

/// Number of shapes kept.
const SHAPES: usize = 64;

/// A part of a law without its factor, and its integral.
#[derive(Debug)]
pub(crate) struct Shape {
    part: Part,
    pub(crate) integral: AnyScale,
    /// Whether the shape has recurred.
    recurs: AtomicBool,
}

/// The shapes of all threads.
#[derive(Debug, Default)]
pub(crate) struct Shapes(RwLock<Vec<Arc<Shape>>>);

impl Shapes {
    /// The shape of a part, new or kept.
    fn shape(&self, part: &Part, tolerance: Tolerance) -> Arc<Shape> {
        let known = |shapes: &[Arc<Shape>]| shapes.iter().find(|s| s.part.recurs_in(part)).cloned();
        let shapes = self.0.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(shape) = known(&shapes) {
            shape.recurs.store(true, Ordering::Relaxed);
            return shape;
        }
        drop(shapes);
        let mut shapes = self.0.write().unwrap_or_else(PoisonError::into_inner);
        // Another thread may have added it meanwhile.
        if let Some(shape) = known(&shapes) {
            return shape;
        }
        let part = part.without_factor();
        let integral = AnyScale::new(part.density(), tolerance.relative());
        let shape = Arc::new(Shape { part, integral, recurs: AtomicBool::new(false) });
        if shapes.len() >= SHAPES {
            shapes.retain(|shape| shape.recurs.load(Ordering::Relaxed));
        }
        if shapes.len() < SHAPES {
            shapes.push(shape.clone());
        }
        shape
    }
}

/// A shape of all threads, counted within one: no row writes what another thread reads.
pub(crate) struct LocalShape(pub(crate) Arc<Shape>);

/// One thread's view of the shapes.
pub(crate) struct RecentShapes<'s> {
    shapes: &'s Shapes,
    tolerance: Tolerance,
    /// Shapes of the previous case, part by part: mostly the next one's as well.
    recent: Vec<Rc<LocalShape>>,
}

impl<'s> RecentShapes<'s> {
    pub(crate) fn new(shapes: &'s Shapes, tolerance: Tolerance) -> Self {
        Self { shapes, tolerance, recent: vec![] }
    }

    /// The shape of a part, at its place in the laws of a case.
    pub(crate) fn shape(&mut self, place: usize, part: &Part) -> Rc<LocalShape> {
        if let Some(shape) = self.recent.get(place)
            && shape.0.part.recurs_in(part)
        {
            return shape.clone();
        }
        let shape = Rc::new(LocalShape(self.shapes.shape(part, self.tolerance)));
        if place >= self.recent.len() {
            self.recent.resize(place + 1, shape.clone());
        }
        self.recent[place] = shape.clone();
        shape
    }
}
