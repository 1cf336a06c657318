//! Free parameters as they are typed: `name=low:high`.

use asperity::fit::Role;
use asperity::short;

use crate::quantity::UNITS;
use crate::{key_of_input, quantity, quantity_of, unit_of};

/// Bounds that are farther from the scene's value than this factor may be in another unit.
const FAR: f64 = 100.0;

/// A free parameter: an input of a scene by its name, `separation_offset` or `series_compliance`,
/// with its bounds in SI units if they are given.
///
/// ```
/// use asperity_inputs::Free;
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
        let number = |text: &str| match Role::of(name) {
            Role::SeparationOffset => quantity(text, "m"),
            Role::SeriesCompliance => quantity(text, "m/N"),
            _ => quantity_of(key_of_input(name), text),
        };
        let number = |text: &str| match number(text)? {
            value if value.is_finite() => Ok(value),
            _ => Err(format!("{text} is not finite")),
        };
        let mut has_unit = false;
        let bounds = bounds.map(|bounds| match bounds.split_once(':') {
            Some((low, high)) => {
                // 0 needs no unit.
                let plain = |text: &str| text.trim().parse::<f64>().is_ok_and(|value| value != 0.0);
                let (bounds, plain) = ([number(low)?, number(high)?], [plain(low), plain(high)]);
                let unit = [low, high].map(|text| text.trim().parse::<f64>().is_err());
                has_unit = unit.contains(&true);
                match (plain, unit) {
                    ([true, _], [_, true]) => {
                        Err(format!("{low} has no unit; give both bounds a unit"))
                    }
                    ([_, true], [true, _]) => {
                        Err(format!("{high} has no unit; give both bounds a unit"))
                    }
                    _ => Ok(bounds),
                }
            }
            None if number(bounds).is_ok() => Err(format!(
                "{bounds:?} is one value: write {name}=low:high for bounds, or {name} alone"
            )),
            None => {
                Err(format!("{bounds:?} are no bounds: write {name}=low:high, with decimal points"))
            }
        });
        let bounds = bounds.transpose().map_err(|error| format!("{name}: {error}"))?;
        Ok(Self { name: name.into(), bounds, has_unit })
    }
}

/// The SI unit of a free parameter; `None` for pure numbers.
#[must_use]
pub fn unit_of_free(name: &str) -> Option<&'static str> {
    match Role::of(name) {
        Role::SeparationOffset => Some("m"),
        Role::SeriesCompliance => Some("m/N"),
        _ => unit_of(key_of_input(name)),
    }
}

/// The reason against bounds far from the scene's value that are near it in another unit.
pub(crate) fn other_unit(name: &str, start: f64, [low, high]: [f64; 2]) -> Option<String> {
    let is_far = start > 0.0 && low > 0.0 && (low > FAR * start || FAR * high < start);
    let (si, _, units) = UNITS.into_iter().find(|(si, ..)| Some(*si) == unit_of_free(name))?;
    let holds = |power: i32| {
        let factor = 10f64.powi(power);
        (low * factor..=high * factor).contains(&start)
    };
    let (unit, power) = units.iter().filter(|_| is_far).find(|(_, power)| holds(*power))?;
    let [bottom, top] = [low, high].map(short);
    // 1/mm2 behind a number is /mm2.
    let behind = unit.trim_start_matches('1');
    Some(format!(
        "the bounds {bottom} and {top} look like {unit}; {bottom} {unit} is {} {si}, and the scene has {} {si}: write {name}={bottom}{behind}:{top}{behind}",
        short(low * 10f64.powi(*power)),
        short(start)
    ))
}
