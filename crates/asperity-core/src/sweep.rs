//! Many scenes, one model: what their laws have in common is integrated once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

use asperity_quadrature::{AnyScale, Density, Moments};
use rayon::prelude::*;

use crate::channel::{check_scales, failed, law_of};
use crate::evaluation::Units;
use crate::height_integral::HeightIntegral;
use crate::request::checked_separation;
use crate::{
    ContactError, ContactModel, Evaluation, Form, HeightDistribution, Law, Part, Power, Quantity,
    Scene, Tolerance,
};

/// Cases handed to a thread at a time.
const TOGETHER: usize = 256;
/// Cases of a stream that are held in memory.
const HELD: usize = 16_384;
/// Shapes that are kept.
const SHAPES: usize = 64;

/// A scene and a separation d/σ_z on it.
#[derive(Debug, Clone)]
pub struct Case {
    /// The scene.
    pub scene: Scene,
    /// d/σ_z, from the mean of the asperity heights.
    pub separation: f64,
}

/// One model on many scenes: the part of a law that recurs, up to its units and a factor, is
/// integrated once, whatever the scale it comes back at. Threads share what has been built.
///
/// ```
/// # use asperity_core::*;
/// # fn demo(model: &dyn ContactModel, scene: Scene) -> Result<(), ContactError> {
/// let sweep = Sweep::new(model, &[Quantity::Force], Tolerance::default());
/// let rougher = |k: u32| {
///     let mut scene = scene.clone();
///     scene.surface.asperity_height_std *= 1.0 + 1e-6 * f64::from(k);
///     Case { scene, separation: 1.0 }
/// };
/// // A million scenes, 16384 at a time in memory, in order.
/// sweep.stream((0..1_000_000).map(rougher), |_, answer| {
///     println!("{} N", answer?[0].value());
///     Ok::<(), ContactError>(())
/// })?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Sweep<'m> {
    model: &'m dyn ContactModel,
    quantities: Vec<Quantity>,
    tolerance: Tolerance,
    separation_rounding: f64,
    shapes: RwLock<Vec<Arc<Shape>>>,
}

/// A part of a law without its factor, and its integral.
#[derive(Debug)]
struct Shape {
    part: Part,
    integral: AnyScale,
    /// Whether it has been found again.
    recurs: AtomicBool,
}

impl<'m> Sweep<'m> {
    /// Prepares nothing: laws are built for the scenes that come.
    #[must_use]
    pub fn new(model: &'m dyn ContactModel, quantities: &[Quantity], tolerance: Tolerance) -> Self {
        let (quantities, shapes) = (quantities.to_vec(), RwLock::default());
        Self { model, quantities, tolerance, separation_rounding: 0.0, shapes }
    }

    /// For separations with this relative rounding error, as in
    /// [`Request::separation_rounding`](crate::Request): bounds include what it does to values.
    #[must_use]
    pub fn with_separation_rounding(mut self, relative: f64) -> Self {
        self.separation_rounding = relative;
        self
    }

    /// The quantities at one separation of one scene, in the order of the sweep's.
    ///
    /// # Errors
    /// Those of [`ContactModel::compile`] and [`crate::Compiled::evaluate`].
    pub fn evaluate(&self, case: &Case) -> Result<Vec<Evaluation>, ContactError> {
        Worker::new(self).evaluate(case)
    }

    /// Every case on all cores, in order. The digits do not depend on the number of threads.
    #[must_use]
    pub fn evaluate_all(&self, cases: &[Case]) -> Vec<Result<Vec<Evaluation>, ContactError>> {
        let one_thread = |cases: &[Case]| {
            let mut worker = Worker::new(self);
            cases.iter().map(|case| worker.evaluate(case)).collect::<Vec<_>>()
        };
        cases.par_chunks(TOGETHER).flat_map_iter(one_thread).collect()
    }

    /// Every case on all cores, delivered in order with its number; however many there are, some
    /// thousand are in memory.
    ///
    /// # Errors
    /// What `deliver` refuses: the stream ends there.
    pub fn stream<E>(
        &self,
        cases: impl IntoIterator<Item = Case, IntoIter: Send>,
        mut deliver: impl FnMut(usize, Result<Vec<Evaluation>, ContactError>) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut cases = cases.into_iter();
        let mut count = 0;
        let mut held: Vec<Case> = cases.by_ref().take(HELD).collect();
        while !held.is_empty() {
            // The next cases are made while these are answered.
            let (answers, next) = rayon::join(
                || self.evaluate_all(&held),
                || cases.by_ref().take(HELD).collect::<Vec<_>>(),
            );
            for answer in answers {
                deliver(count, answer)?;
                count += 1;
            }
            held = next;
        }
        Ok(())
    }

    /// The shape of a part, new or known.
    fn shape(&self, part: &Part) -> Arc<Shape> {
        let known = |shapes: &[Arc<Shape>]| shapes.iter().find(|s| s.part.recurs_in(part)).cloned();
        let shapes = self.shapes.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(shape) = known(&shapes) {
            shape.recurs.store(true, Ordering::Relaxed);
            return shape;
        }
        drop(shapes);
        let mut shapes = self.shapes.write().unwrap_or_else(PoisonError::into_inner);
        // Another thread may have been faster.
        if let Some(shape) = known(&shapes) {
            return shape;
        }
        let part = part.without_factor();
        let density = Density { pieces: vec![part.piece()] };
        let integral = AnyScale::new(density, self.tolerance.relative());
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

/// One thread's view of a sweep.
struct Worker<'s> {
    sweep: &'s Sweep<'s>,
    /// Shapes of the case before, part by part: mostly those of the next one.
    recent: Vec<Arc<Shape>>,
}

impl<'s> Worker<'s> {
    fn new(sweep: &'s Sweep<'_>) -> Self {
        Self { sweep, recent: vec![] }
    }

    fn evaluate(&mut self, case: &Case) -> Result<Vec<Evaluation>, ContactError> {
        let Sweep { model, quantities, tolerance, separation_rounding, .. } = self.sweep;
        let asperity = case.scene.asperity()?;
        let s = checked_separation(case.separation)?;
        let height_std = case.scene.surface.asperity_height_std;
        let mut answers = Vec::with_capacity(quantities.len());
        let mut place = 0;
        for &quantity in quantities {
            let of_law = law_of(quantity, model.stiffness());
            let law = model.law(&asperity, of_law, *tolerance)?;
            let factor = case.scene.asperities() * law.value_unit;
            let scale = law.interference_unit / height_std;
            check_scales(quantity, factor, scale, height_std)?;
            let value = quantity == of_law;
            let moments = if matches!(case.scene.heights, HeightDistribution::Gaussian) {
                let value_only = value && *separation_rounding <= 0.0;
                self.moments(&law, &mut place, (s, scale), value_only)
            } else {
                let tolerance = tolerance.relative();
                HeightIntegral::new(law.density(), scale, &case.scene.heights, tolerance).at(s)
            };
            let moments = moments.map_err(failed(quantity, s))?;
            let units = Units { factor, height_std };
            let evaluation = if value {
                Evaluation::of_value(&moments, units).held(moments.sizes[0], quantity)
            } else {
                Evaluation::of_slope(&moments, units).held(moments.sizes[1], quantity)
            }?;
            answers.push(evaluation.with_rounding(*separation_rounding, s, &moments));
        }
        Ok(answers)
    }

    /// The sum over the parts of a law; `place` counts parts over the quantities of a case.
    fn moments(
        &mut self,
        law: &Law,
        place: &mut usize,
        (s, scale): (f64, f64),
        value_only: bool,
    ) -> Result<Moments, asperity_quadrature::QuadratureError> {
        let mut sum =
            Moments { value: 0.0, slope: 0.0, ln_scale: 0.0, sizes: [0.0; 2], error: 0.0 };
        for part in &law.parts {
            match self.recent.get(*place) {
                Some(shape) if shape.part.recurs_in(part) => {}
                Some(_) => self.recent[*place] = self.sweep.shape(part),
                None => self.recent.push(self.sweep.shape(part)),
            }
            let integral = &self.recent[*place].integral;
            *place += 1;
            let m = if value_only { integral.value(s, scale) } else { integral.at(s, scale) }?;
            let factor = part.factor();
            sum.value += factor * m.value;
            sum.slope += factor * m.slope;
            sum.ln_scale = m.ln_scale;
            sum.sizes[0] += factor.abs() * m.sizes[0];
            sum.sizes[1] += factor.abs() * m.sizes[1];
            // Parts of any size: the largest relative error bounds that of the sum.
            sum.error = sum.error.max(m.error);
        }
        Ok(sum)
    }
}

impl Part {
    /// The sign, times the first coefficient of a sum of powers.
    fn factor(&self) -> f64 {
        match &self.form {
            Form::Powers(powers) => self.sign * leading(powers),
            Form::Function { .. } => self.sign,
        }
    }

    fn without_factor(&self) -> Self {
        let mut part = Self { sign: 1.0, ..self.clone() };
        if let Form::Powers(powers) = &mut part.form {
            let first = leading(powers);
            powers.iter_mut().for_each(|p| p.coefficient /= first);
        }
        part
    }

    /// Whether the other part is this one, which has no factor, but for a factor.
    fn recurs_in(&self, other: &Self) -> bool {
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
        let forms = match (&self.form, &other.form) {
            (Form::Powers(a), Form::Powers(b)) => {
                let first = leading(b);
                a.len() == b.len()
                    && a.iter().zip(b).all(|(a, b)| {
                        same(a.exponent, b.exponent)
                            && same(a.origin, b.origin)
                            && same(a.coefficient, b.coefficient / first)
                    })
            }
            (Form::Function { key: Some(a), .. }, Form::Function { key: Some(b), .. }) => a == b,
            _ => false,
        };
        forms
            && same(self.range.start, other.range.start)
            && same(self.range.end, other.range.end)
            && self.kinks == other.kinks
    }
}

/// The first coefficient that is not 0.
fn leading(powers: &[Power]) -> f64 {
    powers.iter().map(|p| p.coefficient).find(|c| c.abs() > 0.0).unwrap_or(1.0)
}
