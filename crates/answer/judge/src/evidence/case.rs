//! A solved case with the results of boundary elements and of the models, and the compared
//! quantities of a model.

use asperity_core::{At, Contact, ContactError, Datum, Quantity, SeparationUnit};
use serde::Serialize;

/// One family of surfaces, one material and one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvidenceCase {
    /// m₀ m₄/m₂² of profiles, the mean of all directions.
    pub alpha: f64,
    /// Skewness of the heights.
    pub skewness: f64,
    /// Rms slope across the lay over that along it.
    pub slope_ratio: f64,
    /// ψ = √(σ_z/w_c); 0 for elastic cases.
    pub plasticity_index: f64,
    /// p/(E g), with the root mean square gradient g.
    pub load: f64,
    /// Number of surfaces with the same moments.
    pub surfaces: usize,
    /// Contact patches of at least 12 pixels on all of them.
    pub patches: usize,
    /// Share of the contact at the hardness.
    pub plastic_share: f64,
    /// Boundary elements: the mean of the surfaces.
    pub bem: EvidenceRow,
    /// Results of the models, by id.
    #[serde(skip)]
    pub models: Vec<(String, EvidenceRow)>,
}

/// Dimensionless results, in the order of [`Compared::ALL`]; `None` if not available.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// The values.
    pub values: [Option<f64>; 4],
    /// Standard errors of the mean, for boundary elements only.
    pub errors: [Option<f64>; 4],
}

/// A quantity that is compared with boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Compared {
    /// Real area; in rows over the nominal area.
    Area,
    /// Stiffness of first loading; in rows −dp/d(gap) √m₀/E of a surface with the gradient
    /// [`Evidence::GRADIENT`](crate::Evidence::GRADIENT), in proportion to which it grows.
    Stiffness,
    /// Stiffness at the start of unloading, with which conductances and the tangential stiffness
    /// go; in rows in the same unit.
    UnloadingStiffness,
    /// Mean gap; in rows over √m₀.
    MeanGap,
}

impl Compared {
    /// All four.
    pub const ALL: [Self; 4] =
        [Self::Area, Self::Stiffness, Self::UnloadingStiffness, Self::MeanGap];

    /// Of each its name, its words and its quantity.
    const TABLE: [(&'static str, &'static str, Option<Quantity>); 4] = [
        ("area", "real area", Some(Quantity::Area)),
        ("stiffness", "first-loading stiffness", Some(Quantity::Tangent)),
        (
            "unloading_stiffness",
            "stiffness of small vibrations",
            Some(Quantity::UnloadingStiffness),
        ),
        ("mean_gap", "mean gap", None),
    ];

    /// Its name in columns and keys.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::TABLE[self as usize].0
    }

    /// Its name in sentences.
    #[must_use]
    pub fn label(self) -> &'static str {
        Self::TABLE[self as usize].1
    }

    /// The quantity of a contact that is compared; none is the distance of the mean planes.
    #[must_use]
    pub fn quantity(self) -> Option<Quantity> {
        Self::TABLE[self as usize].2
    }

    /// The quantities of a contact that are compared; the mean gap is none.
    pub const QUANTITIES: [Quantity; 3] =
        [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness];

    /// The value of a model at a place: area over nominal area, stiffness \[N/m\], mean gap \[m\].
    ///
    /// # Errors
    /// Those of the contact, which must be compiled for the area, the tangent and the unloading
    /// stiffness.
    pub fn of_contact(self, contact: &dyn Contact, at: At) -> Result<f64, ContactError> {
        let Some(quantity) = self.quantity() else {
            return contact.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at);
        };
        let unit = if self == Self::Area { contact.scene().nominal_area } else { 1.0 };
        Ok(contact.evaluate(quantity, at)?.value() / unit)
    }

    /// The compared quantity from which a quantity at a load follows.
    #[must_use]
    pub fn behind(quantity: Quantity) -> Option<Self> {
        match quantity {
            Quantity::Area | Quantity::AreaFraction | Quantity::MeanPressure | Quantity::LnArea => {
                Some(Self::Area)
            }
            Quantity::Tangent => Some(Self::Stiffness),
            radii if radii.needs_circles() => Some(Self::UnloadingStiffness),
            _ => None,
        }
    }
}

impl EvidenceRow {
    /// The value of a quantity.
    #[must_use]
    pub fn value(&self, quantity: Compared) -> Option<f64> {
        self.values[quantity as usize]
    }

    /// Its standard error.
    #[must_use]
    pub fn error(&self, quantity: Compared) -> Option<f64> {
        self.errors[quantity as usize]
    }
}

/// Quantities that a model does not have, and why.
pub(crate) type Lacking = Vec<(Quantity, ContactError)>;

/// A contact compiled for those of the quantities that the model has, and why it lacks the others;
/// `compile` makes it for some of them. Without any, it is made for those `otherwise`.
///
/// # Errors
/// The errors of the model for all quantities, if it has none and there is nothing otherwise.
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
