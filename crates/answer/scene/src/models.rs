//! The models that a scene allows.

use asperity::joints::{Correlated, Correlation};
use asperity::recommended::ANSWERING;
use asperity::{
    Asperities, Best, Code, ContactError, ContactModel, Finding, Model, Quantity, Request,
    Tolerance, usual_reference,
};
use asperity_bem::Bem;
use asperity_curved::{BetweenCurved, Curved, Shape};

use crate::error::{Place, SceneError};
use crate::options::ModelOptions;
use crate::scene_file::SceneFile;
use crate::spec::SMOOTH;

/// A model that cannot be used for a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct LeftOut {
    /// The model's id.
    pub id: String,
    /// The missing input, or the reason why the model is not valid for the scene.
    pub reason: ContactError,
}

impl SceneFile {
    /// The model of an id, with the scene's options; `bem` for [boundary elements](Self::bem) on
    /// the scene's scan. The gaps of `persson` follow from the spectrum of that scan.
    ///
    /// # Errors
    /// [`SceneError::Refused`] for an unknown id, with a near match and all ids; the errors of
    /// [`bem`](Self::bem).
    pub fn model(&self, id: &str) -> Result<Model, SceneError> {
        self.model_with(&self.spec.options, id)
    }

    /// [`model`](Self::model) with these options instead of the scene's.
    ///
    /// # Errors
    /// The errors of [`model`](Self::model).
    pub fn model_with(&self, options: &ModelOptions, id: &str) -> Result<Model, SceneError> {
        match id.trim().to_lowercase().as_str() {
            Bem::ID => Ok(Model::new(self.pressed(options.bem())?)),
            Best::<Model>::ID => Ok(match self.shape() {
                // No solved surface is that of curved bodies.
                Some(shape) => {
                    let model = self.flat_model(options, usual_reference(&self.scene))?;
                    let mut between = self.between_bodies(model, shape);
                    between.id = Some(Best::<Model>::ID);
                    Model::new(between)
                }
                None => Model::new(self.best_with(options)),
            }),
            _ => Ok(self.between(self.flat_model(options, id)?)),
        }
    }

    /// The model of an id between flat bodies.
    fn flat_model(&self, options: &ModelOptions, id: &str) -> Result<Model, SceneError> {
        let model = options.model_beside(|| self.spectrum(), id)?;
        let of_id = |one: &Correlation| one.id() == model.id();
        if let Some(correlation) = Correlation::ALL.into_iter().find(of_id) {
            let roughness = Some(self.gap_roughness());
            return Ok(Model::known(Correlated { correlation, roughness }));
        }
        match self.no_asperities_for(&model) {
            Some(reason) => Err(SceneError::refused(Place::field("surface.file"), reason)),
            None => Ok(model),
        }
    }

    /// A model between the curved bodies of the scene, with these quantities of its patch.
    ///
    /// # Errors
    /// Those of [`model`](Self::model) and of [`Curved::new`], and [`ContactError::Missing`] of
    /// flat bodies.
    pub fn curved(
        &self,
        id: &str,
        asked: &[Quantity],
        tolerance: Tolerance,
    ) -> Result<Result<Curved, ContactError>, SceneError> {
        let id = if id == Best::<Model>::ID { usual_reference(&self.scene) } else { id };
        let model = self.flat_model(&self.spec.options, id)?;
        let flat =
            || ContactError::Missing { field: "curvature", reason: "the bodies are flat".into() };
        let shape = self.shape().ok_or_else(flat);
        Ok(shape.and_then(|shape| Curved::new(&model, &self.scene, shape, asked, tolerance)))
    }

    /// The undeformed bodies, where these are curved.
    #[must_use]
    pub fn shape(&self) -> Option<Shape> {
        self.spec.curvature.and_then(|bodies| bodies.shape().ok())
    }

    /// A model of flat bodies between the scene's bodies, where these are curved.
    #[must_use]
    pub fn between(&self, model: Model) -> Model {
        match self.shape() {
            Some(shape) => Model::new(self.between_bodies(model, shape)),
            None => model,
        }
    }

    fn between_bodies(&self, model: Model, shape: Shape) -> BetweenCurved {
        let mut between = BetweenCurved::new(model, shape);
        between.strength = self.spec.strength();
        between
    }

    /// What is known best about the scene, by its models and the shape of its surface.
    #[must_use]
    pub fn best(&self) -> Best<Model> {
        self.best_with(&self.spec.options)
    }

    fn best_with(&self, options: &ModelOptions) -> Best<Model> {
        let allowed = |model: &Model| self.no_asperities_for(model).is_none();
        let models = ANSWERING.iter().filter_map(|id| options.model(id).ok()).filter(allowed);
        let best = Best::new(models.collect(), self.surface_shape());
        best.with_solved(self.solved.clone()).within_ranges(self.within_ranges)
    }

    /// The [usual](Model::usual) models of asperities that the scene allows, with its options,
    /// those with adhesion if it has a work of adhesion and those with hardening if it has a
    /// tangent modulus; and the others, each with the reason.
    #[must_use]
    pub fn models(&self) -> (Vec<Model>, Vec<LeftOut>) {
        self.allowed(Model::usual())
    }

    /// Those of the models `known`, and of those with adhesion or hardening, that the scene allows.
    fn allowed(&self, known: Vec<Model>) -> (Vec<Model>, Vec<LeftOut>) {
        let (mut allowed, mut left_out) = (vec![], vec![]);
        let interface = &self.scene.interface;
        let adhesive = interface.work_of_adhesion.map_or(vec![], |_| Model::adhesive());
        let hardening = interface.tangent_modulus.map_or(vec![], |_| Model::hardening());
        for model in known.into_iter().chain(adhesive).chain(hardening) {
            let model = self.model(model.id()).unwrap_or(model);
            match self.refusal(&model) {
                None => allowed.push(model),
                Some(reason) => left_out.push(LeftOut { id: model.id().into(), reason }),
            }
        }
        (allowed, left_out)
    }

    /// Why the scene does not allow a model, if it does not: a missing input, for example.
    #[must_use]
    pub fn refusal(&self, model: &Model) -> Option<ContactError> {
        if let Some(reason) = self.no_asperities_for(model) {
            return Some(ContactError::Refused { model: model.id().into(), reason });
        }
        let of_asperities = model.validity().asperities;
        let asked = if of_asperities { Quantity::Force } else { Quantity::Area };
        model.compile(&self.scene, &Request::new([asked])).err()
    }

    /// A note that models of pairs, among these, stand for another joint than models of one surface
    /// do: two surfaces with the asperities of the scene where those have one on a flat. With a
    /// counterface the joint is the same.
    #[must_use]
    pub fn other_joint<'m>(&self, models: impl Iterator<Item = &'m Model>) -> Option<Finding> {
        let (mut of_pairs, mut of_one) = (None, None);
        for model in models {
            let is_pairs = model.asperities() == Asperities::Pairs;
            if is_pairs { &mut of_pairs } else { &mut of_one }.get_or_insert(model.id());
        }
        let (pairs, one) = of_pairs.zip(of_one)?;
        let fact = format!(
            "{pairs} presses two surfaces with these asperities on each other, {one} one such surface on a flat"
        );
        let found =
            Finding::note(Code::OtherJoint, "asperity_radius", self.scene.surface.asperity_radius)
                .fact(fact)
                .advice("describe the second surface by counterface to compare them on one joint");
        self.scene.pair.is_none().then_some(found)
    }

    /// Why the scene has no asperities for a model.
    fn no_asperities_for(&self, model: &Model) -> Option<String> {
        let none = self.no_asperities().filter(|_| model.validity().asperities);
        let pairs = || self.no_pair().filter(|_| model.asperities() == Asperities::Pairs);
        none.or_else(|| pairs().map(Into::into))
    }

    /// Why models of pairs do not know each of its two surfaces.
    fn no_pair(&self) -> Option<&'static str> {
        if self.spec.counterface_word == Some(SMOOTH) {
            return Some(
                "counterface = \"smooth\" leaves one rough surface, and models of pairs press two",
            );
        }
        let unknown = self.spec.counterface.is_some() && self.scene.pair.is_none();
        unknown.then_some(match self.spec.pressed {
            Some(_) => "models of pairs need two independent surfaces, not aligned scans",
            None => "models of pairs need the asperities of each surface, and one has none",
        })
    }

    /// The models to compare with boundary elements on the scene's scan: [`models`](Self::models)
    /// and their variants, with those of random asperities and of the whole surface where these
    /// have the same joint; and those that the scene does not allow, each with the reason.
    #[must_use]
    pub fn models_beside_bem(&self) -> (Vec<Model>, Vec<LeftOut>) {
        let mut known = Model::of_asperities();
        for other in [Model::all_on(Asperities::Random), Model::whole_surface()].concat() {
            if known.iter().all(|model| model.id() != other.id()) {
                known.push(other);
            }
        }
        self.allowed(known)
    }
}
