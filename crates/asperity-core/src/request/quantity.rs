//! What can be asked of a contact.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::{ContactError, Regime, nearest_name};

/// A quantity of the whole contact, by the name users ask for it.
///
/// ```
/// use asperity_core::Quantity;
///
/// let quantity: Quantity = "mean-pressure".parse()?;
/// assert_eq!((quantity.to_string().as_str(), quantity.unit()), ("mean-pressure", "Pa"));
/// let mistyped = "stifness".parse::<Quantity>().unwrap_err().to_string();
/// assert!(mistyped.contains("did you mean \"stiffness\"?"));
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Quantity {
    /// Normal contact force \[N\].
    Force,
    /// Real contact area \[m²\].
    Area,
    /// Stiffness \[N/m\] as the model's paper defines it: the tangent for the models of upright
    /// asperities, an average of asperity stiffnesses for Gao and AT.
    Stiffness,
    /// -dF/dd \[N/m\], jumps of the law included.
    Tangent,
    /// Force over nominal area \[Pa\].
    Pressure,
    /// Real over nominal area.
    AreaFraction,
    /// Number of asperities that touch: η A_n ∫ g(d + w) dw, the same for every model.
    Contacts,
    /// Sum of the contact radii √(A/π) \[m\], for upright asperities with circular contacts: what
    /// the next six follow from.
    ContactRadiusSum,
    /// 2 E Σ a \[N/m\]: what small vibrations, ultrasound and modal tests feel, the slope at which
    /// unloading begins. First loading follows the tangent, which is smaller where asperities yield.
    /// Of contacts that stick (JKR), with edges that stay where they are, as they do for small motions.
    UnloadingStiffness,
    /// 8 G Σ a \[N/m\] in stick (Mindlin); needs the equivalent shear modulus.
    TangentialStiffness,
    /// 2 k Σ a \[W/K\], of contacts far from each other; needs the thermal conductivity.
    ThermalConductance,
    /// 2 Σ a/ρ \[S\], of contacts far from each other; needs the electrical resistivity.
    ElectricalConductance,
    /// The thermal conductance over the nominal area \[W/(m² K)\].
    ThermalConductancePerArea,
    /// The electrical conductance over the nominal area \[S/m²\].
    ElectricalConductancePerArea,
    /// Force over real area \[Pa\].
    MeanPressure,
    /// Natural logarithm of the absolute force in newtons, also where the force underflows.
    LnForce,
    /// Natural logarithm of the absolute area in square metres.
    LnArea,
    /// Share of the force that elastic asperities carry; signed where a model subtracts a part.
    ElasticShare,
    /// Share of the force that elastic-plastic asperities carry.
    ElasticPlasticShare,
    /// Share of the force that plastic asperities carry.
    PlasticShare,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Self; 20] = [
        Self::Force,
        Self::Area,
        Self::Stiffness,
        Self::Tangent,
        Self::Pressure,
        Self::AreaFraction,
        Self::Contacts,
        Self::ContactRadiusSum,
        Self::UnloadingStiffness,
        Self::TangentialStiffness,
        Self::ThermalConductance,
        Self::ElectricalConductance,
        Self::ThermalConductancePerArea,
        Self::ElectricalConductancePerArea,
        Self::MeanPressure,
        Self::LnForce,
        Self::LnArea,
        Self::ElasticShare,
        Self::ElasticPlasticShare,
        Self::PlasticShare,
    ];

    /// SI unit, as in the heads of tables; empty for pure numbers.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Force => "N",
            Self::Area => "m2",
            Self::Stiffness
            | Self::Tangent
            | Self::UnloadingStiffness
            | Self::TangentialStiffness => "N/m",
            Self::ContactRadiusSum => "m",
            Self::ThermalConductance => "W/K",
            Self::ElectricalConductance => "S",
            Self::ThermalConductancePerArea => "W/m2/K",
            Self::ElectricalConductancePerArea => "S/m2",
            Self::Pressure | Self::MeanPressure => "Pa",
            Self::LnForce => "ln N",
            Self::LnArea => "ln m2",
            _ => "",
        }
    }

    /// Its column in a table, unit included: `force_N`, `tangent_N_per_m`, `contacts`.
    #[must_use]
    pub fn column(self) -> String {
        let (name, unit) = (self.to_string().replace('-', "_"), self.unit().replace('/', "_per_"));
        match unit.as_str() {
            "" => name,
            unit => format!("{name}_{}", unit.replace(' ', "_")),
        }
    }

    /// What it is over the nominal area, of a conductance per nominal area.
    pub(crate) fn over_area(self) -> Option<Self> {
        match self {
            Self::ThermalConductancePerArea => Some(Self::ThermalConductance),
            Self::ElectricalConductancePerArea => Some(Self::ElectricalConductance),
            _ => None,
        }
    }

    /// Whether its errors and deviations are differences: those of logarithms and shares are.
    #[must_use]
    pub fn is_absolute(self) -> bool {
        matches!(self, Self::LnForce | Self::LnArea) || self.regime().is_some()
    }

    /// The regime whose share it is.
    #[must_use]
    pub fn regime(self) -> Option<Regime> {
        match self {
            Self::ElasticShare => Some(Regime::Elastic),
            Self::ElasticPlasticShare => Some(Regime::ElasticPlastic),
            Self::PlasticShare => Some(Regime::Plastic),
            _ => None,
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Force => "force",
            Self::Area => "area",
            Self::Stiffness => "stiffness",
            Self::Tangent => "tangent",
            Self::Pressure => "pressure",
            Self::AreaFraction => "area-fraction",
            Self::Contacts => "contacts",
            Self::ContactRadiusSum => "contact-radius-sum",
            Self::UnloadingStiffness => "unloading-stiffness",
            Self::TangentialStiffness => "tangential-stiffness",
            Self::ThermalConductance => "thermal-conductance",
            Self::ElectricalConductance => "electrical-conductance",
            Self::ThermalConductancePerArea => "thermal-conductance-per-area",
            Self::ElectricalConductancePerArea => "electrical-conductance-per-area",
            Self::MeanPressure => "mean-pressure",
            Self::LnForce => "ln-force",
            Self::LnArea => "ln-area",
            Self::ElasticShare => "elastic-share",
            Self::ElasticPlasticShare => "elastic-plastic-share",
            Self::PlasticShare => "plastic-share",
        })
    }
}

impl FromStr for Quantity {
    type Err = ContactError;

    /// Reads the names that [`Display`](fmt::Display) writes, in any case.
    fn from_str(name: &str) -> Result<Self, ContactError> {
        let wanted = name.trim().to_lowercase().replace('_', "-");
        let names = Self::ALL.map(|quantity| quantity.to_string());
        let named =
            |name: &str| Self::ALL.into_iter().zip(&names).find(|(_, known)| *known == name);
        if let Some((quantity, _)) = named(&wanted) {
            return Ok(quantity);
        }
        let separation = ["separation", "gap", "mean-gap", "distance"];
        let beside = match separation.iter().any(|word| wanted.starts_with(word)) {
            true => " (separations come with every answer, unasked)",
            false => "",
        };
        let near = nearest_name(&wanted, names.iter().map(String::as_str)).and_then(named);
        Err(ContactError::UnknownQuantity {
            name: name.into(),
            near: near.map(|(quantity, _)| quantity),
            known: names.join(", ") + beside,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_separation_is_no_quantity_and_comes_unasked() {
        let refused = |name: &str| name.parse::<Quantity>().unwrap_err().to_string();
        for name in ["separation", "mean_gap", "Separation_m"] {
            let text = refused(name);
            assert!(text.ends_with("plastic-share (separations come with every answer, unasked)"));
            assert!(
                text.starts_with(&format!("quantity {name:?} is not known: the quan")),
                "{text}"
            );
        }
        assert!(!refused("forse").contains("unasked"));
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
