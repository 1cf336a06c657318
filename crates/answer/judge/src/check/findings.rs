//! Findings about a model's answer at a place.

use crate::recommended::{ADHESIVE, DMT, JKR, WHOLE_SURFACE, YIELDING};
use asperity_core::{Advice, At, Code, ContactModel, Finding, KnownDefect, Scene, Severity, short};

/// Area fraction above which asperities interact.
const CROWDED: f64 = 0.1;
/// Number of contacts below which a single realisation differs much from the average.
pub(super) const FEW: f64 = 30.0;
/// Largest plausible p/H; plastic contacts of JG and AF, whose p/H rises with w, are below.
const PLASTIC: f64 = 1.5;
/// Share of the force on yielding asperities (note, warning), which an elastic law ignores.
const YIELDS: [f64; 2] = [0.02, 0.1];
/// Share of the force in the range of a known defect of the law.
const MISSED: f64 = 0.2;
/// Share of the force beyond the fitted range of a law.
const BEYOND: f64 = 0.02;
/// Adhesion parameter above which roughness hides adhesion.
const HIDDEN: f64 = Scene::HIDES_ADHESION;

/// A model on a scene at a place, whose answer is judged.
#[derive(Debug, Clone, Copy)]
pub(super) struct Answer<'a> {
    pub(super) model: &'a dyn ContactModel,
    pub(super) scene: &'a Scene,
    pub(super) at: At,
}

impl Answer<'_> {
    pub(super) fn warning(self, code: Code, field: &'static str, value: f64) -> Finding {
        Finding::warning(code, field, value).of_model(self.model.id()).at(self.at)
    }

    /// A warning if the model ignores the scene's adhesion or is outside its range of adhesion.
    pub(super) fn sticks(self) -> Option<Finding> {
        let theta = self.scene.adhesion_parameter().filter(|theta| *theta < HIDDEN)?;
        let Some([least, most]) = self.model.validity().tabor else {
            let found = Finding::warning(Code::Sticks, "adhesion_parameter", theta)
                .usual([HIDDEN, f64::INFINITY])
                .of_model(self.model.id())
                .advice("this model ignores work_of_adhesion, which matters here")
                .to_do(Advice::UseModels(ADHESIVE));
            return Some(found);
        };
        let tabor = self.scene.asperity().ok()?.tabor_parameter()?;
        let other = if tabor > most { JKR } else { DMT };
        let found = Finding::warning(Code::Tabor, "tabor_parameter", tabor)
            .usual([least, most])
            .of_model(self.model.id())
            .advice("outside the range of this model")
            .to_do(Advice::UseModels(other));
        (!(least..=most).contains(&tabor)).then_some(found)
    }

    /// A finding for a load on yielding asperities with an elastic model.
    pub(super) fn yields(self, share: f64) -> Option<Finding> {
        let adhesive = self.model.validity().adhesive;
        let others = match adhesive {
            true => format!(
                "; no model has both yielding and adhesion; where roughness hides adhesion (adhesion_parameter above {HIDDEN}), use {YIELDING}"
            ),
            false => String::new(),
        };
        let carriers = match self.model.validity().asperities {
            true => "yielding asperities",
            false => "pressures above the hardness",
        };
        let (severity, chance) = match share > YIELDS[1] {
            true => (Severity::Warning, ", and its area is right only by chance"),
            false => (Severity::Note, ""),
        };
        let found = self
            .warning(Code::Yields, "yielding_share", share)
            .severity(severity)
            .usual([0.0, YIELDS[0]])
            .fact(format!("{carriers} carry {} % of the force", short(100.0 * share.min(1.0))))
            .advice(format!("{} ignores yielding{chance}{others}", self.model.id()));
        let found = if adhesive { found } else { found.to_do(Advice::UseModels(YIELDING)) };
        (share > YIELDS[0]).then_some(found)
    }

    /// A finding for a load in the range of a known defect of the law.
    pub(super) fn missed(self, share: f64, defect: &KnownDefect) -> Option<Finding> {
        let KnownDefect { from, to, summary } = defect;
        let percent = short(100.0 * share);
        let found = self.warning(Code::FitMisses, "missed_share", share)
            .usual([0.0, MISSED])
            .fact(format!(
                "asperities with interferences from {from} to {to} w_c carry {percent} % of the force"
            ))
            .advice(format!("{} {summary}", self.model.id()));
        (share > MISSED).then_some(found)
    }

    /// A finding for a load beyond the fitted range of a law; `x` is the largest relevant w/w_c.
    pub(super) fn beyond_fit(
        self,
        (share, x): (f64, f64),
        holds_to: f64,
        plastic: bool,
    ) -> Option<Finding> {
        let continued = if plastic { "assumes full plasticity" } else { "is extrapolated" };
        let (name, limit, percent) = (self.model.id(), short(holds_to), short(100.0 * share));
        let found = self
            .warning(Code::BeyondFit, "interference_over_critical", x)
            .severity(Severity::Note)
            .usual([0.0, holds_to])
            .fact(format!(
                "asperities with interferences beyond {limit} w_c carry {percent} % of the force"
            ))
            .advice(format!("beyond this interference {name} {continued}"));
        (share > BEYOND).then_some(found)
    }

    /// A warning where contacts merge, or where the asperities have more area than there is.
    pub(super) fn crowded(self, fraction: f64) -> Option<Finding> {
        let (area, meaning) = match fraction {
            f if f > 1.0 => (format!("{} times", short(f)), "no contact has so much"),
            f => (format!("{} % of", short(100.0 * f)), "contacts merge"),
        };
        let found = self
            .warning(Code::Crowded, "area_fraction", fraction)
            .usual([0.0, CROWDED])
            .fact(format!("the real area is {area} the nominal area"))
            .advice(format!("{meaning}, and models of independent asperities do not hold"))
            .to_do(Advice::UseModels(WHOLE_SURFACE));
        (fraction > CROWDED).then_some(found)
    }

    /// A warning for a mean pressure that exceeds any hardness.
    pub(super) fn above_hardness(self, ratio: f64) -> Option<Finding> {
        let found = self
            .warning(Code::AboveHardness, "mean_pressure_over_hardness", ratio)
            .usual([0.0, PLASTIC])
            .fact(format!(
                "the mean pressure on the real area is {} times the hardness",
                short(ratio)
            ))
            .advice("the contacts would yield, and the real area is larger")
            .to_do(Advice::UseModels(YIELDING));
        (ratio > PLASTIC).then_some(found)
    }

    pub(super) fn few(self, contacts: f64) -> Finding {
        self.warning(Code::FewContacts, "contacts", contacts)
            .usual([FEW, f64::INFINITY])
            .fact(format!("about {} asperities touch", short(contacts)))
            .advice(format!(
                "with fewer than {FEW}, samples of one surface differ more than the models do"
            ))
    }

    /// A warning for a load that no contact carries: a mean pressure above the hardness or, for
    /// elastic bodies, a pressure on the real area above the equivalent modulus. Full contact of a
    /// soft body below its modulus is possible.
    pub(super) fn beyond_full_contact(
        self,
        [pressure, area_fraction]: [f64; 2],
    ) -> Option<Finding> {
        let (value, limit, area, name, advice) = match self.scene.interface.softer_hardness() {
            Some(hardness) => {
                let advice =
                    "full contact carries no more; check the units of load and nominal area";
                (pressure, hardness, "nominal", "hardness", advice)
            }
            None => {
                let (limit, name) = (self.scene.interface.equivalent_modulus, "equivalent modulus");
                let advice =
                    "small strains do not hold; check the units of load, nominal area and modulus";
                (pressure / area_fraction, limit, "real", name, advice)
            }
        };
        let [shown, most] = [value, limit].map(short);
        let found = self
            .warning(Code::BeyondFullContact, "pressure", value)
            .usual([0.0, limit])
            .unit("Pa")
            .fact(format!(
                "the mean pressure on the {area} area is {shown} Pa, above the {name} ({most} Pa)"
            ))
            .advice(advice);
        (value > limit).then_some(found)
    }
}

/// The share of the load that an elastic theory of the whole surface puts on pressures above this
/// multiple of the mean pressure: pressures of small contact areas follow Rayleigh's distribution
/// (Persson 2001) \[derived\].
pub(super) fn share_above(multiple: f64) -> f64 {
    let x = 0.5 * std::f64::consts::PI.sqrt() * multiple;
    libm::erfc(x) + std::f64::consts::FRAC_2_SQRT_PI * x * (-x * x).exp()
}
