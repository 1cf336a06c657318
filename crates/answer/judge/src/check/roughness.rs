//! Plausibility of asperity sizes and numbers.

use super::Plausible;
use super::usual::{CHECK_UNIT, Input, SURFACE, implausible, in_other_units, within};
use asperity_core::{Code, Finding, Findings, Scene, Severity, Surface, short};

/// A_n from the tip of an instrument to a large flange.
const AREA: Input<'static> = Input::new(
    "nominal_area",
    [1e-16, 0.03],
    "m2",
    &[("mm2", 1e-6), ("cm2", 1e-4), ("um2", 1e-12)],
);
/// σ_z \[m\] of a typical machined surface.
const MICRON: f64 = 1e-6;
/// Largest σ_z \[m\] of most surfaces.
const COARSE: f64 = 1e-4;
/// Factor outside the usual range from which β is a warning.
const RARE: f64 = 5.0;
/// Largest plausible A_n of a joint \[m²\].
const FIELD: f64 = 1.0;
/// Numbers of asperities below which the average is meaningless, uncertain, and accurate.
const POPULATION: [f64; 3] = [30.0, 300.0, 1000.0];

impl Plausible for Surface {
    /// With the units in which the numbers would make a surface.
    fn findings(&self) -> Findings {
        let is_within = |of: &Self, factor: f64| {
            criteria(of).iter().all(|(input, value, _)| {
                within(*value, [input.usual[0] / factor, input.usual[1] * factor])
            })
        };
        // Another unit is off by orders of magnitude. Two numbers outside their ranges have the
        // same cause; fine but wide waves have them, too.
        let is_odd = |(input, value, _): &(Input<'_>, f64, _)| !within(*value, input.usual);
        let odd = criteria(self)[..3].iter().filter(|number| is_odd(number)).count();
        let is_coarse = odd > 1 && self.asperity_height_std > COARSE;
        if is_within(self, 10.0) && !is_coarse {
            return plain_findings(self);
        }
        let [std, radius, density, ..] = SURFACE;
        let numbers = [
            (std, self.asperity_height_std),
            (radius, self.asperity_radius),
            (density, self.asperity_density),
        ];
        let found = [1.0, 10.0].into_iter().find_map(|factor| {
            let found = in_other_units(&numbers, |of, units| {
                // Either one number is wrong, or both lengths have one unit.
                let [std, radius] = [0, 1].map(|k| units[k].map(|(name, _)| name));
                let is_likely = std == radius || units.iter().flatten().count() == 1;
                let is_surface = is_within(&Self::new(of[1], of[2], of[0]), factor);
                (is_likely && is_surface).then(|| (of[0] / MICRON).ln().abs())
            });
            (!found.is_empty()).then_some(found)
        });
        let Some(found) = found else { return plain_findings(self) };
        let odd = criteria(self).into_iter().rfind(is_odd).map(|(input, value, _)| {
            let ([from, to], value) = (input.usual.map(short), short(value));
            format!("{} is {value}, where {from} to {to} is usual; {CHECK_UNIT}", input.field)
        });
        let advice = odd.unwrap_or_default();
        found.into_iter().map(|found| found.advice(advice.clone())).collect()
    }
}

/// Criteria, with the values of this surface and the advice where they are unusual.
fn criteria(surface: &Surface) -> [(Input<'static>, f64, &'static str); 6] {
    let derived = |field, usual| Input::new(field, usual, "", &[]);
    let [std, radius, density, ..] = SURFACE;
    [
        (std, surface.asperity_height_std, CHECK_UNIT),
        (radius, surface.asperity_radius, CHECK_UNIT),
        (density, surface.asperity_density, CHECK_UNIT),
        (
            derived("roughness_parameter", Surface::USUAL_ASPERITY_ROUGHNESS),
            surface.roughness_parameter(),
            "one of asperity_density, asperity_radius and asperity_height_std is wrong, or the scan is noisy or too coarse",
        ),
        (
            derived("height_std_over_radius", [0.0, 1.0]),
            surface.asperity_height_std / surface.asperity_radius,
            "the asperities would be needles, not spherical caps",
        ),
        (
            derived("rms_gradient", [0.0, 1.0]),
            surface.rms_gradient(),
            "half-space contact assumes slopes well below 1",
        ),
    ]
}

/// Findings of each number outside its range without a likely unit, as for asperities that
/// follow from other numbers.
#[must_use]
pub fn plain_findings(surface: &Surface) -> Findings {
    let odd = criteria(surface).into_iter().filter(|(input, x, _)| !within(*x, input.usual));
    let found = |(input, value, advice): (Input<'_>, f64, &'static str)| {
        let found = input.in_unit(value, None).advice(advice);
        match input.field {
            // Below that factor the laws remain valid.
            "roughness_parameter" if found.excess() <= RARE => found.severity(Severity::Note),
            _ => found,
        }
    };
    odd.map(found).collect()
}

/// A finding for an unusual nominal area, alone or for its number of asperities. Beside findings
/// `of_surface`, whose density may be wrong, only an area that is impossible has one.
pub(crate) fn of_area(scene: &Scene, of_surface: &Findings) -> Option<Finding> {
    let (area, density) = (scene.nominal_area, scene.surface.asperity_density);
    let is_odd = !of_surface.is_empty();
    let has_unit = of_surface.iter().any(|found| found.likely_unit.is_some());
    let (count, least) = (area * density, if is_odd { 1.0 } else { POPULATION[1] });
    let of = |severity, usual: [f64; 2], meaning: String| {
        let is_usual = |a: f64| within(a, AREA.usual) && (is_odd || a * density >= POPULATION[2]);
        // Of a small area, the number of asperities counts.
        let units = AREA.units.iter().filter(|_| area > AREA.usual[1]);
        let unit = units.copied().find(|(_, size)| is_usual(area * size));
        let found = Input { usual, ..AREA }.in_unit(area, unit).advice(meaning);
        found.severity(severity).implausible(implausible(area, [0.0, FIELD]))
    };
    match area {
        a if a > FIELD => Some(of(Severity::Warning, AREA.usual, "no joint is so large".into())),
        a if a > AREA.usual[1] && !is_odd => {
            Some(of(Severity::Note, AREA.usual, "few joints are so large".into()))
        }
        _ if has_unit || count >= least => None,
        _ => {
            let few = count < POPULATION[0];
            let severity = if few { Severity::Warning } else { Severity::Note };
            let usual = [POPULATION[1] / density, f64::INFINITY];
            let text =
                format!("the area holds {} asperities, too few for an average", short(count));
            let mut found = of(severity, usual, text);
            found.code = Code::FewAsperities;
            Some(found)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_in_millimetres_are_implausible_with_that_unit() {
        let units = |surface: Surface| {
            let found = surface.findings();
            assert!(found.are_implausible(), "{found:?}");
            found.iter().map(|found| found.likely_unit.clone().unwrap()).collect::<Vec<_>>()
        };
        let mm = units(Surface::new(0.08, 800.0, 0.0008));
        let wanted = ["8e-4 mm is 8e-7 m", "0.08 mm is 8e-5 m", "800 1/mm2 is 8e8 1/m2"];
        assert!(mm.iter().zip(wanted).all(|(found, end)| found.ends_with(end)), "{mm:?}");
        let um = units(Surface::new(80.0, 8e-4, 0.8));
        assert!(um[0].contains("like um") && um[2].contains("like 1/um2"), "{um:?}");
    }

    #[test]
    fn a_number_that_is_large_in_its_unit_as_well_has_that_unit() {
        let found = &Surface::new(8e-5, 8e8, 8.0).findings()[0];
        assert!(found.to_string().ends_with("8 um is 8e-6 m"), "{found}");
    }

    #[test]
    fn an_area_that_no_joint_has_is_said_beside_a_wrong_surface() {
        let interface = asperity_core::Interface::new(1e11, 0.3, 1e9);
        let areas = |area: f64| -> Vec<String> {
            let scene = Scene::new(interface, Surface::new(0.05, 800.0, 0.02), area);
            let found = scene.findings().into_iter();
            found.filter(|f| f.field == "nominal_area").map(|f| f.to_string()).collect()
        };
        assert!(areas(4e-4)[0].contains("holds 0.32 asperities, too few"), "{:?}", areas(4e-4));
        assert!(areas(400.0)[0].ends_with("400 looks like mm2; 400 mm2 is 4e-4 m2"));
        assert_eq!(areas(0.02), [""; 0]);
    }
}
