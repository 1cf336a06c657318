//! Models compared with boundary elements: the table on which advice is based.

mod case;
mod csv;
mod expected;

use std::fmt;
use std::sync::OnceLock;

use serde::Serialize;

pub use crate::evidence::case::{Compared, EvidenceCase, EvidenceRow};
pub use crate::evidence::expected::Expected;
use crate::{ContactError, HeightDistribution, Scene};

/// Scenes farther than this factor beyond the solved range have no evidence.
const BEYOND: f64 = 1.5;
/// First clause of a refusal.
pub(crate) const NONE: &str = "no boundary-element solution is close";
/// Below this plasticity index almost nothing yields: compared with elastic cases.
const ELASTIC: f64 = 1.0 / BEYOND;

/// Every model compared with boundary elements on generated surfaces, as `cargo xtask truth`
/// computes them: periodic, 256 x 256 to 2048 x 2048 pixels with shortest waves of 8 pixels, from
/// [`RandomSurface`](crate::bem::RandomSurface); isotropic and Gaussian, or skewed, or with a lay;
/// elastic and with plasticity indices (moments, E, S and H as the models use them).
///
/// ```
/// use asperity::{Evidence, Interface, ProfileMoments, Scene, Surface};
///
/// let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4: 3e8 })?;
/// let mut scene = Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4);
/// let near = Evidence::committed()?.nearest(&scene, 2e8)?;
/// let off = near.deviation("ke").and_then(|found| found.area);
/// assert!(near.away < 2.0 && off.is_some_and(|off| off.abs() < 0.5), "{near:?}");
/// // No surface of so large a bandwidth was solved.
/// scene.surface = Surface::from_moments(&ProfileMoments { m0: 1e-11, m2: 2.5e-3, m4: 1e9 })?;
/// let refused = Evidence::committed()?.nearest(&scene, 2e8);
/// assert!(refused.unwrap_err().to_string().contains("alpha"));
/// # Ok::<(), asperity::ContactError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    cases: Vec<EvidenceCase>,
}

/// Deviation of a model, relative to boundary elements.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Deviation {
    /// Of the real area.
    pub area: Option<f64>,
    /// Standard error of the mean of the surfaces, relative to it.
    pub area_spread: Option<f64>,
    /// Of the stiffness.
    pub stiffness: Option<f64>,
    /// Standard error of the mean of the surfaces, relative to it.
    pub stiffness_spread: Option<f64>,
}

/// The case nearest to a scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Nearest<'e> {
    /// The case.
    pub case: &'e EvidenceCase,
    /// The largest factor between scene and case, in α, ψ or p/(E g); at least 1.
    pub away: f64,
    /// Whether the load is below all solved ones, where ratios are taken as constant.
    pub extrapolated: bool,
}

impl fmt::Display for Nearest<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let EvidenceCase { alpha, plasticity_index, load, .. } = self.case;
        write!(f, "alpha {alpha:.1}, ")?;
        match *plasticity_index > 0.0 {
            true => write!(f, "psi {plasticity_index}, ")?,
            false => write!(f, "elastic, ")?,
        }
        write!(f, "p/(E g) {load} (within a factor {:.2}", self.away)?;
        f.write_str(if self.extrapolated { ", extrapolated to a lighter load)" } else { ")" })
    }
}

impl Deviation {
    /// The larger deviations of two, each quantity separately.
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
    /// Deviation of a model in this case; `None` for an unknown model.
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
    /// The committed table, a csv with the columns [`COLUMNS`](Self::COLUMNS) and four for each
    /// model: area, stiffness and unloading stiffness over those of boundary elements, and the mean
    /// gap less that of boundary elements over √m₀, all in thousandths; empty if not available.
    pub const CSV: &'static str = include_str!("../../data/truth.csv");

    /// Columns of the cases and of boundary elements: means over the surfaces and their standard
    /// errors. Stiffnesses -dp/d(gap) are in units of E/√m₀, mean gaps in √m₀.
    pub const COLUMNS: [&'static str; 16] = csv::COLUMNS;

    /// The number of a model in the table, from a result of it and of boundary elements.
    #[must_use]
    pub fn relative(quantity: Compared, model: f64, bem: f64) -> f64 {
        csv::relative(quantity, model, bem)
    }

    /// The committed evidence.
    ///
    /// # Errors
    /// Those of [`parse`](Self::parse).
    pub fn committed() -> Result<&'static Self, ContactError> {
        static READ: OnceLock<Result<Evidence, ContactError>> = OnceLock::new();
        READ.get_or_init(|| Self::parse(Self::CSV)).as_ref().map_err(Clone::clone)
    }

    /// Reads evidence from a text like [`CSV`](Self::CSV).
    ///
    /// # Errors
    /// [`ContactError::Refused`] with line, column and content of the first invalid field, or if
    /// there are no cases.
    pub fn parse(text: &str) -> Result<Self, ContactError> {
        Ok(Self { cases: csv::cases(text)? })
    }

    /// The cases of isotropic Gaussian surfaces.
    fn plain(&self) -> impl Iterator<Item = &EvidenceCase> {
        self.cases.iter().filter(|case| case.skewness == 0.0 && case.slope_ratio <= 1.0)
    }

    /// The solved cases of isotropic Gaussian surfaces in one line: `alpha 3.1, 7.5, 29.5, elastic
    /// and psi 1, 2, 4, p/(E g) from 0.001 to 0.2`.
    #[must_use]
    pub fn solved(&self) -> String {
        let each = |of: fn(&EvidenceCase) -> f64| {
            let mut all: Vec<f64> = self.plain().map(of).filter(|x| *x > 0.0).collect();
            all.sort_by(f64::total_cmp);
            all.dedup();
            all
        };
        let listed = |all: Vec<String>| all.join(", ");
        let alpha = each(|case| case.alpha).iter().map(|x| format!("{x:.1}")).collect();
        let index = each(|case| case.plasticity_index).iter().map(ToString::to_string).collect();
        let [lightest, heaviest] = self.range(|case| case.load);
        let (alpha, index) = (listed(alpha), listed(index));
        format!("alpha {alpha}, elastic and psi {index}, p/(E g) from {lightest} to {heaviest}")
    }

    /// The error for a scene without evidence.
    pub(crate) fn none(reason: String) -> ContactError {
        ContactError::Refused { model: NONE.into(), reason }
    }

    /// The smallest and the largest value above 0.
    fn range(&self, of: impl Fn(&EvidenceCase) -> f64) -> [f64; 2] {
        let known = self.plain().map(of).filter(|x| *x > 0.0);
        known.fold([f64::INFINITY, 0.0], |[low, high], x| [low.min(x), high.max(x)])
    }

    /// All cases, ordered by surface, material and load.
    #[must_use]
    pub fn cases(&self) -> &[EvidenceCase] {
        &self.cases
    }

    /// The case nearest to a scene at a mean pressure \[Pa\].
    ///
    /// # Errors
    /// [`ContactError::Refused`] naming the property of the scene outside the solved range, and the
    /// range; heights must be Gaussian, and roughness must hide adhesion. Errors of the scene.
    pub fn nearest(&self, scene: &Scene, pressure: f64) -> Result<Nearest<'_>, ContactError> {
        let none = Self::none;
        let Query { alpha, index, yields, load } = Query::new(scene, pressure)?;
        let index = if !yields || index < ELASTIC { 0.0 } else { index };
        // Ratios are constant under lighter loads.
        let [lightest, _] = self.range(|case| case.load);
        let extrapolated = load < lightest;
        let place = [alpha, index, load.max(lightest)];
        let of = |case: &EvidenceCase| [case.alpha, case.plasticity_index, case.load];
        for (k, field) in ["alpha (m0 m4/m2^2)", "plasticity_index", "p/(E g)"].iter().enumerate() {
            let [low, high] = self.range(|case| of(case)[k]);
            if place[k] > 0.0 && !(low / BEYOND..=high * BEYOND).contains(&place[k]) {
                let value = place[k];
                let found = match k {
                    0 => format!("{value:.1}; solved range {low:.1} to {high:.1}"),
                    // Smaller indices are compared with elastic cases.
                    1 => format!("{value:.1}; solved up to {high:.1}"),
                    _ => format!("{value:.1e}; solved range {low:.1e} to {high:.1e}"),
                };
                return Err(none(format!("{field} = {found}")));
            }
        }
        // ψ is 0 for both or for neither.
        let away = |case: &EvidenceCase| {
            let logs = place.iter().zip(of(case)).filter(|(a, b)| **a > 0.0 || *b > 0.0);
            logs.map(|(a, b)| (a / b).ln().abs())
                .fold([0.0, 0.0], |[sum, most], log: f64| [log.mul_add(log, sum), log.max(most)])
        };
        let found = self.plain().map(|case| (away(case), case));
        let found = found.min_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        let ([_, most], case) = found.ok_or_else(|| none("there are no cases".into()))?;
        Ok(Nearest { case, away: most.exp(), extrapolated })
    }
}

/// The place of a scene at a load among the cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Query {
    /// m₀ m₄/m₂².
    pub(crate) alpha: f64,
    /// Whether there is a hardness; then ψ.
    pub(crate) yields: bool,
    pub(crate) index: f64,
    /// p/(E g).
    pub(crate) load: f64,
}

impl Query {
    /// The place of a scene with an isotropic Gaussian surface at a mean pressure \[Pa\].
    pub(crate) fn new(scene: &Scene, pressure: f64) -> Result<Self, ContactError> {
        if !matches!(scene.heights, HeightDistribution::Gaussian) {
            let reason = "the heights are not Gaussian, the solved surfaces are";
            return Err(Evidence::none(reason.into()));
        }
        if scene.adhesion_parameter().is_some_and(|theta| theta < Scene::HIDES_ADHESION) {
            let reason = "the surfaces adhere, the solved surfaces do not";
            return Err(Evidence::none(reason.into()));
        }
        let asperity = scene.asperity()?;
        let yields = asperity.hardness.is_some();
        let index = if yields { scene.plasticity_index()? } else { 0.0 };
        let moments = scene.surface.moments();
        let unit = asperity.equivalent_modulus * (2.0 * moments.m2).sqrt();
        let load = crate::positive("pressure", pressure)? / unit;
        Ok(Self { alpha: moments.bandwidth(), yields, index, load })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, Model, ProfileMoments, Surface};

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
    fn the_committed_table_is_complete() {
        let evidence = Evidence::committed().unwrap();
        let whole = Model::whole_surface().len();
        for case in evidence.cases() {
            let [low, high] = case.bem.area_span.unwrap();
            let area = case.bem.area_fraction.unwrap();
            assert!(low <= area && area <= high && high < 1.0, "{case:?}");
            assert!(case.surfaces >= 4 && (0.0..=1.0).contains(&case.plastic_share), "{case:?}");
            // Elastic: gw and gw-random; with a hardness nine of the paper and four random ones.
            let of_asperities = if case.plasticity_index > 0.0 { 13 } else { 2 };
            assert_eq!(case.models.len(), of_asperities + whole, "{case:?}");
        }
        assert!(Evidence::CSV.len() < 150_000, "{}", Evidence::CSV.len());
    }

    /// Other texts repeat the line of `solved`.
    #[test]
    fn the_solved_cases_are_listed() {
        let solved = Evidence::committed().unwrap().solved();
        let wanted =
            "alpha 3.1, 7.5, 29.5, 76.9, elastic and psi 0.7, 1, 2, 4, 8, p/(E g) from 0.00001 to 0.3";
        assert_eq!(solved, wanted);
    }

    #[test]
    fn a_case_is_its_own_nearest_and_neighbours_are_found() {
        let evidence = Evidence::committed().unwrap();
        for case in evidence.plain() {
            let scene = scene(case.alpha, case.plasticity_index);
            let near = evidence.nearest(&scene, case.load * unit()).unwrap();
            assert_eq!(near.case, case);
            assert!((near.away - 1.0).abs() < 1e-3, "{}", near.away);
            let gw = near.deviation("gw").unwrap();
            let model = case.models.iter().find(|(id, _)| id == "gw").unwrap().1;
            let wanted = model.area_fraction.unwrap() / case.bem.area_fraction.unwrap() - 1.0;
            assert!((gw.area.unwrap() - wanted).abs() < 1e-12);
            assert!(near.deviation("persson").is_some_and(|p| p.stiffness.is_some()));
        }
        let near = evidence.nearest(&scene(10.0, 2.2), 0.011 * unit()).unwrap();
        assert!((near.case.plasticity_index - 2.0).abs() < 1e-9 && near.away < 1.5, "{near:?}");
        // Small indices are compared with elastic cases.
        let near = evidence.nearest(&scene(10.0, 0.3), 0.011 * unit()).unwrap();
        assert!(near.case.plasticity_index <= 0.0);
    }

    #[test]
    fn outside_there_is_no_evidence() {
        let refused = |alpha: f64, index: f64, load: f64| {
            let found = Evidence::committed().unwrap().nearest(&scene(alpha, index), load * unit());
            found.unwrap_err().to_string()
        };
        for (found, field) in [
            (refused(1.6, 2.0, 0.01), "alpha (m0 m4/m2^2) = 1.6"),
            (refused(200.0, 2.0, 0.01), "alpha (m0 m4/m2^2) = 200.0; solved range 3.1 to 76.9"),
            (refused(8.0, 20.0, 0.01), "plasticity_index = 20.0; solved up to 4.0"),
            (refused(8.0, 2.0, 0.7), "p/(E g) = 7.0e-1"),
        ] {
            assert!(found.starts_with(&format!("{NONE}: {field}")), "{found}");
        }
        // Ratios are constant under loads below all solved ones.
        let light = Evidence::committed().unwrap().nearest(&scene(8.0, 2.0), 1e-7 * unit());
        let light = light.unwrap();
        assert!(light.extrapolated && light.away < 1.5, "{light:?}");
        assert!(light.to_string().ends_with("extrapolated to a lighter load)"), "{light}");
        let mut exponential = scene(8.0, 2.0);
        exponential.heights = HeightDistribution::Exponential;
        let found =
            Evidence::committed().unwrap().nearest(&exponential, 0.01 * unit()).unwrap_err();
        assert!(found.to_string().contains("not Gaussian"), "{found}");
    }
}
