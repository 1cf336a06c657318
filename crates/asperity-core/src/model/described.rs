//! What a model states of itself: names, source, validity.

use std::fmt;

use serde::Serialize;

use crate::Diagnostic;

/// How well the source of an equation is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Provenance {
    /// Read in public text or code that quotes the paper.
    Seen,
    /// Proved or checked numerically from first principles.
    Derived,
    /// From general knowledge of the literature; the primary text was not available.
    Recalled,
}

impl fmt::Display for Provenance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Seen => "seen",
            Self::Derived => "derived",
            Self::Recalled => "recalled",
        })
    }
}

/// Names and source of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Citation {
    /// Short name in lower case, as in tables and scene files: `ke`.
    pub id: &'static str,
    /// The acronym, as in text: `KE`.
    pub name: &'static str,
    /// Authors, as cited.
    pub authors: &'static str,
    /// Year of publication.
    pub year: u16,
    /// Title, if it is known for certain.
    pub title: &'static str,
    /// How well the equations' text is known.
    pub provenance: Provenance,
}

/// Properties and range of a model's laws; the test-kit verifies the properties.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Validity {
    /// The force never falls as the interference grows.
    pub force_monotone: bool,
    /// The ratio of the force to Hertz' law for vanishing interference: 1 for upright asperities.
    /// `None` if there is no such limit.
    pub hertz_limit: Option<f64>,
    /// The model treats asperities as independent; false for theories of the whole surface, which
    /// hold for areas of any size.
    pub asperities: bool,
    /// Contacts are inclined: normals are distributed over angles.
    pub angles: bool,
    /// The surfaces adhere: forces may be negative, and jump at the onset of contact.
    pub adhesive: bool,
    /// The range of Tabor's parameter for which adhesive laws are derived.
    pub tabor: Option<[f64; 2]>,
    /// Range of validity, in a few words; empty if not stated.
    pub valid_for: &'static str,
    /// The interference over w_c up to which the laws are derived or fitted; `None` if not stated,
    /// 1 for a model without yielding.
    pub holds_to: Option<f64>,
    /// Range in which the force is known to be inaccurate, if any.
    pub known_defect: Option<KnownDefect>,
}

/// A range in which a law deviates from the data to which it was fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownDefect {
    /// Lower end of the range, as interference over w_c.
    pub from: f64,
    /// Upper end of the range, as interference over w_c.
    pub to: f64,
    /// The deviation, and which model to use instead.
    pub summary: &'static str,
}

impl Default for Validity {
    fn default() -> Self {
        Self {
            force_monotone: true,
            hertz_limit: Some(1.0),
            asperities: true,
            angles: false,
            adhesive: false,
            tabor: None,
            valid_for: "",
            holds_to: None,
            known_defect: None,
        }
    }
}

impl Validity {
    /// The force may fall as the interference grows.
    #[must_use]
    pub fn not_monotone(self) -> Self {
        Self { force_monotone: false, ..self }
    }

    /// Without a known limit for vanishing interference.
    #[must_use]
    pub fn without_hertz_limit(self) -> Self {
        Self { hertz_limit: None, ..self }
    }

    /// For a theory of the whole surface, without a law of an asperity.
    #[must_use]
    pub fn without_asperities() -> Self {
        Self { asperities: false, ..Self::default().without_hertz_limit() }
    }

    /// For inclined contacts: no Hertz limit, and the force may fall.
    #[must_use]
    pub fn over_angles() -> Self {
        Self { angles: true, ..Self::default().not_monotone().without_hertz_limit() }
    }

    /// For adhesion: no Hertz limit, and the force may be negative and fall.
    #[must_use]
    pub fn with_adhesion() -> Self {
        Self { adhesive: true, ..Self::default().not_monotone().without_hertz_limit() }
    }

    /// The adhesive laws hold where Tabor's parameter is from `least` to `most`.
    #[must_use]
    pub fn for_tabor(self, least: f64, most: f64) -> Self {
        Self { tabor: Some([least, most]), ..self }
    }

    /// The laws are derived or fitted up to this multiple of w_c.
    #[must_use]
    pub fn holds_to(self, interference: f64) -> Self {
        Self { holds_to: Some(interference), ..self }
    }

    /// With a range in which the force is known to be inaccurate.
    #[must_use]
    pub fn known_defect(self, defect: KnownDefect) -> Self {
        Self { known_defect: Some(defect), ..self }
    }

    /// With this range of validity, in a few words.
    #[must_use]
    pub fn valid_for(self, valid_for: &'static str) -> Self {
        Self { valid_for, ..self }
    }
}

/// What every model states of itself: names, source, range and remarks.
pub trait Described: fmt::Debug + Send + Sync {
    /// Names and source of the model.
    fn citation(&self) -> &Citation;

    /// Short name in lower case: `ke`.
    fn id(&self) -> &str {
        self.citation().id
    }

    /// The acronym: `KE`.
    fn name(&self) -> &str {
        self.citation().name
    }

    /// Properties and range of the laws.
    fn validity(&self) -> Validity {
        Validity::default()
    }

    /// Remarks on the chosen options.
    fn notes(&self) -> Vec<Diagnostic> {
        vec![]
    }
}
