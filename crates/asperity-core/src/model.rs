//! A contact model: a name, a source and its laws.

use std::fmt;

use crate::{
    Asperity, Compiled, ContactError, Law, Quantity, Request, Response, Scene, Tolerance, Warning,
};

/// How well the source of an equation is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

/// What a model is called, and where it comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
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

/// Which stiffness a model's paper defines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StiffnessKind {
    /// -dF/dd: [`Quantity::Stiffness`] is [`Quantity::Tangent`].
    Tangent,
    /// An average of asperity stiffnesses, for which the model has a law.
    OwnLaw,
}

/// What a model says of its laws; the test-kit holds it to that.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Claims {
    /// The force never falls as the interference grows.
    pub force_monotone: bool,
    /// The ratio to Hertz' law for vanishing interference: 1, except where normals are spread
    /// over angles. `None` where there is none.
    pub hertz_limit: Option<f64>,
    /// Contact normals are spread over angles.
    pub angles: bool,
}

impl Default for Claims {
    fn default() -> Self {
        Self { force_monotone: true, hertz_limit: Some(1.0), angles: false }
    }
}

/// A statistical contact model: how one asperity answers, and where that is from.
///
/// To add a model, write `source` and `law` (for force and area); tangents, shares and bounds come
/// from the engine. See the example `own_model` of the crate `asperity`.
pub trait ContactModel: fmt::Debug + Send + Sync {
    /// Its names, and where the model comes from.
    fn source(&self) -> &Source;

    /// Short name in lower case: `ke`.
    fn id(&self) -> &str {
        self.source().id
    }

    /// The acronym: `KE`.
    fn name(&self) -> &str {
        self.source().name
    }

    /// The law of one asperity for force \[N\], area \[m²\] or, where
    /// [`stiffness`](Self::stiffness) is [`StiffnessKind::OwnLaw`], stiffness \[N/m\].
    ///
    /// `tolerance` matters only where the law itself is approximated.
    ///
    /// # Errors
    /// [`ContactError`] when the asperity is outside the model's range or lacks an input, and
    /// [`ContactError::NoLaw`] for any other quantity.
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError>;

    /// Which stiffness the model's paper defines.
    fn stiffness(&self) -> StiffnessKind {
        StiffnessKind::Tangent
    }

    /// What the model says of its laws.
    fn claims(&self) -> Claims {
        Claims::default()
    }

    /// What a user of these options should know.
    fn warnings(&self) -> Vec<Warning> {
        vec![]
    }

    /// Prepares a scene for many evaluations: laws for the asked quantities, nothing else.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing.
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Compiled, ContactError> {
        Compiled::new(self, scene, request)
    }

    /// Answers a request.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing, or the integral that
    /// did not converge.
    fn solve(&self, scene: &Scene, request: &Request) -> Result<Response, ContactError> {
        self.compile(scene, request)?.respond(request)
    }

    /// The error of a law this model does not have.
    fn no_law(&self, quantity: Quantity) -> ContactError {
        ContactError::NoLaw { model: self.name().into(), quantity }
    }
}
