//! Random surfaces as scans.

use std::str::FromStr;

use asperity::bem::RandomSurface;
use asperity_topography::Topography;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

use crate::refusal::Refusal;

/// Most pixels on a side of a map that is solved in the page.
pub(crate) const MOST_PIXELS: usize = 1024;

/// The beginning of the names of random surfaces.
pub(crate) const RANDOM: &str = "random-";

/// What a random surface is made of, as typed; lengths have a unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct RandomKeys {
    /// Pixels on a side.
    #[serde(deserialize_with = "text")]
    pub(crate) pixels: String,
    /// The length of a side.
    pub(crate) side: String,
    pub(crate) longest: String,
    pub(crate) shortest: String,
    #[serde(deserialize_with = "text")]
    pub(crate) hurst: String,
    /// Standard deviation of the heights.
    pub(crate) sq: String,
    #[serde(deserialize_with = "text")]
    pub(crate) seed: String,
}

/// A text, or a number as links had it.
fn text<'d, D: Deserializer<'d>>(from: D) -> Result<String, D::Error> {
    Ok(match Value::deserialize(from)? {
        Value::String(text) => text,
        number => number.to_string(),
    })
}

fn number<N: FromStr>(key: &str, text: &str, kind: &str) -> Result<N, Refusal> {
    let field = format!("random.{key}");
    let wrong = |_| format!("{field} is {:?}: {kind} was required", text.trim());
    text.trim().parse().map_err(wrong).map_err(|reason| Refusal::at(&field, reason))
}

impl RandomKeys {
    /// The name under which the surface is handed over.
    pub(crate) fn name(&self) -> String {
        format!("{RANDOM}{}.x3p", self.seed.trim())
    }

    /// The surface as the bytes of an X3P file, which states unit and pixel size.
    pub(crate) fn file(&self) -> Result<Vec<u8>, Refusal> {
        let length = |field: &str, text: &str| {
            let length = asperity_inputs::quantity(text, "m");
            length.map_err(|error| Refusal::at(field, format!("{field}: {error}")))
        };
        let pixels = number("pixels", &self.pixels, "a whole number of pixels such as 256")?;
        let hurst = number("hurst", &self.hurst, "a number from 0 to 1 such as 0.8")?;
        let seed = number("seed", &self.seed, "a whole number such as 1")?;
        if pixels > MOST_PIXELS {
            let required = format!("at most {MOST_PIXELS} pixels on a side were required");
            return Err(Refusal::at("random.pixels", format!("{pixels} pixels: {required}")));
        }
        let side = length("random.side", &self.side)?;
        let longest = length("random.longest", &self.longest)?;
        let shortest = length("random.shortest", &self.shortest)?;
        let sq = length("random.sq", &self.sq)?;
        let surface = RandomSurface::of_wavelengths([longest, longest, shortest], [side; 2])?;
        let surface = surface.hurst(hurst)?.rms_height(sq)?.seed(seed);
        let map = surface.heights(pixels)?;
        let [dy, dx] = map.pixel();
        Ok(Topography::new(map.heights().to_vec(), pixels, [dx, dy])?.x3p()?)
    }
}

#[cfg(test)]
pub(crate) fn example() -> RandomKeys {
    RandomKeys {
        pixels: "64".into(),
        side: "64 um".into(),
        longest: "32 um".into(),
        shortest: "4 um".into(),
        hurst: "0.8".into(),
        sq: "0.5 um".into(),
        seed: "3".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_random_surface_is_a_file_with_its_height_and_pixel() {
        let keys = example();
        let bytes = keys.file().unwrap();
        assert_eq!(bytes, keys.file().unwrap());
        let read = asperity_topography::read_bytes(&keys.name(), &bytes, &Default::default());
        let read = read.unwrap();
        assert_eq!((read.rows(), read.columns(), read.pixel_size()), (64, 64, [1e-6; 2]));
        let square: f64 = read.heights().iter().map(|z| z * z).sum();
        assert!(((square / 4096.0).sqrt() / 0.5e-6 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn typed_numbers_are_checked_at_their_field() {
        let typed = |pixels: &str, seed: &str| RandomKeys {
            pixels: pixels.into(),
            seed: seed.into(),
            ..example()
        };
        assert_eq!(typed(" 64 ", "3").file().unwrap(), example().file().unwrap());
        for (keys, field, text) in [
            (typed("abc", "3"), "random.pixels", "abc"),
            (typed("64", "-1"), "random.seed", "-1"),
            (typed("1e9", "3"), "random.pixels", "1e9"),
        ] {
            let refused = keys.file().unwrap_err();
            assert_eq!(refused.field.as_deref(), Some(field));
            assert!(refused.message.contains(text), "{}", refused.message);
        }
        // Older links have numbers.
        let old = r#"{"pixels":64,"side":"64 um","longest":"32 um","shortest":"4 um","hurst":0.8,"sq":"0.5 um","seed":3}"#;
        assert_eq!(serde_json::from_str::<RandomKeys>(old).unwrap(), example());
    }

    #[test]
    fn wrong_numbers_are_refused_at_their_field() {
        let refused = |keys: RandomKeys| keys.file().unwrap_err();
        let found = refused(RandomKeys { pixels: "1048576".into(), ..example() });
        assert_eq!(found.field.as_deref(), Some("random.pixels"));
        let found = refused(RandomKeys { sq: "0.5 V".into(), ..example() });
        assert_eq!(found.field.as_deref(), Some("random.sq"));
        let found = refused(RandomKeys { shortest: "1 um".into(), ..example() });
        assert!(found.message.contains("two pixels for the shortest wave"), "{}", found.message);
    }
}
