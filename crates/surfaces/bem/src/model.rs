//! Boundary elements on a scan as a model: beside the others by the name `bem`.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use asperity_core::{
    At, Citation, Contact, ContactEngine, ContactError, ContactModel, Datum, Described, Evaluation,
    Finding, Findings, Interface, Provenance, Quantity, Request, Scene, Separation, SeparationUnit,
    Validity,
};

use crate::error::{self, refused};
use crate::summary::{ContactSummary, known};
use crate::{BemError, BemOptions, BoundaryElements, Continuation, HeightMap, LoadCase, Solution};

/// Loads with a smaller relative difference are equal within rounding.
const SAME: f64 = 1e-12;

/// A scan pressed against the bodies of a scene.
///
/// The scan stands for the scene's whole nominal area: pressures are alike, loads and areas are
/// scaled. Separations are mean gaps, from the mean plane of the scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Bem {
    map: HeightMap,
    continuation: Continuation,
    elastic: bool,
    /// Why the default continuation is used, where edges do not match.
    note: Option<Finding>,
}

impl Bem {
    /// The id of boundary elements in scene files and commands; they need a scan.
    pub const ID: &str = error::ID;

    /// Names and source of the method.
    pub const SOURCE: Citation = SOURCE;

    /// Range of validity, in a few words.
    pub const VALID_FOR: &str = "scans with small slopes; the hardness limits the pressure";

    /// A map with its options; a default [continuation](Continuation::of) other than repetition has
    /// a [note](Self::note).
    #[must_use]
    pub fn new(map: HeightMap, BemOptions { boundary, elastic }: BemOptions) -> Self {
        let continuation = boundary.unwrap_or_else(|| Continuation::of(&map));
        let note = boundary.is_none().then(|| continuation.note(&map)).flatten();
        Self { map: continuation.applied(map), continuation, elastic, note }
    }

    /// The map that is solved.
    #[must_use]
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// How the scan continues beyond its edges.
    #[must_use]
    pub fn continuation(&self) -> Continuation {
        self.continuation
    }

    /// A note where the edges of the scan do not match, in height or slope, and no continuation is
    /// declared.
    #[must_use]
    pub fn note(&self) -> Option<Finding> {
        self.note.clone()
    }

    /// The same on [another](HeightMap::another) surface like this periodic one.
    #[must_use]
    pub fn another(&self, seed: u64) -> Self {
        Self { map: self.map.another(seed), ..self.clone() }
    }

    /// The same on every second pixel: see [`HeightMap::half_grid`].
    ///
    /// # Errors
    /// The errors of [`HeightMap::half_grid`].
    pub fn half_grid(&self) -> Result<Self, BemError> {
        Ok(Self { map: self.map.half_grid()?, ..self.clone() })
    }

    /// The largest pressure of these bodies \[Pa\]; `None` if they are elastic.
    ///
    /// # Errors
    /// [`ContactError`] naming the field of the interface that is out of range or missing.
    pub fn hardness(&self, interface: &Interface) -> Result<Option<f64>, ContactError> {
        let (hardness, ..) = interface.check()?;
        Ok(hardness.filter(|_| !self.elastic))
    }

    /// The solver for these bodies.
    ///
    /// # Errors
    /// [`ContactError`] naming the field of the interface that is out of range or missing.
    pub fn elements(&self, interface: &Interface) -> Result<BoundaryElements, ContactError> {
        let hardness = self.hardness(interface)?;
        let elements = BoundaryElements::new(self.map.clone(), interface.equivalent_modulus);
        let elements = elements.map_err(refused)?.boundary(self.continuation.boundary());
        match hardness {
            Some(hardness) => elements.hardness(hardness).map_err(refused),
            None => Ok(elements),
        }
    }
}

const SOURCE: Citation = Citation {
    id: Bem::ID,
    name: "BEM",
    authors: "Polonsky & Keer",
    year: 1999,
    title: "A numerical method for solving rough contact problems based on the multi-level multi-summation and conjugate gradient techniques",
    provenance: Provenance::Recalled,
    published: &[
        ("author", "Polonsky, I. A. and Keer, L. M."),
        ("journal", "Wear"),
        ("volume", "231"),
        ("number", "2"),
        ("pages", "206--219"),
        ("doi", "10.1016/S0043-1648(99)00113-1"),
    ],
};

impl Described for Bem {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        let valid_for = Self::VALID_FOR;
        Validity { asperities: false, hertz_limit: None, valid_for, ..Validity::default() }
    }
}

impl ContactModel for Bem {
    /// Solves the places of the request, each from the one before; other places are solved when
    /// they are evaluated.
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        asperity_core::positive("nominal_area", scene.nominal_area)?;
        let mut contact = OnScene {
            elements: self.elements(&scene.interface)?,
            scene: scene.clone(),
            quantities: request.quantities.clone(),
            solved: Mutex::default(),
            notes: vec![],
        };
        // Before anything is solved.
        request.quantities.iter().try_for_each(|q| contact.check(*q))?;
        let given: Vec<LoadCase> =
            request.at.iter().filter_map(|at| contact.given(*at).ok()).collect();
        let all = contact.elements.solve_all(&given, |_| ControlFlow::Continue(()));
        let solutions = all.iter().filter_map(|solution| solution.as_ref().ok());
        let mut notes: Findings = solutions.flat_map(|solution| solution.notes.clone()).collect();
        let all = given.into_iter().zip(all);
        let all: Vec<Solved> =
            all.map(|(given, solution)| (given, contact.summary(solution))).collect();
        notes.extend(all.iter().filter_map(|(_, found)| found.as_ref().ok()?.finding()));
        contact.notes = self.note().into_iter().chain(notes).collect();
        contact.keep(all);
        Ok(Box::new(contact))
    }
}

type Solved = (LoadCase, Result<ContactSummary, BemError>);

struct OnScene {
    elements: BoundaryElements,
    scene: Scene,
    quantities: Vec<Quantity>,
    solved: Mutex<Vec<Solved>>,
    /// Of the scan, and of the places that were solved first.
    notes: Vec<Finding>,
}

impl fmt::Debug for OnScene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OnScene").field("scene", &self.scene).finish_non_exhaustive()
    }
}

impl OnScene {
    fn given(&self, at: At) -> Result<LoadCase, ContactError> {
        let metres = SeparationUnit::Metres;
        Ok(match at {
            At::Separation(separation) => {
                let gap = separation.measured_in(metres, Datum::SurfaceMean, &self.scene)?;
                LoadCase::MeanGap(gap.value)
            }
            At::Pressure(pressure) => LoadCase::MeanPressure(pressure),
            At::Load(load) => LoadCase::MeanPressure(load / self.scene.nominal_area),
            _ => return Err(self.unsupported(&format!("an answer at {at}"))),
        })
    }

    fn keep(&self, more: Vec<Solved>) {
        self.solved.lock().unwrap_or_else(PoisonError::into_inner).extend(more);
    }

    fn summary(&self, solution: Result<Solution, BemError>) -> Result<ContactSummary, BemError> {
        match solution {
            Ok(solution) => Ok(self.elements.summary(&solution, &self.quantities)),
            Err(BemError::NothingTouches { gap, .. }) => {
                Ok(self.elements.open_summary(gap, &self.quantities))
            }
            Err(error) => Err(error),
        }
    }

    /// Refuses a quantity that was not requested, that boundary elements lack, or that lacks an
    /// input.
    fn check(&self, quantity: Quantity) -> Result<(), ContactError> {
        self.check_asked(quantity, known)?;
        Evaluation::of_contact_radii(quantity, 0.0, &self.scene, 0.0).map(drop)
    }

    fn solve(&self, given: LoadCase) -> Result<ContactSummary, ContactError> {
        let known = {
            let solved = self.solved.lock().unwrap_or_else(PoisonError::into_inner);
            solved.iter().find(|(other, _)| same(given, *other)).map(|(_, found)| found.clone())
        };
        let found = known.unwrap_or_else(|| {
            let found = self.summary(self.elements.solve(given));
            self.keep(vec![(given, found.clone())]);
            found
        });
        found.map_err(refused)
    }
}

fn same(one: LoadCase, other: LoadCase) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= SAME * b.abs();
    match (one, other) {
        (LoadCase::MeanPressure(a), LoadCase::MeanPressure(b))
        | (LoadCase::MeanGap(a), LoadCase::MeanGap(b)) => near(a, b),
        _ => false,
    }
}

impl ContactEngine for OnScene {
    fn model(&self) -> &str {
        SOURCE.id
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn notes(&self, _: &[At]) -> Vec<Finding> {
        self.notes.to_vec()
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.check(quantity)?;
        let found = self.solve(self.given(at)?)?.evaluate(quantity, &self.scene)?;
        let value = found.filter(|found| found.scaled.is_finite());
        value.ok_or(ContactError::NoValue { quantity, at })
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        asperity_core::positive("load", load)?;
        let gap = self.solve(self.given(At::Load(load))?)?.mean_gap;
        Ok(vec![Separation::metres(gap).from_surface_mean()])
    }
}
