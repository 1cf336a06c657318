//! Plausibility of asperity sizes and numbers.

use super::units::{AREAS, DENSITIES, LENGTHS, Unit, likely_unit};
use super::usual::{CHECK_UNIT, severity, within};
use crate::finding::{FEW_ASPERITIES, short};
use crate::{Finding, Findings, Scene, Severity, Surface};

/// R \[m\], from a sharp tip to a lens.
const RADIUS: [f64; 2] = [2e-9, 5e-2];
/// η \[1/m²\], from the stones of asphalt, a centimetre apart, to atomic corrugation.
const DENSITY: [f64; 2] = [5e3, 1e16];
/// σ_z \[m\], from cleaved mica to the texture of asphalt.
const HEIGHT_STD: [f64; 2] = [3e-11, 2e-3];
/// σ_z \[m\] of a typical machined surface.
const MICRON: f64 = 1e-6;
/// Factor outside the usual range from which β is a warning.
const RARE: f64 = 5.0;
/// A_n \[m²\], from the tip of an instrument to a large flange.
const AREA: [f64; 2] = [1e-16, 0.03];
/// σ_z \[m\] of surfaces, from polished to rough, of which a length in another unit is not one.
const FINE: f64 = 1e-9;
const COARSE: f64 = 1e-4;
/// Largest plausible A_n of a joint \[m²\].
const FIELD: f64 = 1.0;
/// Numbers of asperities below which the average is meaningless, and uncertain.
const POPULATION: [f64; 2] = [30.0, 300.0];

impl Surface {
    /// √(2 m₂) of an isotropic Gaussian surface with these asperities: its rms slope.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        (2.0 * self.moments().m2).sqrt()
    }

    /// Findings of numbers outside the range of any surface.
    #[must_use]
    pub fn findings(&self) -> Findings {
        if makes_sense(self) {
            return Findings::default();
        }
        let is_possible = |other: &Self| other.severity() != Severity::Error;
        let found = self.slip(makes_sense).or_else(|| self.in_one_unit()).or_else(|| {
            (self.severity() == Severity::Error).then(|| self.slip(is_possible)).flatten()
        });
        found.map_or_else(|| self.apart(), |found| vec![found]).into_iter().collect()
    }

    /// The finding of the one number that in another unit makes a surface that `is_usual`; `None`
    /// if there is none. Another unit is off by orders of magnitude: an error.
    fn slip(&self, is_usual: fn(&Self) -> bool) -> Option<Finding> {
        let one = |field, value, usual, units: &[Unit], si, set: fn(&mut Self, f64)| {
            let unit = likely_unit(value, units, si, |x| {
                let mut other = *self;
                set(&mut other, x);
                is_usual(&other)
            });
            let found = Finding::error(CODE, field, value).usual(usual).unit(si);
            unit.map(|unit| found.advice(CHECK_UNIT).likely_unit(unit))
        };
        let &Self { asperity_height_std: std, asperity_radius: radius, .. } = self;
        let density = self.asperity_density;
        let slips = [
            one("asperity_height_std", std, HEIGHT_STD, LENGTHS, "m", |s, x| {
                s.asperity_height_std = x;
            }),
            one("asperity_radius", radius, RADIUS, LENGTHS, "m", |s, x| s.asperity_radius = x),
            one("asperity_density", density, DENSITY, DENSITIES, "1/m2", |s, x| {
                s.asperity_density = x;
            }),
        ];
        // The number farthest from the middle of its range is reported.
        let distance = |found: &Finding| {
            let ([from, to], value) = (found.usual, found.value);
            ((value / from).ln() + (value / to).ln()).abs() / (to / from).ln()
        };
        let worst = slips.into_iter().flatten().max_by(|a, b| distance(a).total_cmp(&distance(b)));
        worst.map(|found| match within(found.value, found.usual) {
            true => {
                let fact = format!("`{}` is {} {}, ", found.field, short(found.value), found.unit);
                found.fact(fact + &self.together())
            }
            false => found,
        })
    }

    /// The most severe of the criteria: numbers ten times outside their ranges are errors.
    fn severity(&self) -> Severity {
        let sizes = self.criteria().into_iter().map(|(_, value, usual, ..)| severity(value, usual));
        sizes.min().unwrap_or(Severity::Warning)
    }

    /// A finding if all lengths are plausible in another common unit, with densities in its square
    /// or in another unit; of several, that with the height nearest to 1 um.
    fn in_one_unit(&self) -> Option<Finding> {
        let scaled = |length: f64, density: f64| Self {
            asperity_radius: length * self.asperity_radius,
            asperity_density: density * self.asperity_density,
            asperity_height_std: length * self.asperity_height_std,
        };
        let same =
            LENGTHS.iter().map(|(name, unit)| (*name, *unit, format!("1/{name}2"), unit.powi(-2)));
        let others = LENGTHS.iter().flat_map(|(name, unit)| {
            DENSITIES.iter().map(|(inverse, density)| (*name, *unit, inverse.to_string(), *density))
        });
        let makes_sense =
            |(_, length, _, density): &(_, f64, _, f64)| makes_sense(&scaled(*length, *density));
        let std = self.asperity_height_std;
        let order = |(_, length, ..): &(_, f64, String, f64)| (length * std / MICRON).ln().abs();
        let nearest = |a: &_, b: &_| order(a).total_cmp(&order(b));
        let (name, _, inverse, _) = same
            .filter(makes_sense)
            .min_by(nearest)
            .or_else(|| others.filter(makes_sense).min_by(nearest))?;
        // Two numbers outside their ranges have the same cause; fine but wide waves have them, too.
        let sizes = self.criteria().into_iter().take(3);
        let odd = sizes.filter(|(_, value, usual, ..)| !within(*value, *usual)).count();
        let is_unit = odd > 1 && !(FINE..COARSE).contains(&std);
        let severity = if is_unit { Severity::Error } else { self.severity() };
        let found = Finding::warning(CODE, "asperity_height_std", std)
            .usual(HEIGHT_STD)
            .severity(severity)
            .fact(format!(
                "`asperity_height_std` is {} m, `asperity_radius` {} m",
                short(std),
                short(self.asperity_radius)
            ))
            .advice("check the numbers and their units")
            .likely_unit(format!(
                "all lengths look like {name}, and the density {} like {inverse}; give m and 1/m2",
                short(self.asperity_density)
            ));
        Some(found)
    }

    /// Criteria: field, value, usual range, unit and advice.
    fn criteria(&self) -> [(&'static str, f64, [f64; 2], &'static str, &'static str); 6] {
        let ratio = self.asperity_height_std / self.asperity_radius;
        let beta = self.roughness_parameter();
        let together = "one of `asperity_density`, `asperity_radius` and `asperity_height_std` is wrong, or the scan is noisy or too coarse";
        [
            ("asperity_height_std", self.asperity_height_std, HEIGHT_STD, "m", CHECK_UNIT),
            ("asperity_radius", self.asperity_radius, RADIUS, "m", CHECK_UNIT),
            ("asperity_density", self.asperity_density, DENSITY, "1/m2", CHECK_UNIT),
            ("roughness_parameter", beta, Self::USUAL_ASPERITY_ROUGHNESS, "", together),
            (
                "height_std_over_radius",
                ratio,
                [0.0, 1.0],
                "",
                "the asperities would be needles, not spherical caps",
            ),
            (
                "rms_slope",
                self.rms_slope(),
                [0.0, 1.0],
                "",
                "half-space contact assumes slopes well below 1",
            ),
        ]
    }

    /// Findings of each number alone, without a likely unit.
    fn apart(&self) -> Vec<Finding> {
        let unusual = |(_, value, usual, ..): &(_, f64, [f64; 2], _, _)| !within(*value, *usual);
        let found = |(field, value, usual, unit, advice)| {
            let found = Finding::warning(CODE, field, value).usual(usual);
            let severity = match field {
                "roughness_parameter" if found.excess() > RARE => Severity::Warning,
                // The laws remain valid.
                "roughness_parameter" => Severity::Note,
                _ => severity(value, usual),
            };
            found.severity(severity).unit(unit).advice(advice)
        };
        self.criteria().into_iter().filter(unusual).map(found).collect()
    }

    /// The unusual combination of numbers that are usual alone.
    fn together(&self) -> String {
        let (name, value, [from, to]) = match self.roughness_parameter() {
            beta if within(beta, Self::USUAL_ASPERITY_ROUGHNESS) => {
                ("the rms slope", self.rms_slope(), [0.0, 1.0])
            }
            beta => ("density x radius x `height_std`", beta, Self::USUAL_ASPERITY_ROUGHNESS),
        };
        let value = short(value);
        format!("which makes {name} {value} (usual: {} to {})", short(from), short(to))
    }
}

const CODE: &str = "unusual-size";

fn makes_sense(surface: &Surface) -> bool {
    within(surface.asperity_height_std, HEIGHT_STD)
        && within(surface.asperity_radius, RADIUS)
        && within(surface.asperity_density, DENSITY)
        && within(surface.roughness_parameter(), Surface::USUAL_ASPERITY_ROUGHNESS)
        && surface.asperity_height_std <= surface.asperity_radius
        && surface.rms_slope() <= 1.0
}

/// A finding for an unusual nominal area, alone or for its number of asperities. Beside findings
/// `of_surface`, whose density may be wrong, only an area that is impossible has one.
pub(crate) fn of_area(scene: &Scene, of_surface: &Findings) -> Option<Finding> {
    let (area, density) = (scene.nominal_area, scene.surface.asperity_density);
    let has_unit = of_surface.iter().any(|found| found.likely_unit.is_some());
    let population = if has_unit { 0.0 } else { POPULATION[1] / density };
    let enough = AREA[0].max(population);
    let usual = [enough, if enough < AREA[1] { AREA[1] } else { f64::INFINITY }];
    let odd_surface = !of_surface.is_empty();
    let is_possible = area <= FIELD && (has_unit || area * density >= 1.0);
    if within(area, [enough, AREA[1]]) || odd_surface && is_possible {
        return None;
    }
    let least = if odd_surface { AREA[0] } else { 1000.0 / density };
    let unit = likely_unit(area, AREAS, "m2", |a| within(a, [least, AREA[1]]));
    let unit = unit.filter(|_| !odd_surface || area > FIELD);
    // A likely unit refers to the area alone.
    let few = within(area, AREA) && unit.is_none();
    let (severity, meaning) = match area {
        a if a > FIELD => (severity(a, [0.0, FIELD]), "no joint is so large".to_string()),
        a if a > AREA[1] => (Severity::Note, "few joints are so large".to_string()),
        a => {
            let (count, few) = (short(a * density), a * density < POPULATION[0]);
            let meaning = format!("the area holds {count} asperities, too few for an average");
            (if few { Severity::Warning } else { Severity::Note }, meaning)
        }
    };
    let code = if few { FEW_ASPERITIES } else { CODE };
    let found = Finding::warning(code, "nominal_area", area).severity(severity);
    let found = found.usual(usual).unit("m2").advice(meaning);
    Some(match unit {
        Some(unit) => found.likely_unit(unit),
        None => found,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first finding, with its severity.
    fn of(radius: f64, density: f64, std: f64) -> String {
        let found = Surface::new(radius, density, std).findings();
        found.first().map_or_else(String::new, |found| format!("{}: {found}", found.severity))
    }

    #[test]
    fn lengths_in_millimetres_are_an_error_with_that_unit() {
        let wanted = "error: asperity_height_std is 8e-4 m, asperity_radius 0.08 m: all lengths look like mm, and the density 800 like 1/mm2; give m and 1/m2";
        assert_eq!(of(0.08, 800.0, 0.0008), wanted);
        let um = of(80.0, 8e-4, 0.8);
        assert!(um.contains("look like um, and the density 8e-4 like 1/um2"), "{um}");
    }

    #[test]
    fn a_number_that_is_large_in_its_unit_as_well_has_that_unit() {
        let found = of(8e-5, 8e8, 8.0);
        assert!(found.ends_with("8 looks like um; 8 um is 8e-6 m"), "{found}");
    }

    #[test]
    fn an_area_that_no_joint_has_is_said_beside_a_wrong_surface() {
        let interface = crate::Interface::new(1e11, 0.3, 1e9);
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
