//! Files that the page hands over: their size, and whether a scene can use them.

use asperity::short;
use asperity_topography::TopographyError::{
    PixelSizeMissing, TooManyMissing, Undecided, UnitMissing, UnknownName,
};
use asperity_topography::{Estimator, ReadOptions, Topography};

use serde_json::{Value, json};

use crate::refusal::Refusal;

/// The longest file, in bytes: each worker that solves the scene holds it.
pub(crate) const MOST_FILE: u64 = 128 << 20;

/// The largest share of missing points of a file that is used.
const MOST_MISSING: f64 = 0.5;

/// Refuses a file without bytes and one that is too large.
pub(crate) fn admit(name: &str, size: u64) -> Result<(), Refusal> {
    let reason = match size {
        0 => format!("{name} is empty (0 bytes): choose another file"),
        1..=MOST_FILE => return Ok(()),
        _ => format!(
            "{name} has {} MB, and the page reads at most {} MB: use the program, asperity surface {name}",
            size >> 20,
            MOST_FILE >> 20
        ),
    };
    Err(Refusal::at("surface.file", reason))
}

/// Refuses a file that no keys of a scene make usable: unit, pixel size and the options of texts
/// can be given;
/// a rough surface cannot. Where many points are missing, the answer has the `max_missing` that
/// uses the others.
pub(crate) fn usable(name: &str, bytes: &[u8]) -> Result<Value, Refusal> {
    let refused = |reason: String| Err(Refusal::at("surface.file", format!("{name}: {reason}")));
    let read = asperity_topography::read_bytes(name, bytes, &ReadOptions::default());
    // A scan needs roughness.
    let measured = |scan: Topography| scan.levelled(None)?.statistics(Estimator::Moments);
    match read.and_then(measured).map(drop) {
        Ok(()) | Err(UnitMissing | PixelSizeMissing | Undecided { .. }) => Ok(Value::Null),
        Err(UnknownName { field: "channel", .. }) => Ok(Value::Null),
        Err(TooManyMissing { share, limit }) => {
            let [percent, usual] = [100.0 * share, 100.0 * limit].map(short);
            let fact = format!("{percent} % of the points are missing");
            if share > MOST_MISSING {
                return refused(format!(
                    "{fact}, and the others do not describe the surface: measure again, or crop the scan to its measured part"
                ));
            }
            Ok(json!({
                "message": format!("{name}: {fact}, and {usual} % are usual"),
                "value": format!("{:.2}", share + 0.005),
            }))
        }
        Err(error) => refused(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_lack_what_keys_can_give_are_usable_and_others_are_not() {
        let row = |k: usize| format!("{} 2 {} 4 1 3 5 7\n", k * k % 7, k % 5);
        let numbers: String = (0..8).map(row).collect();
        assert!(usable("a.txt", numbers.as_bytes()).is_ok());
        let refused = usable("a.x3p", b"PK\x03\x04 nothing").unwrap_err();
        assert_eq!(refused.field.as_deref(), Some("surface.file"));
        assert!(usable("a.txt", "nan nan\n".repeat(9).as_bytes()).is_err());
        // `channel` decides.
        assert!(usable("a.txt", format!("{numbers}# other\n{numbers}").as_bytes()).is_ok());
    }

    #[test]
    fn missing_points_are_left_out_by_one_change_unless_they_are_the_most() {
        let row = |missing: usize, k: usize| {
            let values = ["3", "1", "4", "2"].map(|z| if k < missing { "nan" } else { z });
            values.join("\t") + "\n"
        };
        let of = |missing: usize| {
            let head = "# Width: 4 um\n# Height: 8 um\n# Value units: nm\n";
            let rows: String = (0..8).map(|k| row(missing, k)).collect();
            usable("a.txt", (head.to_string() + &rows).as_bytes())
        };
        let offer = of(2).unwrap();
        assert_eq!(offer["value"], "0.26");
        assert!(of(7).is_err());
    }

    #[test]
    fn flat_scans_and_pictures_are_not_usable() {
        let head = String::from("# Width: 4 um\n# Height: 8 um\n# Value units: nm\n");
        let flat = head + &"1\t1\t1\t1\n".repeat(8);
        assert!(usable("flat.txt", flat.as_bytes()).is_err());
        assert!(usable("photo.jpg", b"\xff\xd8\xff\xe0 JFIF").is_err());
    }
}
