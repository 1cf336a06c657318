//! Whether the asperities, and how many there are, are those of any surface.

use super::finding::{FEW_ASPERITIES, Finding, Severity, short};
use super::materials::{severity, within};
use super::units::{AREAS, DENSITIES, LENGTHS, Unit, slip};
use crate::{Scene, Surface};

/// R \[m\]: from a sharp tip to a lens.
const RADIUS: [f64; 2] = [2e-9, 5e-2];
/// η \[1/m²\].
const DENSITY: [f64; 2] = [1e5, 1e16];
/// σ_z \[m\]: from cleaved mica to coarse blasting.
const HEIGHT_STD: [f64; 2] = [3e-11, 2e-4];
/// β_z = η R σ_z; 0.03 to 0.06 for classic surfaces, more for those with structure on all scales.
const ROUGHNESS: [f64; 2] = [0.005, 0.5];
/// A_n \[m²\]: from the tip of an instrument to a large flange.
const AREA: [f64; 2] = [1e-16, 0.03];
/// Beyond this \[m²\] there is no joint, but perhaps a landing pad.
const FIELD: f64 = 1.0;
/// Fewer asperities than the first are no population, and fewer than the second a small one.
const POPULATION: [f64; 2] = [30.0, 300.0];

impl Surface {
    /// √(2 m₂) of an isotropic Gaussian surface with these asperities: its rms slope.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        (2.0 * self.moments().m2).sqrt()
    }

    /// What is unusual about these numbers for any surface.
    #[must_use]
    pub fn findings(&self) -> Vec<Finding> {
        if makes_sense(self) {
            return vec![];
        }
        let alone = |field, value, usual, units: &[Unit], si, set: fn(&mut Self, f64)| {
            let question = slip(value, units, si, |x| {
                let mut other = *self;
                set(&mut other, x);
                makes_sense(&other)
            });
            question.map(|question| (field, value, usual, si, question))
        };
        let slips = [
            alone(
                "asperity_height_std",
                self.asperity_height_std,
                HEIGHT_STD,
                LENGTHS,
                "m",
                |s, x| {
                    s.asperity_height_std = x;
                },
            ),
            alone("asperity_radius", self.asperity_radius, RADIUS, LENGTHS, "m", |s, x| {
                s.asperity_radius = x;
            }),
            alone("asperity_density", self.asperity_density, DENSITY, DENSITIES, "1/m2", |s, x| {
                s.asperity_density = x;
            }),
        ];
        // The number that is farthest from what is usual is to blame.
        let distance = |(_, value, [from, to], ..): &(_, f64, [f64; 2], _, _)| {
            ((value / from).ln() + (value / to).ln()).abs() / (to / from).ln()
        };
        let worst = slips.into_iter().flatten().max_by(|a, b| distance(a).total_cmp(&distance(b)));
        if let Some((field, value, usual, si, question)) = worst {
            let why = match within(value, usual) {
                true => self.together(),
                false => format!("asperities have {} to {} {si}", short(usual[0]), short(usual[1])),
            };
            let message = format!("{field} is {} {si}, {why}: {question}", short(value));
            return vec![Finding::new(CODE, Severity::Error, field, value, usual, message)];
        }
        self.in_one_unit().map_or_else(|| self.apart(), |finding| vec![finding])
    }

    /// All lengths in the same other unit.
    fn in_one_unit(&self) -> Option<Finding> {
        let scaled = |unit: f64| Self {
            asperity_radius: unit * self.asperity_radius,
            asperity_density: self.asperity_density / unit.powi(2),
            asperity_height_std: unit * self.asperity_height_std,
        };
        let (name, _) = LENGTHS.iter().find(|(_, unit)| makes_sense(&scaled(*unit)))?;
        let value = self.asperity_height_std;
        let message = format!(
            "asperity_height_std is {} m, asperity_radius {} m: are all lengths in {name}, and the density in 1/{name}2? m and 1/m2 were required",
            short(value),
            short(self.asperity_radius)
        );
        let severity = Severity::Error;
        Some(Finding::new(CODE, severity, "asperity_height_std", value, HEIGHT_STD, message))
    }

    /// What is odd about each number, where no unit explains it.
    fn apart(&self) -> Vec<Finding> {
        let beta = self.roughness_parameter();
        let ratio = self.asperity_height_std / self.asperity_radius;
        let slope = self.rms_slope();
        let together = "one of asperity_density, asperity_radius and asperity_height_std is off, or the scan is noisy or too coarse";
        [
            ("asperity_height_std", self.asperity_height_std, HEIGHT_STD, "m", "the unit is m"),
            ("asperity_radius", self.asperity_radius, RADIUS, "m", "the unit is m"),
            ("asperity_density", self.asperity_density, DENSITY, "1/m2", "the unit is 1/m2"),
            (
                "roughness_parameter",
                beta,
                ROUGHNESS,
                "(density times radius times height_std)",
                together,
            ),
            (
                "height_std_over_radius",
                ratio,
                [0.0, 1.0],
                "",
                "asperities would be needles, not caps",
            ),
            ("rms_slope", slope, [0.0, 1.0], "", "steeper than half-space contact is made for"),
        ]
        .into_iter()
        .filter(|(_, value, usual, ..)| !within(*value, *usual))
        .map(|(field, value, usual, unit, why)| {
            let space = if unit.is_empty() { "" } else { " " };
            let message = format!(
                "{field} is {}{space}{unit}, where {} to {} is usual: {why}",
                short(value),
                short(usual[0]),
                short(usual[1])
            );
            Finding::new(CODE, severity(value, usual), field, value, usual, message)
        })
        .collect()
    }

    fn together(&self) -> String {
        let beta = self.roughness_parameter();
        if within(beta, ROUGHNESS) {
            return format!(
                "with an rms slope of {}, where below 1 is usual",
                short(self.rms_slope())
            );
        }
        let [from, to] = ROUGHNESS;
        format!(
            "and density times radius times height_std {}, where {from} to {to} is usual",
            short(beta)
        )
    }
}

const CODE: &str = "unusual-size";

fn makes_sense(surface: &Surface) -> bool {
    within(surface.asperity_height_std, HEIGHT_STD)
        && within(surface.asperity_radius, RADIUS)
        && within(surface.asperity_density, DENSITY)
        && within(surface.roughness_parameter(), ROUGHNESS)
        && surface.asperity_height_std <= surface.asperity_radius
        && surface.rms_slope() <= 1.0
}

/// What is unusual about the nominal area, by itself and for these asperities.
pub(crate) fn of_area(scene: &Scene) -> Option<Finding> {
    let (area, density) = (scene.nominal_area, scene.surface.asperity_density);
    let usual = [AREA[0].max(POPULATION[1] / density), AREA[1]];
    if within(area, usual) {
        return None;
    }
    let question = slip(area, AREAS, "m2", |a| within(a, [1000.0 / density, AREA[1]]));
    // Another unit is of the area itself.
    let few = within(area, AREA) && question.is_none();
    let code = if few { FEW_ASPERITIES } else { CODE };
    let (severity, why) = match area {
        a if a > FIELD => (severity(a, [0.0, FIELD]), "no joint is so large".to_string()),
        a if a > AREA[1] => (Severity::Note, "few joints are so large".to_string()),
        a => {
            let count = short(a * density);
            let many = format!("it holds {count} asperities, and averages are of many");
            let few = a * density < POPULATION[0];
            (if few { Severity::Warning } else { Severity::Note }, many)
        }
    };
    let question = question.map_or(String::new(), |question| format!(": {question}"));
    let message = format!("nominal_area is {} m2, {why}{question}", short(area));
    Some(Finding::new(code, severity, "nominal_area", area, usual, message))
}
