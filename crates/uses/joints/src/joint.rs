//! A joint: a model's contact on a scene, closed and opened.

use std::sync::Arc;

use asperity_core::{
    At, Citation, Contact, ContactError, ContactModel, Datum, Evaluation, HeightDistribution,
    Quantity, Request, Scene, Separation, SeparationUnit, Tolerance,
};

use crate::asperity_laws::{AsperityLaws, UnloadingQuantity};
use crate::retreat_model::RetreatModel;
use crate::unloading_law::UnloadingLaw;

/// Bound on the error of the first remaining interference, in units of the last place: δ takes some
/// ten operations and grows at least as a square root; the largest error observed is 26.
const FIRST_ROUNDING_ULPS: f64 = 40.0;

/// First loading of a contact, and unloading from any closest approach.
#[derive(Debug, Clone)]
pub struct Joint {
    source: Citation,
    pub(crate) name: String,
    virgin: Arc<dyn Contact>,
    pub(crate) loading: Arc<AsperityLaws>,
    pub(crate) tolerance: Tolerance,
}

impl Joint {
    /// A model's contact on a scene, with an unloading law.
    ///
    /// # Errors
    /// [`ContactError::Unsupported`] for models without an asperity law, with inclined contacts or
    /// with adhesion; the errors of the model.
    pub fn new(
        model: &(impl ContactModel + ?Sized),
        scene: &Scene,
        law: UnloadingLaw,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let asperity = model.scene_of(scene)?.asperity()?;
        let loading = AsperityLaws::new(model, asperity, law, tolerance)?;
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        Ok(Self {
            source: *model.citation(),
            name: model.id().into(),
            virgin: model.compile(scene, &request)?.into(),
            loading: Arc::new(loading),
            tolerance,
        })
    }

    /// The same joint with the larger of two tolerances, its own and this one.
    pub(crate) fn with_tolerance_at_least(&self, tolerance: Tolerance) -> Self {
        let tolerance = if self.tolerance > tolerance { self.tolerance } else { tolerance };
        Self { tolerance, ..self.clone() }
    }

    /// The curve of first loading, compiled for force and tangent.
    #[must_use]
    pub fn virgin(&self) -> &dyn Contact {
        &*self.virgin
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.virgin.scene()
    }

    /// The unloading law.
    #[must_use]
    pub fn law(&self) -> UnloadingLaw {
        self.loading.unloading
    }

    /// The turning points of a history as separations \[m\] from the mean of the asperity heights,
    /// for [`path`](Self::path): loads above the largest so far lie on the virgin curve, smaller
    /// loads on the unloading curve from the closest approach.
    ///
    /// # Errors
    /// The errors of finding a load; [`ContactError::OutOfRange`] for a load that is not above 0.
    pub fn turning_points(&self, turns: &[At]) -> Result<Vec<f64>, ContactError> {
        let (metres, mean) = (SeparationUnit::Metres, Datum::AsperityMean);
        let place = |separation: Separation| {
            Ok::<_, ContactError>(separation.measured_in(metres, mean, self.scene())?.value)
        };
        let (mut closest, mut found) = (f64::INFINITY, vec![]);
        for turn in turns {
            let at = match (*turn, turn.load(self.scene())) {
                (At::Separation(separation), _) => place(separation)?,
                (_, Some(load)) if closest.is_finite() => {
                    let way = self.unloading(At::metres(closest))?;
                    match load < way.force(0.0)?.value() {
                        true => closest + way.retreat_to(load)?,
                        false => place(self.virgin.separation(*turn)?)?,
                    }
                }
                _ => place(self.virgin.separation(*turn)?)?,
            };
            closest = closest.min(at);
            found.push(at);
        }
        Ok(found)
    }

    /// A quantity after a retreat \[m\] from each of these closest approaches \[σ_z from the mean
    /// of the asperity heights\].
    pub(crate) fn retreated(
        &self,
        quantity: UnloadingQuantity,
        retreat: f64,
        closest: &[f64],
    ) -> Result<Vec<Evaluation>, ContactError> {
        let model =
            RetreatModel::new((&self.source, &self.name), &self.loading, quantity, retreat)?;
        let scene = self.scene();
        let lost = |place: f64| {
            nothing_above(scene, place + model.first / scene.surface.asperity_height_std)
        };
        let touching = closest.iter().copied().filter(|place| !lost(*place));
        let request = Request::new([Quantity::Force]).within(self.tolerance);
        let answer = model.solve(scene, &request.at(touching))?;
        let mut rows = answer.columns.into_iter().flat_map(|column| column.rows);
        let next = |place: &f64| {
            if lost(*place) {
                return Ok(Evaluation::new(0.0, 0.0));
            }
            let missing = ContactError::NotRequested { quantity: Quantity::Force };
            let mut found =
                rows.next().unwrap_or_else(|| Err(missing.into())).map_err(|error| *error)?;
            // The first remaining interference has the error of δ; the tail is assumed to
            // fall as steeply as a Gaussian density.
            let first = model.first / scene.surface.asperity_height_std;
            found.error +=
                FIRST_ROUNDING_ULPS * f64::EPSILON * first * ((place + first).max(0.0) + 1.0);
            Ok(found)
        };
        closest.iter().map(next).collect()
    }
}

/// Whether the share of asperities above this height \[σ_z\] underflows: so far out, rounding of
/// the height dominates the logarithms of the Gaussian and Weibull densities.
fn nothing_above(scene: &Scene, place: f64) -> bool {
    const LN_NOTHING: f64 = -1e4;
    let ln = match &scene.heights {
        HeightDistribution::Gaussian => -0.5 * place * place,
        HeightDistribution::Exponential => -place,
        HeightDistribution::Weibull(heights) => heights.ln_density(place),
        _ => return false,
    };
    place > 0.0 && ln < LN_NOTHING
}
