//! The formats of contact tables, and how each is read between the nodes.

/// How a finite-element code reads the space between two nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines: the pressure is continuous, its slope is not.
    Linear,
    /// Cubics through pressures and stiffnesses (Hermite): both are continuous, as Newton's method
    /// needs.
    Hermite,
}

/// The format of a contact table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum TableFormat {
    /// Clearance, pressure and tangent with their units in the head, for cubics.
    Csv,
    /// `*SURFACE BEHAVIOR` of Abaqus: pairs of pressure and overclosure, for straight lines.
    Abaqus,
    /// The same for CalculiX, with overclosures from the onset of pressure.
    Calculix,
    /// Real constants of the nonlinear spring COMBIN39 of ANSYS, which stands for the nominal area.
    Ansys,
}

impl TableFormat {
    /// The name of the format, in lower case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Abaqus => "abaqus",
            Self::Calculix => "calculix",
            Self::Ansys => "ansys",
        }
    }

    /// How the format is read between the nodes.
    #[must_use]
    pub fn interpolation(self) -> Interpolation {
        match self {
            Self::Csv => Interpolation::Hermite,
            _ => Interpolation::Linear,
        }
    }
}
