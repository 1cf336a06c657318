//! Surfaces whose numbers are known within ranges, and the scenes at the ends of these.

use asperity::{At, Check, Code, ContactError, ContactModel, Finding, ProfileMoments, Severity};

use crate::error::{Place, SceneError};
use crate::ranges::{Corner, Face, MIDDLE, NAMES, Unknown};
use crate::scene_file::SceneFile;
use crate::spec::{Description, SurfaceSpec};

/// The names of the unknowns of each surface among derived numbers.
const DERIVED: [[&str; 3]; 2] = [
    ["surface_rq", "surface_mean_slope", "surface_bandwidth"],
    ["counterface_rq", "counterface_mean_slope", "counterface_bandwidth"],
];
/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;

/// Where a finding is from that the middle of the ranges does not have.
pub const AT_AN_END: &str = "at an end of the ranges of the surface";

/// The warnings at the ends of the ranges with codes that are not `known` in the middle: one of
/// each code, with the largest excess over its usual range.
pub fn worst_at_ends<'f>(
    known: &[Finding],
    at_ends: impl Iterator<Item = &'f Finding>,
) -> Vec<Finding> {
    let mut new: Vec<&Finding> = vec![];
    let is_new = |found: &Finding| known.iter().all(|known| known.code != found.code);
    for found in at_ends.filter(|found| found.severity < Severity::Note && is_new(found)) {
        match new.iter_mut().find(|known| known.code == found.code) {
            Some(known) if found.excess() > known.excess() => *known = found,
            Some(_) => {}
            None => new.push(found),
        }
    }
    new.into_iter().map(|found| found.clone().from_origin(AT_AN_END)).collect()
}

/// The unknowns that have a range, as places in the list of names.
fn open(faces: &[(&str, Face)]) -> Vec<usize> {
    let is_open = |k: &usize| faces.iter().any(|(_, face)| face.unknowns[*k].is_open());
    (0..NAMES.len()).filter(is_open).collect()
}

impl SceneFile {
    /// The numbers of the surfaces that are known within ranges or given beside such, each with the
    /// section of its surface; none where the surface is described otherwise.
    #[must_use]
    pub fn unknowns(&self) -> Vec<(&'static str, Unknown)> {
        let of = |(section, face): (_, Face)| face.unknowns.map(|one| (section, one));
        self.faces().into_iter().flat_map(of).collect()
    }

    /// Each surface with its unknowns, one by numbers without ranges; none where no surface is
    /// known by its finish.
    fn faces(&self) -> Vec<(&'static str, Face)> {
        let interface = &self.scene.interface;
        let of = |(section, one): (_, &SurfaceSpec)| {
            let known = || Some(Face::known(&one.moments(interface)?));
            Some((section, one.face().or_else(known)?))
        };
        match self.spec.surfaces().any(|(_, one)| one.face().is_some()) {
            true => self.spec.surfaces().filter_map(of).collect(),
            false => vec![],
        }
    }

    /// The names of the unknowns that have a range, each with the ratio of its ends on both
    /// surfaces together; none where the surface is known.
    #[must_use]
    pub fn spreads(&self) -> Vec<(&'static str, f64)> {
        let faces = self.faces();
        let spread = |k: usize| {
            let [lower, upper] = [0, 2].map(|end| {
                let mut at = MIDDLE;
                at[k] = end;
                let none = ProfileMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
                let found = faces.iter().fold(none, |sum, (_, face)| sum.plus(&face.moments(at)));
                [found.m0.sqrt(), found.m2.sqrt(), found.bandwidth()][k]
            });
            (NAMES[k], upper / lower)
        };
        open(&faces).into_iter().map(spread).collect()
    }

    /// The scene in the middle of the ranges, and then at each combination of their ends: of `k`
    /// unknowns with a range 2ᵏ scenes, where bit `j` of the place is 1 at the upper end of
    /// unknown `j` of [`spreads`](Self::spreads). Both surfaces vary together.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn corners(&self) -> Result<(Self, Vec<Self>), ContactError> {
        let open = open(&self.faces());
        let corner = |corner: usize| {
            let mut place = MIDDLE;
            for (bit, k) in open.iter().enumerate() {
                place[*k] = 2 * ((corner >> bit) & 1);
            }
            self.taken_at(place)
        };
        let corners = (0..1 << open.len()).map(corner).collect::<Result<_, _>>()?;
        Ok((self.taken_at(MIDDLE)?, corners))
    }

    /// The scene with its unknowns taken at one place.
    fn taken_at(&self, place: Corner) -> Result<Self, ContactError> {
        let mut spec = self.spec.clone();
        for second in [false, true] {
            if let Some(SurfaceSpec { by: Description::Drawing(drawing), .. }) =
                spec.surface_mut(second)
            {
                drawing.at = Some(place);
            }
        }
        let made = Self::of_spec(spec)?;
        Ok(Self { warnings: self.warnings.clone(), origin: self.origin.clone(), ..made })
    }

    /// The scene in the middle of the ranges, and this scene without any.
    ///
    /// # Errors
    /// Those of [`corners`](Self::corners).
    pub fn middle(&self) -> Result<Self, ContactError> {
        if self.faces().is_empty() { Ok(self.clone()) } else { self.taken_at(MIDDLE) }
    }

    /// The check of the scene in the middle of the ranges, with those of all numbers.
    pub(crate) fn check_ranges(
        &self,
        place: Option<(&dyn ContactModel, At)>,
    ) -> Result<Check, ContactError> {
        let (middle, corners) = self.corners()?;
        let mut check = middle.check(place)?;
        // An end of assumed ranges may be an unusual surface, which the given numbers are not.
        let of_answer = |corner: &Self| -> Result<Check, ContactError> {
            let (mut check, own) = (corner.check(place)?, corner.findings());
            let is_own = |found: &Finding| own.iter().any(|own| own.code == found.code);
            check.findings = check.findings.into_iter().filter(|found| !is_own(found)).collect();
            Ok(check)
        };
        let corners = corners.iter().map(of_answer).collect::<Result<Vec<_>, _>>()?;
        for number in &mut check.numbers {
            let found = corners.iter().filter_map(|corner| corner.number(number.name));
            let [lower, upper] = found.fold([number.value; 2], |[lower, upper], value| {
                [lower.min(value), upper.max(value)]
            });
            let differs = upper - lower > SAME * number.value.abs();
            number.ends = differs.then_some([lower, upper]);
        }
        let mut given = Check::default();
        for ((_, face), names) in self.faces().iter().zip(DERIVED) {
            for (unknown, name) in face.unknowns.iter().zip(names) {
                let Unknown { range: [lower, middle, upper], status, source, .. } = unknown;
                let unit = if unknown.name == NAMES[0] { "m" } else { "" };
                given.add_number(name, *middle, unit, format!("{status}: {source}"));
                if let Some(added) = given.numbers.last_mut() {
                    added.ends = (lower < upper).then_some([*lower, *upper]);
                }
            }
        }
        given.numbers.append(&mut check.numbers);
        check.numbers = given.numbers;
        let at_ends = corners.iter().flat_map(|corner| corner.findings.iter());
        let new = worst_at_ends(&check.findings, at_ends);
        check.extend(new);
        check.extend(self.smooth_counterface());
        check.findings = self.accepted(check.findings);
        Ok(check)
    }

    /// A note that the other surface is taken as smooth, of a single surface with ranges.
    #[must_use]
    pub fn smooth_counterface(&self) -> Option<Finding> {
        let is_alone = self.spec.counterface.is_none() && !self.spreads().is_empty();
        let found = Finding::note(Code::SmoothCounterface, "counterface", f64::NAN)
            .fact("the other surface is taken as smooth (by models of pairs as rough as this one)")
            .advice("describe it as counterface if it is rough, too");
        is_alone.then_some(found)
    }

    /// Nothing where the surface is known; where it is known within ranges, an answer in single
    /// numbers is refused.
    ///
    /// # Errors
    /// [`SceneError::Refused`] with the numbers that have ranges.
    pub fn need_known(&self) -> Result<(), SceneError> {
        match self.open_reason() {
            Some(reason) => Err(SceneError::Refused { at: Place::field("surface").into(), reason }),
            None => Ok(()),
        }
    }

    /// Why answers in single numbers are refused, if they are.
    pub(crate) fn open_reason(&self) -> Option<String> {
        let names: Vec<String> = self.spreads().iter().map(|(name, _)| name.to_string()).collect();
        (!names.is_empty()).then(|| {
            format!(
                "the surface is known within ranges only ({}), and this answer is a single number: use answer, curve or check (ranges in Python), which answer with ranges, or give rq, rdq and bandwidth without a finish, whose lay leaves the slope open",
                names.join(", ")
            )
        })
    }
}
