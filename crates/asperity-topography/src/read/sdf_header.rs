//! The header of an SDF file, text or binary.

use super::refusal::sdf as refuse;
use super::sample::{Kind, Sample};
use super::scan::points;
use crate::TopographyError;

/// The fields of a header. Lengths are in m.
pub(super) struct Header {
    pub(super) columns: u64,
    pub(super) rows: u64,
    pub(super) scales: [f64; 3],
    /// Compression and checksum, which are not read.
    pub(super) packing: [u8; 2],
    pub(super) data_type: u8,
    /// Whether the largest number of the type marks missing points, as in BCR-1.0. In ISO it is
    /// the smallest.
    pub(super) largest_is_missing: bool,
}

impl Header {
    /// The number of points.
    pub(super) fn points(&self) -> Result<usize, TopographyError> {
        for (packing, field) in self.packing.into_iter().zip(["Compression", "CheckType"]) {
            if packing != 0 {
                return Err(refuse(field, packing, "0: none"));
            }
        }
        for (n, field) in [(self.columns, "NumPoints"), (self.rows, "NumProfiles")] {
            if n == 0 {
                return Err(refuse(field, n, "at least 1"));
            }
        }
        points(self.columns, self.rows)
    }

    pub(super) fn sample(&self) -> Result<Sample, TopographyError> {
        let kind = match self.data_type {
            0 => Kind::U8,
            1 => Kind::U16,
            2 => Kind::U32,
            3 => Kind::F32,
            4 => Kind::I8,
            5 => Kind::I16,
            6 => Kind::I32,
            7 => Kind::F64,
            other => return Err(refuse("DataType", other, "0 to 7")),
        };
        Ok(Sample { kind, big_endian: false })
    }

    /// NaN for numbers that mark missing points.
    pub(super) fn mark(&self, heights: &mut [f64]) -> Result<(), TopographyError> {
        let (least, largest) = match self.sample()?.kind {
            Kind::U8 => (-1.0, 255.0),
            Kind::U16 => (-1.0, 65_535.0),
            Kind::U32 => (-1.0, 4_294_967_295.0),
            Kind::I8 => (-128.0, 127.0),
            Kind::I16 => (-32_768.0, 32_767.0),
            Kind::I32 => (-2_147_483_648.0, 2_147_483_647.0),
            // Files print the limit with few digits.
            Kind::F32 => (-3.4e38, 3.4e38),
            _ => (-1.7e308, 1.7e308),
        };
        let missing = |height: f64| match self.largest_is_missing {
            true => height >= largest,
            false => height <= least,
        };
        for height in heights.iter_mut().filter(|height| missing(**height)) {
            *height = f64::NAN;
        }
        Ok(())
    }

    pub(super) fn pixel_size(&self) -> Result<[f64; 2], TopographyError> {
        let [x, y, _] = self.scales;
        let dx = positive("Xscale", x)?;
        // A profile has no distance of rows.
        Ok([dx, if self.rows == 1 { dx } else { positive("Yscale", y)? }])
    }

    pub(super) fn height_scale(&self) -> Result<f64, TopographyError> {
        positive("Zscale", self.scales[2])
    }
}

fn positive(field: &'static str, value: f64) -> Result<f64, TopographyError> {
    let fits = value.is_finite() && value > 0.0;
    if fits { Ok(value) } else { Err(refuse(field, value, "a finite number above 0")) }
}
