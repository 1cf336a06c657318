//! A separation with its unit and reference plane, or a load.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::text::short;

/// The unit of a separation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SeparationUnit {
    /// Multiples of the scene's `asperity_height_std` σ_z.
    #[default]
    Sigma,
    /// Metres.
    #[serde(rename = "m")]
    Metres,
    /// Multiples of [`Scene::surface_height_std`](crate::Scene::surface_height_std): the film
    /// ratio λ, from the mean plane of the surface.
    SurfaceStd,
}

/// The plane that a separation is measured from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Datum {
    /// The mean of the asperity heights (the lowest asperity, for exponential heights).
    #[default]
    AsperityMean,
    /// The mean plane of the rough surface,
    /// [`Scene::mean_plane_offset`](crate::Scene::mean_plane_offset) below.
    SurfaceMean,
}

/// A separation, with its unit and the plane it is measured from.
///
/// ```
/// use asperity_core::{Datum, Interface, Scene, Separation, SeparationUnit, Surface};
///
/// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
/// let gap = Separation::metres(2e-6).from_surface_mean();
/// // The mean of the asperity heights lies 0.0459/(η R) = 1.16 µm above the mean plane here.
/// let s = gap.measured_in(SeparationUnit::Sigma, Datum::AsperityMean, &scene)?;
/// assert!((s.value - 0.8398).abs() < 1e-4);
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Separation {
    /// The number.
    pub value: f64,
    /// Its unit.
    #[serde(default)]
    pub unit: SeparationUnit,
    /// Its reference plane.
    #[serde(default)]
    pub from: Datum,
}

impl Separation {
    /// d/σ_z from the mean of the asperity heights.
    #[must_use]
    pub fn sigmas(value: f64) -> Self {
        Self { value, unit: SeparationUnit::Sigma, from: Datum::AsperityMean }
    }

    /// d \[m\] from the mean of the asperity heights.
    #[must_use]
    pub fn metres(value: f64) -> Self {
        Self { value, unit: SeparationUnit::Metres, from: Datum::AsperityMean }
    }

    /// The film ratio λ = h/σ of a film h between the mean planes of the surfaces, with the
    /// standard deviation σ of the surface heights.
    #[must_use]
    pub fn film_ratio(value: f64) -> Self {
        Self { value, unit: SeparationUnit::SurfaceStd, from: Datum::SurfaceMean }
    }

    /// The same number, measured from the mean plane of the surface.
    #[must_use]
    pub fn from_surface_mean(self) -> Self {
        Self { from: Datum::SurfaceMean, ..self }
    }
}

impl fmt::Display for Separation {
    /// `2 asperity_height_std`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.unit {
            // Large numbers are shorter with an exponent.
            SeparationUnit::Sigma if self.value.abs() >= 1e16 => {
                write!(f, "{:e} asperity_height_std", self.value)?;
            }
            SeparationUnit::Sigma => {
                write!(f, "{} asperity_height_std", self.value)?;
            }
            SeparationUnit::Metres if self.value == 0.0 => f.write_str("0 m")?,
            SeparationUnit::Metres => write!(f, "{:e} m", self.value)?,
            SeparationUnit::SurfaceStd => write!(f, "{} surface_height_std", self.value)?,
        }
        match self.from {
            Datum::AsperityMean => Ok(()),
            Datum::SurfaceMean => f.write_str(" from the mean plane of the surface"),
        }
    }
}

/// The separation, load or pressure of a row. A plain number is a separation in multiples of σ_z
/// from the mean of the asperity heights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum At {
    /// At a separation.
    Separation(Separation),
    /// Under a normal load \[N\], > 0 (below 0 for a tension, with adhesion). If several
    /// separations carry it, the largest is meant, the first on approach; of a tension
    /// the smallest, where the contact is stable.
    Load(f64),
    /// Under a mean pressure on the nominal area \[Pa\], > 0.
    Pressure(f64),
}

impl At {
    /// A separation of d/σ_z from the mean of the asperity heights.
    #[must_use]
    pub fn sigmas(value: f64) -> Self {
        Self::Separation(Separation::sigmas(value))
    }

    /// A separation of d \[m\] from the mean of the asperity heights.
    #[must_use]
    pub fn metres(value: f64) -> Self {
        Self::Separation(Separation::metres(value))
    }
}

impl From<f64> for At {
    fn from(sigmas: f64) -> Self {
        Self::sigmas(sigmas)
    }
}

impl From<Separation> for At {
    fn from(separation: Separation) -> Self {
        Self::Separation(separation)
    }
}

impl At {
    /// The place to four digits, for messages.
    #[must_use]
    pub fn rounded(self) -> Self {
        self.to_digits(4)
    }

    fn to_digits(self, digits: usize) -> Self {
        let few = |x: f64| format!("{x:.*e}", digits - 1).parse().unwrap_or(x);
        match self {
            Self::Separation(place) => {
                Self::Separation(Separation { value: few(place.value), ..place })
            }
            Self::Load(load) => Self::Load(few(load)),
            Self::Pressure(pressure) => Self::Pressure(few(pressure)),
        }
    }
}

impl fmt::Display for At {
    /// To six digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.to_digits(6) {
            Self::Separation(separation) => write!(f, "a separation of {separation}"),
            // Very small and large numbers are shorter with an exponent.
            Self::Load(load) if load.abs() < 1e-5 || load.abs() >= 1e16 => {
                write!(f, "a load of {load:e} N")
            }
            Self::Load(load) => write!(f, "a load of {load} N"),
            Self::Pressure(pressure) => write!(f, "a pressure of {} Pa", short(pressure)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_printed_in_few_digits() {
        let loads = [1200.0, 0.01, 1e-300, -1e20, 0.1 + 0.2, 20480.5];
        let printed = loads.map(|load| At::Load(load).to_string());
        let wanted = ["1200", "0.01", "1e-300", "-1e20", "0.3", "20480.5"]
            .map(|load| format!("a load of {load} N"));
        assert_eq!(printed, wanted);
    }
}
