//! Compressed data of Digital Surf files: streams of zlib, after a table of their sizes.

use std::io::Read;

use flate2::read::ZlibDecoder;

use super::refusal::sur as refuse;
use crate::TopographyError;

/// The highest ratio of deflate: 258 bytes in two bits.
const DEFLATE_RATIO: usize = 1032;

/// The unpacked data of exactly `size` bytes.
pub(super) fn unpack(data: &[u8], size: usize) -> Result<Vec<u8>, TopographyError> {
    if size / DEFLATE_RATIO > data.len() {
        let found = format!("{} bytes", data.len());
        return Err(refuse("compressed data", found, &format!("enough for {size} unpacked bytes")));
    }
    let short = || refuse("compressed data", "a short table", "the sizes of all streams");
    let number = |bytes: &[u8; 4]| u32::from_le_bytes(*bytes) as usize;
    let (count, table) = data.split_first_chunk().ok_or_else(short)?;
    let table_size = number(count).checked_mul(8).ok_or_else(short)?;
    let (table, mut streams) = table.split_at_checked(table_size).ok_or_else(short)?;
    let sizes = table.as_chunks().0.as_chunks().0;
    let mut unpacked = Vec::with_capacity(size);
    for [plain, packed] in sizes {
        let (plain, packed) = (number(plain), number(packed));
        let wrong = |found: String| {
            let required = format!("{plain} bytes unpacked from {packed}");
            refuse("compressed data", found, &required)
        };
        let (stream, rest) = streams
            .split_at_checked(packed)
            .ok_or_else(|| wrong(format!("{} bytes", streams.len())))?;
        if plain > size - unpacked.len() {
            let required = format!("{size} bytes for the points of the header");
            return Err(refuse("compressed data", format!("streams of {plain} bytes"), &required));
        }
        let before = unpacked.len();
        // One byte more tells whether the stream ends there, and checks its checksum.
        let mut decoder = ZlibDecoder::new(stream).take(plain as u64 + 1);
        decoder.read_to_end(&mut unpacked).map_err(|error| wrong(error.to_string()))?;
        if unpacked.len() - before != plain {
            return Err(wrong(format!("{} bytes", unpacked.len() - before)));
        }
        streams = rest;
    }
    if unpacked.len() != size {
        let required = format!("{size} bytes for the points of the header");
        return Err(refuse("compressed data", format!("{} bytes", unpacked.len()), &required));
    }
    Ok(unpacked)
}
