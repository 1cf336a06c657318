//! Models divided by their expected ratio to boundary elements.

use crate::bem::Bem;
use crate::evidence::{Counted, Lacking, compile_known};
use crate::{
    At, Compared, Contact, ContactError, Described, Evidence, ExpectedContact, Model, Quantity,
    Request, Scene, Separation, SeparationUnit, SurfaceShape,
};

/// A model on a scene, corrected by what boundary elements gave on solved surfaces: a value over
/// its expected ratio, with the interval of that ratio, which holds nine of ten single surfaces
/// with as many contacts as the usual reference counts, for all models alike. Where there is no
/// evidence, there is no value.
///
/// Every corrected model has nearly the same values: those that boundary elements are expected to
/// give.
///
/// ```
/// use asperity::{At, Corrected, Interface, Model, ProfileMoments, Quantity, Request, Scene, Surface};
///
/// let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4: 3e8 })?;
/// let scene = Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4);
/// let request = Request::new([Quantity::Area]).at_loads([1e3]);
/// let ke: Model = "ke".parse()?;
/// let corrected = Corrected::new(&ke, &scene, None, &request)?;
/// let area = corrected.at(At::Load(1e3))?.value(Quantity::Area)?;
/// assert_eq!(corrected.id(), "ke-corrected");
/// assert!(area.lower < area.value && area.value < area.upper);
/// // Separations are no loads.
/// assert!(corrected.at(At::from(2.0)).is_err());
/// # Ok::<(), asperity::ContactError>(())
/// ```
#[derive(Debug)]
pub struct Corrected {
    id: String,
    contact: Box<dyn Contact>,
    counted: Counted,
    lacking: Lacking,
    shape: Option<SurfaceShape>,
}

/// A corrected value and an interval that holds nine of ten surfaces.
///
/// An area is at least F/H, which may be the lower end and, where most of the contact flows, the
/// [value itself](CorrectedRow::is_least_area): less cannot carry the load. Where tangent and
/// unloading stiffness are known, the latter is at least the former, since what yielded in loading
/// unloads elastically.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CorrectedValue {
    /// The value of the model over its expected ratio.
    pub value: f64,
    /// Ends of the interval.
    pub lower: f64,
    /// Ends of the interval.
    pub upper: f64,
}

/// A corrected separation and an interval that holds nine of ten surfaces, from the same plane.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct CorrectedSeparation {
    /// The separation of the model less its expected difference of mean gaps.
    pub value: Separation,
    /// Ends of the interval.
    pub lower: Separation,
    /// Ends of the interval.
    pub upper: Separation,
}

/// A corrected model at one load.
#[derive(Debug)]
pub struct CorrectedRow<'c> {
    of: &'c Corrected,
    at: At,
    expected: ExpectedContact,
}

impl Corrected {
    /// The model on a scene whose surface has this shape; without one, it is taken as isotropic and
    /// must have Gaussian heights.
    ///
    /// A quantity that the model does not have is refused in every row, the others are answered.
    ///
    /// # Errors
    /// Those of the model, if it has none of the quantities; [`ContactError::Refused`] for boundary
    /// elements themselves, and for `ghaednia`, as the solved surfaces do not harden.
    pub fn new(
        model: &Model,
        scene: &Scene,
        shape: Option<SurfaceShape>,
        request: &Request,
    ) -> Result<Self, ContactError> {
        let id = format!("{}-corrected", model.id());
        let unlike = match model.id() {
            Bem::ID => Some("boundary elements are the reference; solve without correction"),
            "ghaednia" => Some("the solved surfaces do not harden; solve without correction"),
            _ => None,
        };
        if let Some(reason) = unlike {
            return Err(ContactError::Refused { model: id, reason: reason.into() });
        }
        let (contact, lacking) = compile_known(model, scene, request)?;
        Ok(Self { id, contact, counted: Counted::on(scene)?, lacking, shape })
    }

    /// The same under the id by which the model was asked for, as `ke`, which the options of a
    /// scene may make `ke-random`.
    #[must_use]
    pub fn named(self, id: &str) -> Self {
        Self { id: format!("{id}-corrected"), ..self }
    }

    /// The id of the model with `-corrected`.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// The answers at a load.
    ///
    /// # Errors
    /// [`ContactError::Refused`] at a separation, since models are compared under equal loads, and
    /// where there is no evidence, with the property of the scene outside the solved range.
    pub fn at(&self, at: impl Into<At>) -> Result<CorrectedRow<'_>, ContactError> {
        let at = at.into();
        let pressure = at.pressure(self.contact.scene()).ok_or_else(|| {
            self.refused("models are compared with boundary elements at equal loads; give a load or a pressure".into())
        })?;
        let contacts = self.counted.at(pressure);
        let expected =
            Evidence::committed()?.expected(self.contact.scene(), self.shape, pressure, contacts);
        let expected = expected.map_err(|reason| match reason {
            // With the name of the model in front, as other refusals.
            ContactError::Refused { .. } => self.refused(reason.to_string()),
            other => other,
        })?;
        Ok(CorrectedRow { of: self, at, expected })
    }

    fn refused(&self, reason: String) -> ContactError {
        ContactError::Refused { model: self.id.clone(), reason }
    }
}

impl CorrectedRow<'_> {
    /// Whether the load is below all solved ones, where ratios are taken as constant.
    #[must_use]
    pub fn is_extrapolated(&self) -> bool {
        self.expected.extrapolated
    }

    /// Whether the area is F/H, the least that carries the load, and its interval extends above
    /// only.
    #[must_use]
    pub fn is_least_area(&self) -> bool {
        self.expected.estimate(Compared::Area).is_some_and(|area| area.value <= area.low)
    }

    /// What stands behind the correction: `alpha 8, psi 2; boundary elements on 16 surfaces`.
    #[must_use]
    pub fn basis(&self) -> String {
        self.expected.basis()
    }

    /// A quantity.
    ///
    /// # Errors
    /// [`ContactError::Refused`] for a quantity that is not compared with boundary elements, or
    /// that the solved surfaces do not determine here; errors of the model.
    pub fn value(&self, quantity: Quantity) -> Result<CorrectedValue, ContactError> {
        let contact = &*self.of.contact;
        if let Some((_, lacks)) = self.of.lacking.iter().find(|(lacks, _)| *lacks == quantity) {
            return Err(lacks.clone());
        }
        let value = contact.evaluate(quantity, self.at)?.value();
        if matches!(quantity, Quantity::Force | Quantity::Pressure) {
            // Loads are given.
            return Ok(CorrectedValue { value, lower: value, upper: value });
        }
        let Some((compared, power)) = Compared::behind(quantity) else {
            return Err(self.of.refused(match quantity {
                Quantity::Stiffness => "stiffness is what the paper of each model defines; use tangent (first loading) or unloading-stiffness (small vibrations)".into(),
                _ => format!(
                    "{quantity} has no counterpart in boundary elements; corrected are areas, mean-pressure, tangent, unloading-stiffness, tangential-stiffness and conductances"
                ),
            }));
        };
        let here = compared.of_contact(contact, self.expected.pressure)?;
        let ratio = self.expected.ratio(compared, here).ok_or_else(|| {
            let why = self.expected.undetermined(compared);
            self.of
                .refused(format!("the solved surfaces do not determine the {quantity} here: {why}"))
        })?;
        let of = |ratio: f64| value / ratio.powf(power);
        let ends = [of(ratio.low), of(ratio.high)];
        let [lower, upper] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        self.within_limits(quantity, CorrectedValue { value: of(ratio.ratio), lower, upper })
    }

    /// A value within its limits to the last digit, of which dividing by a ratio can leave it
    /// short: the area is at least F/H, and the unloading stiffness at least the tangent.
    fn within_limits(
        &self,
        quantity: Quantity,
        found: CorrectedValue,
    ) -> Result<CorrectedValue, ContactError> {
        let scene = self.of.contact.scene();
        let hardness = || scene.asperity().ok()?.hardness;
        let all = |number: f64| CorrectedValue { value: number, lower: number, upper: number };
        let least = match quantity {
            Quantity::Area => hardness().zip(self.at.load(scene)).map(|(h, load)| all(load / h)),
            Quantity::AreaFraction => {
                hardness().zip(self.at.pressure(scene)).map(|(h, p)| all(p / h))
            }
            Quantity::UnloadingStiffness => self.value(Quantity::Tangent).ok(),
            _ => None,
        };
        let Some(least) = least else { return Ok(found) };
        if found.upper < least.lower && self.is_extrapolated() {
            return Err(self.of.refused(format!(
                "the {quantity} extrapolated from the lightest solved load would be below {:e}, the least that is possible",
                least.lower
            )));
        }
        Ok(CorrectedValue {
            value: found.value.max(least.value),
            lower: found.lower.max(least.lower),
            upper: found.upper.max(least.upper),
        })
    }

    /// The separation of the model less the expected difference of mean gaps, with its interval, in
    /// metres and from the same plane.
    ///
    /// # Errors
    /// Those of [`value`](Self::value).
    pub fn separation(&self) -> Result<CorrectedSeparation, ContactError> {
        let contact = &*self.of.contact;
        let gap = Compared::MeanGap.of_contact(contact, self.expected.pressure)?;
        let ratio = self.expected.ratio(Compared::MeanGap, gap).ok_or_else(|| {
            let why = self.expected.undetermined(Compared::MeanGap);
            self.of
                .refused(format!("the solved surfaces do not determine the separation here: {why}"))
        })?;
        let separation = contact.separation(self.at)?;
        let metres =
            separation.measured_in(SeparationUnit::Metres, separation.from, contact.scene())?;
        let less = |difference: f64| Separation {
            value: metres.value - difference * self.expected.rms_height,
            ..metres
        };
        let [value, lower, upper] = [ratio.ratio, ratio.high, ratio.low].map(less);
        Ok(CorrectedSeparation { value, lower, upper })
    }
}

#[cfg(test)]
mod tests;
