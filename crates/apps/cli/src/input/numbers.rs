//! Single numbers on the command line, plain or with their unit.

use asperity::joints::coefficient_of_friction;
use asperity::shortest_digits;
use asperity_scene::{NO_LOAD, notation_hint};

/// A force other than 0, in N or with its unit: a tension is below 0.
pub fn load_or_tension(text: &str) -> Result<f64, String> {
    of_unit(text, "N").and_then(not_0)
}

/// A pressure other than 0, in Pa or with its unit.
pub fn pressure_or_tension(text: &str) -> Result<f64, String> {
    of_unit(text, "Pa").and_then(not_0)
}

/// A force above 0, in N or with its unit.
pub fn load(text: &str) -> Result<f64, String> {
    of_unit(text, "N").and_then(positive)
}

/// A pressure above 0, in Pa or with its unit.
pub fn pressure(text: &str) -> Result<f64, String> {
    of_unit(text, "Pa").and_then(positive)
}

/// A length above 0, in m or with its unit.
pub fn length(text: &str) -> Result<f64, String> {
    of_unit(text, "m").and_then(positive)
}

/// A finite number, plain or with its unit.
pub fn of_unit(text: &str, si: &str) -> Result<f64, String> {
    match asperity_scene::quantity(text, si)? {
        value if value.is_finite() => Ok(value),
        _ => Err(format!("{text} is not finite")),
    }
}

fn not_0(value: f64) -> Result<f64, String> {
    match value {
        0.0 => Err(NO_LOAD.into()),
        value => Ok(value),
    }
}

/// A whole number.
pub fn whole(text: &str) -> Result<u64, String> {
    let wrong = |_| format!("{text:?} is not a whole number such as 1000");
    text.trim().parse().map_err(wrong)
}

/// A number of values: a whole number from 2 to `most`.
pub fn count_up_to(most: usize) -> impl Fn(&str) -> Result<usize, String> + Clone {
    move |text| match usize::try_from(whole(text)?) {
        Ok(count) if (2..=most).contains(&count) => Ok(count),
        _ => Err(format!("{} is not a whole number from 2 to {most}", text.trim())),
    }
}

/// A finite number.
pub fn number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("{text} is not finite")),
        Err(_) => {
            let hint = notation_hint(text).unwrap_or("is not a number such as 2, -0.5 or 1e-6");
            Err(format!("{text:?} {hint}"))
        }
    }
}

/// A coefficient of friction.
pub fn friction(text: &str) -> Result<f64, String> {
    coefficient_of_friction(positive_number(text)?).map_err(|error| error.to_string())
}

/// A share from 0 to 1.
pub fn share(text: &str) -> Result<f64, String> {
    match number(text)? {
        share if (0.0..=1.0).contains(&share) => Ok(share),
        other => Err(format!("{} is not a share from 0 to 1", shortest_digits(other))),
    }
}

/// A share above 0, likewise.
pub fn share_above_0(text: &str) -> Result<f64, String> {
    share(text).and_then(positive)
}

/// A finite number above 0.
pub fn positive_number(text: &str) -> Result<f64, String> {
    number(text).and_then(positive)
}

/// The value, if it is above 0.
pub fn positive(value: f64) -> Result<f64, String> {
    match value > 0.0 {
        true => Ok(value),
        false => Err(format!("{} is not above 0", shortest_digits(value))),
    }
}
