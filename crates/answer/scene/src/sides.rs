//! Areas given by two sides: 10 mm x 20 mm.

use asperity::plain_unit as plain;

use crate::scaled::{mantissa, scale};

/// An area in m² by its two sides: `10mm x 20mm`, `10 x 20 mm` or `10 x 20 mm2`.
pub(crate) fn area(text: &str, lengths: &[(&str, i32)], areas: &[(&str, i32)]) -> Option<f64> {
    let (first, second) = text.split_once(['x', 'X', '\u{d7}', '*'])?;
    // No powers of ten: 10 x 10^2 mm may have sides of 10 and 100 mm, or a power in its unit.
    let side = |text: &str| {
        let (number, rest) = mantissa(text.trim())?;
        let is_unit = rest.trim_start().starts_with(char::is_alphabetic);
        let number = scale(&number, 0).filter(|side| *side > 0.0)?;
        (rest.is_empty() || is_unit).then(|| (number, plain(rest)))
    };
    let ((a, of_first), (b, of_second)) = (side(first)?, side(second)?);
    let power = |name: &str, units: &[(&str, i32)]| {
        units.iter().find(|(unit, _)| *unit == name).map(|(_, power)| *power)
    };
    let power = match of_first.as_str() {
        "" => power(&of_second, areas).or_else(|| Some(2 * power(&of_second, lengths)?))?,
        _ => power(&of_first, lengths)? + power(&of_second, lengths)?,
    };
    scale(&format!("{:e}", a * b), power)
}

#[cfg(test)]
mod tests {
    use crate::quantity;

    #[test]
    fn an_area_may_be_given_by_its_sides() {
        for (text, meant) in [
            ("10mm x 10mm", 1e-4),
            ("10 x 20 mm", 2e-4),
            ("10 x 10 mm2", 1e-4),
            ("10 mm \u{d7} 2 cm", 2e-4),
            ("2*3 cm^2", 6e-4),
            ("0.3 m x 0.1 m", 0.03),
        ] {
            assert_eq!(quantity(text, "m^2"), Ok(meant), "{text}");
        }
        for text in [
            "10 x 10",
            "x 10 mm",
            "10 mm x 10",
            "10mm x 2 mm2",
            "2 x 3 x 4 mm",
            "3 x 2 N",
            "-1mm x -1mm",
            "10 20 x 5 mm",
            "10 x 10^2 mm",
            "10 x 1\u{b7}5 mm",
        ] {
            assert!(quantity(text, "m^2").is_err(), "{text}");
        }
        // No product elsewhere, and never 1010.
        assert!(quantity("10 x 10 mm", "m").is_err() && quantity("10*10 mm", "m").is_err());
    }
}
