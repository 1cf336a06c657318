//! One asymmetric map, written in every format, has the same rows and columns in all.

#![allow(clippy::float_cmp, reason = "tests")]

use asperity_topography::{Distance, ReadOptions, Topography, read_bytes};

use crate::files::{Sur, X3p, gwy, gwy_field, gzip, item, sdf, sdf_text, x3p_of};

/// The height in a row and column \[µm\]: no mirror image and no transposition is equal.
fn height(row: usize, column: usize) -> f64 {
    (1 + 10 * row + column) as f64
}

/// 4 rows of 5 columns.
fn map() -> Vec<f64> {
    (0..20).map(|i| height(i / 5, i % 5)).collect()
}

fn read(name: &str, bytes: &[u8], options: &ReadOptions) -> Topography {
    read_bytes(name, bytes, options).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn check(name: &str, surface: &Topography) {
    assert_eq!((surface.rows(), surface.columns()), (4, 5), "{name}");
    for (i, found) in surface.heights().iter().enumerate() {
        let expected = 1e-6 * height(i / 5, i % 5);
        assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {i} {found:e} {expected:e}");
    }
    let [dx, dy] = surface.pixel_size();
    assert!((dx / 5e-6 - 1.0).abs() < 1e-6 && (dy / 2.5e-6 - 1.0).abs() < 1e-6, "{name}");
}

/// Every format and variant with both sizes and the unit in it, and the text formats.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    let map = map();
    let eighths: Vec<f64> = map.iter().map(|z| 8.0 * z).collect();
    let mirrored: Vec<f64> = (0..20).map(|i| -8.0 * height(i / 5, 4 - i % 5)).collect();
    let upside_down: Vec<f64> = (0..20).map(|i| -8.0 * height(3 - i / 5, i % 5)).collect();
    let doubles: Vec<u8> = map.iter().flat_map(|z| z.to_le_bytes()).collect();
    let metres: Vec<f64> = map.iter().map(|z| 1e-6 * z).collect();
    let in_metres = metres.iter().flat_map(|z| z.to_le_bytes()).collect();
    let floats: Vec<u8> = map.iter().flat_map(|z| (*z as f32).to_le_bytes()).collect();
    let words: Vec<u8> = map.iter().flat_map(|z| (*z as i16).to_le_bytes()).collect();
    let lines = |gap: &str, point: &str| {
        let line = |row: usize| {
            let numbers = (0..5).map(|column| format!("{:?}", height(row, column)));
            numbers.map(|z| z.replace('.', point)).collect::<Vec<_>>().join(gap) + "\n"
        };
        (0..4).map(line).collect::<String>()
    };
    let head = "Width: 25 um\nHeight: 10 um\nValue units: um\n";
    let german = "# Kanal: Z\n# Breite: 25,0 µm\n# Höhe: 10 µm\n# Einheit: µm\n";
    let factor = "pixel size=5 um\ndata unit=rad\nheight conversion factor (-> m)=1e-6\n";
    // Points column by column, y descending.
    let points: String = (0..20)
        .map(|i| (i % 4, i / 4))
        .map(|(row, column)| {
            format!("{} {} {}\n", 5 * column, 2.5 * (3.0 - row as f64), height(3 - row, column))
        })
        .collect();
    let utf16 = |text: &str| -> Vec<u8> {
        let units = text.encode_utf16().flat_map(u16::to_le_bytes);
        [0xff, 0xfe].into_iter().chain(units).collect()
    };
    let field = |heights: &[f64], xy, z| item("/0/data", b'o', &gwy_field(heights, xy, z));
    let negative = X3p { data: doubles.clone(), ..X3p::default() };
    assert!(negative.xml().contains("5e-7"));
    let sur = |sur: Sur, heights: &[f64]| sur.bytes(heights);
    vec![
        ("spaces.txt", (head.to_owned() + &lines(" ", ".")).into_bytes()),
        ("commas.csv", (head.to_owned() + &lines(",", ".")).into_bytes()),
        ("german.txt", (german.to_owned() + &lines("\t", ",")).into_bytes()),
        ("utf16.txt", utf16(&(german.to_owned() + &lines(";", ",")))),
        ("points.xyz", format!("x_um y_um z_um\n{points}").into_bytes()),
        ("plain.sur", sur(Sur::default(), &eighths)),
        ("short.sur", sur(Sur { bits: 16, ..Sur::default() }, &eighths)),
        ("packed.sur", sur(Sur { streams: 3, ..Sur::default() }, &eighths)),
        ("mirrored.sur", sur(Sur { inversion: 2, ..Sur::default() }, &mirrored)),
        ("upside-down.sur", sur(Sur { inversion: 3, ..Sur::default() }, &upside_down)),
        ("um.gwy", gwy(&[field(&map, "um", "µm")])),
        ("ascii.sdf", sdf_text("aISO-1.0", [5, 4], &lines(" ", ".")).into_bytes()),
        ("ascii-2.sdf", sdf_text("aISO-2.0", [5, 4], &lines("\n", ".")).into_bytes()),
        ("ascii-bcr.sdf", sdf_text("aBCR-1.0", [5, 4], &lines(" ", ".")).into_bytes()),
        ("doubles.sdf", sdf("bISO-1.0", [5, 4], 7, &doubles)),
        ("floats.sdf", sdf("bISO-2.0", [5, 4], 3, &floats)),
        ("words.sdf", sdf("bISO-1.0", [5, 4], 5, &words)),
        ("bcr.sdf", sdf("bBCR-1.0", [5, 4], 5, &words)),
        ("factor.txt", (factor.to_owned() + &lines(" ", ".")).into_bytes()),
        ("map.x3p", x3p_of(&X3p { data: in_metres, ..X3p::default() })),
    ]
}

#[test]
fn an_asymmetric_map_is_equal_in_all_formats() {
    for (name, bytes) in files() {
        // Of two sizes that differ from the others', the lengths are changed below.
        if matches!(name, "factor.txt" | "map.x3p") {
            continue;
        }
        check(name, &read(name, &bytes, &ReadOptions::default()));
        check(name, &read(&format!("{name}.gz"), &gzip(&bytes), &ReadOptions::default()));
    }
    for (name, [dx, dy]) in [("factor.txt", [5e-6, 5e-6]), ("map.x3p", [5e-7, 2.5e-7])] {
        let (_, bytes) = files().into_iter().find(|(of, _)| *of == name).unwrap();
        let surface = read(name, &bytes, &ReadOptions::default());
        for (i, found) in surface.heights().iter().enumerate() {
            assert!((found / (1e-6 * height(i / 5, i % 5)) - 1.0).abs() < 1e-12, "{name} {i}");
        }
        assert!((surface.pixel_size()[0] / dx - 1.0).abs() < 1e-12, "{name}");
        assert!((surface.pixel_size()[1] / dy - 1.0).abs() < 1e-12, "{name}");
    }
}

#[test]
fn every_beginning_of_a_file_gives_an_error_or_fewer_rows() {
    let lenient = ReadOptions {
        unit: Some("um".parse().unwrap()),
        pixel_size: Some([5.0, 2.5].map(Distance::from)),
        max_missing: Some(1.0),
        ..ReadOptions::default()
    };
    for (name, bytes) in files() {
        let text = name.ends_with(".txt") || name.ends_with(".csv") || name.ends_with(".xyz");
        for length in 0..bytes.len() {
            let found = read_bytes(name, &bytes[..length], &lenient);
            let stated = read_bytes(name, &bytes[..length], &ReadOptions::default());
            // A text ends anywhere; so does an SDF file of BCR within its last number, and what
            // follows the numbers of an SDF is free text.
            let free = match name {
                "ascii-bcr.sdf" => 32,
                "ascii.sdf" | "ascii-2.sdf" => 20,
                _ => 0,
            };
            let whole = bytes.len() - free;
            if !text && length < whole {
                assert!(found.is_err() && stated.is_err(), "{name} {length}");
            }
        }
        let packed = gzip(&bytes);
        for length in 3..packed.len() {
            assert!(read_bytes(name, &packed[..length], &lenient).is_err(), "{name} {length}");
        }
    }
}
