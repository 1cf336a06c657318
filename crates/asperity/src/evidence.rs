//! What was found where models stood beside boundary elements: the table that advice comes of.

use std::fmt;
use std::sync::OnceLock;

use serde::Serialize;

use crate::{ContactError, HeightDistribution, Scene};

/// Scenes that are farther than this factor beyond the last case have no evidence.
const BEYOND: f64 = 1.5;
/// Below this plasticity index next to nothing flows: held against elastic cases.
const ELASTIC: f64 = 1.0 / BEYOND;

/// Every model beside boundary elements on generated surfaces, as `cargo xtask truth` finds it:
/// isotropic, Gaussian and periodic, of 512 x 512 pixels with shortest waves of 8, as
/// [`RandomSurface`](crate::bem::RandomSurface) makes them, elastic and with plasticity indices
/// (moments and E, S, H taken as the models take them) of 1, 2 and 4.
///
/// ```
/// use asperity::{Evidence, Interface, ProfileMoments, Scene, Surface};
///
/// let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4: 3e8 })?;
/// let mut scene = Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4);
/// let near = Evidence::committed().nearest(&scene, 2e8)?;
/// let off = near.deviation("ke").and_then(|found| found.area);
/// assert!(near.away < 2.0 && off.is_some_and(|off| off.abs() < 0.5), "{near:?}");
/// // Nothing is known of a surface with so many scales.
/// scene.surface = Surface::from_moments(&ProfileMoments { m0: 1e-11, m2: 2.5e-3, m4: 1e9 })?;
/// let refused = Evidence::committed().nearest(&scene, 2e8);
/// assert!(refused.unwrap_err().to_string().contains("alpha"));
/// # Ok::<(), asperity::ContactError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    cases: Vec<EvidenceCase>,
}

/// One surface, one material and one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvidenceCase {
    /// m₀ m₄/m₂².
    pub alpha: f64,
    /// ψ = √(σ_z/w_c); 0 where nothing yields.
    pub plasticity_index: f64,
    /// p/(E g), with the root mean square gradient g.
    pub load: f64,
    /// Boundary elements: the mean of several surfaces.
    pub bem: EvidenceRow,
    /// What the models say, by their ids.
    #[serde(skip)]
    pub models: Vec<(String, EvidenceRow)>,
}

/// Numbers without a unit; none where there is no such number.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// Real over nominal area.
    pub area_fraction: Option<f64>,
    /// Least and largest of the surfaces.
    pub area_span: Option<[f64; 2]>,
    /// -dp/d(gap) √m₀/E.
    pub stiffness: Option<f64>,
    /// Least and largest of the surfaces.
    pub stiffness_span: Option<[f64; 2]>,
}

/// How far a model was off, relative to boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Deviation {
    /// Of the real area.
    pub area: Option<f64>,
    /// Half the span of the surfaces, relative to their mean.
    pub area_spread: Option<f64>,
    /// Of the stiffness.
    pub stiffness: Option<f64>,
    /// Half the span of the surfaces, relative to their mean.
    pub stiffness_spread: Option<f64>,
}

/// The case nearest to a scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Nearest<'e> {
    /// The case.
    pub case: &'e EvidenceCase,
    /// The factor by which the scene is farthest from it, in α, in ψ or in p/(E g); at least 1.
    pub away: f64,
}

impl fmt::Display for Nearest<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let EvidenceCase { alpha, plasticity_index, load, .. } = self.case;
        write!(f, "alpha {alpha:.1}, ")?;
        match *plasticity_index > 0.0 {
            true => write!(f, "psi {plasticity_index}, ")?,
            false => write!(f, "elastic, ")?,
        }
        write!(f, "p/(E g) {load} (within a factor {:.2})", self.away)
    }
}

impl Deviation {
    /// Of two, what is farther off, each by itself.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        type Pair = (Option<f64>, Option<f64>);
        let far = |(off, _): Pair| off.map_or(-1.0, f64::abs);
        let of = |a: Pair, b: Pair| if far(b) > far(a) { b } else { a };
        let (area, area_spread) =
            of((self.area, self.area_spread), (other.area, other.area_spread));
        let (stiffness, stiffness_spread) =
            of((self.stiffness, self.stiffness_spread), (other.stiffness, other.stiffness_spread));
        Self { area, area_spread, stiffness, stiffness_spread }
    }
}

impl Nearest<'_> {
    /// How far a model was off there.
    #[must_use]
    pub fn deviation(&self, id: &str) -> Option<Deviation> {
        let EvidenceCase { bem, models, .. } = self.case;
        let (_, found) = models.iter().find(|(known, _)| known == id)?;
        let off = |a: Option<f64>, b: Option<f64>| a.zip(b).map(|(a, b)| a / b - 1.0);
        let spread = |span: Option<[f64; 2]>, mean: Option<f64>| {
            span.zip(mean).map(|([low, high], mean)| 0.5 * (high - low) / mean)
        };
        Some(Deviation {
            area: off(found.area_fraction, bem.area_fraction),
            area_spread: spread(bem.area_span, bem.area_fraction),
            stiffness: off(found.stiffness, bem.stiffness),
            stiffness_spread: spread(bem.stiffness_span, bem.stiffness),
        })
    }
}

impl Evidence {
    /// The text of what is committed, a csv.
    pub const CSV: &'static str = include_str!("../data/truth.csv");

    /// What is committed.
    #[must_use]
    pub fn committed() -> &'static Self {
        static READ: OnceLock<Evidence> = OnceLock::new();
        // That it reads is tested.
        READ.get_or_init(|| Self::parse(Self::CSV).unwrap_or(Self { cases: vec![] }))
    }

    /// Reads evidence from a text like [`CSV`](Self::CSV).
    ///
    /// # Errors
    /// [`ContactError::Refused`] with the line that is none of such a text.
    pub fn parse(text: &str) -> Result<Self, ContactError> {
        let mut cases: Vec<EvidenceCase> = vec![];
        for line in text.lines().skip(1) {
            let refused = || ContactError::Refused {
                model: "evidence".into(),
                reason: format!("{line:?} is no row of it"),
            };
            let fields: Vec<&str> = line.split(',').collect();
            let number = |k: usize| fields.get(k).and_then(|text| text.parse::<f64>().ok());
            let span = |k: usize| number(k).zip(number(k + 1)).map(|(low, high)| [low, high]);
            let (Some(alpha), Some(plasticity_index), Some(load), Some(id)) =
                (number(0), number(1), number(2), fields.get(3))
            else {
                return Err(refused());
            };
            let row = EvidenceRow {
                area_fraction: number(4),
                area_span: span(5),
                stiffness: number(7),
                stiffness_span: span(8),
            };
            match (*id, cases.last_mut()) {
                ("bem", _) => {
                    let (bem, models) = (row, vec![]);
                    cases.push(EvidenceCase { alpha, plasticity_index, load, bem, models });
                }
                (id, Some(case)) => case.models.push((id.into(), row)),
                (_, None) => return Err(refused()),
            }
        }
        Ok(Self { cases })
    }

    /// All cases: surface by surface, on each material by material, load by load.
    #[must_use]
    pub fn cases(&self) -> &[EvidenceCase] {
        &self.cases
    }

    /// The case nearest to a scene at a mean pressure \[Pa\].
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] naming what of the scene has no evidence, and the range that has;
    /// [`ContactError::Unsupported`] for heights that are not Gaussian and surfaces that stick; what is wrong with the scene.
    pub fn nearest(&self, scene: &Scene, pressure: f64) -> Result<Nearest<'_>, ContactError> {
        if !matches!(scene.heights, HeightDistribution::Gaussian) {
            let what = "heights that are not Gaussian: no such surfaces were solved".into();
            return Err(ContactError::Unsupported { model: "evidence".into(), what });
        }
        if scene.adhesion_parameter().is_some_and(|theta| theta < 10.0) {
            let what = "surfaces that stick: none was solved with adhesion".into();
            return Err(ContactError::Unsupported { model: "evidence".into(), what });
        }
        let asperity = scene.asperity()?;
        let index = match asperity.hardness {
            Some(_) => scene.plasticity_index()?,
            None => 0.0,
        };
        let index = if index < ELASTIC { 0.0 } else { index };
        let moments = scene.surface.moments();
        let gradient = (2.0 * moments.m2).sqrt();
        let load =
            crate::positive("pressure", pressure)? / (asperity.equivalent_modulus * gradient);
        let place = [moments.bandwidth(), index, load];
        let of = |case: &EvidenceCase| [case.alpha, case.plasticity_index, case.load];
        let fields = [
            ("alpha (m0 m4/m2^2)", "of a surface like those that were solved, 2 to 44"),
            ("plasticity_index", "of a material like those that were solved, at most 6"),
            ("p/(E g)", "a load like those that were solved, 7e-4 to 0.3"),
        ];
        for (k, (field, required)) in fields.into_iter().enumerate() {
            let known = self.cases.iter().map(|case| of(case)[k]).filter(|x| *x > 0.0);
            let [low, high] = [f64::min, f64::max].map(|end| known.clone().reduce(end));
            let (low, high) = (low.unwrap_or(f64::INFINITY) / BEYOND, high.unwrap_or(0.0) * BEYOND);
            if place[k] > 0.0 && !(low..=high).contains(&place[k]) {
                return Err(ContactError::OutOfRange { field, value: place[k], required });
            }
        }
        // ψ is 0 on both sides, or on none.
        let away = |case: &EvidenceCase| {
            let logs = place.iter().zip(of(case)).filter(|(a, b)| **a > 0.0 || *b > 0.0);
            logs.map(|(a, b)| (a / b).ln().abs())
                .fold([0.0, 0.0], |[sum, most], log: f64| [log.mul_add(log, sum), log.max(most)])
        };
        let found = self.cases.iter().map(|case| (away(case), case));
        let found = found.min_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        let nothing =
            || ContactError::Refused { model: "evidence".into(), reason: "it has no cases".into() };
        let ([_, most], case) = found.ok_or_else(nothing)?;
        Ok(Nearest { case, away: most.exp() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, ProfileMoments, Surface};

    fn scene(alpha: f64, index: f64) -> Scene {
        let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: alpha * 1e4 };
        let surface = Surface::from_moments(&moments).unwrap();
        let mut scene = Scene::new(Interface::elastic(1e11, 0.3), surface, 1e-6);
        if index > 0.0 {
            scene.interface.hardness = Some(1e9);
            let hardness = 1e9 * scene.plasticity_index().unwrap() / index;
            scene.interface.hardness = Some(hardness);
        }
        scene
    }

    /// E g of these scenes \[Pa\].
    fn unit() -> f64 {
        1e11 * 2e-4f64.sqrt()
    }

    #[test]
    fn what_is_committed_reads_and_is_whole() {
        let evidence = Evidence::parse(Evidence::CSV).unwrap();
        assert_eq!(evidence.cases().len(), 3 * 4 * 8);
        for case in evidence.cases() {
            let [low, high] = case.bem.area_span.unwrap();
            let area = case.bem.area_fraction.unwrap();
            assert!(low <= area && area <= high && high < 1.0, "{case:?}");
            assert!(case.bem.stiffness.is_some_and(|k| k > 0.0));
            let elastic = case.plasticity_index <= 0.0;
            // gw, gw-random and Persson's two; with a hardness all.
            assert_eq!(case.models.len(), if elastic { 4 } else { 22 }, "{case:?}");
        }
    }

    #[test]
    fn a_case_is_its_own_nearest_and_neighbours_are_found() {
        let evidence = Evidence::committed();
        for case in evidence.cases() {
            let scene = scene(case.alpha, case.plasticity_index);
            let near = evidence.nearest(&scene, case.load * unit()).unwrap();
            assert_eq!(near.case, case);
            assert!((near.away - 1.0).abs() < 1e-6, "{}", near.away);
            let gw = near.deviation("gw").unwrap();
            let model = case.models.iter().find(|(id, _)| id == "gw").unwrap().1;
            let wanted = model.area_fraction.unwrap() / case.bem.area_fraction.unwrap() - 1.0;
            assert!((gw.area.unwrap() - wanted).abs() < 1e-12);
            assert!(near.deviation("persson").is_some_and(|p| p.stiffness.is_none()));
        }
        let near = evidence.nearest(&scene(10.0, 2.2), 0.011 * unit()).unwrap();
        assert!((near.case.plasticity_index - 2.0).abs() < 1e-9 && near.away < 1.5, "{near:?}");
        // Nearly elastic is elastic.
        let near = evidence.nearest(&scene(10.0, 0.3), 0.011 * unit()).unwrap();
        assert!(near.case.plasticity_index <= 0.0);
    }

    #[test]
    fn outside_there_is_no_evidence() {
        let refused = |alpha: f64, index: f64, load: f64| {
            let found = Evidence::committed().nearest(&scene(alpha, index), load * unit());
            found.unwrap_err().to_string()
        };
        assert!(refused(1.6, 2.0, 0.01).starts_with("alpha (m0 m4/m2^2) is 1."));
        assert!(refused(100.0, 2.0, 0.01).starts_with("alpha"));
        assert!(refused(8.0, 20.0, 0.01).starts_with("plasticity_index is "));
        assert!(refused(8.0, 2.0, 1e-5).starts_with("p/(E g) is"));
        assert!(refused(8.0, 2.0, 0.5).contains("7e-4 to 0.3"));
        let mut exponential = scene(8.0, 2.0);
        exponential.heights = HeightDistribution::Exponential;
        let found = Evidence::committed().nearest(&exponential, 0.01 * unit()).unwrap_err();
        assert!(found.to_string().contains("not Gaussian"), "{found}");
    }
}
