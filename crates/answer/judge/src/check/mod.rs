//! Plausibility of a scene: derived numbers, and findings of numbers outside the range of
//! materials, surfaces and models.

mod answer;
mod findings;
mod interferences;
mod moduli;
mod roughness;
mod usual;

use std::borrow::Cow;

use serde::{Serialize, Serializer};

pub use self::usual::{outside, unusual};
use crate::recommended::{DMT, JKR, JKR_SEPARATION};
use asperity_core::{
    ATOMIC_DISTANCE, Code, ContactError, Finding, Findings, HeightDistribution, Scene, short,
};

/// A number that follows from a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct DerivedNumber {
    /// Its name, as in tables: `plasticity_index`.
    pub name: Cow<'static, str>,
    /// Its value.
    pub value: f64,
    /// Its SI unit; empty for pure numbers.
    pub unit: &'static str,
    /// Its meaning and formula.
    pub meaning: Cow<'static, str>,
    /// Its smallest and largest value where it is known within a range.
    pub ends: Option<[f64; 2]>,
}

/// Derived numbers and findings of a scene or an answer.
///
/// ```
/// use asperity_core::{Interface, Scene, Surface};
/// use asperity_judge::Check;
///
/// // The modulus is in GPa.
/// let scene = Scene::new(Interface::new(116.0, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
/// let check = Check::of(&scene)?;
/// let finding = &check.findings[0];
/// assert!(finding.is_implausible() && finding.field == "equivalent_modulus");
/// assert!(finding.to_string().ends_with("116 looks like GPa; 116 GPa is 1.16e11 Pa"));
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Check {
    /// Numbers derived from the inputs.
    #[serde(serialize_with = "as_map")]
    pub numbers: Vec<DerivedNumber>,
    /// Unusual numbers, most severe first.
    pub findings: Findings,
}

fn as_map<S: Serializer>(numbers: &[DerivedNumber], serializer: S) -> Result<S::Ok, S::Error> {
    let named = numbers.iter().flat_map(DerivedNumber::named);
    serializer.collect_map(named)
}

impl DerivedNumber {
    /// The value by its name, and the ends of its range as `name_lower` and `name_upper`.
    pub fn named(&self) -> impl Iterator<Item = (String, f64)> {
        let end = |(what, value)| (format!("{}_{what}", self.name), value);
        let ends = self.ends.map(|ends| ["lower", "upper"].into_iter().zip(ends).map(end));
        [(self.name.to_string(), self.value)].into_iter().chain(ends.into_iter().flatten())
    }
}

impl Check {
    /// The value of a number, by its name.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|number| number.name == name).map(|number| number.value)
    }

    /// Adds findings, one for each cause.
    pub fn extend(&mut self, findings: impl IntoIterator<Item = Finding>) {
        self.findings.extend(findings);
        self.findings = std::mem::take(&mut self.findings).by_cause();
    }

    /// Adds a number, if there is one.
    pub fn add_number(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        value: impl Into<Option<f64>>,
        unit: &'static str,
        meaning: impl Into<Cow<'static, str>>,
    ) {
        let Some(value) = value.into() else { return };
        let (name, meaning) = (name.into(), meaning.into());
        self.numbers.push(DerivedNumber { name, value, unit, meaning, ends: None });
    }
}

/// Largest Tabor parameter of DMT, and smallest of JKR.
pub(crate) const LEAST_TABOR: f64 = 0.1;
pub(crate) const MOST_TABOR: f64 = 5.0;

/// Numbers that may be outside the range of anything in use.
pub trait Plausible {
    /// Unusual numbers, alone and in combination; none for most. Cheap enough for every scene of a
    /// study. A finding names the likely unit if a power of ten explains the number.
    fn findings(&self) -> Findings;
}

impl Check {
    /// Derived numbers and findings of a scene. Usual ranges cover engineering materials and
    /// surfaces, from elastomers to ceramics and from micro-machines to blasted steel.
    ///
    /// # Errors
    /// [`ContactError`] for an invalid input, for example a negative length.
    pub fn of(scene: &Scene) -> Result<Self, ContactError> {
        Self::of_contacts(scene, scene)
    }

    /// The same for a model with these contacts: of models of pairs, [those between both
    /// surfaces](Scene::of_contacts), whose critical interference and numbers of both surfaces it
    /// has. All other numbers are of one surface.
    ///
    /// # Errors
    /// The errors of [`of`](Self::of).
    fn of_contacts(scene: &Scene, contacts: &Scene) -> Result<Self, ContactError> {
        let asperity = contacts.asperity()?;
        let is_of_pair = contacts.surface != scene.surface;
        let whose = match (is_of_pair, scene.pair) {
            (false, _) => "",
            (true, None) => ", of one surface",
            (true, Some(_)) => ", of the surface that is equivalent to both",
        };
        let surface = &scene.surface;
        let mut check = Self::default();
        let (r, sigma) = (surface.asperity_radius, surface.asperity_height_std);
        check.add_number("equivalent_modulus", asperity.equivalent_modulus, "Pa", "E");
        check.add_number("equivalent_shear_modulus", asperity.equivalent_shear_modulus, "Pa", "G");
        let ratio = asperity.hardness.map(|hardness| hardness / asperity.equivalent_modulus);
        check.add_number("hardness", asperity.hardness, "Pa", "H of the softer body");
        let meaning = match contacts.interface.yield_strength {
            Some(_) => "S_y of the softer body",
            None => "S_y of the softer body, hardened: H/2.8",
        };
        check.add_number("yield_strength", asperity.yield_strength, "Pa", meaning);
        check.add_number("hardness_over_modulus", ratio, "", "H/E");
        // Elastic asperities have no critical interference.
        let critical = asperity.critical_interference().ok();
        let index = critical.map(|_| scene.plasticity_index()).transpose()?;
        let (of_radius, own) = match (is_of_pair, critical) {
            (true, Some(_)) => {
                let own = scene.asperity()?.critical_interference()?;
                let radius = asperity.radius;
                let of_radius =
                    format!(", with R = {radius:.4e} m of contacts between both surfaces");
                (of_radius, format!("{whose}, whose w_c is {own:.4e} m"))
            }
            _ => Default::default(),
        };
        let meaning = format!("w_c = (pi S H/(2 E))^2 R{of_radius}");
        check.add_number("critical_interference", critical, "m", meaning);
        let meaning = format!("F_c = (2/3) pi R w_c S H{of_radius}");
        check.add_number("critical_force", asperity.critical_force().ok(), "N", meaning);
        let meaning = format!("psi = sqrt(sigma_z/w_c), by Chang, Etsion & Bogy{own}");
        check.add_number("plasticity_index", index, "", meaning);
        check.add_number("work_of_adhesion", asperity.work_of_adhesion, "J/m2", "w_a");
        let meaning = format!(
            "(R w_a^2/(E^2 z0^3))^(1/3), z0 = 0.3 nm: {DMT} below {LEAST_TABOR}, {JKR} above {MOST_TABOR}"
        );
        check.add_number("tabor_parameter", asperity.tabor_parameter(), "", meaning);
        let meaning = "theta = E sigma_z^1.5/(w_a sqrt(R)): above 10 roughness hides adhesion";
        check.add_number("adhesion_parameter", scene.adhesion_parameter(), "", meaning);
        let moments = surface.moments();
        let gaussian = "of an isotropic Gaussian surface with these asperities";
        check.add_number("asperity_radius", r, "m", "R");
        check.add_number("asperity_density", surface.asperity_density, "1/m2", "eta");
        check.add_number("asperity_height_std", sigma, "m", "sigma_z, of the asperities");
        let skewness = match &scene.heights {
            HeightDistribution::Weibull(heights) => Some(heights.skewness()),
            _ => None,
        };
        let meaning = "of the asperity heights, which a Weibull density has; 0 for a Gaussian one";
        check.add_number("asperity_height_skewness", skewness, "", meaning);
        check.add_number("surface_height_std", moments.m0.sqrt(), "m", gaussian);
        check.add_number("rms_gradient", surface.rms_gradient(), "", gaussian);
        check.add_number("bandwidth", moments.bandwidth(), "", "alpha = m0 m4/m2^2, likewise");
        let beta = surface.roughness_parameter();
        let meaning = format!("beta_z = eta R sigma_z{whose}");
        check.add_number("roughness_parameter", beta, "", meaning);
        check.add_number("height_std_over_radius", sigma / r, "", "sigma_z/R");
        let above = "of the asperities above the mean plane";
        check.add_number("mean_plane_offset", scene.mean_plane_offset(), "m", above);
        let of_pair = |number: f64| is_of_pair.then_some(number);
        let std = of_pair(contacts.surface.asperity_height_std);
        let meaning = "sigma_z of both surfaces together, the unit of separations";
        check.add_number("pair_asperity_height_std", std, "m", meaning);
        let std = of_pair(contacts.surface_height_std());
        let meaning = "sigma of both surfaces together, the unit of films";
        check.add_number("pair_surface_height_std", std, "m", meaning);
        let offset = of_pair(contacts.mean_plane_offset());
        let meaning = "of the asperities of both surfaces above their mean planes";
        check.add_number("pair_mean_plane_offset", offset, "m", meaning);
        check.add_number("nominal_area", scene.nominal_area, "m2", "A_n");
        check.add_number("asperities", scene.asperities(), "", "eta A_n");
        check.extend(scene.findings());
        Ok(check)
    }
}

impl Plausible for Scene {
    fn findings(&self) -> Findings {
        let mut found = self.interface.findings();
        let surface = self.surface.findings();
        let area = roughness::of_area(self, &surface);
        found.extend(surface.into_iter().chain(area));
        let critical = self.asperity().and_then(|asperity| asperity.critical_interference());
        if let (true, Ok(w)) = (found.is_empty(), critical)
            && w < ATOMIC_DISTANCE
        {
            let advice = "below the distance of two atoms (0.3 nm) contacts are plastic from the onset of contact";
            let atomic = Finding::note(Code::Atomic, "critical_interference", w);
            found.push(atomic.usual([ATOMIC_DISTANCE, f64::INFINITY]).unit("m").advice(advice));
        }
        found.extend(which_adhesion(self));
        found
    }
}

/// A note on the models with adhesion that fit a scene.
fn which_adhesion(scene: &Scene) -> Option<Finding> {
    let tabor = scene.asperity().ok()?.tabor_parameter().filter(|tabor| *tabor > 0.0)?;
    let theta = scene.adhesion_parameter()?;
    let advice = match tabor {
        t if t <= LEAST_TABOR => format!("use {DMT}"),
        t if t >= MOST_TABOR => {
            format!("use {JKR}, or {JKR_SEPARATION} as the surfaces part")
        }
        _ => format!(
            "use {DMT} (for less than {LEAST_TABOR}) and {JKR} (for more than {MOST_TABOR}) as bounds"
        ),
    };
    let (theta, hides) = (short(theta), theta > Scene::HIDES_ADHESION);
    let limit = Scene::HIDES_ADHESION;
    let advice = match hides {
        true => format!(
            "roughness hides adhesion (adhesion_parameter is {theta}, above {limit}), and models without it hold; to include it, {advice}"
        ),
        false => format!(
            "{advice}; other models ignore work_of_adhesion, which matters here (adhesion_parameter is {theta}, below {limit})"
        ),
    };
    let found =
        Finding::note(Code::Adhesion, "tabor_parameter", tabor).usual([LEAST_TABOR, MOST_TABOR]);
    let fact = format!("the Tabor parameter is {}", short(tabor));
    Some(found.fact(fact).advice(advice))
}
