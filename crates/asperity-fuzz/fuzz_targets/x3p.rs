#![no_main]
//! The bytes of an archive; or, after a `!`, its main.xml, a zero byte and its heights. The
//! checksums, which a mutation would never match, are then computed.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let parts = bytes.strip_prefix(b"!").and_then(|parts| {
        let end = parts.iter().position(|byte| *byte == 0)?;
        Some((&parts[..end], &parts[end + 1..]))
    });
    let Some((xml, heights)) = parts else { return asperity_fuzz::measure("a.x3p", bytes) };
    // One bit for each height in doubles.
    let valid = &heights[..heights.len().div_ceil(64)];
    let mut archive = ZipWriter::new(Cursor::new(vec![]));
    for (name, part) in
        [("main.xml", xml), ("bindata/data.bin", heights), ("bindata/valid.bin", valid)]
    {
        archive.start_file(name, SimpleFileOptions::default()).expect("memory to write to");
        archive.write_all(part).expect("memory to write to");
    }
    let archive = archive.finish().expect("memory to write to").into_inner();
    asperity_fuzz::measure("a.x3p", &archive);
});
