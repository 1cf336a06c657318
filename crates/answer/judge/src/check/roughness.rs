//! Plausibility of asperity sizes and numbers.

use super::Plausible;
use super::usual::unusual;
use asperity_core::{Code, Finding, Findings, Scene, Severity, Surface, short};

/// Factor outside the usual range from which β is a warning.
const RARE: f64 = 5.0;
/// Largest plausible A_n of a joint \[m²\].
const FIELD: f64 = 1.0;
/// Numbers of asperities below which the average is meaningless, and uncertain.
const POPULATION: [f64; 2] = [30.0, 300.0];

impl Plausible for Surface {
    fn findings(&self) -> Findings {
        let advised = |field, value, advice: &'static str| {
            unusual(field, value).map(|found| found.advice(advice))
        };
        let numbers = [
            unusual("asperity_height_std", self.asperity_height_std),
            unusual("asperity_radius", self.asperity_radius),
            unusual("asperity_density", self.asperity_density),
        ];
        // A number in another unit explains what follows from it.
        let of_numbers: Findings = numbers.into_iter().flatten().collect();
        if of_numbers.iter().any(|found| found.likely_unit.is_some()) {
            return of_numbers;
        }
        let beta = advised(
            "roughness_parameter",
            self.roughness_parameter(),
            "one of asperity_density, asperity_radius and asperity_height_std is wrong, or the scan is noisy or too coarse",
        );
        let beta = beta.map(|found| match found.excess() <= RARE {
            // Below that factor the laws remain valid.
            true => found.severity(Severity::Note),
            false => found,
        });
        let needles = advised(
            "height_std_over_radius",
            self.asperity_height_std / self.asperity_radius,
            "the asperities would be needles, not spherical caps",
        );
        let steep = advised(
            "rms_gradient",
            self.rms_gradient(),
            "half-space contact assumes slopes well below 1",
        );
        of_numbers.into_iter().chain([beta, needles, steep].into_iter().flatten()).collect()
    }
}

/// A finding for an unusual nominal area, alone or for its number of asperities. Beside findings
/// `of_surface`, whose density may be wrong, only an area that is impossible has one.
pub(crate) fn of_area(scene: &Scene, of_surface: &Findings) -> Option<Finding> {
    let (area, density) = (scene.nominal_area, scene.surface.asperity_density);
    let large = unusual("nominal_area", area).filter(|found| area > found.usual[1]);
    let is_odd = !of_surface.is_empty();
    match large {
        Some(found) if area > FIELD => return Some(found.advice("no joint is so large")),
        Some(found) if !is_odd => {
            let found = found.severity(Severity::Note).implausible(false);
            return Some(found.advice("few joints are so large"));
        }
        _ => {}
    }
    let has_unit = of_surface.iter().any(|found| found.likely_unit.is_some());
    let (count, least) = (area * density, if is_odd { 1.0 } else { POPULATION[1] });
    let few = Finding::warning(Code::FewAsperities, "nominal_area", area)
        .unit("m2")
        .usual([POPULATION[1] / density, f64::INFINITY])
        .severity(if count < POPULATION[0] { Severity::Warning } else { Severity::Note })
        .advice(format!("the area holds {} asperities, too few for an average", short(count)));
    (!has_unit && count < least).then_some(few)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_that_no_joint_has_is_said_beside_a_wrong_surface() {
        let interface = asperity_core::Interface::new(1e11, 0.3, 1e9);
        let units = |area: f64| -> Vec<Option<String>> {
            let scene = Scene::new(interface, Surface::new(0.05, 800.0, 0.02), area);
            let found = scene.findings().into_iter();
            found.filter(|f| f.field == "nominal_area").map(|f| f.likely_unit).collect()
        };
        assert!(units(400.0)[0].as_ref().is_some_and(|unit| unit.ends_with("is 4e-4 m2")));
        assert!(units(0.02).is_empty());
    }
}
