//! Curved bodies: the section `[curvature]`.

use asperity::{ContactError, require};
use asperity_curved::Shape;
use serde::{Deserialize, Serialize};

/// Curved bodies: the keys of `[curvature]`, lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Curvature {
    /// Relative radius of spheres, 1/R = 1/R₁ + 1/R₂.
    pub radius: Option<f64>,
    /// Relative radius along x.
    pub radius_x: Option<f64>,
    /// Relative radius along y.
    pub radius_y: Option<f64>,
    /// Radius of the first body along x, below 0 if it is hollow; flat without one.
    pub body1_radius_x: Option<f64>,
    /// Its radius along y.
    pub body1_radius_y: Option<f64>,
    /// Radius of the second body along x.
    pub body2_radius_x: Option<f64>,
    /// Its radius along y.
    pub body2_radius_y: Option<f64>,
    /// Length of a line contact.
    pub length: Option<f64>,
    /// The length in the deflection of a line contact, on which its approach depends.
    pub reference_length: Option<f64>,
    /// The least yield strength that was written without a hardness \[Pa\].
    #[serde(skip)]
    pub(crate) strength: Option<f64>,
}

const WAYS: &str = "one of: radius; radius_x and radius_y; radius_x and length, of a line contact; body1_radius_x and so on, of each body";

impl Curvature {
    /// The relative radius along an axis from those of both bodies; `None` without any.
    fn relative(bodies: [Option<f64>; 2]) -> Option<f64> {
        let each = bodies.into_iter().flatten();
        each.map(f64::recip).reduce(|a, b| a + b).map(f64::recip)
    }

    /// The undeformed bodies.
    ///
    /// # Errors
    /// [`ContactError::Missing`] where the radii do not describe bodies,
    /// [`ContactError::Refused`] where two ways describe them or they are closed around each
    /// other, and [`ContactError::OutOfRange`].
    pub fn shape(&self) -> Result<Shape, ContactError> {
        let each =
            [self.body1_radius_x, self.body1_radius_y, self.body2_radius_x, self.body2_radius_y];
        let relative = [self.radius_x, self.radius_y];
        let ways = [
            self.radius.is_some(),
            relative.iter().any(Option::is_some),
            each.iter().any(Option::is_some),
        ];
        let refused = |reason: &str| {
            let model = "curved bodies".into();
            Err(ContactError::Refused { model, reason: reason.into() })
        };
        if ways.iter().filter(|is_used| **is_used).count() > 1 {
            return refused(&format!("the radii are given in more than one way: write {WAYS}"));
        }
        let is_zero = each.into_iter().flatten().any(|radius| radius == 0.0);
        let required = "a radius that is not 0 (leave a flat direction out)";
        require(!is_zero, "radius", 0.0, required)?;
        let [x, y] = match self.radius {
            Some(radius) => [Some(radius); 2],
            None if ways[2] => {
                [Self::relative([each[0], each[2]]), Self::relative([each[1], each[3]])]
            }
            None => relative,
        };
        for (field, radius) in [("radius_x", x), ("radius_y", y)] {
            let Some(value) = radius else { continue };
            let required = "a relative radius above 0: 1/R = 1/R1 + 1/R2, a hollow body with less curvature than the other";
            let field = if self.radius.is_some() { "radius" } else { field };
            require(value > 0.0 && value.is_finite(), field, value, required)?;
        }
        let missing = || ContactError::Missing { field: "", reason: WAYS.into() };
        match (x, y, self.length) {
            (Some(radius_x), Some(radius_y), None) if self.reference_length.is_none() => {
                Ok(Shape::Point { radius_x, radius_y })
            }
            (Some(_), Some(_), _) => refused(
                "length and reference_length are of a line contact, which has no radius along y",
            ),
            (Some(radius), None, Some(length)) => {
                for (field, value) in
                    [("length", Some(length)), ("reference_length", self.reference_length)]
                {
                    asperity::positive(field, value.unwrap_or(1.0))?;
                }
                Ok(Shape::Line { radius, length, reference_length: self.reference_length })
            }
            _ => Err(missing()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use asperity::{At, ContactModel, Quantity, Request};

    use super::*;
    use crate::{SceneError, SceneFile, parse, template};

    fn with(curvature: &str) -> Result<SceneFile, SceneError> {
        let flat = template().lines().find(|line| line.starts_with("nominal_area")).unwrap();
        let text = template().replace(flat, "") + "\n[curvature]\n" + curvature;
        parse(&text, Path::new("."))
    }

    #[test]
    fn each_way_gives_its_bodies() {
        let shape = |text| with(text).unwrap().spec.curvature.unwrap().shape().unwrap();
        let ball = Shape::Point { radius_x: 0.01, radius_y: 0.01 };
        assert_eq!(shape("radius = \"10 mm\""), ball);
        assert_eq!(shape("radius_x = 0.01\nradius_y = \"1 cm\""), ball);
        let wheel = shape("body1_radius_x = 0.46\nbody2_radius_y = 0.3");
        assert_eq!(wheel, Shape::Point { radius_x: 0.46, radius_y: 0.3 });
        let ring = shape(
            "body1_radius_x = 0.01\nbody1_radius_y = 0.01\nbody2_radius_x = -0.02\nbody2_radius_y = -0.02",
        );
        assert_eq!(ring, Shape::Point { radius_x: 0.02, radius_y: 0.02 });
        let roller = shape("radius_x = 0.01\nlength = 0.02");
        assert_eq!(roller, Shape::Line { radius: 0.01, length: 0.02, reference_length: None });
    }

    #[test]
    fn what_describes_no_bodies_is_refused() {
        for text in [
            "radius_x = 0.01",
            "length = 0.01",
            "radius = 0.01\nradius_x = 0.01",
            "radius = 0.0",
            "radius = -0.01",
            "body1_radius_x = 0.01\nbody2_radius_x = -0.005\nlength = 1.0",
            "body1_radius_x = 0.0\nlength = 1.0",
            "radius = 0.01\nlength = 0.01",
            "radius = 0.01\nreference_length = 0.01",
            "radius_x = 0.01\nlength = -0.01",
        ] {
            let place = with(text).unwrap_err().place().unwrap().field.clone();
            assert!(place.contains("curvature"), "{text}: {place}");
        }
        let both = template().to_string() + "\n[curvature]\nradius = 0.01\n";
        let refused = parse(&both, Path::new(".")).unwrap_err();
        assert_eq!(refused.place().unwrap().field, "nominal_area");
    }

    #[test]
    fn any_model_answers_between_them_and_the_scene_is_written() {
        let file = with("radius = 0.01").unwrap();
        let request = Request::new([Quantity::PeakPressureRatio]).at_loads([50.0]);
        let ratios = ["gw", "ke", "jg", "best"].map(|id| {
            let found = file.model(id).unwrap().solve(&file.scene, &request).unwrap();
            found.values(Quantity::PeakPressureRatio).unwrap()[0]
        });
        assert!(ratios.iter().all(|ratio| (0.2..1.0).contains(ratio)), "{ratios:?}");
        assert_eq!(ratios[1].to_bits(), ratios[3].to_bits());
        for refused in ["cmy", "persson-plastic"] {
            let model = file.model(refused).unwrap();
            let request = Request::new([Quantity::ThermalConductance]);
            assert!(model.compile(&file.scene, &request).is_err(), "{refused}");
        }
        let text = file.to_toml().unwrap();
        let again = parse(&text, Path::new(".")).unwrap();
        assert_eq!(again.spec.curvature, file.spec.curvature);
        assert!(!text.contains("nominal_area"));
    }

    #[test]
    fn a_radius_may_be_known_within_a_range() {
        let file = with("radius_x = [\"9 mm\", \"11 mm\"]\nradius_y = 0.01").unwrap();
        for (share, radius_x) in [(0.0, 0.009), (1.0, 0.011)] {
            let end = file.at(&[share]).unwrap().shape();
            assert_eq!(end, Some(Shape::Point { radius_x, radius_y: 0.01 }));
        }
        let again = parse(&file.to_toml().unwrap(), Path::new(".")).unwrap();
        assert_eq!(again.unknowns(), file.unknowns());
        assert!(with("radius = [-0.01, 0.01]").is_err());
    }
    /// Below the surface the bodies have not hardened: a yield strength that was written holds.
    #[test]
    fn bodies_yield_by_the_strength_that_was_written() {
        let text = "rigid_counterface = true\n[[body]]\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\n\
            yield_strength = 3.5e8\n[surface]\nrq = 2e-7\nrdq = 0.05\nbandwidth = 10\n\
            [curvature]\nradius = 0.01\n";
        let file = parse(text, Path::new(".")).unwrap();
        let request = Request::new([Quantity::PeakPressure]);
        for file in [file.middle().unwrap(), file.at(&[1.0]).unwrap()] {
            let contact = file.model("ke").unwrap().contact(&file.scene, &request).unwrap();
            let notes = contact.notes(&[At::Load(30.0)]);
            let found = notes.iter().find(|one| one.field == "peak_pressure").unwrap();
            assert!((found.usual[1] / 5.6e8 - 1.0).abs() < 1e-9, "{found}");
        }
    }
}
