//! What follows from the table of quantities: names, units, labels and sources.

use std::fmt;
use std::str::FromStr;

use crate::request::quantity_table::{Derivation, InterfaceProperty};
use crate::{ContactError, Evaluation, Quantity, nearest_name};

/// Why a contact has no leak.
pub(crate) const LEAK: &str =
    "leak, which follows from [seal] and a scan; `asperity bem --quantity leak` gives it";

impl Quantity {
    /// What tells whether an answer is plausible.
    pub const JUDGED: [Self; 3] = [Self::Force, Self::Area, Self::Contacts];

    /// SI unit, as in the heads of tables; empty for pure numbers.
    #[must_use]
    pub fn unit(self) -> &'static str {
        self.entry().unit
    }

    /// Symbol, in ASCII: `F`, `A/A_n`, `ln F`.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        self.entry().symbol
    }

    /// Name in words, without a unit, as beside an axis: `thermal conductance per area`.
    #[must_use]
    pub fn label(self) -> &'static str {
        self.entry().label
    }

    /// Definition in one sentence.
    #[must_use]
    pub fn definition(self) -> &'static str {
        self.entry().definition
    }

    /// Column in a table, unit included: `force_N`, `tangent_N_per_m`, `contacts`.
    #[must_use]
    pub fn column(self) -> String {
        let (name, unit) = (self.entry().name.replace('-', "_"), self.unit().replace('/', "_per_"));
        match unit.as_str() {
            "" => name,
            unit => format!("{name}_{}", unit.replace(' ', "_")),
        }
    }

    #[inline]
    pub(crate) fn derivation(self) -> Derivation {
        self.entry().derivation
    }

    /// Whether errors and deviations are absolute, as for logarithms and shares.
    #[must_use]
    pub fn is_absolute(self) -> bool {
        matches!(self.derivation(), Derivation::Logarithm(_) | Derivation::RegimeShare(_))
    }

    /// The quantity that gives this one its sign: the force for a pressure or its logarithm.
    pub(crate) fn origin(self) -> Self {
        match self.derivation() {
            Derivation::PerNominalArea(of) | Derivation::Logarithm(of) => of.origin(),
            Derivation::Ratio(above, _) => above.origin(),
            Derivation::ContactRadii(..) => Self::ContactRadiusSum,
            Derivation::RegimeShare(_) => Self::Force,
            // Integrals, slopes, and what follows from no law.
            _ => self,
        }
    }

    /// Whether this follows from the force and the real area of the whole surface alone.
    #[must_use]
    pub fn follows_from_totals(self) -> bool {
        Evaluation::of_totals(self, (1.0, 1.0), 1.0, 0.0).is_some()
    }

    /// Whether this follows from the sum of the contact radii, for which contacts must be circles.
    #[must_use]
    pub fn needs_circles(self) -> bool {
        self.origin() == Self::ContactRadiusSum
    }

    /// Whether this is a factor of the flow of a film, which depends on the film and the surfaces
    /// alone, not on a model of contact.
    #[must_use]
    pub fn is_flow_factor(self) -> bool {
        matches!(self.derivation(), Derivation::Flow)
    }

    /// Whether this follows from the film between the surfaces: a factor of flow, or a conductance
    /// of the gas in the gap.
    #[must_use]
    pub fn is_of_film(self) -> bool {
        matches!(self.derivation(), Derivation::Flow | Derivation::Gap)
    }

    /// Whether this is a stiffness or a conductance of a joint, per area or not: a multiple of the
    /// sum of the contact radii.
    #[must_use]
    pub fn is_of_joint(self) -> bool {
        self.interface_property().is_some()
    }

    /// The key of the property of the interface that this quantity needs, for a stiffness or a
    /// conductance of a joint.
    #[must_use]
    pub fn property(self) -> Option<&'static str> {
        self.interface_property().map(|property| property.0)
    }

    /// Whether the quantity is of flows through a map of the gap, which boundary elements have and
    /// no law of asperities.
    #[must_use]
    pub fn is_of_map(self) -> bool {
        matches!(self.derivation(), Derivation::Map)
    }

    /// Whether the quantity is of the patch of curved bodies, of which flat ones have none.
    #[must_use]
    pub fn is_of_bodies(self) -> bool {
        matches!(self.derivation(), Derivation::Bodies)
    }

    /// Whether models of flat surfaces have this quantity, and not boundary elements, curved bodies
    /// or a film alone.
    #[must_use]
    pub fn is_of_models(self) -> bool {
        !self.is_of_film() && !self.is_of_map() && !self.is_of_bodies() && self != Self::Leak
    }

    /// The number of the interface that this quantity needs, for a stiffness or a conductance, and
    /// the factor of the sum of the contact radii that follows from it.
    pub(crate) fn interface_property(self) -> Option<InterfaceProperty> {
        match self.derivation() {
            Derivation::ContactRadii(property) => Some(property),
            Derivation::PerNominalArea(of) => of.interface_property(),
            _ => None,
        }
    }

    /// The laws whose integrals this quantity needs, for a model with or without a law of the
    /// stiffness.
    pub(crate) fn laws(self, own_stiffness: bool) -> impl Iterator<Item = Self> {
        let (first, second) = match self.derivation() {
            Derivation::Integral => (self, None),
            Derivation::IntegralOrSlope(_) if own_stiffness => (self, None),
            Derivation::IntegralOrSlope(of) | Derivation::Slope(of) => (of, None),
            Derivation::Ratio(above, below) => (above, Some(below)),
            _ => (self.origin(), None),
        };
        std::iter::once(first).chain(second)
    }

    /// Whether this quantity is the slope of an integral.
    pub(crate) fn is_slope(self) -> bool {
        matches!(self.derivation(), Derivation::IntegralOrSlope(_) | Derivation::Slope(_))
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.entry().name)
    }
}

impl FromStr for Quantity {
    type Err = ContactError;

    /// Reads the names that [`Display`](fmt::Display) writes, in any case.
    fn from_str(name: &str) -> Result<Self, ContactError> {
        let wanted = name.trim().to_lowercase().replace('_', "-");
        let names = Self::ALL.map(|quantity| quantity.entry().name);
        let found = Self::ALL.into_iter().zip(names).find(|(_, known)| *known == wanted);
        found.map(|(quantity, _)| quantity).ok_or_else(|| ContactError::UnknownName {
            what: "quantity",
            name: name.into(),
            near: nearest_name(&wanted, names).map(Into::into),
            help: format!(": the quantities are {}", names.join(", ")),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definitions_and_labels_stand_for_themselves() {
        for quantity in Quantity::ALL {
            let (label, definition) = (quantity.label(), quantity.definition());
            assert!(!label.contains('-') || quantity == Quantity::ElasticPlasticShare, "{label}");
            assert!(definition.ends_with('.') && !definition.contains("  "), "{definition}");
            let same = |other: &Quantity| other.label() == label;
            assert_eq!(Quantity::ALL.iter().filter(|other| same(other)).count(), 1);
        }
    }

    #[test]
    fn signs_come_from_an_integral_or_a_slope() {
        use Quantity::{Area, ContactRadiusSum, Force};
        for (quantity, origin) in [
            (Quantity::MeanPressure, Force),
            (Quantity::LnArea, Area),
            (Quantity::ElectricalConductancePerArea, ContactRadiusSum),
            (Quantity::PlasticShare, Force),
            (Quantity::Tangent, Quantity::Tangent),
        ] {
            assert_eq!(quantity.origin(), origin);
        }
        for quantity in Quantity::ALL {
            assert_eq!(quantity.origin().origin(), quantity.origin());
        }
    }

    #[test]
    fn names_read_back_and_are_those_of_serde() {
        for quantity in Quantity::ALL {
            let name = quantity.to_string();
            assert_eq!(name.parse(), Ok(quantity));
            assert_eq!(name.to_uppercase().replace('-', "_").parse(), Ok(quantity));
            assert_eq!(serde_json::to_string(&quantity).unwrap(), format!("{name:?}"));
        }
        assert_eq!(Quantity::Tangent.column(), "tangent_N_per_m");
        assert_eq!(Quantity::AreaFraction.column(), "area_fraction");
        let column = Quantity::ThermalConductancePerArea.column();
        assert_eq!(column, "thermal_conductance_per_area_W_per_m2_per_K");
        assert_eq!(Quantity::LnForce.column(), "ln_force_ln_N");
        let far = "wear-rate".parse::<Quantity>().unwrap_err().to_string();
        assert!(far.contains("force, area") && !far.contains("mean \""), "{far}");
    }
}
