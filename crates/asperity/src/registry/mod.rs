//! The only place that lists all models.

mod options;

use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;
use std::str::FromStr;
use std::sync::{Arc, OnceLock};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use options::{Configurable, Rearranged};

use crate::joints::{Correlated, Correlation};
use crate::{
    AbdoFarhang, AminiTehrani, AsperityModel, AsperityPairs, AtReading, Best, ChangEtsionBogy,
    Contact, ContactError, ContactModel, DerjaguinMullerToporov, Described, EtsionKligermanKadin,
    Gao, GeometricHardness, Ghaednia, GreenwoodWilliamson, JacksonGreen, JkrBranch,
    JohnsonKendallRoberts, KogutEtsion, Persson, PerssonVariance, RandomAsperities, Request, Scene,
    SumOfContacts, Wraps, ZhaoMaiettaChang, nearest_name,
};

/// Any contact model, by value: cheap to clone, shared between threads, read from its name, and
/// written with its options.
///
/// ```
/// use asperity::{ContactModel, Model};
///
/// let model: Model = "ke".parse()?;
/// assert_eq!(model.name(), "KE");
/// let mistyped = "zcm".parse::<Model>().unwrap_err().to_string();
/// assert!(mistyped.contains("the nearest is \"zmc\""));
///
/// let text = r#"{"id": "gao", "options": {"displacement": "none"}}"#;
/// let frictionless: Model = serde_json::from_str(text)?;
/// assert_eq!(frictionless.options().unwrap()["displacement"], "none");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Model {
    model: Arc<dyn ContactModel>,
    /// Its options, for a model of this project.
    known: Option<Arc<dyn Configurable>>,
    asperities: Asperities,
    /// The model of equal asperities, for one of others.
    equal: Option<Arc<Model>>,
}

/// How the asperities are distributed, and what they meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Asperities {
    /// Asperities of one radius meet a flat.
    #[default]
    Equal,
    /// Heights and radii are distributed together as on an isotropic Gaussian surface with the
    /// moments of the asperities: see [`RandomAsperities`].
    Random,
    /// Asperities of one radius meet asperities of another rough surface: see [`AsperityPairs`].
    Pairs,
}

impl Asperities {
    /// Those that are not equal: models have ids of their own for them.
    pub const OTHERS: [Self; 2] = [Self::Random, Self::Pairs];
}

impl Model {
    /// Wraps a model of your own.
    #[must_use]
    pub fn new(model: impl ContactModel + 'static) -> Self {
        Self { model: Arc::new(model), known: None, asperities: Asperities::Equal, equal: None }
    }

    /// Wraps a model whose options can be written and read.
    #[must_use]
    pub fn known(model: impl ContactModel + Serialize + DeserializeOwned + 'static) -> Self {
        let model = Arc::new(model);
        Self { known: Some(model.clone()), model, asperities: Asperities::Equal, equal: None }
    }

    /// The same laws on these asperities: `ke` becomes `ke-random` or `ke-pairs`. See
    /// [`RandomAsperities`] and [`AsperityPairs`], which tell what they refuse.
    ///
    /// ```
    /// use asperity::{Asperities, ContactModel, Model};
    ///
    /// let ke: Model = "ke".parse()?;
    /// let random = ke.on(Asperities::Random);
    /// assert_eq!((random.id(), random.name()), ("ke-random", "KE random"));
    /// assert_eq!(random.on(Asperities::Pairs).id(), "ke-pairs");
    /// # Ok::<(), asperity::ContactError>(())
    /// ```
    #[must_use]
    pub fn on(&self, asperities: Asperities) -> Self {
        let equal = Arc::new(self.equal().clone());
        let one = (*equal).clone();
        let model: Arc<dyn ContactModel> = match asperities {
            Asperities::Equal => return one,
            Asperities::Random => Arc::new(RandomAsperities::new(one)),
            Asperities::Pairs => Arc::new(AsperityPairs::new(one)),
        };
        let rearranged = || Arc::new(Rearranged { equal: equal.clone(), asperities }) as Arc<_>;
        let known = equal.known.is_some().then(rearranged);
        Self { model, known, asperities, equal: Some(equal) }
    }

    /// The asperities that it is for.
    #[must_use]
    pub fn asperities(&self) -> Asperities {
        self.asperities
    }

    /// The same laws on asperities of one radius.
    #[must_use]
    pub fn equal(&self) -> &Self {
        self.equal.as_deref().unwrap_or(self)
    }

    /// What is known best about a scene, by the models here and solved surfaces: see [`Best`].
    #[must_use]
    pub fn best() -> Self {
        Self::known(Best::<Self>::default())
    }

    /// Every model that has an id here, with its default options: variants, too. `bem`, which needs
    /// a scan, is a model of the crate `asperity-bem`.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let equal =
            [Self::of_asperities(), Self::whole_surface(), Self::adhesive(), Self::hardening()];
        let others: [Vec<Self>; 2] = Asperities::OTHERS.map(|asperities| {
            let hardening = Self::hardening().into_iter().map(|model| model.on(asperities));
            Self::all_on(asperities).into_iter().chain(hardening).collect()
        });
        [equal.concat(), Self::correlations(), others.concat(), vec![Self::best()]].concat()
    }

    /// The models of tables and pictures where none is named: those [of
    /// asperities](Self::of_asperities) that are no [variant](Described::variant).
    #[must_use]
    pub fn usual() -> Vec<Self> {
        Self::of_asperities().into_iter().filter(|model| model.variant().is_empty()).collect()
    }

    /// The models of asperities of one radius that need no work of adhesion and no tangent modulus,
    /// variants too, in the order of years.
    #[must_use]
    pub fn of_asperities() -> Vec<Self> {
        let reading = |reading| AminiTehrani { reading, ..AminiTehrani::default() };
        let cosine = JacksonGreen { hardness: GeometricHardness::Cosine };
        vec![
            Self::known(GreenwoodWilliamson),
            Self::known(ChangEtsionBogy),
            Self::known(ZhaoMaiettaChang),
            Self::known(KogutEtsion),
            Self::known(EtsionKligermanKadin),
            Self::known(JacksonGreen::default()),
            Self::known(cosine),
            Self::known(AbdoFarhang::default()),
            Self::known(Gao::default()),
            Self::known(reading(AtReading::Printed)),
            Self::known(reading(AtReading::Additive)),
            Self::known(reading(AtReading::Overlap)),
        ]
    }

    /// Those [of asperities](Self::of_asperities) that other asperities than equal ones allow, [on
    /// them](Self::on): they are known by their names.
    #[must_use]
    pub fn all_on(asperities: Asperities) -> Vec<Self> {
        let upright = Self::of_asperities().into_iter().filter(|model| !model.validity().angles);
        upright.map(|model| model.on(asperities)).collect()
    }

    /// Theories of the whole surface, without asperities: they have values at loads, and, elastic
    /// ones with a spectrum, at separations. Commands use them only by name.
    #[must_use]
    pub fn whole_surface() -> Vec<Self> {
        let persson = |variance| Self::known(Persson { variance, ..Persson::default() });
        PerssonVariance::ALL.map(persson).to_vec()
    }

    /// Elastic asperities with adhesion: they need the scene's work of adhesion. Commands use them
    /// by name, and by default where the scene has a work of adhesion.
    #[must_use]
    pub fn adhesive() -> Vec<Self> {
        let jkr = |branch| Self::known(JohnsonKendallRoberts { branch });
        vec![
            Self::known(DerjaguinMullerToporov),
            jkr(JkrBranch::Approach),
            jkr(JkrBranch::Separation),
        ]
    }

    /// Correlations of the thermal conductance at loads, which have no other quantity. Commands use
    /// them only by name.
    #[must_use]
    pub fn correlations() -> Vec<Self> {
        let of = |correlation| Self::known(Correlated { correlation, roughness: None });
        Correlation::ALL.map(of).to_vec()
    }

    /// Like bodies that harden: they need the scene's tangent modulus. Commands use them by name,
    /// and by default where the scene has a tangent modulus.
    #[must_use]
    pub fn hardening() -> Vec<Self> {
        vec![Self::known(Ghaednia)]
    }
}

impl Wraps for Model {
    fn inner(&self) -> &dyn Described {
        &*self.model
    }
}

impl ContactModel for Model {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        self.model.asperity_model()
    }

    fn sum_of_contacts(&self) -> Option<SumOfContacts> {
        self.model.sum_of_contacts()
    }

    fn scene_of<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        self.model.scene_of(scene)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        self.model.compile(scene, request)
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        self.model.contact(scene, request)
    }
}

/// So that the methods are there without the trait.
impl Deref for Model {
    type Target = dyn ContactModel;

    fn deref(&self) -> &Self::Target {
        &*self.model
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.id())
    }
}

impl FromStr for Model {
    type Err = ContactError;

    /// Reads a model's id, in any case.
    fn from_str(name: &str) -> Result<Self, ContactError> {
        static ALL: OnceLock<Vec<Model>> = OnceLock::new();
        let models = ALL.get_or_init(Self::all);
        let wanted = match name.trim().to_lowercase() {
            greenwood_tripp if greenwood_tripp == "gt" => "gw-pairs".into(),
            id => id,
        };
        #[cfg(not(feature = "bem"))]
        if wanted == crate::recommended::BEM {
            let reason = "asperity is compiled without bem; add its feature bem".into();
            return Err(ContactError::Refused { model: wanted, reason });
        }
        if let Some(model) = models.iter().find(|m| m.id() == wanted) {
            return Ok(model.clone());
        }
        let near = nearest_name(&wanted, models.iter().map(|m| m.id())).map(Into::into);
        let help = match near {
            None if name.contains([' ', ';', '+']) => ": commas separate several models",
            None => ": see the list of models",
            Some(_) => "",
        };
        let (what, name, help) = ("model", name.into(), help.into());
        Err(ContactError::UnknownName { what, name, near, help })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_id_reads_back_and_is_unique() {
        let models = Model::all();
        let ids: Vec<String> = models.iter().map(ToString::to_string).collect();
        for id in &ids {
            assert_eq!(id.to_uppercase().parse::<Model>().unwrap().id(), id);
        }
        let mut unique = ids.clone();
        unique.sort();
        unique.dedup();
        assert_eq!(unique.len(), ids.len());
    }

    #[test]
    fn every_variant_states_how_it_differs_and_no_other_model_does() {
        for model in Model::all() {
            let parts = model.id().split('-').skip(1).count();
            assert_eq!(model.variant().len(), parts, "{model}");
        }
        let cosine: Model = "jg-cosine-random".parse().unwrap();
        let [hardness, random] = cosine.variant()[..] else { panic!("{:?}", cosine.variant()) };
        assert!(hardness.starts_with("the hardness") && random.starts_with("averaged over"));
    }

    #[test]
    fn a_model_of_your_own_has_laws_on_other_asperities() {
        use crate::{Interface, Quantity, Request, Scene, Surface};
        let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-5);
        let request = Request::new([Quantity::Force]).at([1.0]);
        let force = |model: &Model| {
            model.solve(&scene, &request).unwrap().values(Quantity::Force).unwrap()[0]
        };
        let own = Model::new(GreenwoodWilliamson).on(Asperities::Pairs);
        assert_eq!((own.id(), own.asperities()), ("gw-pairs", Asperities::Pairs));
        let known: Model = "GT".parse().unwrap();
        assert!((force(&own) / force(&known) - 1.0).abs() < 1e-15);
        assert_eq!(known.equal().id(), "gw");
        assert!(own.options().is_none() && known.options().is_some());
    }

    #[test]
    fn the_models_that_messages_recommend_are_what_they_are_recommended_for() {
        use crate::recommended::{DMT, JKR, JKR_SEPARATION, WHOLE_SURFACE, YIELDING};
        let ids = |text: &'static str| {
            let ids = text.trim_end_matches(" if nothing yields").replace(", or ", ", ");
            ids.replace(" and ", ", ").replace(" or ", ", ")
        };
        let models = |text| -> Vec<Model> {
            let ids = ids(text);
            ids.split(", ")
                .filter(|id| *id != "boundary elements")
                .map(|id| id.parse().unwrap())
                .collect()
        };
        let yields = |model: &Model| model.validity().holds_to.is_none_or(|x| x > 1.0);
        assert!(models(YIELDING).iter().all(|m| yields(m) && m.validity().asperities));
        assert!([DMT, JKR, JKR_SEPARATION].iter().all(|id| models(id)[0].validity().adhesive));
        let whole = models(WHOLE_SURFACE);
        assert!(whole.iter().all(|model| !model.validity().asperities));
    }

    #[test]
    fn far_names_get_no_guess() {
        let near = |name: &str| match name.parse::<Model>() {
            Err(crate::ContactError::UnknownName { near, .. }) => near,
            other => panic!("{other:?}"),
        };
        assert_eq!(near("westergaard"), None);
        assert_eq!(near("etsoin").as_deref(), Some("etsion"));
    }
}
