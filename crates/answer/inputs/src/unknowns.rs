//! Surfaces whose numbers are known within ranges, and the scenes at the ends of these.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use asperity::{
    At, Check, Code, ContactError, ContactModel, Finding, Pair, ProfileMoments, Severity, Surface,
};

use crate::{Place, SceneError, SceneFile};

/// The names of the unknowns of a surface.
pub(crate) const NAMES: [&str; 3] = ["rq", "mean_slope", "bandwidth"];
/// Those of each surface among derived numbers.
const DERIVED: [[&str; 3]; 2] = [
    ["surface_rq", "surface_mean_slope", "surface_bandwidth"],
    ["counterface_rq", "counterface_mean_slope", "counterface_bandwidth"],
];
/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;

/// A number of a surface that is known within a range.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Unknown {
    /// `rq` \[m\], `mean_slope` (of the isotropic surface with the same rms gradient) or
    /// `bandwidth`.
    pub name: &'static str,
    /// Lower end, geometric mean and upper end.
    pub range: [f64; 3],
    /// What the range rests on: `given`, `formula`, `scan` or `assumed`.
    pub status: &'static str,
    /// Where the range comes from.
    pub source: String,
    /// What would narrow the range.
    pub narrowed: &'static str,
}

impl Unknown {
    pub(crate) fn new(
        name: &'static str,
        [lower, upper]: [f64; 2],
        status: &'static str,
        source: String,
        narrowed: &'static str,
    ) -> Self {
        Self { name, range: [lower, (lower * upper).sqrt(), upper], status, source, narrowed }
    }

    pub(crate) fn given(name: &'static str, value: f64, source: &str) -> Self {
        // Only the lay of a finish opens a given slope again.
        let given = Self::new(name, [value; 2], "given", source.into(), "a scan");
        Self { range: [value; 3], ..given }
    }
}

/// One rough surface with its unknowns in the order of [`NAMES`].
#[derive(Debug, Clone)]
pub(crate) struct Face {
    /// The section of its keys.
    pub(crate) section: &'static str,
    pub(crate) unknowns: [Unknown; 3],
    /// The slope varies with this power of Rq over its middle; 0 if it does not follow from Rq.
    pub(crate) slope_power: f64,
}

/// Where each unknown of the faces is taken: 0 at its lower end, 1 in the middle, 2 at its upper
/// end.
type Corner = [usize; 3];
const MIDDLE: Corner = [1; 3];

impl Face {
    /// A surface whose moments are known.
    pub(crate) fn known(section: &'static str, moments: &ProfileMoments) -> Self {
        let values = [moments.m0.sqrt(), (FRAC_2_PI * moments.m2).sqrt(), moments.bandwidth()];
        let given = |k: usize| Unknown::given(NAMES[k], values[k], "the numbers of the surface");
        Self { section, unknowns: [0, 1, 2].map(given), slope_power: 0.0 }
    }

    fn moments(&self, at: Corner) -> ProfileMoments {
        let [rq, slope, bandwidth] = [0, 1, 2].map(|k| self.unknowns[k].range[at[k]]);
        let slope = slope * (rq / self.unknowns[0].range[1]).powf(self.slope_power);
        let (m0, m2) = (rq * rq, FRAC_PI_2 * slope * slope);
        ProfileMoments { m0, m2, m4: bandwidth * m2 * (m2 / m0) }
    }
}

/// The moments of all faces together.
fn moments(faces: &[Face], at: Corner) -> ProfileMoments {
    let none = ProfileMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
    faces.iter().fold(none, |sum, face| sum.plus(&face.moments(at)))
}

/// The surface that faces make together, and the asperities of each of two.
fn surfaces(faces: &[Face], at: Corner) -> Result<(Surface, Option<Pair>), ContactError> {
    let together = Surface::from_moments(&moments(faces, at))?;
    let each = faces.iter().map(|face| Surface::from_moments(&face.moments(at)));
    let pair = match each.collect::<Result<Vec<_>, _>>()?[..] {
        [first, second] => Some(Pair::new(first, second)),
        _ => None,
    };
    Ok((together, pair))
}

/// The surfaces of faces in the middle of their ranges.
///
/// # Errors
/// Those of [`Surface::from_moments`].
pub(crate) fn middle(faces: &[Face]) -> Result<(Surface, Option<Pair>), ContactError> {
    surfaces(faces, MIDDLE)
}

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

impl SceneFile {
    /// The numbers of the surfaces that are known within ranges or given beside such, each with the
    /// section of its surface; none where the surface is described otherwise.
    pub fn unknowns(&self) -> impl Iterator<Item = (&'static str, &Unknown)> {
        self.faces.iter().flat_map(|face| face.unknowns.iter().map(|one| (face.section, one)))
    }

    /// The unknowns that have a range, as places in the list of names.
    fn open(&self) -> Vec<usize> {
        let is_open = |k: &usize| {
            self.faces.iter().any(|face| face.unknowns[*k].range[0] < face.unknowns[*k].range[2])
        };
        (0..NAMES.len()).filter(is_open).collect()
    }

    /// The names of the unknowns that have a range, each with the ratio of its ends on both
    /// surfaces together; none where the surface is known.
    #[must_use]
    pub fn spreads(&self) -> Vec<(&'static str, f64)> {
        let spread = |k: usize| {
            let [lower, upper] = [0, 2].map(|end| {
                let mut at = MIDDLE;
                at[k] = end;
                let found = moments(&self.faces, at);
                [found.m0.sqrt(), found.m2.sqrt(), found.bandwidth()][k]
            });
            (NAMES[k], upper / lower)
        };
        self.open().into_iter().map(spread).collect()
    }

    /// The scene in the middle of the ranges, and then at each combination of their ends: of `k`
    /// unknowns with a range 2ᵏ scenes, where bit `j` of the place is 1 at the upper end of
    /// unknown `j` of [`spreads`](Self::spreads). Both surfaces vary together.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn corners(&self) -> Result<(Self, Vec<Self>), ContactError> {
        let open = self.open();
        let at = |place: Corner| {
            let (surface, pair) = surfaces(&self.faces, place)?;
            let mut file = Self { faces: vec![], ..self.clone() };
            (file.scene.surface, file.scene.pair) = (surface, pair);
            let offsets = self.mean_plane_offsets();
            if offsets.iter().any(Option::is_some) {
                file.set_mean_plane_offsets(offsets);
            }
            Ok(file)
        };
        let corner = |corner: usize| {
            let mut place = MIDDLE;
            for (bit, k) in open.iter().enumerate() {
                place[*k] = 2 * ((corner >> bit) & 1);
            }
            at(place)
        };
        Ok((at(MIDDLE)?, (0..1 << open.len()).map(corner).collect::<Result<_, _>>()?))
    }

    /// The scene in the middle of the ranges, and this scene without any.
    ///
    /// # Errors
    /// Those of [`corners`](Self::corners).
    pub fn middle(&self) -> Result<Self, ContactError> {
        Ok(if self.faces.is_empty() { self.clone() } else { self.corners()?.0 })
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
        for (face, names) in self.faces.iter().zip(DERIVED) {
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
        let is_alone = self.faces.len() == 1 && !self.spreads().is_empty();
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
                "the surface is known within ranges only ({}), and this answer is a single number: use curve, check, conductance or recommend (ranges in Python), which answer with ranges, or give rq, rdq and bandwidth without a finish, whose lay leaves the slope open",
                names.join(", ")
            )
        })
    }
}
