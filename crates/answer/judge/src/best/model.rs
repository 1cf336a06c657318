//! The model `best`: what it is made from.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::evidence::{Compared, SurfaceShape};
use asperity_core::{
    Citation, Code, ContactError, ContactModel, Described, Finding, Provenance, Validity,
};

/// What is known best about a scene: what boundary elements gave at the load, where that was
/// solved; else what they are expected to give: between solved surfaces with an interval, beyond
/// them by the nearest, without one; else, as with adhesion, what the first valid model gives.
///
/// It has what boundary elements are compared in, and what follows from that: areas, mean pressure,
/// tangent and unloading stiffness, tangential stiffness, conductances and mean gaps; and the
/// number of contacts of the usual model.
///
/// ```
/// use asperity::{At, ContactModel, Interface, Model, ProfileMoments, Quantity, Request, Scene, Surface};
///
/// let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4: 3e8 })?;
/// let scene = Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4);
/// let best: Model = "best".parse()?;
/// let contact = best.compile(&scene, &Request::new([Quantity::Area]))?;
/// let area = contact.evaluate(Quantity::Area, At::Load(1e3))?.value();
/// let interval = contact.interval(Quantity::Area, At::Load(1e3)).ok_or("no interval")?;
/// assert!(interval.lower < area && area < interval.upper);
/// assert!(interval.of.starts_with("nine of ten surfaces of this spectrum, 1 cm2 with some "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(bound = "")]
pub struct Best<M> {
    /// Those that answer without evidence, preferred first; the usual ones, if there are none.
    #[serde(skip)]
    pub(super) models: Vec<M>,
    #[serde(skip)]
    pub(super) shape: Option<SurfaceShape>,
    #[serde(skip)]
    pub(super) unlike: Option<ContactError>,
    #[serde(skip)]
    pub(super) solved: Vec<SolvedContact>,
    #[serde(skip)]
    pub(super) within_ranges: bool,
}

/// What boundary elements gave on the scan of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedContact {
    /// Mean pressure \[Pa\].
    pub pressure: f64,
    /// Area over nominal area, stiffnesses \[N/m\], mean gap \[m\].
    pub values: BTreeMap<Compared, f64>,
    /// The finding that makes the solution uncertain, and why, if there is one: it does not answer
    /// then where solved surfaces give an interval.
    pub uncertain: Option<(Code, String)>,
}

/// A model that may answer.
pub trait Answering: ContactModel + Clone + FromStr<Err = ContactError> + 'static {}

impl<M: ContactModel + Clone + FromStr<Err = ContactError> + 'static> Answering for M {}

impl<M> Best<M> {
    /// The id of this model.
    pub const ID: &'static str = "best";

    /// With these models, preferred first, on a surface of this shape, or the reason why no solved
    /// surface is like it. Without a shape, it is taken as isotropic and must have Gaussian heights
    /// to have evidence.
    #[must_use]
    pub fn new(models: Vec<M>, shape: Result<Option<SurfaceShape>, ContactError>) -> Self {
        let (shape, unlike) = match shape {
            Ok(shape) => (shape, None),
            Err(reason) => (None, Some(reason)),
        };
        Self { models, shape, unlike, solved: vec![], within_ranges: false }
    }

    /// The same with what was solved on the scan of the scene.
    #[must_use]
    pub fn with_solved(self, solved: Vec<SolvedContact>) -> Self {
        Self { solved, ..self }
    }

    /// The same at a point of ranges, if it is one: an interval that is not known is there presumed
    /// as that at the nearest solved surface, so that ends do not jump between
    /// points.
    #[must_use]
    pub fn within_ranges(self, within_ranges: bool) -> Self {
        Self { within_ranges, ..self }
    }
}

impl<M> Default for Best<M> {
    fn default() -> Self {
        Self::new(vec![], Ok(None))
    }
}

const CITATION: Citation = Citation {
    id: "best",
    name: "Best",
    authors: "The asperity developers",
    year: 2026,
    title: "asperity: rough surfaces in contact",
    provenance: Provenance::Derived,
    published: &[("howpublished", "program")],
};

impl<M: fmt::Debug + Send + Sync> Described for Best<M> {
    fn citation(&self) -> &Citation {
        &CITATION
    }

    fn validity(&self) -> Validity {
        Validity {
            asperities: false,
            hertz_limit: None,
            // Where adhesion matters a model of its range answers.
            adhesive: true,
            tabor: Some([0.0, f64::INFINITY]),
            valid_for: "what is known best: boundary elements on surfaces like this one or nearest to it, else a valid model",
            ..Validity::default()
        }
    }
}

/// A compared number of an answer: area over nominal area, stiffness \[N/m\], mean gap \[m\].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Known {
    /// The number.
    pub value: f64,
    /// The ends of an interval that holds nine of ten surfaces, with evidence.
    pub ends: Option<[f64; 2]>,
    /// The ends without: beyond solved surfaces as at the nearest of them.
    pub(super) presumed: Option<[f64; 2]>,
    /// Where it is from.
    pub source: Source,
    /// A bound on its relative numerical error.
    pub(super) error: f64,
}

impl Known {
    pub(super) fn without_ends(value: f64, source: Source, error: f64) -> Self {
        Self { value, ends: None, presumed: None, source, error }
    }
}

/// Where a number is from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// Boundary elements on this scan at this load.
    Solved,
    /// Boundary elements on solved surfaces like this one.
    Evidence,
    /// The model of this id, and why it is not valid here, if it is not.
    Model(String, Option<Box<Finding>>),
}
