//! Channels, masks, lists and marks of missing points in formats of other programs.

use asperity_topography::{ReadOptions, read_bytes};

use crate::files::{
    Sur, X3p, archive, gwy, gwy_field, item, object, sdf, sdf_text, x3p_of, zeroed,
};

fn map() -> Vec<f64> {
    (0..20).map(|i| f64::from(1 + 10 * (i / 5) + i % 5)).collect()
}

fn message(name: &str, bytes: &[u8], options: &ReadOptions) -> String {
    read_bytes(name, bytes, options).unwrap_err().to_string()
}

fn channel(name: &str) -> ReadOptions {
    ReadOptions { channel: Some(name.to_owned()), max_missing: Some(1.0), ..ReadOptions::default() }
}

#[test]
fn channels_of_gwyddion_files_have_names() {
    let (height, twice) = (map(), map().iter().map(|z| 2.0 * z).collect::<Vec<_>>());
    let title = |key: &str, name: &str| item(key, b's', &zeroed(name));
    let field = |key: &str, heights: &[f64], z| item(key, b'o', &gwy_field(heights, "m", z));
    let log = item("/0/data/log", b'o', &object("GwyStringList", &[item("s", b'S', &[0; 4])]));
    let file = gwy(&[
        title("/0/data/title", "Phase"),
        field("/0/data", &height, "deg"),
        log,
        item("/0/data/visible", b'b', &[1]),
        title("/1/data/title", "Height"),
        field("/1/data", &height, "nm"),
        title("/12/data/title", "Height back"),
        field("/12/data", &twice, "nm"),
    ]);
    // The first one with heights is read, and that is said.
    let surface = read_bytes("a.gwy", &file, &ReadOptions::default()).unwrap();
    assert!((surface.heights()[19] / 35e-9 - 1.0).abs() < 1e-12);
    assert!((surface.pixel_size()[1] / 2.5 - 1.0).abs() < 1e-12);
    let note = surface.notes()[0].to_string();
    assert!(note.contains("2 surfaces; \"Height\" is read") && note.contains("back"), "{note}");
    for name in ["height back", "2"] {
        let surface = read_bytes("a.gwy", &file, &channel(name)).unwrap();
        assert!((surface.heights()[19] / 70e-9 - 1.0).abs() < 1e-12 && surface.notes().is_empty());
    }
    for name in ["Phase", "0", "3", ""] {
        let text = message("a.gwy", &file, &channel(name));
        assert!(text.contains("1 \"Height\", 2 \"Height back\" was required"), "{text}");
    }
    let text = message("a.txt", b"1 2 3 4\n", &channel("Height"));
    assert!(text.starts_with("channel is \"Height\""), "{text}");
    let phase = gwy(&[field("/0/data", &height, "deg")]);
    let text = message("a.gwy", &phase, &ReadOptions::default());
    assert!(text.contains("channel 0 [deg]"), "{text}");
}

#[test]
fn masked_points_of_gwyddion_files_are_missing() {
    let mask: Vec<f64> = (0..20).map(|i| f64::from(u8::from(i == 7))).collect();
    let file = gwy(&[
        item("/0/data", b'o', &gwy_field(&map(), "m", "m")),
        item("/0/mask", b'o', &gwy_field(&mask, "m", "")),
    ]);
    let surface = read_bytes("a.gwy", &file, &ReadOptions::default()).unwrap();
    assert!(surface.heights()[7].is_nan() && (surface.missing_share() - 0.05).abs() < 1e-12);
    assert_eq!(surface.notes()[0].value.to_bits(), 0.05f64.to_bits());
}

#[test]
fn surfaces_of_digital_surf_files_have_numbers() {
    let of = |name, streams| Sur { kind: 5, objects: 2, name, streams, ..Sur::default() };
    let twice: Vec<f64> = map().iter().map(|z| 2.0 * z).collect();
    for streams in [0, 1] {
        let file = [of("", streams).bytes(&map()), of("second", streams).bytes(&twice)].concat();
        let surface = read_bytes("a.sur", &file, &ReadOptions::default()).unwrap();
        assert!((surface.heights()[19] / 4.375e-6 - 1.0).abs() < 1e-6);
        let note = surface.notes()[0].to_string();
        assert!(note.contains("\"surface 1 of 2\""), "{note}");
        for name in ["second", "2"] {
            let surface = read_bytes("a.sur", &file, &channel(name)).unwrap();
            assert!((surface.heights()[19] / 8.75e-6 - 1.0).abs() < 1e-6);
        }
        let text = message("a.sur", &of("", streams).bytes(&map()), &ReadOptions::default());
        assert!(text.contains("objects: 1 of 2"), "{text}");
    }
    let picture = Sur { kind: 12, ..Sur::default() }.bytes(&map());
    let text = message("a.sur", &picture, &ReadOptions::default());
    assert!(text.contains("object type: 12"), "{text}");
}

#[test]
fn infinite_heights_and_lists_of_x3p_are_read() {
    let metres = |z: f64| (1e-6 * z).to_le_bytes();
    let mut heights = map();
    (heights[3], heights[4], heights[5]) = (f64::INFINITY, f64::NEG_INFINITY, f64::NAN);
    let data = heights.iter().flat_map(|z| metres(*z)).collect();
    let options = ReadOptions { max_missing: Some(0.2), ..ReadOptions::default() };
    let surface = read_bytes("a.x3p", &x3p_of(&X3p { data, ..X3p::default() }), &options).unwrap();
    assert!((surface.missing_share() - 0.15).abs() < 1e-12 && surface.heights()[4].is_nan());
    // Heights in main.xml, one of them missing.
    let list =
        "<DataList><Datum>1e-6</Datum><Datum/> <Datum>3e-6</Datum><Datum>4e-6</Datum></DataList>";
    let x3p = X3p { list, size: [4, 1], feature: "PRF", ..X3p::default() };
    let surface = read_bytes("a.x3p", &x3p_of(&x3p), &channel_free()).unwrap();
    assert!(surface.is_profile() && surface.heights()[1].is_nan());
    assert!((surface.heights()[3] / 4e-6 - 1.0).abs() < 1e-12);
    let short = X3p { list, size: [5, 1], feature: "PRF", ..X3p::default() };
    let text = message("a.x3p", &x3p_of(&short), &channel_free());
    assert!(text.contains("DataList: 4 points"), "{text}");
    // A profile of positions and heights, at unequal distances.
    let data = [0.0, 1.0, 4.0].iter().flat_map(|x| [metres(*x), metres(2.0 * x)]).flatten();
    let profile =
        X3p { data: data.collect(), size: [3, 1], feature: "PRF", x: "A", ..X3p::default() };
    let surface = read_bytes("a.x3p", &x3p_of(&profile), &channel_free()).unwrap();
    assert!((surface.pixel_size()[0] / 2e-6 - 1.0).abs() < 1e-12);
    assert!((surface.heights()[1] / 4e-6 - 1.0).abs() < 1e-12);
    assert_eq!(surface.notes()[0].code.name(), "resampled");
    // Points of a regular grid, in any order.
    let points = [3usize, 0, 2, 1].map(|i| [(i % 2) as f64, (i / 2) as f64, i as f64 + 1.0]);
    let data = points.iter().flatten().flat_map(|number| metres(*number)).collect();
    let cloud = X3p { data, size: [4, 1], feature: "PCL", x: "A", ..X3p::default() };
    let xml = cloud.xml().replace("<CY><AxisType>I", "<CY><AxisType>A").replace(">2.5e-7<", ">1<");
    let cloud = archive(&[("main.xml", xml.as_bytes()), ("bindata/data.bin", &cloud.data)]);
    let surface = read_bytes("a.x3p", &cloud, &channel_free()).unwrap();
    assert_eq!((surface.rows(), surface.columns()), (2, 2));
    assert!((surface.heights()[2] / 3e-6 - 1.0).abs() < 1e-12);
    let areal = X3p { x: "A", ..X3p::default() };
    assert!(message("a.x3p", &x3p_of(&areal), &channel_free()).contains("CX AxisType: A"));
}

fn channel_free() -> ReadOptions {
    ReadOptions { max_missing: Some(0.5), ..ReadOptions::default() }
}

#[test]
fn missing_points_of_sdf_have_their_marks() {
    let heights = map();
    let missing = |file: &[u8]| {
        let surface = read_bytes("a.sdf", file, &channel_free()).unwrap();
        let missing = surface.heights().iter().map(|z| z.is_nan()).collect::<Vec<_>>();
        (0..20).filter(|i| missing[*i]).collect::<Vec<_>>()
    };
    let words = |mark: i16| -> Vec<u8> {
        let word = |(i, z): (usize, &f64)| if i == 6 { mark } else { *z as i16 }.to_le_bytes();
        heights.iter().enumerate().flat_map(word).collect()
    };
    assert_eq!(missing(&sdf("bISO-2.0", [5, 4], 5, &words(i16::MIN))), [6]);
    assert_eq!(missing(&sdf("bISO-1.0", [5, 4], 5, &words(i16::MAX))), [0; 0]);
    assert_eq!(missing(&sdf("bBCR-1.0", [5, 4], 5, &words(i16::MAX))), [6]);
    let doubles = |mark: f64| -> Vec<u8> {
        let of = |(i, z): (usize, &f64)| if i == 6 { mark } else { *z }.to_le_bytes();
        heights.iter().enumerate().flat_map(of).collect()
    };
    for mark in [f64::MIN, f64::NAN] {
        assert_eq!(missing(&sdf("bISO-2.0", [5, 4], 7, &doubles(mark))), [6]);
    }
    let text: String = heights.iter().map(|z| format!("{z} ")).collect();
    let with_bad = text.replacen("12 ", "BAD ", 1);
    assert_eq!(missing(sdf_text("aISO-2.0", [5, 4], &with_bad).as_bytes()), [6]);
    let refused = |file: &[u8], part: &str| {
        let text = message("a.sdf", file, &channel_free());
        assert!(text.contains(part), "{text}");
    };
    refused(sdf_text("aISO-1.0", [5, 3], &text).as_bytes(), "data: more; required: 15 numbers");
    refused(sdf_text("aISO-1.0", [5, 0], &text).as_bytes(), "NumProfiles: 0");
    let big = sdf_text("aISO-1.0", [1_000_000_000, 1_000_000_000], &text);
    refused(big.as_bytes(), "number of points");
    refused(sdf_text("aISO-1.0", [10_000, 10_000], &text).as_bytes(), "bytes; required: 100000000");
    let zscale = text_with("Zscale = 1e-6", "Zscale = nan", &text);
    refused(zscale.as_bytes(), "Zscale: NaN");
    let packed = text_with("Compression = 0", "Compression = 1", &text);
    refused(packed.as_bytes(), "Compression: 1");
    refused(&sdf("bISO-2.0", [u32::MAX, u32::MAX], 5, &[0; 8]), "number of points");
    refused(&sdf("bISO-2.0", [5, 4], 9, &[0; 8]), "DataType: 9");
    refused(&sdf("bISO-3.0", [5, 4], 5, &[0; 8]), "version: 3.0; required: 1.0 or 2.0");
}

fn text_with(from: &str, to: &str, data: &str) -> String {
    sdf_text("aISO-1.0", [5, 4], data).replace(from, to)
}

#[test]
fn texts_of_instruments_are_read() {
    let options = channel_free();
    let text = "Scan Parameters\nForce,3.00 mg\nLateral um,Raw Micrometer,\n0.0,1.5,,\n0.2,2.5,,\n";
    let surface = read_bytes("a.csv", text.as_bytes(), &options).unwrap();
    assert!(surface.is_profile() && (surface.pixel_size()[0] / 2e-7 - 1.0).abs() < 1e-9);
    assert!((surface.heights()[1] / 2.5e-6 - 1.0).abs() < 1e-12);
    let text = "X;Y;valid\n[mm];[um];[1/0]\n0;1;1\n1;2;0\n2;3;1\n";
    let surface = read_bytes("a.hfm", text.as_bytes(), &options).unwrap();
    assert!((surface.pixel_size()[0] / 1e-3 - 1.0).abs() < 1e-12);
    assert!(surface.heights()[1].is_nan() && (surface.heights()[2] / 3e-6 - 1.0).abs() < 1e-12);
    // Points with a word of two words.
    let text = "0 0 1\n1 0 No Data\n0 1 3\n1 1 4\n";
    let in_um = ReadOptions { unit: Some("um".parse().unwrap()), ..options };
    let surface = read_bytes("a.xyz", text.as_bytes(), &in_um).unwrap();
    assert!(surface.heights()[1].is_nan() && (surface.missing_share() - 0.25).abs() < 1e-12);
}
