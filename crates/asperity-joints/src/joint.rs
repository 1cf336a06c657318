//! A model's contact on a scene, to be closed and opened.

use std::sync::Arc;

use asperity_core::{
    At, Citation, Contact, ContactError, ContactModel, Datum, Evaluation, HeightDistribution,
    Quantity, Request, Scene, Separation, SeparationUnit, Tolerance,
};

use crate::asperity_laws::{AsperityLaws, RetreatModel, UnloadingQuantity};
use crate::{Unloading, UnloadingLaw};

/// Units in the last place that the place of the first contact that lasts may be off by: δ is some
/// ten operations, as steep as a root at least. 26 were seen.
const FIRST_ROUNDING_ULPS: f64 = 40.0;

/// The first closing, and the way back from any closest approach.
#[derive(Debug, Clone)]
pub struct Joint {
    source: Citation,
    name: String,
    virgin: Arc<dyn Contact>,
    loading: Arc<AsperityLaws>,
    tolerance: Tolerance,
}

impl Joint {
    /// A model's contact on a scene, which comes back as `law` says.
    ///
    /// # Errors
    /// [`ContactError::Unsupported`] for models that have no law of an asperity, one spread over
    /// angles, or adhesion; those of the model.
    pub fn new(
        model: &(impl ContactModel + ?Sized),
        scene: &Scene,
        law: UnloadingLaw,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let loading = AsperityLaws::new(model, scene.asperity()?, law, tolerance)?;
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        Ok(Self {
            source: *model.citation(),
            name: model.name().into(),
            virgin: model.compile(scene, &request)?.into(),
            loading: Arc::new(loading),
            tolerance,
        })
    }

    /// The same to this tolerance, unless its own is the larger one.
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

    /// How the asperities come back.
    #[must_use]
    pub fn law(&self) -> UnloadingLaw {
        self.loading.unloading
    }

    pub(crate) fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    /// Whether any asperity comes back another way than it went.
    pub(crate) fn yields(&self) -> bool {
        self.loading.critical.is_finite()
    }

    /// Height of the highest asperity above the mean \[m\]; infinite for heights without an end.
    pub(crate) fn highest(&self) -> f64 {
        match &self.scene().heights {
            HeightDistribution::Other(heights) => heights.heights().support().1,
            _ => f64::INFINITY,
        }
    }

    pub(crate) fn loading(&self) -> &AsperityLaws {
        &self.loading
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The way back from a closest approach: of a load, the largest separation that carries it.
    ///
    /// # Errors
    /// Those of finding a load.
    pub fn unloading(&self, closest: At) -> Result<Unloading, ContactError> {
        Unloading::of_joint(self.clone(), self.virgin.separation(closest)?)
    }

    /// Where a history turns, as separations \[m\] from the mean of the asperity heights for
    /// [`path`](Self::path): loads beyond the largest so far are met on the virgin curve, smaller
    /// ones on the way back from the closest approach.
    ///
    /// # Errors
    /// Those of finding a load; [`ContactError::OutOfRange`] for a load that is not above 0.
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

    /// What is asked after a retreat \[m\] from each of these closest approaches \[σ_z from the
    /// mean of the asperity heights\].
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
            // The first contact that lasts is known as well as δ is, and the tail falls as steeply
            // as that of a Gaussian density.
            let first = model.first / scene.surface.asperity_height_std;
            found.error +=
                FIRST_ROUNDING_ULPS * f64::EPSILON * first * ((place + first).max(0.0) + 1.0);
            Ok(found)
        };
        closest.iter().map(next).collect()
    }
}

/// Whether no double holds how many asperities are higher than this \[σ_z\]: so far out, places
/// have no digits for the logarithms of Gauss' and Weibull's densities.
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
