//! A law of one asperity on a random surface, as a contact model.

use asperity_core::{
    At, Contact, ContactEngine, ContactError, ContactModel, Datum, Described, Evaluation, Part,
    QuadratureError, Quantity, Request, Scene, Separation, SeparationUnit, Share, Tolerance,
    Variant, Wraps, require,
};

use crate::average::{Average, Population};

/// The largest separation from the surface's mean plane, in √m₀.
pub const FARTHEST: f64 = 6.0;
/// Relative rounding error of the ends of parts.
const ROUNDING: f64 = 1e-12;

/// A model of upright contacts with the heights and radii of an isotropic Gaussian surface.
///
/// It is not an [`AsperityModel`](asperity_core::AsperityModel), because the law that it averages
/// over heights is not the law of one radius.
#[derive(Debug, Clone)]
pub struct RandomAsperities(Variant);

impl RandomAsperities {
    /// The averaged laws of `model`: `ke` becomes `ke-random`.
    #[must_use]
    pub fn new(model: impl ContactModel + 'static) -> Self {
        let differs =
            "averaged over asperities whose heights and radii differ, as on a random surface";
        let what = "averages over the asperities of a random surface";
        Self(Variant::new(model, "random", differs, what))
    }
}

impl Wraps for RandomAsperities {
    fn inner(&self) -> &dyn Described {
        &self.0
    }
}

/// An averaged law on its own scene.
fn compiled(
    average: &Average<'_>,
    scene: &Scene,
    request: &Request,
) -> Result<Box<dyn Contact>, ContactError> {
    // Loads need no change; each separation is shifted.
    let loads = request.at.iter().copied().filter(|at| !matches!(at, At::Separation(_)));
    let asked = Request::new(request.quantities.clone()).within(request.tolerance).at(loads);
    average.compile(&average.population.scene(scene), &asked)
}

impl ContactModel for RandomAsperities {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let (model, variant) = (self.0.laws(&scene.heights)?, &self.0);
        let population = Population::new(scene)?;
        let tolerance = request.tolerance;
        let average = Average { model, variant, population, cuts: &[], tolerance };
        let averaged = compiled(&average, scene, request)?;
        let variant = variant.clone();
        Ok(Box::new(OnScene { averaged, variant, scene: scene.clone(), population, tolerance }))
    }
}

/// The averaged law on its own scene, evaluated at separations of the given scene.
#[derive(Debug)]
struct OnScene {
    averaged: Box<dyn Contact>,
    variant: Variant,
    scene: Scene,
    population: Population,
    tolerance: Tolerance,
}

impl OnScene {
    /// The same place on the scene of the averaged law.
    fn own(&self, at: At) -> Result<At, ContactError> {
        match at {
            At::Separation(separation) => {
                let from = Datum::SurfaceMean;
                let height = separation.measured_in(SeparationUnit::Metres, from, &self.scene)?;
                self.check(height.value)?;
                Ok(Separation::metres(height.value - self.population.begin()).into())
            }
            at => {
                let load = at.load(&self.scene).unwrap_or(f64::NAN);
                self.separation_at(load)?;
                Ok(at)
            }
        }
    }

    /// A refusal of the averaged law at the caller's place and tolerance: both of its own are
    /// others.
    fn at(&self, at: At) -> impl Fn(ContactError) -> ContactError {
        let asked = self.tolerance.relative();
        move |error| match error {
            ContactError::Integral { quantity, source, .. } => {
                let source = match source {
                    QuadratureError::NotConverged { reached, evaluations, .. } => {
                        QuadratureError::NotConverged { reached, asked, evaluations }
                    }
                    other => other,
                };
                ContactError::Integral { quantity, at, source }
            }
            other => other,
        }
    }

    /// Refuses heights above the mean plane \[m\] beyond the range of the averaged law.
    fn check(&self, height: f64) -> Result<(), ContactError> {
        let value = height / self.population.surface_std;
        let field = "separation from the surface's mean plane over sqrt(m0)";
        require(value <= FARTHEST, field, value, "at most 6").map(drop)
    }
}

impl ContactEngine for OnScene {
    fn model(&self) -> &str {
        self.averaged.model()
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        self.averaged.quantities()
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.averaged.evaluate_at(quantity, self.own(at)?).map_err(self.at(at))
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        self.averaged.force_and_tangent_at(self.own(at)?).map_err(self.at(at))
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let metres = SeparationUnit::Metres;
        let moved = |own: Separation| {
            let own = own.measured_in(metres, Datum::AsperityMean, self.averaged.scene())?;
            let height = own.value + self.population.begin();
            self.check(height)?;
            let found = Separation::metres(height).from_surface_mean();
            found.measured_in(SeparationUnit::Sigma, Datum::AsperityMean, &self.scene)
        };
        self.averaged.separations_at(load)?.into_iter().map(moved).collect()
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        self.averaged.shares_at(quantity, self.own(at)?).map_err(self.at(at))
    }

    fn shares_beyond(&self, at: At, multiples: &[f64]) -> Result<Option<Vec<f64>>, ContactError> {
        let (model, population) = (self.variant.laws(&self.scene.heights)?, self.population);
        // w_c is proportional to the radius, and each law of an asperity a function of w over it.
        let asperity = population.scene(&self.scene).asperity()?;
        let critical = asperity.critical_interference()?;
        let cuts: Vec<f64> = multiples.iter().map(|multiple| multiple * critical).collect();
        let (variant, tolerance) = (&self.variant, self.tolerance);
        let request = Request::new([Quantity::Force]).within(tolerance).at([at]);
        let average = Average { model, variant, population, cuts: &cuts, tolerance };
        let averaged = compiled(&average, &self.scene, &request)?;
        let shares = averaged.shares_at(Quantity::Force, self.own(at)?).map_err(self.at(at))?;
        let law = average.cut(model.force(&asperity, Tolerance::default())?);
        let from = |part: &Part| (part.range.start + law.onset) * law.interference_unit;
        let beyond = |cut: &f64| {
            let parts = law.parts.iter().zip(&shares);
            let beyond = parts.filter(|(part, _)| from(part) >= cut * (1.0 - ROUNDING));
            beyond.map(|(_, share)| share.share).sum()
        };
        Ok(Some(cuts.iter().map(beyond).collect()))
    }
}
