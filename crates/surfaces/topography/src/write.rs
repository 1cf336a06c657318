//! Surfaces to files.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::{Topography, TopographyError};

impl Topography {
    /// The bytes of an ISO 25178-72 `.x3p` file: heights as doubles in metres, NaN for missing
    /// points. The same surface gives the same bytes.
    ///
    /// # Errors
    /// [`TopographyError::Io`] when the archive cannot be made.
    pub fn x3p(&self) -> Result<Vec<u8>, TopographyError> {
        let heights: Vec<u8> = self.heights().iter().flat_map(|z| z.to_le_bytes()).collect();
        let failed = |error: zip::result::ZipError| TopographyError::Io(error.into());
        let mut archive = ZipWriter::new(Cursor::new(vec![]));
        let options = SimpleFileOptions::default().large_file(heights.len() as u64 >= 1 << 32);
        let xml = self.main_xml(&format!("{:X}", md5::compute(&heights)));
        let sum = format!("{:x} *main.xml\n", md5::compute(&xml));
        let entries = [
            ("main.xml", xml.as_bytes()),
            ("bindata/data.bin", &heights),
            ("md5checksum.hex", sum.as_bytes()),
        ];
        for (name, bytes) in entries {
            archive.start_file(name, options).map_err(failed)?;
            archive.write_all(bytes)?;
        }
        Ok(archive.finish().map_err(failed)?.into_inner())
    }

    /// The description, by the schema of ISO 5436-2. \[recalled\]
    fn main_xml(&self, sum: &str) -> String {
        let [dx, dy] = self.pixel_size();
        let numbers = [
            ("@kind", if self.is_profile() { "PRF" } else { "SUR" }.to_owned()),
            ("@dx", format!("{dx:e}")),
            ("@dy", format!("{dy:e}")),
            ("@columns", self.columns().to_string()),
            ("@rows", self.rows().to_string()),
            ("@sum", sum.to_owned()),
        ];
        let fill = |xml: String, (name, number): &(&str, String)| xml.replace(name, number);
        numbers.iter().fold(include_str!("main.xml").to_owned(), fill)
    }
}

#[cfg(test)]
mod tests {
    use crate::{ReadOptions, Topography, read_bytes};

    #[test]
    fn what_is_written_is_read_to_the_last_digit() {
        let heights = vec![1e-7 / 3.0, -2e-9, f64::NAN, 4e-6, 5e-300, -1.0];
        for (columns, pixel) in [(3, [1e-6 / 3.0, 2.5e-7]), (6, [1e-7 / 7.0; 2])] {
            let surface = Topography::new(heights.clone(), columns, pixel).unwrap();
            let bytes = surface.x3p().unwrap();
            assert_eq!(bytes, surface.x3p().unwrap());
            let options = ReadOptions { max_missing: Some(0.5), ..ReadOptions::default() };
            let read = read_bytes("s.x3p", &bytes, &options).unwrap();
            assert_eq!((read.columns(), read.pixel_size()), (columns, pixel));
            for (found, wanted) in read.heights().iter().zip(surface.heights()) {
                assert!(found.to_bits() == wanted.to_bits() || found.is_nan() && wanted.is_nan());
            }
        }
    }
}
