//! A model of one asperity on a random surface, as a contact model.

use asperity_core::{
    AsperityModel, At, Claims, Contact, ContactError, ContactModel, Datum, Evaluation,
    HeightDistribution, Quantity, Request, Scene, Separation, SeparationUnit, Share, Source,
    Warning,
};

use crate::average::Average;
use crate::population::Population;

/// The largest separation from the surface's mean plane, in √m₀.
pub const FARTHEST: f64 = 6.0;

/// A model of upright asperities whose heights and radii are those of an isotropic Gaussian surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RandomAsperities<M>(
    /// The law of one asperity.
    pub M,
);

impl<M: AsperityModel> ContactModel for RandomAsperities<M> {
    fn source(&self) -> &Source {
        self.0.source()
    }

    fn id(&self) -> &str {
        self.0.id()
    }

    fn name(&self) -> &str {
        self.0.name()
    }

    fn claims(&self) -> Claims {
        self.0.claims()
    }

    fn notes(&self) -> Vec<Warning> {
        self.0.notes()
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let unsupported = |what: &str| ContactError::Unsupported {
            model: self.0.name().into(),
            what: format!("averages over the asperities of a random surface: {what}"),
        };
        if self.0.claims().adhesive {
            return Err(unsupported("asperities of many radii: adhesion changes with the radius"));
        }
        if self.0.claims().angles {
            return Err(unsupported("its contact normals are spread over angles"));
        }
        if !matches!(scene.heights, HeightDistribution::Gaussian) {
            return Err(unsupported("heights must be Gaussian"));
        }
        let population = Population::new(scene)?;
        // Loads are the same; separations are moved one by one.
        let loads = request.at.iter().copied().filter(|at| !matches!(at, At::Separation(_)));
        let asked = Request::new(request.quantities.clone()).within(request.tolerance).at(loads);
        let average = Average { model: &self.0, population };
        let averaged = average.compile(&population.scene(scene), &asked)?;
        Ok(Box::new(OnScene { averaged, scene: scene.clone(), population }))
    }
}

/// The averaged law on its own scene, asked in the terms of the scene given.
#[derive(Debug)]
struct OnScene {
    averaged: Box<dyn Contact>,
    scene: Scene,
    population: Population,
}

impl OnScene {
    /// The place on the averaged law's own scene.
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

    /// Refuses what is farther from the mean plane \[m\] than the averaged law serves.
    fn check(&self, height: f64) -> Result<(), ContactError> {
        let value = height / self.population.surface_std;
        if value <= FARTHEST {
            return Ok(());
        }
        let field = "separation from the surface's mean plane over sqrt(m0)";
        Err(ContactError::OutOfRange { field, value, required: "at most 6" })
    }
}

impl Contact for OnScene {
    fn model(&self) -> &str {
        self.averaged.model()
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        self.averaged.quantities()
    }

    fn notes(&self) -> &[Warning] {
        self.averaged.notes()
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.averaged.evaluate_at(quantity, self.own(at)?)
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        self.averaged.force_and_tangent_at(self.own(at)?)
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
        self.averaged.shares_at(quantity, self.own(at)?)
    }

    fn second_derivative_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.averaged.second_derivative_at(quantity, self.own(at)?)
    }
}
