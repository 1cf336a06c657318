//! What is known of the conduction of the bodies.

use asperity::{Body, Finding, Findings, Quantity};

use crate::keys::{BODY, Field};
use crate::materials::materials;
use crate::scene_file::SceneFile;

impl SceneFile {
    /// What is known of the conduction of the materials of the bodies, where one of these
    /// quantities needs it: that a material has no value, and which have one; and that the alloys
    /// of a pure metal conduct less.
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
            for new in needed.iter().filter_map(|key| material.conduction(key)) {
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
    fn conduction_of_pure_metals_and_of_materials_without_it_is_noted_where_it_is_needed() {
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
        let [(code, text)] = &found("steel-a36", electrical)[..] else { panic!("once") };
        assert_eq!(*code, "no-conductivity");
        assert!(text.contains("steel-a36 has no electrical_"), "{text}");
        assert!(text.contains("titanium-6al-4v") && !text.contains("steel-100cr6"), "{text}");
    }
}
