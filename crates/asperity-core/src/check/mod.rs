//! A scene that is looked at before it is believed: what follows from its numbers, and which of
//! them are those of no surface, no material, or of none that a model is made for.

mod answer;
mod interferences;
mod materials;
mod roughness;
mod units;

use std::borrow::Cow;

use serde::{Serialize, Serializer};

use crate::diagnostic::short;
use crate::{ContactError, Diagnostic, Diagnostics, HeightDistribution, Scene};

/// A number that follows from a scene.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DerivedNumber {
    /// Its name, as in tables: `plasticity_index`.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// Its SI unit; empty for pure numbers.
    pub unit: &'static str,
    /// What it is, with its formula.
    pub meaning: Cow<'static, str>,
}

/// What a look at a scene, or at an answer, has shown.
///
/// ```
/// use asperity_core::{Interface, Scene, Severity, Surface};
///
/// // The modulus is in GPa.
/// let scene = Scene::new(Interface::new(116.0, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
/// let check = scene.check()?;
/// let finding = &check.findings[0];
/// assert_eq!((finding.severity, &*finding.field), (Severity::Error, "equivalent_modulus"));
/// assert!(finding.message().ends_with("116 looks like GPa; 116 GPa is 1.16e11 Pa"));
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Check {
    /// What follows from the inputs.
    #[serde(serialize_with = "as_map")]
    pub numbers: Vec<DerivedNumber>,
    /// What is unusual, most severe first.
    pub findings: Diagnostics,
}

fn as_map<S: Serializer>(numbers: &[DerivedNumber], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(numbers.iter().map(|number| (number.name, number.value)))
}

impl Check {
    /// The value of a number, by its name.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().find(|number| number.name == name).map(|number| number.value)
    }

    /// Adds findings, one for each cause.
    pub fn extend(&mut self, findings: impl IntoIterator<Item = Diagnostic>) {
        self.findings.extend(findings);
        self.findings = std::mem::take(&mut self.findings).by_cause();
    }

    /// Adds a number.
    pub fn say(
        &mut self,
        name: &'static str,
        value: f64,
        unit: &'static str,
        meaning: impl Into<Cow<'static, str>>,
    ) {
        self.numbers.push(DerivedNumber { name, value, unit, meaning: meaning.into() });
    }
}

/// Tabor's parameter up to which DMT holds, and from which on JKR does.
const DMT: f64 = 0.1;
const JKR: f64 = 5.0;

/// Below this w_c \[m\] asperities would yield before they approach by the distance of two atoms.
const ATOM: f64 = 3e-10;

impl Scene {
    /// What follows from the scene, and what is unusual about it. Sizes are held against those of
    /// engineering materials and surfaces, from elastomers to ceramics and from micro-machines to
    /// blasted steel; where a power of ten explains one that is not, the likely unit is named.
    ///
    /// # Errors
    /// [`ContactError`] naming an input that is no scene's: a negative length, say.
    pub fn check(&self) -> Result<Check, ContactError> {
        let asperity = self.asperity()?;
        let surface = &self.surface;
        let mut check = Check::default();
        let (r, sigma) = (surface.asperity_radius, surface.asperity_height_std);
        check.say("equivalent_modulus", asperity.equivalent_modulus, "Pa", "E");
        if let Some(shear) = asperity.equivalent_shear_modulus {
            check.say("equivalent_shear_modulus", shear, "Pa", "G");
        }
        if let (Some(hardness), Some(yields)) = (asperity.hardness, asperity.yield_strength) {
            let ratio = hardness / asperity.equivalent_modulus;
            check.say("hardness", hardness, "Pa", "H of the softer body");
            check.say("yield_strength", yields, "Pa", "S_y of the softer body");
            check.say("hardness_over_modulus", ratio, "", "H/E");
            // Where asperities never yield there is none.
            if let (Ok(w), Ok(f)) = (asperity.critical_interference(), asperity.critical_force()) {
                check.say("critical_interference", w, "m", "w_c = (pi S H/(2 E))^2 R");
                check.say("critical_force", f, "N", "F_c = (2/3) pi R w_c S H");
                let index = (sigma / w).sqrt();
                let meaning = "psi = sqrt(sigma_z/w_c), as Chang, Etsion & Bogy have it";
                check.say("plasticity_index", index, "", meaning);
            }
        }
        if let (Some(work), Some(tabor)) = (asperity.work_of_adhesion, asperity.tabor_parameter()) {
            check.say("work_of_adhesion", work, "J/m2", "w_a");
            let meaning = "(R w_a^2/(E^2 z0^3))^(1/3), z0 = 0.3 nm: dmt below 0.1, jkr above 5";
            check.say("tabor_parameter", tabor, "", meaning);
            if let Some(stiff) = self.adhesion_parameter() {
                let meaning =
                    "theta = E sigma_z^1.5/(w_a sqrt(R)): above 10 roughness hides adhesion";
                check.say("adhesion_parameter", stiff, "", meaning);
            }
        }
        let moments = surface.moments();
        let gaussian = "of an isotropic Gaussian surface with these asperities";
        check.say("asperity_radius", r, "m", "R");
        check.say("asperity_density", surface.asperity_density, "1/m2", "eta");
        check.say("asperity_height_std", sigma, "m", "sigma_z, of the asperities");
        if let HeightDistribution::Weibull(heights) = &self.heights {
            let meaning =
                "of the asperity heights, which a Weibull density has; 0 for a Gaussian one";
            check.say("asperity_height_skewness", heights.skewness(), "", meaning);
        }
        check.say("surface_height_std", moments.m0.sqrt(), "m", gaussian);
        check.say("rms_slope", surface.rms_slope(), "", gaussian);
        check.say("bandwidth", moments.bandwidth(), "", "alpha = m0 m4/m2^2, likewise");
        check.say(
            "roughness_parameter",
            surface.roughness_parameter(),
            "",
            "beta_z = eta R sigma_z",
        );
        check.say("height_std_over_radius", sigma / r, "", "sigma_z/R");
        check.say(
            "mean_plane_offset",
            self.mean_plane_offset(),
            "m",
            "of the asperities above the mean plane",
        );
        check.say("nominal_area", self.nominal_area, "m2", "A_n");
        check.say("asperities", self.asperities(), "", "eta A_n");
        check.extend(self.findings());
        Ok(check)
    }

    /// What is unusual about the numbers of the scene, by themselves and for each other; nothing
    /// for most scenes. Cheap enough to be asked of every scene of a study.
    #[must_use]
    pub fn findings(&self) -> Diagnostics {
        let mut found = self.interface.findings();
        let surface = self.surface.findings();
        let area = surface.is_empty().then(|| roughness::of_area(self)).flatten();
        found.extend(surface.into_iter().chain(area));
        let critical = self.asperity().and_then(|asperity| asperity.critical_interference());
        if let (true, Ok(w)) = (found.is_empty(), critical)
            && w < ATOM
        {
            let advice = "below the distance of two atoms (0.3 nm) contacts are plastic from the first touch";
            let atomic = Diagnostic::note("atomic", "critical_interference", w);
            found.push(atomic.usual([ATOM, f64::INFINITY]).unit("m").advice(advice));
        }
        found.extend(self.which_adhesion());
        found
    }

    /// Which models know the scene's work of adhesion, and which of them is made for it.
    fn which_adhesion(&self) -> Option<Diagnostic> {
        let tabor = self.asperity().ok()?.tabor_parameter().filter(|tabor| *tabor > 0.0)?;
        let theta = self.adhesion_parameter()?;
        let advice = match tabor {
            t if t <= DMT => "use dmt",
            t if t >= JKR => "use jkr, or jkr-separation as the surfaces part",
            _ => "between dmt (below 0.1) and jkr (above 5); use both as bounds",
        };
        let advice = format!(
            "{advice}, as other models ignore work_of_adhesion; adhesion_parameter is {}, and above {} roughness hides adhesion",
            short(theta),
            Self::HIDES_ADHESION
        );
        let found = Diagnostic::note("adhesion", "tabor_parameter", tabor).usual([DMT, JKR]);
        let fact = format!("tabor_parameter is {}", short(tabor));
        Some(found.fact(fact).advice(advice))
    }
}
