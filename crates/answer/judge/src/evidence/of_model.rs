//! The compared quantities of a model.

use crate::evidence::case::Compared;
use asperity_core::{
    At, Contact, ContactError, ContactModel, Datum, Quantity, Request, Scene, SeparationUnit,
};

impl Compared {
    /// The quantities of a contact that are compared; the mean gap is none.
    pub const QUANTITIES: [Quantity; 3] =
        [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness];

    /// The value of a model at a mean pressure \[Pa\]: area over nominal area, stiffness \[N/m\],
    /// mean gap \[m\].
    ///
    /// # Errors
    /// Those of the contact, which must be compiled for the area, the tangent and the unloading
    /// stiffness.
    pub fn of_contact(self, contact: &dyn Contact, pressure: f64) -> Result<f64, ContactError> {
        let at = At::Pressure(pressure);
        let value = |quantity| contact.evaluate(quantity, at).map(|found| found.value());
        match self {
            Self::Area => value(Quantity::Area).map(|area| area / contact.scene().nominal_area),
            Self::Stiffness => value(Quantity::Tangent),
            Self::UnloadingStiffness => value(Quantity::UnloadingStiffness),
            Self::MeanGap => contact.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at),
        }
    }

    /// The compared quantities on which these depend; all, if none is compared. A force at a
    /// separation depends on the mean gap.
    pub(crate) fn for_request(asked: &[Quantity]) -> Vec<Self> {
        let of = |quantity: &Quantity| match quantity {
            Quantity::Force | Quantity::Pressure => Some(Self::MeanGap),
            Quantity::Stiffness => Some(Self::Stiffness),
            other => Self::behind(*other).map(|(compared, _)| compared),
        };
        let asked: Vec<Self> = asked.iter().filter_map(of).collect();
        let mut all = Self::ALL.to_vec();
        all.retain(|compared| asked.is_empty() || asked.contains(compared));
        all
    }

    /// The quantity of a contact that is compared; none is the distance of the mean planes.
    #[must_use]
    pub fn quantity(self) -> Option<Quantity> {
        match self {
            Self::Area => Some(Quantity::Area),
            Self::Stiffness => Some(Quantity::Tangent),
            Self::UnloadingStiffness => Some(Quantity::UnloadingStiffness),
            Self::MeanGap => None,
        }
    }

    /// The compared quantity to which a quantity at a load is proportional, with the sign of the
    /// power: the mean pressure falls as the area grows.
    #[must_use]
    pub fn behind(quantity: Quantity) -> Option<(Self, f64)> {
        match quantity {
            Quantity::Area | Quantity::AreaFraction => Some((Self::Area, 1.0)),
            Quantity::MeanPressure => Some((Self::Area, -1.0)),
            Quantity::Tangent => Some((Self::Stiffness, 1.0)),
            Quantity::UnloadingStiffness
            | Quantity::ContactRadiusSum
            | Quantity::TangentialStiffness
            | Quantity::ThermalConductance
            | Quantity::ElectricalConductance
            | Quantity::ThermalConductancePerArea
            | Quantity::ElectricalConductancePerArea => Some((Self::UnloadingStiffness, 1.0)),
            _ => None,
        }
    }
}

/// Quantities that a model does not have, and why.
pub(crate) type Lacking = Vec<(Quantity, ContactError)>;

/// A contact compiled for those of the quantities that the model has, and why it lacks the others;
/// `compile` makes it for some of them. Without any, it is made for those `otherwise`.
///
/// # Errors
/// Those of the model for all quantities, if it has none and there is nothing otherwise.
pub fn compile_known(
    quantities: &[Quantity],
    otherwise: &[Quantity],
    compile: impl Fn(&[Quantity]) -> Result<Box<dyn Contact>, ContactError>,
) -> Result<(Box<dyn Contact>, Lacking), ContactError> {
    let whole = match compile(quantities) {
        Ok(contact) => return Ok((contact, vec![])),
        Err(whole) => whole,
    };
    let refusal = |q: &Quantity| Some((*q, compile(&[*q]).err()?));
    let lacking: Lacking = quantities.iter().filter_map(refusal).collect();
    let mut had = quantities.to_vec();
    had.retain(|q| lacking.iter().all(|(lacks, _)| lacks != q));
    let had = if had.is_empty() { otherwise.to_vec() } else { had };
    match had.is_empty() {
        true => Err(whole),
        false => Ok((compile(&had).map_err(|_| whole)?, lacking)),
    }
}

/// A contact compiled for quantities and, as far as the model has them, for the compared ones.
///
/// # Errors
/// Those of the model for the quantities alone.
pub fn compile_compared(
    quantities: &[Quantity],
    compile: impl Fn(&[Quantity]) -> Result<Box<dyn Contact>, ContactError>,
) -> Result<Box<dyn Contact>, ContactError> {
    // Some have no contact radii or no gap.
    let with = |k: usize| compile(&[quantities, &Compared::QUANTITIES[..k]].concat());
    [3, 2, 1].iter().find_map(|k| with(*k).ok()).map_or_else(|| with(0), Ok)
}

/// [`compile_compared`] of a model on a scene, at the places of a request; also for what is judged,
/// but of inclined contacts, which take longer than to judge without tables.
pub(crate) fn compile(
    model: &dyn ContactModel,
    scene: &Scene,
    request: &Request,
    quantities: &[Quantity],
) -> Result<Box<dyn Contact>, ContactError> {
    let validity = model.validity();
    let judged = Quantity::JUDGED.into_iter().filter(|_| validity.asperities && !validity.angles);
    compile_compared(quantities, |all| {
        let all = all.iter().copied().chain(judged.clone());
        let all = Request::new(all).within(request.tolerance);
        model.compile(scene, &all.at(request.at.iter().copied()))
    })
}
