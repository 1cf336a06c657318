//! A model's contact on a scene, to be closed and opened.

use std::sync::Arc;

use asperity_core::{
    At, Contact, ContactError, ContactModel, Datum, Evaluation, HeightDistribution, Quantity,
    Request, Scene, Separation, SeparationUnit, Source, Tolerance,
};
use asperity_quadrature::{fallible, gauss_kronrod};

use crate::one::{Asked, Loading, MOST, Retreated};
use crate::{Unloading, UnloadingLaw};

/// No force is looked at beyond this separation \[σ_z\].
const FARTHEST: f64 = 1e8;

/// The first closing, and the way back from any closest approach.
#[derive(Debug, Clone)]
pub struct Joint {
    source: Source,
    name: String,
    virgin: Arc<dyn Contact>,
    loading: Arc<Loading>,
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
        let loading = Loading::new(model, scene.asperity()?, law, tolerance)?;
        let asked = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        Ok(Self {
            source: *model.source(),
            name: model.name().into(),
            virgin: model.compile(scene, &asked)?.into(),
            loading: Arc::new(loading),
            tolerance,
        })
    }

    /// The same to this tolerance, unless its own is the larger one.
    pub(crate) fn roughly(&self, tolerance: Tolerance) -> Self {
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

    /// The work \[J\] of first closing, from no contact to `closest`.
    ///
    /// # Errors
    /// Those of the contact's evaluations, [`ContactError::Integral`], and [`ContactError::OutOfRange`]
    /// under heights with a tail so heavy that work is left beyond 1e8 σ_z.
    pub fn spent(&self, closest: At) -> Result<f64, ContactError> {
        let way = self.unloading(closest)?;
        let sigma = self.scene().surface.asperity_height_std;
        // Twice as far each time, until nothing is left.
        let (mut from, mut step, mut work) = (sigma * way.place(), sigma, 0.0);
        loop {
            let panel = self.closing(from + step, from)?;
            work += panel;
            (from, step) = (from + step, 2.0 * step);
            if panel <= 1e-3 * self.tolerance.relative() * work {
                return Ok(work);
            }
            if from > FARTHEST * sigma {
                let field = "share of the work beyond 1e8 asperity_height_std";
                let required = "next to none, as heights with a lighter tail leave it,";
                return Err(ContactError::OutOfRange { field, value: panel / work, required });
            }
        }
    }

    /// The work \[J\] of first closing from one separation \[m\] to another, both from the mean of the
    /// asperity heights.
    pub(crate) fn closing(&self, from: f64, to: f64) -> Result<f64, ContactError> {
        let quantity = Quantity::Force;
        let force =
            |d| Ok::<_, ContactError>(self.virgin.evaluate(quantity, At::metres(d))?.value());
        let goal = self.tolerance.relative();
        let work = fallible(force, |force| gauss_kronrod(force, &[to, from], goal, MOST))?;
        let at = At::metres(to);
        Ok(work.map_err(|source| ContactError::Integral { quantity, at, source })?.value)
    }

    /// The work \[J\] that yielding has taken for good, where the contact has been closed as far as
    /// `closest` and open again: what is spent less what comes back. A cycle between fixed
    /// separations loses it once; after that, it retraces.
    ///
    /// Below 0 where a loading law jumps up (CEB: by half of Hertz' force at w_c) and the way back is
    /// longer than the way there: such a pair of laws makes energy, and is none for dynamics.
    ///
    /// # Errors
    /// Those of [`spent`](Self::spent).
    pub fn dissipated(&self, closest: At) -> Result<f64, ContactError> {
        let returned = self.unloading(closest)?.returned(f64::INFINITY)?;
        Ok(self.spent(closest)? - returned.value())
    }

    /// The loss factor of closing as far as `closest` for the first time and opening again: what is
    /// [dissipated](Self::dissipated) over 2π times what was [spent](Self::spent).
    ///
    /// # Errors
    /// Those of [`spent`](Self::spent).
    pub fn loss_factor(&self, closest: At) -> Result<f64, ContactError> {
        Ok(self.dissipated(closest)? / (2.0 * std::f64::consts::PI * self.spent(closest)?))
    }

    /// Where a history turns, as separations \[m\] from the mean of the asperity heights for
    /// [`path`](Self::path): loads beyond the largest so far are met on the virgin curve, smaller ones
    /// on the way back from the closest approach.
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

    /// What is asked after a retreat \[m\] from each of these closest approaches \[σ_z from the mean of
    /// the asperity heights\].
    pub(crate) fn retreated(
        &self,
        asked: Asked,
        retreat: f64,
        closest: &[f64],
    ) -> Result<Vec<Evaluation>, ContactError> {
        let model = Retreated::new((&self.source, &self.name), &self.loading, asked, retreat)?;
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
            rows.next().unwrap_or_else(|| Err(missing.into())).map_err(|error| *error)
        };
        closest.iter().map(next).collect()
    }
}

/// Whether no double holds how many asperities are higher than this \[σ_z\]: so far out, places have no
/// digits for the logarithms of Gauss' and Weibull's densities.
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
