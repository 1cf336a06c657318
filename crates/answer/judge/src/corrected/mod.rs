//! Models divided by their expected ratio to boundary elements.

use std::sync::Arc;

use crate::evidence::{Counted, Lacking, compile, compile_known};
use crate::{Compared, Evidence, ExpectedContact, SurfaceShape, Weighed};
use asperity_core::{
    At, Contact, ContactError, Quantity, Request, Scene, Separation, SeparationUnit, short,
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
    contact: Arc<dyn Contact>,
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
    pub fn new<M: Weighed>(
        model: &M,
        scene: &Scene,
        shape: Option<SurfaceShape>,
        request: &Request,
    ) -> Result<Self, ContactError> {
        Self::check(model)?;
        let compile = |quantities: &[Quantity]| compile(model, scene, request, quantities);
        let (contact, lacking) = compile_known(&request.quantities, &[], compile)?;
        Self::of(model, contact.into(), lacking, shape)
    }

    /// The same of a contact that is compiled already, for the quantities asked for except those
    /// that it lacks, and for area, tangent and unloading stiffness as far as the model has them.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn of<M: Weighed>(
        model: &M,
        contact: Arc<dyn Contact>,
        lacking: Vec<(Quantity, ContactError)>,
        shape: Option<SurfaceShape>,
    ) -> Result<Self, ContactError> {
        let id = Self::check(model)?;
        let counted = Counted::on::<M>(contact.scene())?;
        Ok(Self { id, contact, counted, lacking, shape })
    }

    /// The id of a corrected model; an error for one that the evidence says nothing about.
    fn check(model: &impl Weighed) -> Result<String, ContactError> {
        let id = format!("{}-corrected", model.id());
        match model.unlike() {
            Some(unlike) => {
                Err(ContactError::Refused { model: id, reason: unlike.reason().into() })
            }
            None => Ok(id),
        }
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
    /// [`ContactError::Refused`] at a separation, since models are compared under equal loads;
    /// [`ContactError::NoEvidence`] with the property of the scene outside the solved range.
    pub fn at(&self, at: impl Into<At>) -> Result<CorrectedRow<'_>, ContactError> {
        let at = at.into();
        let pressure = at.pressure(self.contact.scene()).ok_or_else(|| {
            self.refused("models are compared with boundary elements at equal loads; give a load or a pressure".into())
        })?;
        let contacts = self.counted.at(pressure);
        let scene = self.contact.scene();
        let expected = Evidence::committed()?.expected(scene, self.shape, pressure, contacts)?;
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

    /// What was solved: `boundary elements on 16 surfaces`.
    #[must_use]
    pub fn solved(&self) -> String {
        self.expected.solved()
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
        let Some(behind) = compared.quantity().filter(|behind| *behind != quantity) else {
            return self.compared(compared, quantity, value);
        };
        // The limits of what it depends on are its own.
        let own = contact.evaluate(behind, self.at)?.value();
        let found = self.value(behind)?;
        let of = |behind: f64| value * (behind / own).powf(power);
        let ends = [of(found.lower), of(found.upper)];
        let [lower, upper] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        Ok(self.in_range(quantity, CorrectedValue { value: of(found.value), lower, upper }))
    }

    /// The value of a compared quantity over its expected ratio. An area carries the load, and what
    /// yielded in loading unloads at least as stiff.
    fn compared(
        &self,
        compared: Compared,
        quantity: Quantity,
        value: f64,
    ) -> Result<CorrectedValue, ContactError> {
        let here = compared.of_contact(&*self.of.contact, self.expected.pressure)?;
        let ratio = self.expected.ratio(compared, here).ok_or_else(|| {
            let why = self.expected.undetermined(compared);
            self.of
                .refused(format!("the solved surfaces do not determine the {quantity} here: {why}"))
        })?;
        let [value, lower, upper] = [ratio.ratio, ratio.high, ratio.low].map(|ratio| value / ratio);
        let found = CorrectedValue { value, lower, upper };
        let least = match quantity {
            Quantity::UnloadingStiffness => match self.value(Quantity::Tangent) {
                Ok(tangent) => tangent,
                Err(_) => return Ok(found),
            },
            _ => self.in_range(quantity, CorrectedValue { value: 0.0, lower: 0.0, upper: 0.0 }),
        };
        if upper < least.lower && self.is_extrapolated() {
            return Err(self.of.refused(format!(
                "the {quantity} extrapolated from the lightest solved load is below its least value, {} {}; use a larger load",
                short(least.lower),
                quantity.unit()
            )));
        }
        Ok(CorrectedValue {
            value: value.max(least.value),
            lower: lower.max(least.lower),
            upper: upper.max(least.upper),
        })
    }

    /// A value within the range that the hardness leaves, to the last digit, of which a quotient
    /// can fall short: the area is at least F/H, and the mean pressure at most H.
    fn in_range(&self, quantity: Quantity, found: CorrectedValue) -> CorrectedValue {
        let scene = self.of.contact.scene();
        let Some(hardness) = scene.asperity().ok().and_then(|asperity| asperity.hardness) else {
            return found;
        };
        let over_hardness = |load: Option<f64>| load.map_or(0.0, |load| load / hardness);
        let [least, most] = match quantity {
            Quantity::Area => [over_hardness(self.at.load(scene)), f64::INFINITY],
            Quantity::AreaFraction => [over_hardness(self.at.pressure(scene)), f64::INFINITY],
            Quantity::MeanPressure => [0.0, hardness],
            _ => return found,
        };
        let CorrectedValue { value, lower, upper } = found;
        let [value, lower, upper] = [value, lower, upper].map(|x| x.max(least).min(most));
        CorrectedValue { value, lower, upper }
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
