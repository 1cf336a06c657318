//! The models of the registry, weighed.

use crate::registry::{Asperities, Model};
use crate::{
    ContactError, Described, Request, Scene, Unlike, Weighed, recommend_among, recommended,
};

/// Deviations of one [`Model`] from the reference.
pub type Comparison = asperity_judge::Comparison<Model>;
/// The models compared with a reference, and the simplest within a limit.
pub type Recommendation = asperity_judge::Recommendation<Model>;

/// Compares all models with `reference` at the separations and loads of the request. Recommends the
/// simplest that deviates by at most `within` in every requested quantity and is valid there: no
/// model without yielding where asperities yield.
///
/// ```
/// use asperity::{Interface, Quantity, Request, Scene, Surface, linspace, recommend};
///
/// // A smooth surface that hardly yields: Greenwood & Williamson is sufficient.
/// let interface = Interface::new(116e9, 0.31, 7e9);
/// let surface = Surface::from_plasticity_index(0.3, 0.04, 1e-7, &interface)?;
/// let scene = Scene::new(interface, surface, 1e-4);
/// let request = Request::new([Quantity::Force, Quantity::Area]).at(linspace(0.0, 4.0, 9));
/// let advice = recommend(&scene, &request, &"ke".parse()?, 0.05)?;
/// assert_eq!(advice.simplest.map(|model| model.id().to_string()).as_deref(), Some("gw"));
/// # Ok::<(), asperity::ContactError>(())
/// ```
///
/// # Errors
/// [`ContactError::OutOfRange`] unless 0 < `within` ≤ 1 and there is at least one separation or
/// load; errors of the reference model.
pub fn recommend(
    scene: &Scene,
    request: &Request,
    reference: &Model,
    within: f64,
) -> Result<Recommendation, ContactError> {
    recommend_among(Model::of_asperities(), scene, None, request, reference, within)
}

impl Weighed for Model {
    fn of_id(id: &str) -> Result<Self, ContactError> {
        id.parse()
    }

    fn equal(&self) -> &Self {
        self.equal()
    }

    fn unlike(&self) -> Option<Unlike> {
        match self.equal().id() {
            recommended::BEM => Some(Unlike::Solution),
            _ if self.asperities() == Asperities::Pairs => Some(Unlike::Pairs),
            "ghaednia" => Some(Unlike::Hardening),
            _ => None,
        }
    }
}
