//! Files that the page hands over: their size, and whether a scene can use them.

use asperity_topography::TopographyError::{
    PixelSizeMissing, TooManyMissing, UnitMissing, UnknownName,
};
use asperity_topography::{Estimator, ReadOptions, Topography, TopographyError};

use crate::fields::fields;
use crate::refusal::Refusal;

/// The longest file, in bytes: each worker that solves the scene holds it.
pub(crate) const MOST_FILE: u64 = 128 << 20;

/// Largest share of missing points at which a file is accepted; `max_missing` of the scene decides
/// later.
const MOST_MISSING: f64 = 0.99;

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

/// Refuses a file that no keys of a scene make usable: unit, pixel size, channel, estimator and the
/// share of missing points can be given; a rough surface cannot, and is required of files that
/// state unit and pixel size. The scene refuses the others once it has these.
///
/// A scan that has values is kept: in its place, a file must have few missing points at once.
pub(crate) fn usable(name: &str, bytes: &[u8], kept: Option<&str>) -> Result<(), Refusal> {
    let most = |scene| {
        let given = fields(scene).get("surface.max_missing").and_then(|most| most.parse().ok());
        given.unwrap_or(ReadOptions::default().max_missing)
    };
    let max_missing = kept.map_or(MOST_MISSING, most);
    let options = ReadOptions { max_missing, ..ReadOptions::default() };
    match asperity_topography::read_bytes(name, bytes, &options).and_then(measurable) {
        Ok(()) | Err(UnitMissing | PixelSizeMissing | UnknownName { field: "channel", .. }) => {
            Ok(())
        }
        Err(error @ TooManyMissing { .. }) if kept.is_some() => Err(Refusal::at(
            "surface.file",
            format!(
                "{name}: {error}; the scan before is kept: raise \"Missing points, at most\" in \
                 \"More about the scan\" and choose this file again"
            ),
        )),
        Err(error) => Err(Refusal::at("surface.file", format!("{name}: {error}"))),
    }
}

/// Refuses a scan without roughness.
fn measurable(scan: Topography) -> Result<(), TopographyError> {
    scan.levelled(None)?.statistics(Estimator::Moments).map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_lack_what_keys_can_give_are_usable_and_others_are_not() {
        let row = |k: usize| format!("{} 2 {} 4 1 3 5 7\n", k * k % 7, k % 5);
        let numbers: String = (0..8).map(row).collect();
        assert!(usable("a.txt", numbers.as_bytes(), None).is_ok());
        let refused = usable("a.x3p", b"PK\x03\x04 nothing", None).unwrap_err();
        assert!(refused.message.starts_with("a.x3p: "), "{}", refused.message);
        assert_eq!(refused.field.as_deref(), Some("surface.file"));
        assert!(usable("a.txt", "nan nan\n".repeat(9).as_bytes(), None).is_err());
    }

    #[test]
    fn a_scan_with_values_is_kept_if_many_points_of_another_are_missing() {
        let row = |k: usize| if k < 4 { "nan\t1\t3\t2\n" } else { "2\t4\t1\t3\n" };
        let head = "# Width: 4 um\n# Height: 8 um\n# Value units: nm\n";
        let text = head.to_string() + &(0..8).map(row).collect::<String>();
        let usable = |kept: Option<&str>| usable("a.txt", text.as_bytes(), kept);
        assert!(usable(None).is_ok());
        let refused = usable(Some("[surface]\nfile = \"b.x3p\"\n")).unwrap_err().message;
        assert!(refused.contains("0.1250") && refused.contains("is kept: raise"), "{refused}");
        assert!(usable(Some("[surface]\nfile = \"b.x3p\"\nmax_missing = 0.2\n")).is_ok());
    }

    #[test]
    fn flat_scans_and_pictures_are_not_usable() {
        let flat = Topography::new(vec![1e-9; 64], 8, [1e-6; 2]).unwrap();
        let refused = measurable(flat).unwrap_err().to_string();
        assert!(refused.contains("a rough surface was required"), "{refused}");
        let refused = usable("photo.jpg", b"\xff\xd8\xff\xe0 JFIF", None).unwrap_err().message;
        let wanted =
            "photo.jpg: the file is a picture (JPEG): a map of heights was required, as csv";
        assert!(refused.starts_with(wanted), "{refused}");
    }
}
