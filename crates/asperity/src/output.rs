//! What can be printed of a contact: the quantities of the laws, and what follows from them.

use std::fmt;
use std::str::FromStr;

use strsim::osa_distance;

use crate::{Quantity, Regime};

/// A column of a table, by the name users ask for it.
///
/// ```
/// use asperity::Output;
///
/// let output: Output = "mean-pressure".parse()?;
/// assert_eq!((output.to_string().as_str(), output.unit()), ("mean-pressure", "Pa"));
/// let mistyped = "stifness".parse::<Output>().unwrap_err().to_string();
/// assert!(mistyped.contains("did you mean \"stiffness\"?"));
/// # Ok::<(), asperity::UnknownOutput>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Output {
    /// Normal contact force \[N\].
    Force,
    /// Real contact area \[m²\].
    Area,
    /// Stiffness \[N/m\] as the model's paper defines it.
    Stiffness,
    /// -dF/dd \[N/m\].
    Tangent,
    /// Force over nominal area \[Pa\].
    Pressure,
    /// Real over nominal area.
    AreaFraction,
    /// Number of asperities that touch: η A_n ∫ g(d + w) dw, the same for every model.
    Contacts,
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

impl Output {
    /// All outputs.
    pub const ALL: [Self; 13] = [
        Self::Force,
        Self::Area,
        Self::Stiffness,
        Self::Tangent,
        Self::Pressure,
        Self::AreaFraction,
        Self::Contacts,
        Self::MeanPressure,
        Self::LnForce,
        Self::LnArea,
        Self::ElasticShare,
        Self::ElasticPlasticShare,
        Self::PlasticShare,
    ];

    /// The quantities it is made of; none for the number of contacts.
    #[must_use]
    pub fn needs(self) -> &'static [Quantity] {
        match self {
            Self::Stiffness => &[Quantity::Stiffness],
            Self::Tangent => &[Quantity::Tangent],
            Self::Area | Self::AreaFraction | Self::LnArea => &[Quantity::Area],
            Self::MeanPressure => &[Quantity::Force, Quantity::Area],
            Self::Contacts => &[],
            _ => &[Quantity::Force],
        }
    }

    /// SI unit, as in the heads of tables; empty for pure numbers.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Force => "N",
            Self::Area => "m2",
            Self::Stiffness | Self::Tangent => "N/m",
            Self::Pressure | Self::MeanPressure => "Pa",
            Self::LnForce => "ln N",
            Self::LnArea => "ln m2",
            _ => "",
        }
    }

    /// How far a value is from a reference: relative to the reference, but the difference for
    /// logarithms and shares; `None` where that is no number.
    #[must_use]
    pub fn deviation(self, value: f64, reference: f64) -> Option<f64> {
        let deviation = match self {
            Self::LnForce | Self::LnArea => value - reference,
            _ if self.regime().is_some() => value - reference,
            _ => value / reference - 1.0,
        };
        deviation.is_finite().then_some(deviation)
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

impl fmt::Display for Output {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Force => "force",
            Self::Area => "area",
            Self::Stiffness => "stiffness",
            Self::Tangent => "tangent",
            Self::Pressure => "pressure",
            Self::AreaFraction => "area-fraction",
            Self::Contacts => "contacts",
            Self::MeanPressure => "mean-pressure",
            Self::LnForce => "ln-force",
            Self::LnArea => "ln-area",
            Self::ElasticShare => "elastic-share",
            Self::ElasticPlasticShare => "elastic-plastic-share",
            Self::PlasticShare => "plastic-share",
        })
    }
}

/// A name that no output has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("quantity {name:?} is not known{}: the quantities are {known}", suggestion(.near))]
pub struct UnknownOutput {
    /// What was given.
    pub name: String,
    /// The nearest output, if one is near.
    pub near: Option<Output>,
    /// All known names.
    pub known: String,
}

fn suggestion(near: &Option<Output>) -> String {
    near.map_or(String::new(), |near| format!(" (did you mean \"{near}\"?)"))
}

impl FromStr for Output {
    type Err = UnknownOutput;

    /// Reads the names that [`Display`](fmt::Display) writes, in any case.
    fn from_str(name: &str) -> Result<Self, UnknownOutput> {
        let wanted = name.trim().to_lowercase().replace('_', "-");
        let distance = |output: &Self| osa_distance(&wanted, &output.to_string());
        let near = Self::ALL.into_iter().min_by_key(distance).map(|o| (o, distance(&o)));
        match near {
            Some((output, 0)) => Ok(output),
            _ => Err(UnknownOutput {
                name: name.into(),
                near: near.filter(|(_, distance)| *distance <= 3).map(|(output, _)| output),
                known: Self::ALL.map(|o| o.to_string()).join(", "),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back_with_either_kind_of_dash() {
        for output in Output::ALL {
            assert_eq!(output.to_string().parse(), Ok(output));
            assert_eq!(output.to_string().replace('-', "_").to_uppercase().parse(), Ok(output));
        }
    }

    #[test]
    fn deviations_are_relative_where_sizes_are_compared() {
        assert_eq!(Output::Force.deviation(3.0, 2.0), Some(0.5));
        assert_eq!(Output::LnForce.deviation(-3.0, -2.0), Some(-1.0));
        assert_eq!(Output::PlasticShare.deviation(0.0, 0.5), Some(-0.5));
        assert_eq!(Output::Force.deviation(0.0, 0.0), None);
    }

    #[test]
    fn mistyped_names_get_the_nearest_and_far_ones_the_list() {
        let near = |name: &str| name.parse::<Output>().unwrap_err().near;
        assert_eq!(near("froce"), Some(Output::Force));
        assert_eq!(near("elastic_plastic"), None);
        let message = "temperature".parse::<Output>().unwrap_err().to_string();
        assert!(!message.contains("did you mean") && message.contains("ln-area"), "{message}");
    }
}
