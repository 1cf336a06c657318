//! Plausibility of asperity sizes and numbers.

use std::cmp::Ordering;

use super::likely_unit::{Input, UNUSUAL, Unit, implausible, within};
use crate::finding::{FEW_ASPERITIES, short};
use crate::{Finding, Findings, Scene, Severity, Surface};

const LENGTHS: &[Unit] = &[("um", 1e-6), ("mm", 1e-3), ("nm", 1e-9)];
const DENSITIES: &[Unit] = &[("1/mm2", 1e6), ("1/um2", 1e12), ("1/cm2", 1e4), ("1/nm2", 1e18)];
/// σ_z from cleaved mica to the texture of asphalt, R from a sharp tip to a lens, η from the stones
/// of asphalt, a centimetre apart, to atomic corrugation.
static NUMBERS: [Input; 3] = [
    Input::new("asperity_height_std", [3e-11, 2e-3], "m", LENGTHS),
    Input::new("asperity_radius", [2e-9, 5e-2], "m", LENGTHS),
    Input::new("asperity_density", [5e3, 1e16], "1/m2", DENSITIES),
];
/// A_n from the tip of an instrument to a large flange.
const AREA: Input = Input::new(
    "nominal_area",
    [1e-16, 0.03],
    "m2",
    &[("mm2", 1e-6), ("cm2", 1e-4), ("um2", 1e-12)],
);
/// σ_z \[m\] of a typical machined surface.
const MICRON: f64 = 1e-6;
/// Factor outside the usual range from which β is a warning.
const RARE: f64 = 5.0;
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
        let is_possible = |other: &Self| !other.is_implausible();
        let found = self
            .slip(makes_sense)
            .or_else(|| self.in_one_unit())
            .or_else(|| self.is_implausible().then(|| self.slip(is_possible)).flatten());
        found.map_or_else(|| self.plain_findings(), |found| [found].into_iter().collect())
    }

    fn numbers(&self) -> [f64; 3] {
        [self.asperity_height_std, self.asperity_radius, self.asperity_density]
    }

    /// The finding of the one number that in another unit makes a surface that `is_usual`; `None`
    /// if there is none. Another unit is off by orders of magnitude.
    fn slip(&self, is_usual: fn(&Self) -> bool) -> Option<Finding> {
        let of = |(k, input): (usize, &Input)| {
            let value = self.numbers()[k];
            let unit = input.unit(value, |x| {
                let mut numbers = self.numbers();
                numbers[k] = x;
                is_usual(&Self::new(numbers[1], numbers[2], numbers[0]))
            })?;
            Some(input.in_unit(value, &[unit]).implausible(true))
        };
        // The number farthest from the middle of its range is reported.
        let distance = |found: &Finding| {
            let ([from, to], value) = (found.usual, found.value);
            ((value / from).ln() + (value / to).ln()).abs() / (to / from).ln()
        };
        let slips = NUMBERS.iter().enumerate().filter_map(of);
        let found = slips.max_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        Some(match within(found.value, found.usual) {
            true => {
                let fact = format!("`{}` is {} {}, ", found.field, short(found.value), found.unit);
                found.fact(fact + &self.together())
            }
            false => found,
        })
    }

    /// Whether a criterion is ten times outside its range.
    fn is_implausible(&self) -> bool {
        self.criteria().into_iter().any(|(input, value)| implausible(value, input.usual))
    }

    /// A finding if all lengths are plausible in another common unit, with densities in its square
    /// or in another unit; of several, that with the height nearest to 1 um.
    fn in_one_unit(&self) -> Option<Finding> {
        let [std, radius, density] = self.numbers();
        let inverse = |(name, size): Unit| (format!("1/{name}2"), size.powi(-2));
        let all = LENGTHS.iter().flat_map(|&length| {
            let others = DENSITIES.iter().map(|(name, size)| ((*name).to_string(), *size));
            let densities = std::iter::once(inverse(length)).chain(others).enumerate();
            densities.map(move |(k, density)| (k > 0, length, density))
        });
        let makes_sense = |(_, (_, length), (_, inverse)): &(bool, Unit, (String, f64))| {
            makes_sense(&Self::new(length * radius, inverse * density, length * std))
        };
        let order = |(is_other, (_, length), _): &(bool, Unit, _)| {
            (*is_other, (length * std / MICRON).ln().abs())
        };
        let nearest = |a: &_, b: &_| order(a).partial_cmp(&order(b)).unwrap_or(Ordering::Equal);
        let (_, (name, _), (inverse, _)) = all.filter(makes_sense).min_by(nearest)?;
        // Two numbers outside their ranges have the same cause; fine but wide waves have them, too.
        let odd = NUMBERS.iter().zip(self.numbers());
        let odd = odd.filter(|(input, value)| !within(*value, input.usual)).count();
        let is_unit = odd > 1 && !(FINE..COARSE).contains(&std);
        let found = Finding::warning(UNUSUAL, "asperity_height_std", std)
            .usual(NUMBERS[0].usual)
            .implausible(is_unit || self.is_implausible())
            .fact(format!(
                "`asperity_height_std` is {} m, `asperity_radius` {} m",
                short(std),
                short(radius)
            ))
            .advice("check the numbers and their units")
            .likely_unit(format!(
                "all lengths look like {name}, and the density {} like {inverse}; give m and 1/m2",
                short(density)
            ));
        Some(found)
    }

    /// Criteria, with the values of this surface.
    fn criteria(&self) -> [(Input, f64); 6] {
        let [std, radius, density] = self.numbers();
        let derived = |field, usual, advice| Input::new(field, usual, "", &[]).advice(advice);
        let together = "one of `asperity_density`, `asperity_radius` and `asperity_height_std` is wrong, or the scan is noisy or too coarse";
        let needles = "the asperities would be needles, not spherical caps";
        let steep = "half-space contact assumes slopes well below 1";
        let [of_std, of_radius, of_density] = NUMBERS;
        let beta = derived("roughness_parameter", Self::USUAL_ASPERITY_ROUGHNESS, together);
        [
            (of_std, std),
            (of_radius, radius),
            (of_density, density),
            (beta, self.roughness_parameter()),
            (derived("height_std_over_radius", [0.0, 1.0], needles), std / radius),
            (derived("rms_slope", [0.0, 1.0], steep), self.rms_slope()),
        ]
    }

    /// Findings of each number outside its range without a likely unit, as for asperities that
    /// follow from other numbers.
    #[must_use]
    pub fn plain_findings(&self) -> Findings {
        let odd = self.criteria().into_iter().filter(|(input, x)| !within(*x, input.usual));
        let found = |(input, value): (Input, f64)| {
            let found = input.in_unit(value, &[]);
            match input.field {
                "roughness_parameter" if found.excess() > RARE => found.severity(Severity::Warning),
                // The laws remain valid.
                "roughness_parameter" => found.severity(Severity::Note),
                _ => found,
            }
        };
        odd.map(found).collect()
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

fn makes_sense(surface: &Surface) -> bool {
    surface.criteria().iter().all(|(input, value)| within(*value, input.usual))
}

/// A finding for an unusual nominal area, alone or for its number of asperities. Beside findings
/// `of_surface`, whose density may be wrong, only an area that is impossible has one.
pub(crate) fn of_area(scene: &Scene, of_surface: &Findings) -> Option<Finding> {
    let (area, density) = (scene.nominal_area, scene.surface.asperity_density);
    let has_unit = of_surface.iter().any(|found| found.likely_unit.is_some());
    let population = if has_unit { 0.0 } else { POPULATION[1] / density };
    let [smallest, largest] = AREA.usual;
    let enough = smallest.max(population);
    let usual = [enough, if enough < largest { largest } else { f64::INFINITY }];
    let odd_surface = !of_surface.is_empty();
    let is_possible = area <= FIELD && (has_unit || area * density >= 1.0);
    if within(area, [enough, largest]) || odd_surface && is_possible {
        return None;
    }
    let least = if odd_surface { smallest } else { 1000.0 / density };
    let unit = AREA.unit(area, |a| within(a, [least, largest]));
    let unit = unit.filter(|_| !odd_surface || area > FIELD);
    // A likely unit refers to the area alone.
    let few = within(area, AREA.usual) && unit.is_none();
    let (severity, meaning) = match area {
        a if a > FIELD => (Severity::Warning, "no joint is so large".to_string()),
        a if a > largest => (Severity::Note, "few joints are so large".to_string()),
        a => {
            let (count, few) = (short(a * density), a * density < POPULATION[0]);
            let meaning = format!("the area holds {count} asperities, too few for an average");
            (if few { Severity::Warning } else { Severity::Note }, meaning)
        }
    };
    let mut found = Input { usual, ..AREA }.in_unit(area, unit.as_slice()).advice(meaning);
    found.code = if few { FEW_ASPERITIES } else { UNUSUAL };
    Some(found.severity(severity).implausible(implausible(area, [0.0, FIELD])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the first finding is of an implausible number, and its text.
    fn of(radius: f64, density: f64, std: f64) -> String {
        let found = Surface::new(radius, density, std).findings();
        found
            .first()
            .map_or_else(String::new, |found| format!("{}: {found}", found.is_implausible()))
    }

    #[test]
    fn lengths_in_millimetres_are_implausible_with_that_unit() {
        let wanted = "true: asperity_height_std is 8e-4 m, asperity_radius 0.08 m: all lengths look like mm, and the density 800 like 1/mm2; give m and 1/m2";
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
