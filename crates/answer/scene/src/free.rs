//! Free parameters as they are typed: `name=low:high`.

use asperity::fit::Role;

use crate::keys::key_of_input;
use crate::quantity::{quantity, quantity_of, unit_of};

/// A free parameter: an input of a scene by its name, `separation_offset` or `series_compliance`,
/// with its bounds in SI units if they are given.
///
/// ```
/// use asperity_scene::Free;
///
/// let free: Free = "asperity_height_std=0.1um:5um".parse()?;
/// assert_eq!(free.bounds, Some([1e-7, 5e-6]));
/// assert_eq!("hardness".parse::<Free>()?.bounds, None);
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Free {
    /// The name.
    pub name: String,
    /// The smallest and the largest value.
    pub bounds: Option<[f64; 2]>,
    /// Whether the bounds were given with a unit, so that they are in no other.
    pub has_unit: bool,
}

impl std::str::FromStr for Free {
    type Err = String;

    /// Reads `name` or `name=low:high`, with or without units.
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, bounds) = text.split_once('=').map_or((text, None), |(a, b)| (a, Some(b)));
        let name = name.trim();
        if name.is_empty() {
            let example = "write name or name=low:high, for example hardness=1GPa:4GPa";
            return Err(format!("a free parameter has no name: {example}"));
        }
        let Some(bounds) = bounds else {
            return Ok(Self { name: name.into(), bounds: None, has_unit: false });
        };
        let refused = |reason: String| format!("{name}: {reason}");
        let number = |text: &str| match Role::of(name) {
            Role::Scene => quantity_of(key_of_input(name), text),
            _ => quantity(text, unit_of_free(name).unwrap_or_default()),
        };
        let Some((low, high)) = bounds.split_once(':') else {
            return Err(refused(format!(
                "{bounds:?} is one value: write {name}=low:high for bounds, or {name} alone"
            )));
        };
        // 0 needs no unit.
        let plain = [low, high].map(|text| text.trim().parse::<f64>());
        for (text, at, other) in [(low, &plain[0], &plain[1]), (high, &plain[1], &plain[0])] {
            if other.is_err() && at.as_ref().is_ok_and(|value| *value != 0.0) {
                return Err(refused(format!("{text} has no unit; give both bounds a unit")));
            }
        }
        let bounds = Some([number(low).map_err(refused)?, number(high).map_err(refused)?]);
        let has_unit = plain.iter().any(Result::is_err);
        Ok(Self { name: name.into(), bounds, has_unit })
    }
}

/// The SI unit of a free parameter; `None` for pure numbers.
#[must_use]
pub(crate) fn unit_of_free(name: &str) -> Option<&'static str> {
    match Role::of(name) {
        Role::SeparationOffset => Some("m"),
        Role::SeriesCompliance => Some("m/N"),
        _ => unit_of(key_of_input(name)),
    }
}
