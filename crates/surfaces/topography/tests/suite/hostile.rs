//! Broken and hostile files give an error that states the fault.

use asperity_topography::{Distance, Estimator, ReadOptions, read_bytes};

use crate::files::{Sur, X3p, archive, gwy, gwy_field, gzip, item, x3p_of};

/// Options that accept as many files as possible.
pub fn lenient() -> ReadOptions {
    ReadOptions {
        unit: Some("um".parse().unwrap()),
        pixel_size: Some([Distance::from(1.0); 2]),
        max_missing: Some(1.0),
        ..ReadOptions::default()
    }
}

fn refused(name: &str, bytes: &[u8], expected: &str) {
    let options = match name {
        "a.x3p" | "a.sur" => ReadOptions::default(),
        _ => lenient(),
    };
    let message = read_bytes(name, bytes, &options).unwrap_err().to_string();
    assert!(message.contains(expected), "{name}: {message}");
    assert!(
        [
            "required",
            "damaged",
            "in the file",
            "give unit",
            "give pixel_size",
            "looks like m",
            "converts"
        ]
        .iter()
        .any(|part| message.contains(part)),
        "{message}"
    );
    assert!(message.len() < 600, "{message}");
}

pub fn npy(header: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(data);
    bytes
}

pub fn npy_of(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    npy(&format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}"), data)
}

pub fn waves(n: i32) -> Vec<f64> {
    (0..n * n).map(|i| 9.0 * f64::from(i % n).sin() + 7.0 * f64::from(i / n).cos()).collect()
}

#[test]
fn empty_and_foreign_files() {
    for name in ["a.npy", "a.x3p", "a.sur"] {
        refused(name, b"", "damaged");
        refused(name, b"\x00\x01\x02\x03", "damaged");
    }
    for name in ["a.txt", "a.csv", "a.xyz", "a", ""] {
        refused(name, b"", "required");
        refused(name, b"\x00\x01\x02\x03", "required");
    }
    refused("a.bin", b"1 2\n\x00\x01", "of unknown format");
    refused("a.spm", b"\x02\x03", "read_topography('FILE').to_gwy('FILE.gwy')");
    refused("a.spm", b"\\*File list\r\n\x00", "format Bruker Nanoscope");
    refused("a.x3p", b"\\*File list\r\n\x00", "format Bruker Nanoscope");
}

#[test]
fn hostile_text() {
    refused("a.txt", b"1 2 3 4\n1 2 \xff 4\n", "line 2: \"\u{ff}\"");
    refused("a.txt", b"# Width: 1e400 um\n1 2 3 4\n", "line 1");
    refused("a.txt", b"# Width: -3 um\n1 2 3 4\n", "line 1");
    refused("a.csv", b"0 1\n1e308 1\n-1e308 2\n", "x: ");
    refused("a.xyz", b"0 0 1\n1e308 1 1\n-1e308 2 1\n", "x: ");
    refused("a.xyz", b"0 0 1\n1 0 1\n1e9 1e9 1\n2 5 1\n", "required");
    refused("a.txt", "x".repeat(100_000).as_bytes(), "a row of numbers");
}

#[test]
fn hostile_npy() {
    let good = npy_of("<f8", "(2, 3)", &[0; 48]);
    assert!(read_bytes("a.npy", &good, &lenient()).is_ok());
    for length in 0..good.len() {
        assert!(read_bytes("a.npy", &good[..length], &lenient()).is_err(), "{length}");
    }
    refused("a.npy", &npy_of("<f8", "(4294967295, 4294967295)", &[]), "number of points");
    refused("a.npy", &npy_of("<f8", "(18446744073709551615, 2)", &[]), "number of points");
    refused("a.npy", &npy_of("<f8", "(99999999999999999999, 2)", &[]), "whole numbers");
    refused("a.npy", &npy_of("<f8", "(-1, 2)", &[]), "whole numbers");
    refused("a.npy", &npy_of("<f8", "()", &[0; 8]), "(n,) or (rows, columns)");
    refused("a.npy", &npy_of("<f8", "(0, 3)", &[]), "heights: 0 in rows");
    refused("a.npy", &npy_of("<f8", "(2, 3)", &[0; 49]), "49 bytes");
    refused("a.npy", &npy_of("|O", "(2, 3)", &[0; 48]), "|O");
    refused("a.npy", &npy_of("é", "(2, 3)", &[0; 48]), "é");
    refused("a.npy", &npy(&"(".repeat(9_000), &[]), "plain numbers");
    let mut gigantic = b"\x93NUMPY\x02\x00\xff\xff\xff\xff".to_vec();
    gigantic.extend([b' '; 100]);
    refused("a.npy", &gigantic, "4294967295 bytes");
    // In the wrong byte order, heights of a µm are out of range or vanish.
    let wrong: Vec<u8> = (1..7).flat_map(|i| f64::from(i).to_be_bytes()).collect();
    let swapped = read_bytes("a.npy", &npy_of("<f8", "(2, 3)", &wrong), &lenient());
    let flat = swapped.map(|surface| surface.statistics(Estimator::Moments).is_err());
    assert!(flat.unwrap_or(true));
    let infinite: Vec<u8> = (0..6).flat_map(|i| (1.0 / f64::from(i)).to_le_bytes()).collect();
    refused("a.npy", &npy_of("<f8", "(2, 3)", &infinite), "row 0, column 0");
}

#[test]
fn npz_archives_are_recognised() {
    let array = npy_of("<f8", "(2, 3)", &[0; 48]);
    let archive = archive(&[("height.npy", &array), ("x.npy", &array)]);
    for name in ["a.npz", "a.NPZ", "a.x3p", "a.zip", "a"] {
        refused(name, &archive, "numpy.save(\"scan.npy\", numpy.load(\"FILE\")[name])");
    }
}

#[test]
fn options_are_refused_before_a_file_is_read() {
    let of = |max_missing, dx| ReadOptions {
        pixel_size: Some([1.0, dx].map(Distance::from)),
        max_missing: Some(max_missing),
        ..ReadOptions::default()
    };
    for (options, wanted) in [
        (of(-0.1, 1.0), "max_missing is -0.1"),
        (of(f64::NAN, 1.0), "max_missing is NaN"),
        (of(0.1, 0.0), "pixel_size is 0:"),
        (of(0.1, f64::NAN), "pixel_size is NaN"),
        (of(0.1, f64::INFINITY), "pixel_size is inf"),
    ] {
        let message = read_bytes("a.txt", b"", &options).unwrap_err().to_string();
        assert!(message.starts_with(wanted), "{message}");
    }
}

#[test]
fn hostile_sur() {
    let heights: Vec<f64> = (0..20).map(f64::from).collect();
    let good = Sur::default().bytes(&heights);
    assert!(read_bytes("a.sur", &good, &ReadOptions::default()).is_ok());
    let sized = |size| Sur { size, ..Sur::default() }.bytes(&heights);
    refused("a.sur", &sized([i32::MAX, i32::MAX]), "number of points");
    refused("a.sur", &sized([5, -4]), "number of rows: -4");
    let comment = Sur { comment: 7, ..Sur::default() }.bytes(&heights);
    refused("a.sur", &comment[..comment.len() - 1], "after the comments");
    let with = |at: usize, bytes: &[u8]| {
        let mut broken = good.clone();
        broken[at..at + bytes.len()].copy_from_slice(bytes);
        broken
    };
    refused("a.sur", &with(12, &[1, 0]), "order of bytes");
    refused("a.sur", &with(98, &[0, 32]), "bits of a point: 8192");
    refused("a.sur", &with(128, &f32::NAN.to_le_bytes()), "one step: NaN");
    refused("a.sur", &with(120, &f32::INFINITY.to_le_bytes()), "distance of columns: inf");
    refused("a.sur", &with(124, &0f32.to_le_bytes()), "distance of rows: 0");
}

#[test]
fn hostile_compressed_sur() {
    let heights: Vec<f64> = (0..20).map(f64::from).collect();
    let good = Sur { streams: 2, ..Sur::default() }.bytes(&heights);
    let with = |at: usize, bytes: &[u8]| {
        let mut broken = good.clone();
        broken[at..at + bytes.len()].copy_from_slice(bytes);
        broken
    };
    let refused = |bytes: &[u8], expected: &str| refused("a.sur", bytes, expected);
    refused(&with(108, &[0, 0, 1, 0, 0, 0, 1, 0]), "number of points");
    refused(&with(324, &u32::MAX.to_le_bytes()), "after the comments");
    refused(&with(14, &3u16.to_le_bytes()), "objects: 1 of 3");
    // Columns, bytes of the data, number of streams, their sizes plain and packed, and content.
    let [few, all] = [3, u32::MAX];
    for (at, number) in
        [(108, 10_000), (324, few), (512, all), (516, 39), (516, all), (520, all), (536, all)]
    {
        refused(&with(at, &number.to_le_bytes()), "compressed data are not those");
    }
}

#[test]
fn hostile_gwy() {
    let field = |heights: &[f64]| item("/0/data", b'o', &gwy_field(heights, "m", "m"));
    let good = gwy(&[field(&waves(9)[..20])]);
    let options = ReadOptions::default();
    assert!(read_bytes("a.gwy", &good, &options).is_ok());
    let refused = |bytes: &[u8], expected: &str| {
        let message = read_bytes("a.gwy", bytes, &options).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}");
    };
    refused(&gwy(&[field(&waves(9)[..19])]), "data: 19 numbers");
    let with = |text: &[u8], bytes: &[u8]| {
        let at = good.windows(text.len()).position(|part| part == text).unwrap() + text.len();
        let mut broken = good.clone();
        broken[at..at + bytes.len()].copy_from_slice(bytes);
        broken
    };
    refused(&with(b"xres\0i", &[0; 4]), "xres: 0; required: a finite number above 0");
    refused(&with(b"xres\0i", &[0xff; 4]), "xres: -1");
    let big = with(b"xres\0i", &1_000_000_000i32.to_le_bytes());
    refused(&big, "points: 4000000000");
    refused(&with(b"yreal\0d", &f64::NAN.to_le_bytes()), "yreal: NaN");
    refused(&with(b"data\0D", &[0xff; 4]), "container");
    refused(&with(b"GwySIUnit\0", &[0xff; 4]), "container");
    refused(&with(b"GwyContainer\0", &[0xff; 4]), "no whole GwyContainer");
    refused(&with(b"xres\0", b"?"), "container");
    refused(&gwy(&[]), "no heights among");
}

#[test]
fn hostile_gzip() {
    let options = lenient();
    let message = |bytes: &[u8]| read_bytes("a.txt.gz", bytes, &options).unwrap_err().to_string();
    // Several members, as `cat a.gz b.gz` writes them.
    let members = [gzip(b"1 2 4 3\n"), gzip(b"3 4 1 2\n")].concat();
    assert_eq!(read_bytes("a.txt.gz", &members, &options).unwrap().rows(), 2);
    assert!(message(&gzip(b"")).contains("a row of numbers"));
    let mut flipped = gzip(b"1 2 3 4\n5 6 7 8\n");
    let at = flipped.len() - 6;
    flipped[at] ^= 1;
    assert!(message(&flipped).contains("gzip"));
}

#[test]
fn hostile_x3p() {
    let data: Vec<u8> = (0..20).flat_map(|i| (f64::from(i) * 1e-6).to_le_bytes()).collect();
    let good = x3p_of(&X3p { data: data.clone(), ..X3p::default() });
    assert!(read_bytes("a.x3p", &good, &ReadOptions::default()).is_ok());
    for length in 0..good.len() {
        let error = read_bytes("a.x3p", &good[..length], &lenient()).unwrap_err().to_string();
        // In words of surfaces, not of archives.
        let internal = ["EOCD", "archive", "deflate", "stream", "checksum", "buffer"];
        assert!(internal.iter().all(|word| !error.contains(word)), "{length}: {error}");
    }
    refused("a.x3p", &good[..good.len() / 2], "list of its parts");
    let sized = |size| x3p_of(&X3p { data: data.clone(), size, ..X3p::default() });
    refused("a.x3p", &sized([u64::MAX, u64::MAX]), "number of points");
    refused("a.x3p", &sized([10_000, 10_000]), "for these points");
    refused("a.x3p", &sized([5, 5]), "200 bytes, by main.xml");
    refused("a.x3p", &sized([5, 3]), "120 bytes, by main.xml");
    refused("a.x3p", &sized([5, 0]), "SizeY: 0");
    let of_z = |of_z| x3p_of(&X3p { data: data.clone(), of_z, ..X3p::default() });
    refused("a.x3p", &of_z("<Increment>inf</Increment>"), "CZ Increment: inf");
    refused("a.x3p", &of_z("<Offset>much</Offset>"), "CZ Offset: much");
    refused("a.x3p", &x3p_of(&X3p { kind: "X", ..X3p::default() }), "CZ DataType: X");
    refused("a.x3p", &x3p_of(&X3p { feature: "PCX", ..X3p::default() }), "FeatureType: PCX");
    let short = X3p { data: data.clone(), valid: Some(vec![0xff; 2]), ..X3p::default() };
    refused("a.x3p", &x3p_of(&short), "3 bytes, by main.xml");
    refused("a.x3p", &archive(&[("other.xml", b"<a/>")]), "main.xml");
    refused("a.x3p", &archive(&[("main.xml", b"\xff\xfe")]), "UTF-8");
    let xml = X3p::default().xml();
    refused("a.x3p", &archive(&[("main.xml", xml.as_bytes())]), "bindata/data.bin");
    // Depth, breadth, and entities that grow.
    let deep = "<a>".repeat(300_000);
    refused("a.x3p", &archive(&[("main.xml", deep.as_bytes())]), "an XML document");
    let broad = format!("<a>{}</a>", "<b/>".repeat(200_000));
    refused("a.x3p", &archive(&[("main.xml", broad.as_bytes())]), "an XML document");
    let lol = "<!DOCTYPE a [<!ENTITY b \"bbbbbbbb\"><!ENTITY c \"&b;&b;&b;\">]><a>&c;</a>";
    refused("a.x3p", &archive(&[("main.xml", lol.as_bytes())]), "an XML document");
    // The checksum detects a flipped bit.
    let mut flipped = good.clone();
    let at = good.windows(8).position(|part| part == 3e-6f64.to_le_bytes());
    if let Some(at) = at {
        flipped[at] ^= 1;
        assert!(read_bytes("a.x3p", &flipped, &ReadOptions::default()).is_err());
    }
}
