//! Materials of bodies that conduct more than those that are used.

use asperity::{Body, Finding, Findings, Quantity};

use crate::keys::{BODY, Field};
use crate::materials::materials;
use crate::scene_file::SceneFile;

impl SceneFile {
    /// That the alloys of a pure metal of a body conduct less, where one of these quantities needs
    /// its conduction.
    #[must_use]
    pub fn conduction_findings(&self, quantities: &[Quantity]) -> Findings {
        let listed = |body: &Body| materials().iter().find(|material| material.body == *body);
        let is_needed =
            |key: &&Field<Body>| quantities.iter().any(|q| q.property() == Some(key.name));
        let needed: Vec<&Field<Body>> = BODY.iter().filter(is_needed).collect();
        // The table is read only where it is needed.
        if needed.is_empty() {
            return Findings::default();
        }
        let mut found: Vec<Finding> = vec![];
        for material in self.bodies().iter().filter_map(listed) {
            for new in needed.iter().filter_map(|key| material.pure_metal(key)) {
                if found.iter().all(|known| known.message() != new.message()) {
                    found.push(new);
                }
            }
        }
        self.accepted(found.into_iter().collect())
    }
}

#[cfg(test)]
mod tests {
    use asperity::Quantity;

    #[test]
    fn conduction_of_pure_metals_is_noted_where_it_is_needed() {
        let scene = |id: &str| {
            let bodies = format!("[[body]]\nmaterial = \"{id}\"\n[[body]]\nmaterial = \"{id}\"");
            let surface =
                "asperity_radius = 1e-4\nasperity_density = 1e9\nasperity_height_std = 1e-6";
            let text = format!("nominal_area = 1e-4\n{bodies}\n[surface]\n{surface}");
            crate::parse(&text, std::path::Path::new(".")).unwrap()
        };
        let found = |id: &str, quantity| {
            let found = scene(id).conduction_findings(&[Quantity::Force, quantity]);
            found.iter().map(|found| (found.code, found.message())).collect::<Vec<_>>()
        };
        let (thermal, electrical) =
            (Quantity::ThermalConductancePerArea, Quantity::ElectricalConductance);
        let [(code, text)] = &found("aluminium", thermal)[..] else { panic!("once") };
        assert_eq!(*code, "pure-metal");
        assert!(text.contains("2.0 times less (aluminium-2024-t3)"), "{text}");
        assert!(
            found("copper-hot-rolled", electrical)[0]
                .1
                .contains("3.6 times less (brass-cuzn39pb3)")
        );
        assert!(found("aluminium", Quantity::Tangent).is_empty());
        for quiet in ["aluminium-6061-t6", "stainless-316", "inconel-718", "grey-iron-class-30"] {
            assert!(found(quiet, thermal).is_empty() && found(quiet, electrical).is_empty());
        }
    }
}
