//! One asperity pressed by a flat: the inputs of a single-asperity law.

use crate::error::{positive, require};
use crate::{ContactError, Interface};

/// One asperity, with every input resolved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asperity {
    /// E \[Pa\].
    pub equivalent_modulus: f64,
    /// G \[Pa\], if given.
    pub equivalent_shear_modulus: Option<f64>,
    /// ν of the softer body.
    pub poissons_ratio: f64,
    /// H of the softer body \[Pa\]; `None` if it never yields.
    pub hardness: Option<f64>,
    /// S_y of the softer body \[Pa\]; `None` if it never yields.
    pub yield_strength: Option<f64>,
    /// E_t of two like bodies \[Pa\], if given.
    pub tangent_modulus: Option<f64>,
    /// S, the maximum contact pressure factor.
    pub pressure_factor: f64,
    /// w_a \[J/m²\], if given.
    pub work_of_adhesion: Option<f64>,
    /// R \[m\].
    pub radius: f64,
    /// η of its surface \[1/m²\]; `None` for an asperity by itself, and for the laws of models that
    /// do not declare to depend on it ([`Validity::density`](crate::Validity::density)).
    pub density: Option<f64>,
}

impl Asperity {
    /// An asperity of this radius \[m\].
    ///
    /// # Errors
    /// [`ContactError`] naming the field of the interface, or the radius, that is out of range.
    pub fn new(interface: &Interface, radius: f64) -> Result<Self, ContactError> {
        let (hardness, yield_strength, pressure_factor) = interface.check()?;
        Ok(Self {
            equivalent_modulus: interface.equivalent_modulus,
            equivalent_shear_modulus: interface.equivalent_shear_modulus,
            poissons_ratio: interface.poissons_ratio,
            hardness,
            yield_strength,
            tangent_modulus: interface.tangent_modulus,
            pressure_factor,
            work_of_adhesion: interface.work_of_adhesion,
            radius: positive("asperity_radius", radius)?,
            density: None,
        })
    }

    /// The asperity as laws see it that depend on the density, or not.
    pub(crate) fn seen_by(self, density: bool) -> Self {
        Self { density: self.density.filter(|_| density), ..self }
    }

    /// w_c = (π S H/(2E))² R \[m\], the interference at which yielding begins. \[seen\]
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] unless w_c < R: beyond, the asperity would be flattened
    /// before it yields, and laws scaled by w_c are meaningless. That of
    /// [`hardness`](Self::hardness()).
    pub fn critical_interference(&self) -> Result<f64, ContactError> {
        let value = self.hardness()?;
        let strain =
            std::f64::consts::PI * self.pressure_factor * value / (2.0 * self.equivalent_modulus);
        let required =
            "a hardness below 2E/(pi S), of the order of the modulus (check the units of both),";
        require(strain < 1.0, "hardness", value, required)?;
        Ok(strain * strain * self.radius)
    }

    /// F_c = (2/3) π R w_c S H = (4/3) E √R w_c^(3/2) \[N\], the force at w_c. \[seen\]
    ///
    /// # Errors
    /// The errors of [`critical_interference`](Self::critical_interference).
    pub fn critical_force(&self) -> Result<f64, ContactError> {
        let area = std::f64::consts::PI * self.radius * self.critical_interference()?;
        Ok(2.0 / 3.0 * area * self.pressure_factor * self.hardness()?)
    }

    /// H \[Pa\].
    ///
    /// # Errors
    /// [`ContactError::Missing`] if the scene gives neither hardness nor yield strength.
    pub fn hardness(&self) -> Result<f64, ContactError> {
        self.hardness.ok_or_else(never_yields)
    }

    /// S_y \[Pa\].
    ///
    /// # Errors
    /// [`ContactError::Missing`] if the scene gives neither hardness nor yield strength.
    pub fn yield_strength(&self) -> Result<f64, ContactError> {
        self.yield_strength.ok_or_else(never_yields)
    }

    /// G \[Pa\].
    ///
    /// # Errors
    /// [`ContactError::Missing`] naming the model that needs it.
    pub fn shear_modulus(&self, needed_by: &str) -> Result<f64, ContactError> {
        self.equivalent_shear_modulus.ok_or_else(|| ContactError::Missing {
            field: "equivalent_shear_modulus",
            reason: format!("{needed_by} needs it"),
        })
    }

    /// w_a \[J/m²\], at least 0.
    ///
    /// # Errors
    /// [`ContactError::Missing`] naming the model that needs it.
    pub fn adhesion(&self, needed_by: &str) -> Result<f64, ContactError> {
        self.work_of_adhesion.ok_or_else(|| ContactError::Missing {
            field: "work_of_adhesion",
            reason: format!("{needed_by} needs it"),
        })
    }

    /// μ = (R w_a²/(E² z₀³))^(1/3), z₀ = 0.3 nm: Tabor's parameter, the elastic deformation by
    /// adhesion over the range of the surface forces. DMT holds below about 0.1, JKR above about 5.
    /// `None` without a work of adhesion. \[recalled\]
    #[must_use]
    pub fn tabor_parameter(&self) -> Option<f64> {
        const RANGE: f64 = 3e-10;
        let ratio = self.work_of_adhesion? / (self.equivalent_modulus * RANGE);
        Some((self.radius / RANGE * ratio * ratio).cbrt())
    }
}

fn never_yields() -> ContactError {
    let reason = "set hardness or yield_strength; only elastic models work without".into();
    ContactError::Missing { field: "hardness", reason }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn critical_force_is_hertz_at_the_critical_interference() {
        let asperity = Asperity::new(&Interface::new(116e9, 0.31, 1.12e9), 3.59e-4).unwrap();
        let w = asperity.critical_interference().unwrap();
        let hertz = 4.0 / 3.0 * asperity.equivalent_modulus * asperity.radius.sqrt() * w.powf(1.5);
        assert!((asperity.critical_force().unwrap() / hertz - 1.0).abs() < 1e-14);
    }
}
