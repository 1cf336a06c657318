//! Contact tables for finite-element programs: pressure against clearance, with conductance beside
//! it.

mod conductance;
mod cubic;
mod error_bound;
mod film;
mod kinks;
mod origin;
mod table;
mod text;
mod units;

use std::str::FromStr;

use asperity::{At, Code, Findings, Separation, SeparationUnit, Severity};

use crate::subject::Subject;
use crate::{AnswerError, Sheet, Watch};
pub(crate) use table::{ContactNode, ContactTable};
pub use units::UnitSystem;

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
    /// Pressure, area fraction and flow factors against the film, for a Reynolds code.
    Film,
}

impl TableFormat {
    /// All formats.
    pub const ALL: [Self; 4] = [Self::Csv, Self::Abaqus, Self::Calculix, Self::Film];

    /// The name of the format, in lower case.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Abaqus => "abaqus",
            Self::Calculix => "calculix",
            Self::Film => "film",
        }
    }

    /// Refuses conductance in a format that has none, before any table is made.
    ///
    /// # Errors
    /// Conductance in formats other than Abaqus and CalculiX.
    pub fn check(self, conductance: bool) -> Result<(), String> {
        match self {
            Self::Csv | Self::Film if conductance => {
                Err(format!("{} has no conductance; use abaqus or calculix", self.name()))
            }
            _ => Ok(()),
        }
    }

    /// Whether nodes are joined by cubics through pressures and stiffnesses (Hermite), both
    /// continuous as Newton's method needs, and not by straight lines.
    pub(crate) fn is_cubic(self) -> bool {
        self == Self::Csv
    }
}

impl FromStr for TableFormat {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|format| format.name() == name);
        found.ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("one of {names} was required")
        })
    }
}

/// Where the nodes of a table are.
#[derive(Debug, Clone, Copy)]
pub enum Nodes<'a> {
    /// From one end to the other, of the same kind.
    Range {
        /// The ends.
        ends: [At; 2],
        /// Number of nodes at equal distances of separation, at least 2.
        count: usize,
        /// Whether they are at equal ratios of load instead, where the ends are loads above 0.
        log: bool,
        /// Nodes are added until no interpolated pressure is off by more than this relative error.
        max_error: Option<f64>,
    },
    /// At these loads: all that boundary elements have.
    Loads(&'a [At]),
}

/// What a table is to have.
#[derive(Debug, Clone, Copy)]
pub struct Export<'a> {
    /// The model on its scene.
    pub subject: Subject<'a>,
    /// Its nodes.
    pub nodes: Nodes<'a>,
    /// The format of the table.
    pub format: TableFormat,
    /// Its units.
    pub units: UnitSystem,
    /// Whether the thermal conductance is added.
    pub conductance: bool,
}

/// A table as a file.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Exported {
    /// The table in its format and units.
    pub text: String,
    /// Bounds of the relative errors of pressure and tangent between the nodes; none of a table of
    /// films and of boundary elements.
    pub errors: Option<[f64; 2]>,
}

impl Export<'_> {
    /// The table, made with the tolerance of the subject; fills a sheet with clearance, pressure
    /// and tangent at the nodes, in SI units.
    ///
    /// # Errors
    /// The errors of the model on the scene, equal ends, pressures that do not fall, an
    /// error that no table meets, and what the format has no room for.
    pub fn answer(&self, sheet: &mut Sheet, watch: &dyn Watch) -> Result<Exported, AnswerError> {
        sheet.under(&[&["clearance_m", "pressure_Pa", "tangent_Pa_per_m"]]);
        self.format.check(self.conductance)?;
        self.subject.file.need_flat()?;
        watch.progress("nodes");
        let of_model = |error: AnswerError| error.of_model(self.subject.id());
        if self.format == TableFormat::Film {
            return Ok(Exported { text: self.film_text(sheet).map_err(of_model)?, errors: None });
        }
        let table = ContactTable::new(self).map_err(of_model)?;
        if table.errors.is_none() && self.conductance {
            return Err("boundary elements at some loads give no lines of conductance; take conductance there from a curve, or export a model".into());
        }
        let notes: Findings = table.notes.iter().cloned().collect();
        sheet.extend(self.subject.file.accepted(notes).at_least(Severity::Warning));
        let mut text = table.text(self)?;
        if self.conductance {
            text += &table.conductance_text(self).map_err(of_model)?;
        }
        for node in &table.nodes {
            let clearance = Separation::sigmas(node.separation);
            let clearance = self.subject.place(clearance, SeparationUnit::Metres)?;
            sheet.rows.push([clearance, node.pressure, node.stiffness].map(Into::into).to_vec());
        }
        if let Some([pressure_error, _]) = table.errors
            && pressure_error > 0.1
        {
            let percent = (100.0 * pressure_error).round();
            let text = format!(
                "the interpolation error of the pressure is up to {percent} %; use more nodes, a maximum error or a narrower range"
            );
            sheet.warn(Code::InterpolationError, text);
        }
        Ok(Exported { text, errors: table.errors })
    }
}
