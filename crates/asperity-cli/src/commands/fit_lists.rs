//! Lists of free parameters and of targets, whose numbers may be typed with decimal commas.

use std::str::FromStr;

use asperity_inputs::Free;

use crate::input::target::target;

/// The items of one argument.
#[derive(Debug, Clone)]
pub struct List<T>(Vec<T>);

/// The items of all arguments.
pub fn all<T: Clone>(lists: &[List<T>]) -> Vec<T> {
    lists.iter().flat_map(|list| list.0.iter().cloned()).collect()
}

/// Free parameters, separated by commas.
pub fn free(text: &str) -> Result<List<Free>, String> {
    items(text, Free::from_str)
}

/// Targets, separated by commas.
pub fn targets(text: &str) -> Result<List<(String, f64)>, String> {
    items(text, target)
}

/// The items of a list; names follow its commas, so that a digit is behind a decimal comma.
fn items<T>(text: &str, read: impl Fn(&str) -> Result<T, String>) -> Result<List<T>, String> {
    let begins = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    if text.split(',').skip(1).any(begins) {
        let mut parts = text.split(',');
        let mut written = parts.next().unwrap_or_default().to_string();
        for part in parts {
            written.push(if begins(part) { '.' } else { ',' });
            written.push_str(part);
        }
        // Three digits are thousands, and 1GPa.5GPa is no number.
        let groups = text
            .split(',')
            .skip(1)
            .map(|part| part.chars().take_while(char::is_ascii_digit).count());
        let is_clear = written.split(',').all(|part| read(part).is_ok())
            && !groups.into_iter().any(|digits| digits == 3);
        return Err(match is_clear {
            true => format!("numbers have decimal points, commas separate items; write {written}"),
            false => "commas separate items; write numbers with decimal points and without thousands separators, and bounds as low:high".into(),
        });
    }
    text.split(',').map(read).collect::<Result<_, _>>().map(List)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_commas_are_told_from_those_between_items() {
        for (text, wanted) in [
            ("area_fraction=0,1%", "write area_fraction=0.1%"),
            ("area=1e-6,area_fraction=0,1%", "write area=1e-6,area_fraction=0.1%"),
        ] {
            assert!(targets(text).unwrap_err().ends_with(wanted), "{text}");
        }
        for (text, not) in [
            ("hardness=1GPa,5GPa", "1GPa.5GPa"),
            ("hardness=1,000,000:5e9", "1.000"),
            ("hardness=1,500:5e9", "1.500"),
        ] {
            let refused = free(text).unwrap_err();
            assert!(refused.ends_with("bounds as low:high") && !refused.contains(not), "{refused}");
        }
        let refused = free("hardness,asperity_height_std=0,1um:2,5um").unwrap_err();
        assert!(refused.ends_with("write hardness,asperity_height_std=0.1um:2.5um"), "{refused}");
        let lists = ["hardness,nominal_area", "asperity_radius=1um:2um"].map(free);
        let names: Vec<String> =
            all(&lists.map(Result::unwrap)).into_iter().map(|free| free.name).collect();
        assert_eq!(names, ["hardness", "nominal_area", "asperity_radius"]);
        assert_eq!(all(&[targets("area=1e-6,tangent=2").unwrap()]).len(), 2);
    }
}
