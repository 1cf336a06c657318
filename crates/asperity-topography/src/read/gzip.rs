//! Files packed by gzip.

use std::fmt::Display;
use std::io::Read;

use flate2::read::MultiGzDecoder;

use super::MAX_FILE_BYTES;
use crate::TopographyError;
use crate::error::refuse;

const MAGIC: &[u8] = b"\x1f\x8b\x08";
/// The largest ratio of unpacked to packed size: heights pack to a tenth of their size, a bomb to
/// a thousandth.
const MAX_RATIO: usize = 100;
/// Small files may have any ratio.
const SMALL: usize = 1 << 20;

pub(super) fn is_packed(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The unpacked file.
pub(super) fn unpack(packed: &[u8]) -> Result<Vec<u8>, TopographyError> {
    let limit = packed.len().saturating_mul(MAX_RATIO).max(SMALL).min(MAX_FILE_BYTES as usize);
    let refuse = |found: &dyn Display, required: &str| refuse("gzip content", found, required);
    let mut bytes = Vec::new();
    MultiGzDecoder::new(packed)
        .take(limit as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| refuse(&error, "a whole gzip file"))?;
    if bytes.len() > limit {
        let required = format!("at most {limit} bytes, {MAX_RATIO} times the packed size");
        return Err(refuse(&"more", &required));
    }
    if is_packed(&bytes) {
        return Err(refuse(&"another gzip file", "a scan; unpack the file once"));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;

    use super::*;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn a_file_is_unpacked_once_and_within_limits() {
        let text = b"1 2 3 4\n5 6 7 8\n";
        assert_eq!(unpack(&packed(text)).unwrap(), text);
        // Several members, as `cat a.gz b.gz` writes them.
        assert_eq!(unpack(&[packed(b"1 2\n"), packed(b"3 4\n")].concat()).unwrap(), b"1 2\n3 4\n");
        let message = |bytes: &[u8]| unpack(bytes).unwrap_err().to_string();
        assert!(message(&packed(&packed(text))).contains("another gzip file"));
        assert!(message(&packed(&vec![0; 4 << 20])).contains("at most 1048576 bytes"));
        let whole = packed(text);
        for length in MAGIC.len()..whole.len() {
            assert!(message(&whole[..length]).contains("a whole gzip file"), "{length}");
        }
    }
}
