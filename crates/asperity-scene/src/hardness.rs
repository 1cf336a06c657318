//! Hardnesses on the scales of indentation tests.

/// The standard acceleration of gravity: 1 kgf in N.
const KILOGRAM_FORCE: f64 = 9.80665;

/// How a hardness in HV is given in Pa, and advice for HB and HRC; `None` for other texts.
///
/// Vickers hardness is the load over the area of the facets of a pyramid of 136°; the projected
/// area, on which models take the mean pressure, is smaller by sin 68°.
pub(crate) fn hardness(text: &str) -> Option<String> {
    let scale = |name: &str| of_scale(text, name);
    if let Some(vickers) = scale("HV") {
        let pressure = 1e-3 * KILOGRAM_FORCE * vickers / 68f64.to_radians().sin();
        let pressure = asperity::short(pressure);
        return Some(format!(
            "write {pressure}GPa, the mean pressure on the projected area (9.807 HV/0.9272 MPa)"
        ));
    }
    let others = ["HBW", "HBS", "HB", "HRC", "HRB", "HRA", "HK"];
    let is_other = others.into_iter().any(|name| scale(name).is_some());
    is_other.then(|| "convert the hardness to HV first".into())
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
