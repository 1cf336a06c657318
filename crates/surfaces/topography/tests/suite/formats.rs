//! Small files of every format, written here, are read back.

#![allow(clippy::float_cmp, reason = "tests")]

use std::io::Write;

use asperity_topography::{
    Distance, LengthUnit, ReadOptions, Topography, TopographyError, read, read_bytes,
};

use crate::files::{Sur, X3p, x3p_of};

/// 5 columns and 4 rows of different heights.
const HEIGHTS: [f64; 20] =
    [0., 1., 2., 3., 4., 10., 11., 12., 13., 14., 20., 21., 22., 23., 24., 30., 31., 32., 33., 34.];

fn in_um(pixel_size: [f64; 2]) -> ReadOptions {
    ReadOptions {
        unit: Some("um".parse().unwrap()),
        pixel_size: Some(pixel_size.map(Distance::from)),
        ..ReadOptions::default()
    }
}

fn check(surface: &Topography, unit: f64, pixel_size: [f64; 2]) {
    assert_eq!((surface.columns(), surface.rows()), (5, 4));
    for (found, expected) in surface.heights().iter().zip(HEIGHTS) {
        assert!((found / unit - expected).abs() < 1e-9, "{found:e} is not {expected} {unit:e}");
    }
    for (found, expected) in surface.pixel_size().iter().zip(pixel_size) {
        assert!((found / expected - 1.0).abs() < 1e-6, "{found:e} {expected:e}");
    }
}

fn lines(delimiter: &str) -> String {
    let row = |row: &[f64]| row.iter().map(f64::to_string).collect::<Vec<_>>().join(delimiter);
    HEIGHTS.chunks(5).map(|heights| row(heights) + "\n").collect()
}

fn message(name: &str, bytes: &[u8], options: &ReadOptions) -> String {
    read_bytes(name, bytes, options).unwrap_err().to_string()
}

#[test]
fn profiles_are_read() {
    let column = read_bytes("a.csv", b"1\n2\n3\n", &in_um([0.5, 9.0])).unwrap();
    assert!(column.is_profile() && (column.pixel_size()[0] / 5e-7 - 1.0).abs() < 1e-12);
    let row = read_bytes("a.txt", b"1 2 3 4 5", &in_um([0.5, 9.0])).unwrap();
    assert_eq!((row.is_profile(), row.columns()), (true, 5));
    // Unequal distances are interpolated linearly, which is said.
    let in_um = ReadOptions { unit: Some("um".parse().unwrap()), ..ReadOptions::default() };
    let uneven = read_bytes("a.csv", b"4,3\n1,2\n0,1\n", &in_um).unwrap();
    assert!((uneven.pixel_size()[0] / 2e-6 - 1.0).abs() < 1e-12);
    assert!((uneven.heights()[1] / (7.0 / 3.0 * 1e-6) - 1.0).abs() < 1e-12);
    assert!((uneven.heights()[0] / 1e-6 - 1.0).abs() < 1e-12);
    assert_eq!(uneven.notes()[0].code.name(), "resampled");
}

#[test]
fn numpy_arrays_are_read() {
    let options = in_um([0.5, 0.25]);
    for array in [
        &include_bytes!("numpy/f8.npy")[..],
        include_bytes!("numpy/f4.npy"),
        include_bytes!("numpy/u1.npy"),
        include_bytes!("numpy/i2.npy"),
        include_bytes!("numpy/big-endian.npy"),
        include_bytes!("numpy/fortran.npy"),
        include_bytes!("numpy/version-2.npy"),
        include_bytes!("numpy/version-3.npy"),
    ] {
        check(&read_bytes("a.npy", array, &options).unwrap(), 1e-6, [5e-7, 2.5e-7]);
        assert!(message("a.npy", array, &ReadOptions::default()).contains("give unit"));
    }
    let archive = message("a.npz", include_bytes!("numpy/archive.npz"), &options);
    assert!(archive.contains("NumPy npz"), "{archive}");
}

#[test]
fn x3p_archives_are_read() {
    let doubles: Vec<u8> = HEIGHTS.iter().flat_map(|z| (z * 1e-6).to_le_bytes()).collect();
    let surface = x3p_of(&X3p { data: doubles.clone(), ..X3p::default() });
    check(&read_bytes("a.x3p", &surface, &ReadOptions::default()).unwrap(), 1e-6, [5e-7, 2.5e-7]);
    // Options must agree with the file.
    let options = ReadOptions { unit: Some(LengthUnit::METRE), ..ReadOptions::default() };
    assert!(read_bytes("a.x3p", &surface, &options).is_ok());
    let unit = read_bytes("a.x3p", &surface, &in_um([0.5, 0.25]));
    assert!(matches!(unit, Err(TopographyError::Contradiction { option: "unit", .. })));
    // Whole numbers with a step and an offset, all points valid except one.
    let data = HEIGHTS.iter().flat_map(|z| (*z as i16 - 100).to_le_bytes()).collect();
    let whole = X3p {
        data,
        kind: "I",
        of_z: "<Increment>1e-6</Increment><Offset>1e-4</Offset>",
        valid: Some(vec![0xff, 0xdf, 0x0f]),
        ..X3p::default()
    };
    let surface = read_bytes("a.x3p", &x3p_of(&whole), &ReadOptions::default()).unwrap();
    assert!(surface.heights()[13].is_nan() && (surface.missing_share() - 0.05).abs() < 1e-12);
    assert!((surface.heights()[14] / 24e-6 - 1.0).abs() < 1e-9);
    // A profile.
    let profile = X3p { data: doubles, size: [20, 1], feature: "PRF", ..X3p::default() };
    let profile = read_bytes("a.x3p", &x3p_of(&profile), &ReadOptions::default()).unwrap();
    assert!(profile.is_profile() && profile.columns() == 20);
}

#[test]
fn digital_surf_files_are_read() {
    let options = ReadOptions::default();
    let short = Sur { bits: 16, comment: 300, ..Sur::default() };
    check(&read_bytes("a.sur", &short.bytes(&HEIGHTS), &options).unwrap(), 1.25e-7, [5e-6, 2.5e-6]);
    // µ as in MS-DOS; upside down; missing points.
    let mut heights = HEIGHTS.map(|z| -z);
    (heights[7], heights[12]) = (-36.0, -36.0);
    let holes = Sur { unit: b"\xe6m", inversion: 1, lowest: Some(-34), ..Sur::default() };
    let surface = read_bytes("a.sur", &holes.bytes(&heights), &options).unwrap();
    assert!(surface.heights()[7].is_nan() && surface.heights()[12].is_nan());
    assert!((surface.missing_share() - 0.1).abs() < 1e-12);
    assert!((surface.heights()[19] / 4.25e-6 - 1.0).abs() < 1e-6);
    for unit in [&b"\xc2\xb5m"[..], b"\xb5m"] {
        let sur = Sur { unit, ..Sur::default() };
        check(
            &read_bytes("a.sur", &sur.bytes(&HEIGHTS), &options).unwrap(),
            1.25e-7,
            [5e-6, 2.5e-6],
        );
    }
    let volt = Sur { unit: b"V", ..Sur::default() };
    let volt = message("a.sur", &volt.bytes(&HEIGHTS), &options);
    assert!(volt.contains("unit of") && volt.contains("\"V\""), "{volt}");
}

#[test]
fn errors_name_the_file() {
    let folder = std::env::temp_dir().join(format!("asperity-topography-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("scan.txt");
    std::fs::File::create(&path).unwrap().write_all(lines(" ").as_bytes()).unwrap();
    check(&read(&path, &in_um([0.5, 0.25])).unwrap(), 1e-6, [5e-7, 2.5e-7]);
    let within = |path: &std::path::Path| match read(path, &ReadOptions::default()) {
        Err(TopographyError::File { path: named, source }) if named == path => *source,
        other => panic!("{other:?}"),
    };
    assert!(matches!(within(&path), TopographyError::UnitMissing));
    assert!(matches!(within(&folder.join("none.txt")), TopographyError::Io(_)));
    assert!(read(&folder, &ReadOptions::default()).is_err());
    std::fs::remove_dir_all(&folder).unwrap();
}
