//! Other names of quantities in headers of measurements.

/// Other names, in lower case.
const OTHER_NAMES: [(&str, &str); 17] = [
    ("normal_force", "load"),
    ("preload", "load"),
    ("f", "load"),
    ("fn", "load"),
    ("nominal_pressure", "pressure"),
    ("p", "pressure"),
    ("contact_area", "area"),
    ("real_area", "area"),
    ("a", "area"),
    ("gap", "separation"),
    ("distance", "separation"),
    ("d", "separation"),
    ("h", "thermal_conductance_per_area"),
    ("contact_stiffness", STIFFNESS),
    ("normal_stiffness", STIFFNESS),
    ("k", STIFFNESS),
    ("kn", STIFFNESS),
];
/// A stiffness of which kind its name does not say.
pub(crate) const STIFFNESS: &str = "stiffness";

/// The usual word for a quantity, in lower case: separation for gap. Names of one or two letters
/// have many meanings without a unit, and are none.
pub(crate) fn usual_name(name: &str, has_unit: bool) -> Option<String> {
    let lower = name.trim().to_lowercase().replace([' ', '-'], "_");
    let known = OTHER_NAMES.into_iter().find(|(other, _)| *other == lower);
    match known {
        Some((other, usual)) => (has_unit || other.len() > 2).then(|| usual.into()),
        None => Some(lower),
    }
}
