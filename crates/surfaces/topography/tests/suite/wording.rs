//! What is said about scans that are refused: one snapshot, read as prose when it changes. Other
//! tests look at variants, fields and numbers.

use std::fmt::Write;

use asperity_topography::{
    Alignment, Distance, Estimator, Level, ReadOptions, Topography, read_bytes,
};

use crate::files::{Sur, X3p, archive, gwy, gwy_field, gzip, item, sdf_text, x3p_of};
use crate::hostile::{lenient, npy_of};

const TEXTS: &[&str] = &[
    "",
    "1 2 3 4\n5 6 7 8\n",
    "# Value units: nm\n1 2 3 4\n",
    "# Value units: V\n1 2 3 4\n",
    "# Width: nan um\n1 2 3 4\n",
    "height factor=2\n1 2 3 4\n",
    "1 2 3 4\n1 2 3\n",
    "1 2 3 4\n1 2 inf 4\n",
    "1,5;2\n3.5;4\n",
    "\\*File list\r\n\0",
    "1 2\n\u{2}\u{3}",
];

#[test]
fn refused_files_and_surfaces() {
    let mut all = String::new();
    let mut said = |what: &str, refused: String| {
        assert!(!refused.contains('\n'), "{refused}");
        writeln!(all, "{}\n    {refused}", what.trim_end().escape_debug()).unwrap();
    };
    for text in TEXTS {
        let refused = read_bytes("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap_err();
        said(text, refused.to_string());
    }
    let field = |key: &str| item(key, b'o', &gwy_field(&[0.0; 3], "m", "m"));
    let sizes = [10_000, 10_000];
    for (what, name, bytes) in [
        ("a picture", "a.jpg", b"\xff\xd8\xff\xe0".to_vec()),
        ("unordered points", "a.csv", b"0 1\n2 2\n1 3\n".to_vec()),
        ("a second point", "a.xyz", b"0 0 1\n1 0 1\n0 1 1\n0 1 2\n".to_vec()),
        ("missing points", "a.txt", b"nan nan nan nan\n".to_vec()),
        ("a height of 1e300", "a.txt", b"1 2 3 4\n1 2 3 1e300\n".to_vec()),
        ("gzip in gzip", "a.txt.gz", gzip(&gzip(b"1 2 3 4"))),
        ("a bomb", "a.txt.gz", gzip(&vec![b' '; 8 << 20])),
        ("an npz", "a.npz", archive(&[("z.npy", &npy_of("<f8", "(2, 3)", &[0; 48]))])),
        ("complex numbers", "a.npy", npy_of("<c16", "(2, 3)", &[0; 96])),
        ("too few bytes", "a.npy", npy_of("<f8", "(10000, 10000)", &[0; 64])),
        ("three sizes", "a.npy", npy_of("<f8", "(1, 2, 3)", &[0; 48])),
        ("no columns", "a.sur", Sur { size: [0, 4], ..Sur::default() }.bytes(&[0.0])),
        ("too few bytes", "a.sur", Sur { size: sizes, ..Sur::default() }.bytes(&[0.0])),
        ("too few numbers", "a.gwy", gwy(&[field("/0/data")])),
        ("a broken item", "a.gwy", gwy(&[item("many", b'O', &[0xff; 4])])),
        ("too few numbers", "a.sdf", sdf_text("aISO-1.0", [5, 5], "1 2 3").into_bytes()),
        ("no parts", "a.x3p", archive(&[("main.xml", b"<a/>")])),
        ("not XML", "a.x3p", archive(&[("main.xml", b"<a><b></a>")])),
        ("too few bytes", "a.x3p", x3p_of(&X3p { data: vec![0; 8], ..X3p::default() })),
    ] {
        let refused = match name {
            "a.sur" | "a.gwy" | "a.sdf" | "a.x3p" => ReadOptions::default(),
            _ => ReadOptions { max_missing: Some(0.5), ..lenient() },
        };
        let refused = read_bytes(name, &bytes, &refused).unwrap_err();
        said(&format!("{name}: {what}"), refused.to_string());
    }
    let surface = |heights: &[f64], columns, pixel: f64| {
        Topography::new(heights.to_vec(), columns, [pixel; 2])
    };
    said("5 heights, 2 columns", surface(&[0.0; 5], 2, 1.0).unwrap_err().to_string());
    said("pixels of 0", surface(&[0.0; 4], 2, 0.0).unwrap_err().to_string());
    let flat = surface(&[0.0; 100], 10, 1e-6).unwrap();
    let coarse = surface(&[0.0; 100], 10, 2e-6).unwrap();
    let profile = surface(&[0.0, 1.0, 0.0], 3, 1.0).unwrap();
    let line = surface(&[1.0, f64::NAN, f64::NAN, 2.0], 2, 1.0).unwrap();
    said("a flat surface", flat.statistics(Estimator::Moments).unwrap_err().to_string());
    said("summits of a profile", profile.summits().unwrap_err().to_string());
    said("a plane through a line", line.clone().level(Level::Plane).unwrap_err().to_string());
    said("half to fill", line.fill().unwrap_err().to_string());
    said("a cut-off of 3 m", flat.clone().filter(3.0).unwrap_err().to_string());
    let sum = flat.facing(&coarse, Alignment::AsRead);
    said("other pixels", sum.unwrap_err().to_string());
    said("an estimator", "peaks".parse::<Estimator>().unwrap_err().to_string());
    said("a pixel size", "1 mile".parse::<Distance>().unwrap_err().to_string());
    insta::assert_snapshot!(all);
}
