//! What a model states of itself: names, source, validity.

use std::fmt;

use serde::Serialize;

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
        self.serialize(f)
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
    /// Fields of its BibTeX entry beside these, such as `journal` and `doi`: verified ones only.
    /// An `author` here has initials.
    pub published: &'static [(&'static str, &'static str)],
}

impl Citation {
    /// The entry of a BibTeX file, keyed by the first author and the year; an `@article` where the
    /// journal is known, otherwise `@misc`.
    ///
    /// ```
    /// use asperity_core::{Citation, Provenance};
    ///
    /// let hertz = Citation {
    ///     id: "hertz",
    ///     name: "Hertz",
    ///     authors: "Hertz",
    ///     year: 1882,
    ///     title: "Über die Berührung fester elastischer Körper",
    ///     provenance: Provenance::Seen,
    ///     published: &[("author", "Hertz, H.")],
    /// };
    /// assert!(hertz.bibtex().starts_with("@misc{hertz1882,\n  author = {Hertz, H.},\n"));
    /// ```
    #[must_use]
    pub fn bibtex(&self) -> String {
        let known = |name| self.published.iter().find(|field| field.0 == name).map(|field| field.1);
        let author = known("author").map_or_else(
            || self.authors.replace(" & ", " and ").replace(", ", " and "),
            String::from,
        );
        let first = author.split([',', ' ']).next().unwrap_or_default().to_lowercase();
        let kind = if known("journal").is_some() { "article" } else { "misc" };
        let mut text = format!("@{kind}{{{first}{},\n", self.year);
        let mut field = |name: &str, value: &str| {
            text += &format!("  {name} = {{{}}},\n", value.replace('&', "\\&"));
        };
        field("author", &author);
        // The inner braces keep capitals.
        if !self.title.is_empty() {
            field("title", &format!("{{{}}}", self.title));
        }
        field("year", &self.year.to_string());
        let others = self.published.iter().filter(|(name, _)| *name != "author");
        others.for_each(|(name, value)| field(name, value));
        text + "}\n"
    }
}

/// Properties and range of a model's laws; the test-kit verifies the properties.
///
/// ```
/// use asperity_core::Validity;
///
/// let fitted = Validity { holds_to: Some(110.0), ..Validity::default() };
/// assert_eq!(fitted.hertz_limit, Some(1.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Validity {
    /// The force never falls as the interference grows.
    pub force_monotone: bool,
    /// The ratio of the force to Hertz' law for vanishing interference: 1 for upright asperities.
    /// `None` if there is no such limit.
    pub hertz_limit: Option<f64>,
    /// The model treats asperities as independent; false for theories of the whole surface, which
    /// hold for areas of any size.
    pub asperities: bool,
    /// Laws depend on [`Asperity::density`](crate::Asperity::density); the others are shared by
    /// surfaces of different densities.
    pub density: bool,
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
            density: false,
            angles: false,
            adhesive: false,
            tabor: None,
            valid_for: "",
            holds_to: None,
            known_defect: None,
        }
    }
}

/// What every model states of itself: names, source and range.
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

    /// How a variant differs from the model whose id stands before the dash, one clause a
    /// difference; empty for a model that is no variant.
    fn variant(&self) -> Vec<&'static str> {
        vec![]
    }

    /// Properties and range of the laws.
    fn validity(&self) -> Validity {
        Validity::default()
    }
}

/// What states of itself what another does: a model in a wrapper, the laws of a [`Variant`].
///
/// [`Variant`]: crate::Variant
pub trait Wraps: fmt::Debug + Send + Sync {
    /// The other.
    fn inner(&self) -> &dyn Described;

    /// An id of its own.
    fn other_id(&self) -> Option<&str> {
        None
    }
}

impl<W: Wraps> Described for W {
    fn citation(&self) -> &Citation {
        self.inner().citation()
    }

    fn id(&self) -> &str {
        self.other_id().unwrap_or(self.inner().id())
    }

    fn name(&self) -> &str {
        self.inner().name()
    }

    fn variant(&self) -> Vec<&'static str> {
        self.inner().variant()
    }

    fn validity(&self) -> Validity {
        self.inner().validity()
    }
}
