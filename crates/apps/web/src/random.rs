//! Random surfaces as scans.

use std::collections::BTreeMap;
use std::str::FromStr;

use asperity::bem::RandomSurface;
use asperity_topography::Topography;
use serde::Deserialize;

use crate::refusal::Refusal;

/// Most pixels on a side of a map that is solved in the page.
pub(crate) const MOST_PIXELS: usize = 1024;

/// The beginning of the names of random surfaces.
pub(crate) const RANDOM: &str = "random-";

/// What a random surface is made of, as typed; lengths have a unit: `pixels` on a side, the length
/// of a `side`, the waves from the `longest` to the `shortest`, the `hurst` exponent, the standard
/// deviation of the heights `sq`, and the `seed`.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct RandomKeys(BTreeMap<String, String>);

impl RandomKeys {
    /// A key as typed.
    fn text(&self, key: &str) -> &str {
        self.0.get(key).map_or("", |text| text.trim())
    }

    fn number<N: FromStr>(&self, key: &str, kind: &str) -> Result<N, Refusal> {
        let (field, text) = (format!("random.{key}"), self.text(key));
        let wrong = |_| format!("{field} is {text:?}: {kind} was required");
        text.parse().map_err(wrong).map_err(|reason| Refusal::at(&field, reason))
    }

    fn length(&self, key: &str) -> Result<f64, Refusal> {
        let field = format!("random.{key}");
        let length = asperity_scene::quantity(self.text(key), "m");
        length.map_err(|error| Refusal::at(&field, format!("{field}: {error}")))
    }

    /// The name under which the surface is handed over.
    pub(crate) fn name(&self) -> String {
        format!("{RANDOM}{}.x3p", self.text("seed"))
    }

    /// The surface as the bytes of an X3P file, which states unit and pixel size.
    pub(crate) fn file(&self) -> Result<Vec<u8>, Refusal> {
        let pixels = self.number("pixels", "a whole number of pixels such as 256")?;
        let hurst = self.number("hurst", "a number from 0 to 1 such as 0.8")?;
        let seed = self.number("seed", "a whole number such as 1")?;
        if pixels > MOST_PIXELS {
            let required = format!("at most {MOST_PIXELS} pixels on a side were required");
            return Err(Refusal::at("random.pixels", format!("{pixels} pixels: {required}")));
        }
        let (side, longest) = (self.length("side")?, self.length("longest")?);
        let (shortest, sq) = (self.length("shortest")?, self.length("sq")?);
        let surface = RandomSurface::of_wavelengths([longest, longest, shortest], [side; 2])?;
        let surface = surface.hurst(hurst)?.rms_height(sq)?.seed(seed);
        let map = surface.heights(pixels)?;
        let [dy, dx] = map.pixel();
        Ok(Topography::new(map.heights().to_vec(), pixels, [dx, dy])?.x3p()?)
    }
}

#[cfg(test)]
pub(crate) fn example() -> RandomKeys {
    let keys = r#"{"pixels":"64","side":"64 um","longest":"32 um","shortest":"4 um","hurst":"0.8","sq":"0.5 um","seed":"3"}"#;
    serde_json::from_str(keys).unwrap()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(key: &str, value: &str) -> RandomKeys {
        let mut keys = example();
        keys.0.insert(key.into(), value.into());
        keys
    }

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
        assert_eq!(with("pixels", " 64 ").file().unwrap(), bytes);
    }
}
