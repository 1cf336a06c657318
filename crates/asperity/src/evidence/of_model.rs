//! The compared quantities of a model.

use crate::evidence::case::Compared;
use crate::{
    At, Contact, ContactError, ContactModel, Datum, Model, Quantity, Request, Scene, SeparationUnit,
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
            Self::MeanGap => {
                let separation = contact.separation(at)?;
                let (metres, mean) = (SeparationUnit::Metres, Datum::SurfaceMean);
                Ok(separation.measured_in(metres, mean, contact.scene())?.value)
            }
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
    pub(crate) fn quantity(self) -> Option<Quantity> {
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

/// Like [`compile`] for the quantities that the model has, and the others.
///
/// # Errors
/// Those of the model, if it has none of the quantities.
pub(crate) fn compile_known(
    model: &Model,
    scene: &Scene,
    request: &Request,
) -> Result<(Box<dyn Contact>, Lacking), ContactError> {
    let whole = match compile(model, scene, request) {
        Ok(contact) => return Ok((contact, vec![])),
        Err(whole) => whole,
    };
    let of = |quantities: Vec<Quantity>| Request::new(quantities).within(request.tolerance);
    let refusal = |q: &Quantity| Some((*q, model.compile(scene, &of(vec![*q])).err()?));
    let lacking: Lacking = request.quantities.iter().filter_map(refusal).collect();
    let mut others = request.quantities.clone();
    others.retain(|q| !lacking.iter().any(|(lacks, _)| lacks == q));
    if others.is_empty() {
        return Err(whole);
    }
    Ok((compile(model, scene, &of(others).at(request.at.iter().copied()))?, lacking))
}

/// A model compiled for a request and, as far as it has them, for the compared quantities.
pub(crate) fn compile(
    model: &Model,
    scene: &Scene,
    request: &Request,
) -> Result<Box<dyn Contact>, ContactError> {
    let compared = Compared::QUANTITIES;
    let with = |others: &[Quantity]| {
        let mut all = request.quantities.clone();
        all.extend(others.iter().filter(|quantity| !request.quantities.contains(quantity)));
        let places = request.at.iter().copied();
        model.compile(scene, &Request::new(all).within(request.tolerance).at(places))
    };
    // Some have no contact radii or no gap.
    [3, 2, 1].iter().find_map(|k| with(&compared[..*k]).ok()).map_or_else(|| with(&[]), Ok)
}
