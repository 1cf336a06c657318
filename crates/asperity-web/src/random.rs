//! Random surfaces as scans.

use asperity::bem::RandomSurface;
use asperity_topography::Topography;
use serde::{Deserialize, Serialize};

use crate::refusal::Refusal;

/// Most pixels on a side of a map that is solved in the page.
pub(crate) const MOST_PIXELS: usize = 1024;

/// What a random surface is made of; lengths are typed with a unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct RandomKeys {
    /// Pixels on a side.
    pub(crate) pixels: usize,
    /// The length of a side.
    pub(crate) side: String,
    pub(crate) longest: String,
    pub(crate) shortest: String,
    pub(crate) hurst: f64,
    /// Standard deviation of the heights.
    pub(crate) sq: String,
    pub(crate) seed: u64,
}

impl RandomKeys {
    /// The name under which the surface is handed over.
    pub(crate) fn name(&self) -> String {
        format!("random-{}.x3p", self.seed)
    }

    /// The surface as the bytes of an X3P file, which states unit and pixel size.
    pub(crate) fn file(&self) -> Result<Vec<u8>, Refusal> {
        let length = |field: &str, text: &str| {
            let length = asperity_scene::quantity(text, "m");
            length.map_err(|error| Refusal::at(field, error))
        };
        if self.pixels > MOST_PIXELS {
            let required = format!("at most {MOST_PIXELS} pixels on a side were required");
            return Err(Refusal::at(
                "random.pixels",
                format!("{} pixels: {required}", self.pixels),
            ));
        }
        let side = length("random.side", &self.side)?;
        let longest = length("random.longest", &self.longest)?;
        let shortest = length("random.shortest", &self.shortest)?;
        let sq = length("random.sq", &self.sq)?;
        let surface = RandomSurface::of_wavelengths([longest, longest, shortest], [side; 2])?;
        let surface = surface.hurst(self.hurst)?.rms_height(sq)?.seed(self.seed);
        let map = surface.heights(self.pixels)?;
        let [dy, dx] = map.pixel();
        Ok(Topography::new(map.heights().to_vec(), self.pixels, [dx, dy])?.x3p()?)
    }
}

#[cfg(test)]
pub(crate) fn example() -> RandomKeys {
    RandomKeys {
        pixels: 64,
        side: "64 um".into(),
        longest: "32 um".into(),
        shortest: "4 um".into(),
        hurst: 0.8,
        sq: "0.5 um".into(),
        seed: 3,
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
    fn wrong_numbers_are_refused_at_their_field() {
        let refused = |keys: RandomKeys| keys.file().unwrap_err();
        let found = refused(RandomKeys { pixels: 1 << 20, ..example() });
        assert_eq!(found.field.as_deref(), Some("random.pixels"));
        let found = refused(RandomKeys { sq: "0.5 V".into(), ..example() });
        assert_eq!(found.field.as_deref(), Some("random.sq"));
        let found = refused(RandomKeys { shortest: "1 um".into(), ..example() });
        assert!(found.message.contains("two pixels for the shortest wave"), "{}", found.message);
    }
}
