//! Areas given by two sides: 10 mm x 20 mm.

use crate::scaled::scale;

/// An area in m² by its two sides: `10mm x 20mm`, `10 x 20 mm` or `10 x 20 mm2`, without spaces and
/// ignored characters.
pub(crate) fn area(text: &str, lengths: &[(&str, i32)], areas: &[(&str, i32)]) -> Option<f64> {
    let (first, second) = text.split_once(['x', 'X', '\u{d7}', '*'])?;
    let number = |text: &str| scale(text, 0).filter(|side| *side > 0.0);
    let of = |text: &str, units: &[(&str, i32)]| {
        let found = |(unit, power): &(&str, i32)| Some((number(text.strip_suffix(unit)?)?, *power));
        units.iter().find_map(found)
    };
    let (product, power) = match (of(first, lengths), number(first)) {
        (Some((a, of_first)), _) => {
            let (b, of_second) = of(second, lengths)?;
            (a * b, of_first + of_second)
        }
        (None, Some(a)) => match (of(second, areas), of(second, lengths)) {
            (Some((b, power)), _) => (a * b, power),
            (None, Some((b, power))) => (a * b, 2 * power),
            (None, None) => return None,
        },
        (None, None) => return None,
    };
    scale(&format!("{product:e}"), power)
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
        ] {
            assert!(quantity(text, "m^2").is_err(), "{text}");
        }
        // No product elsewhere, and never 1010.
        assert!(quantity("10 x 10 mm", "m").is_err() && quantity("10*10 mm", "m").is_err());
    }
}
