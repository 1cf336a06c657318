//! Hardnesses on the scales of indentation tests.

use asperity::{HARDNESS_OVER_YIELD, hardness_of_vickers, short};

/// What a stress of a scene file is, as far as a hardness may be given for it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stress {
    Hardness,
    YieldStrength,
    Modulus,
    TangentModulus,
    /// A pressure on the nominal area.
    Pressure,
}

impl Stress {
    /// The stress of a key of scene files, `body[1].hardness` for example.
    pub(crate) fn of(key: &str) -> Self {
        match key {
            _ if key.ends_with("hardness") => Self::Hardness,
            _ if key.ends_with("yield_strength") => Self::YieldStrength,
            _ if key.ends_with("tangent_modulus") => Self::TangentModulus,
            _ => Self::Modulus,
        }
    }
}

/// How a hardness such as `120 HV` is given instead, behind the text in a message; `None` for other
/// texts.
pub(crate) fn hardness(text: &str, stress: Stress) -> Option<String> {
    let capital = text.to_uppercase();
    let scale = |name: &str| of_scale(&capital, name);
    let vickers = scale("HV").map(|vickers| {
        let contact = hardness_of_vickers(vickers);
        [contact, contact / HARDNESS_OVER_YIELD]
            .map(|pascal| format!("{}GPa", short(1e-9 * pascal)))
    });
    let others = ["HBW", "HBS", "HB", "HRC", "HRB", "HRA", "HK"];
    if vickers.is_none() && others.into_iter().all(|name| scale(name).is_none()) {
        return None;
    }
    Some(match (stress, vickers) {
        (Stress::Hardness, Some([contact, _])) => format!(
            "is not in Pa: write {contact}, the contact hardness (mean pressure on the projected area, 9.807 HV/0.9272 MPa)"
        ),
        (Stress::Hardness, None) => "is not in Pa: convert the hardness to HV first".into(),
        (Stress::YieldStrength, Some([contact, strength])) => format!(
            "is a hardness, not a yield strength: give hardness = \"{contact}\" instead; the yield strength is about {strength} if the contact hardness is {HARDNESS_OVER_YIELD} times as large, as of metals that hardly harden"
        ),
        (Stress::YieldStrength, None) => {
            "is a hardness, not a yield strength: convert it to HV, and give it as hardness".into()
        }
        (Stress::Modulus, _) => {
            "is a hardness, not a modulus of elasticity: write 210GPa, for example".into()
        }
        (Stress::TangentModulus, _) => {
            "is a hardness, not a tangent modulus: write 2GPa, for example".into()
        }
        (Stress::Pressure, _) => {
            "is a hardness, not a pressure on the nominal area: write 5MPa, for example".into()
        }
    })
}

/// The number of a hardness: 120 of `120 HV`, `120 HV10`, `HV 120` or `HV10 120`.
fn of_scale(text: &str, name: &str) -> Option<f64> {
    let (before, after) = text.trim().split_once(name)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
    match before.is_empty() {
        true => number(after).or_else(|| {
            let (load, value) = after.split_once(' ')?;
            number(load).and(number(value))
        }),
        false => number(before).filter(|_| after.is_empty() || number(after).is_some()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hardness_is_refused_by_what_is_needed() {
        let vickers = |stress| hardness("120 HV", stress).unwrap();
        assert!(
            vickers(Stress::of("body[1].hardness"))
                .starts_with("is not in Pa: write 1.269GPa, the contact hardness (mean")
        );
        let strength = vickers(Stress::of("yield_strength"));
        assert!(strength.starts_with("is a hardness, not a yield strength: give hardness = \"1.269GPa\" instead; the yield strength is about 0.4533GPa if"), "{strength}");
        assert!(
            vickers(Stress::of("body[1].youngs_modulus")).starts_with("is a hardness, not a mod")
        );
        let tangent = vickers(Stress::of("tangent_modulus"));
        assert_eq!(tangent, "is a hardness, not a tangent modulus: write 2GPa, for example");
        assert!(
            vickers(Stress::Pressure).starts_with("is a hardness, not a pressure on the nominal")
        );
        for text in ["60 HRC", "200 HBW", "HB 200"] {
            assert!(hardness(text, Stress::Hardness).unwrap().ends_with("to HV first"), "{text}");
        }
        assert_eq!(hardness("120 MPa", Stress::Hardness), None);
    }
}
