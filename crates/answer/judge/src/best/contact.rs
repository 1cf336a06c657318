//! What is known best on one scene.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::candidates::{Adhesion, ByModel, OnDemand, Place, SharedPlace};
use super::model::{Answering, Best, Known, SolvedContact, Source};
use crate::evidence::{Compared, Evidence, ExpectedContact};
use crate::recommended::usual_reference;
use asperity_core::{
    At, Code, Contact, ContactEngine, ContactError, ContactModel, Datum, Evaluation, Finding,
    Interval, Quantity, Request, Scene, Separation, SeparationUnit, Tolerance, short,
};

/// Bound on the relative rounding of an expected value: the covariance of the solved cases has a
/// condition number of some 1e7.
pub(super) const ROUNDED: f64 = 1e-9;
/// ln p and mean gap \[m\], by ascending pressure.
pub(super) type Gaps = OnceLock<Vec<[f64; 2]>>;
/// Places kept.
const MOST_KEPT: usize = 4096;
/// Relative difference of equal pressures.
const SAME: f64 = 1e-12;

/// What is known best on one scene.
#[derive(Debug)]
pub struct BestContact<M> {
    pub(super) best: Best<M>,
    pub(super) scene: Scene,
    /// Whether the hardness of the scene was left out, as it is never reached.
    pub(super) never_yields: bool,
    pub(super) request: Request,
    /// What was asked for, and that by which answers are judged.
    quantities: Vec<Quantity>,
    /// The asperities in contact at a load, by the usual reference. Counts of models differ, by
    /// orders of magnitude with rough asperities on asperities, and the scatter of a surface does
    /// not depend on the model.
    counted: Option<ByModel>,
    adhesion: Option<Adhesion>,
    pub(super) candidates: OnceLock<Vec<OnDemand<M>>>,
    pub(super) gaps: Gaps,
    places: Mutex<BTreeMap<(bool, u64), SharedPlace>>,
}

impl<M: Answering> BestContact<M> {
    pub(super) fn new(
        best: Best<M>,
        scene: &Scene,
        request: &Request,
    ) -> Result<Self, ContactError> {
        let (places, candidates, gaps) = Default::default();
        let (mut scene, request) = (scene.clone(), request.clone());
        // Asperities so hard do not yield at any interference.
        let never_yields =
            scene.asperity()?.hardness.is_some() && scene.plasticity_index().is_err();
        if never_yields {
            (scene.interface.hardness, scene.interface.yield_strength) = (None, None);
        }
        let counted = ByModel::new::<M>(usual_reference(&scene), Quantity::Contacts, &scene);
        let adhesion = Adhesion::on::<M>(&scene);
        let judged = Quantity::JUDGED.into_iter();
        let judged = judged.filter(|one| !request.quantities.contains(one));
        let quantities = request.quantities.iter().copied().chain(judged).collect();
        let made = Self {
            best,
            scene,
            never_yields,
            request,
            quantities,
            counted,
            adhesion,
            candidates,
            gaps,
            places,
        };
        // A quantity that it lacks, or whose property the scene lacks.
        for quantity in &made.request.quantities {
            match Compared::behind(*quantity) {
                Some(_) => made.of(*quantity, 1.0, 1.0, 0.0).map(drop)?,
                None if *quantity == Quantity::Contacts || quantity.follows_from_totals() => {}
                None => return Err(made.lacks(*quantity)),
            }
        }
        Ok(made)
    }

    /// The property that answers by solved surfaces leave out.
    pub(super) const ADHESION: &'static str = "adhesion";

    fn lacks(&self, quantity: Quantity) -> ContactError {
        self.unsupported(&match quantity {
            Quantity::Stiffness => "stiffness, which is what the paper of each model defines; use tangent (first loading) or unloading-stiffness (small vibrations)".into(),
            other if other.is_of_bodies() => format!("{other}, which bodies have that [curvature] describes"),
            other if other.is_of_map() || other == Quantity::Leak => {
                format!("{other}, which only boundary elements on a scan give")
            }
            other => format!("{other}, which is no quantity of solved surfaces: choose one model"),
        })
    }

    pub(super) fn refused(&self, reason: String) -> ContactError {
        ContactError::Refused { model: Best::<M>::ID.into(), reason }
    }

    /// Contacts at a mean pressure \[Pa\]; `None` if unknown.
    fn contacts(&self, pressure: f64) -> Option<f64> {
        self.counted.as_ref()?.at(pressure)
    }

    /// What is known of a place, kept for the next quantity.
    pub(super) fn place(&self, at: At) -> SharedPlace {
        let given = at.pressure(&self.scene);
        let key = match at {
            At::Separation(s) => {
                let gap = s.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, &self.scene);
                (true, gap.map_or(f64::NAN, |gap| gap.value).to_bits())
            }
            _ => (false, given.unwrap_or(f64::NAN).to_bits()),
        };
        let kept = || self.places.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().get(&key) {
            return known.clone();
        }
        let pressure = match at {
            At::Separation(separation) => self.pressure_at(separation),
            _ => given,
        };
        let reason = || "no solved surface has this mean gap".into();
        let none = || ContactError::NoEvidence { property: "separation", reason: reason() };
        let expected = pressure.ok_or_else(none).and_then(|pressure| self.expected(pressure));
        let place = Arc::new(Place { pressure, expected, judged: Default::default() });
        let mut all = kept();
        if all.len() >= MOST_KEPT {
            all.clear();
        }
        all.insert(key, place.clone());
        place
    }

    fn expected(&self, pressure: f64) -> Result<ExpectedContact, ContactError> {
        let mut found = self.expected_of(&Compared::ALL, pressure, self.contacts(pressure))?;
        let effect = self.adhesion.as_ref().and_then(|adhesion| adhesion.effect_on_area(pressure));
        if let Some(reason) = effect {
            found.values.iter_mut().for_each(|(_, one)| (one.ends, one.presumed) = (None, None));
            found.outside = Some((Self::ADHESION, reason));
        }
        Ok(found)
    }

    /// What is expected of some quantities. Intervals depend on the number of `contacts`, values
    /// do not.
    pub(super) fn expected_of(
        &self,
        quantities: &[Compared],
        pressure: f64,
        contacts: Option<f64>,
    ) -> Result<ExpectedContact, ContactError> {
        if let Some(unlike) = &self.best.unlike {
            return Err(unlike.clone());
        }
        let (evidence, shape) = (Evidence::committed()?, self.best.shape);
        evidence.expected_of(quantities, &self.scene, shape, pressure, contacts)
    }

    /// What boundary elements gave at this pressure, if it was solved.
    fn solved(&self, pressure: f64) -> Option<&SolvedContact> {
        let same = |one: &&SolvedContact| (one.pressure / pressure - 1.0).abs() < SAME;
        self.best.solved.iter().find(same)
    }

    /// Why what was solved at this place is uncertain, if it is.
    pub(super) fn uncertain(&self, at: At) -> Option<&(Code, String)> {
        self.solved(self.place(at).pressure?)?.uncertain.as_ref()
    }

    /// Whether the answer at this place is a solution on the scan.
    #[must_use]
    pub fn is_solved(&self, at: At) -> bool {
        let known = self.known(Compared::Area, at);
        known.is_ok_and(|known| known.source == Source::Solved)
    }

    /// A compared number from the best source: boundary elements on this scan, on solved surfaces,
    /// or a model.
    ///
    /// # Errors
    /// The errors of the models, if none has a value.
    pub fn known(&self, of: Compared, at: At) -> Result<Known, ContactError> {
        let place = self.place(at);
        if let Some(pressure) = place.pressure {
            let solved = self.solved(pressure);
            let solved = solved.filter(|one| one.uncertain.is_none() || !place.has_interval());
            if let Some(&value) = solved.and_then(|solved| solved.values.get(&of)) {
                return Ok(Known::without_ends(value, Source::Solved, ROUNDED));
            }
            if let Some(known) = self.expected_value(of, pressure)? {
                return Ok(known);
            }
        }
        let (one, value, outside) = self.first(of, at)?;
        let source = Source::Model(one.model.id().into(), outside.map(Box::new));
        Ok(Known::without_ends(value, source, self.request.tolerance.relative()))
    }

    /// A quantity from the compared number behind it, under a load \[N\].
    fn of(
        &self,
        quantity: Quantity,
        load: f64,
        compared: f64,
        error: f64,
    ) -> Result<Evaluation, ContactError> {
        let area = self.scene.nominal_area;
        let radii = || {
            let sum = compared / (2.0 * self.scene.asperity()?.equivalent_modulus);
            match quantity {
                Quantity::ContactRadiusSum => Ok(Some(Evaluation::new(sum, error))),
                _ => Evaluation::of_contact_radii(quantity, sum, &self.scene, error),
            }
        };
        let found = match quantity {
            Quantity::Tangent | Quantity::UnloadingStiffness => {
                Some(Evaluation::new(compared, error))
            }
            _ => match Evaluation::of_totals(quantity, (load, compared * area), area, error) {
                Some(found) => Some(found),
                None => radii()?,
            },
        };
        found.ok_or_else(|| self.lacks(quantity))
    }

    /// The load \[N\] at a place.
    fn load(&self, at: At) -> Result<Evaluation, ContactError> {
        if let Some(load) = at.load(&self.scene) {
            return Ok(Evaluation::new(load, 0.0));
        }
        if let Some(pressure) = self.place(at).pressure {
            return Ok(Evaluation::new(pressure * self.scene.nominal_area, ROUNDED));
        }
        let valid = self.first(Compared::Area, at)?;
        valid.0.force(at)
    }

    /// What stands behind the answer: `alpha 8, psi 2; boundary elements on 16 surfaces`.
    ///
    /// # Errors
    /// Why no solved surface is like this one.
    pub fn basis(&self, at: At) -> Result<String, ContactError> {
        self.place(at).expected.as_ref().map(ExpectedContact::basis).map_err(Clone::clone)
    }

    /// The property and the reason why a compared number has no interval here.
    #[must_use]
    pub fn why(&self, of: Compared, at: At) -> (&'static str, String) {
        match &self.place(at).expected {
            Err(ContactError::NoEvidence { property, reason }) => (property, reason.clone()),
            Err(error) => ("", error.to_string()),
            Ok(expected) => expected.undetermined(of),
        }
    }

    /// Of what an interval is.
    fn of_what(&self, pressure: f64) -> String {
        let area = short(1e4 * self.scene.nominal_area);
        let some = self.contacts(pressure).map_or_else(String::new, |contacts| {
            let rounded: f64 = format!("{contacts:.0e}").parse().unwrap_or(contacts);
            format!(" with some {} contacts", short(rounded))
        });
        format!("nine of ten surfaces of this spectrum, {area} cm2{some}")
    }
}

impl<M: Answering> ContactEngine for BestContact<M> {
    fn model(&self) -> &str {
        Best::<M>::ID
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        if quantity == Quantity::Contacts {
            let counted = self.place(at).pressure.and_then(|pressure| self.contacts(pressure));
            let counted = counted.map(|n| Evaluation::new(n, self.request.tolerance.relative()));
            return counted.ok_or_else(|| self.refused("no model counts contacts here".into()));
        }
        let load = self.load(at)?;
        let known = Compared::behind(quantity).map(|of| self.known(of, at)).transpose()?;
        let (compared, error) = known.map_or((f64::NAN, 0.0), |known| (known.value, known.error));
        self.of(quantity, load.value(), compared, error.max(load.error))
    }

    fn interval_at(&self, quantity: Option<Quantity>, at: At) -> Option<Interval> {
        let of = match quantity {
            Some(quantity) => Compared::behind(quantity)?,
            None => Compared::MeanGap,
        };
        let pressure = self.place(at).pressure?;
        let known = self.known(of, at).ok()?;
        let presumed = known.presumed.filter(|_| self.best.within_ranges);
        let ends = known.ends.or(presumed)?;
        let nearest = if known.ends.is_none() { ", as at the nearest solved ones" } else { "" };
        let load = pressure * self.scene.nominal_area;
        let end = |compared: f64| match quantity {
            Some(quantity) => Some(self.of(quantity, load, compared, 0.0).ok()?.value()),
            None => Some(compared),
        };
        let [one, other] = [end(ends[0])?, end(ends[1])?];
        let of = self.of_what(pressure) + nearest;
        Some(Interval { lower: one.min(other), upper: one.max(other), of })
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let gap = self.known(Compared::MeanGap, At::Load(load))?.value;
        let (unit, from) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let gap = Separation::metres(gap).from_surface_mean();
        Ok(vec![gap.measured_in(unit, from, &self.scene)?])
    }

    fn notes(&self, at: &[At]) -> Vec<Finding> {
        self.findings(at)
    }
}

impl<M: Answering> Best<M> {
    /// The contact on a scene, for all quantities.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range.
    pub fn on(&self, scene: &Scene, tolerance: Tolerance) -> Result<BestContact<M>, ContactError> {
        BestContact::new(self.clone(), scene, &Request::default().within(tolerance))
    }
}

impl<M: Answering> ContactModel for Best<M> {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        Ok(Box::new(BestContact::new(self.clone(), scene, request)?))
    }
}
