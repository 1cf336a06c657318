//! Files that are broken at random, and random contents, are refused or measured without a panic.

use asperity_topography::{Estimator, Level, ReadOptions, read_bytes};
use proptest::prelude::*;

use crate::files::{Sur, X3p, archive, gwy, gwy_field, gzip, item, sdf, sdf_text, x3p_of};
use crate::hostile::{lenient, npy, npy_of, waves};

/// Measuring a surface from any input does not panic.
fn measure(name: &str, bytes: &[u8]) {
    for options in [lenient(), ReadOptions { max_missing: Some(1.0), ..ReadOptions::default() }] {
        let Ok(surface) = read_bytes(name, bytes, &options) else { continue };
        for level in [Level::None, Level::Mean, Level::Plane, Level::Quadratic] {
            let Ok(levelled) = surface.clone().level(level) else { continue };
            for estimator in [Estimator::Moments, Estimator::Summits] {
                if let Ok(statistics) = levelled.statistics(estimator) {
                    let surface = statistics.surface();
                    assert!(
                        statistics.sq.is_finite()
                            && statistics.moments.profile.bandwidth().is_finite()
                    );
                    assert!(surface.is_err() || surface.unwrap().check().is_ok());
                }
            }
            if let Ok(density) = levelled.summits().and_then(|summits| summits.height_density()) {
                assert!(density.density_per_m.iter().all(|density| *density >= 0.0));
            }
            let _ = levelled.clone().despiked().map(|surface| surface.outliers());
            let cutoff = 3.0 * levelled.pixel_size()[0];
            let _ = levelled.filter(cutoff).map(|rough| rough.statistics(Estimator::Moments));
        }
    }
}

/// A valid file with some bytes changed and a truncated end.
fn broken(good: Vec<u8>) -> impl Strategy<Value = Vec<u8>> {
    let n = good.len();
    let changes = prop::collection::vec((0..n, any::<u8>()), 0..6);
    (changes, 0..=2 * n).prop_map(move |(changes, end)| {
        let mut bytes = good.clone();
        for (at, byte) in changes {
            bytes[at] = byte;
        }
        bytes.truncate(end);
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn broken_compressed_sur(bytes in broken(Sur { size: [9, 9], streams: 2, ..Sur::default() }.bytes(&waves(9)))) {
        measure("a.sur", &bytes);
    }

    #[test]
    fn broken_gwy(bytes in broken(gwy(&[item("/0/data", b'o', &gwy_field(&waves(9)[..20], "um", "nm")), item("/0/mask", b'o', &gwy_field(&waves(9)[20..40], "m", ""))]))) {
        measure("a.gwy", &bytes);
    }

    #[test]
    fn broken_sdf(bytes in broken(sdf("bISO-2.0", [9, 9], 7, &waves(9).iter().flat_map(|z| z.to_le_bytes()).collect::<Vec<_>>()))) {
        measure("a.sdf", &bytes);
    }

    #[test]
    fn broken_sdf_text(bytes in broken(sdf_text("aISO-1.0", [5, 5], &waves(5).iter().map(|z| format!("{z:.3}\n")).collect::<String>()).into_bytes())) {
        measure("a.sdf", &bytes);
    }

    #[test]
    fn broken_gzip(bytes in broken(gzip(b"# Width: 9 um\n# Height: 9 um\n# Value units: nm\n1 2 4 7\n3 nan 1 2\n"))) {
        measure("a.txt.gz", &bytes);
    }

    #[test]
    fn broken_utf16(bytes in broken("\u{feff}Breite: 9,0 \u{b5}m\r\nx [um];z [nm]\r\n1,5;2\r\n3;1\r\n3,5;4\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect())) {
        measure("a.csv", &bytes);
    }

    #[test]
    fn any_profile(rows in prop::collection::vec((any::<f32>(), any::<f32>()), 1..30)) {
        let text: String = rows.iter().map(|(x, z)| format!("{x:e};{z:e}\n")).collect();
        measure("a.csv", text.as_bytes());
    }

    #[test]
    fn any_bytes(name in "a\\.(npy|x3p|sur|txt|xyz|gwy|sdf|csv)", bytes in prop::collection::vec(any::<u8>(), 0..700)) {
        measure(&name, &bytes);
    }

    #[test]
    fn any_text(text in "([-+0-9.eE, ;\t\nna#*x]|nan|1e9|: |um){0,200}") {
        measure("a.txt", text.as_bytes());
    }

    #[test]
    fn any_numbers(rows in prop::collection::vec(prop::array::uniform4(any::<f64>()), 1..20), columns in 1..5usize) {
        let row = |row: &[f64; 4]| row[..columns].iter().map(|z| format!("{z:e}")).collect::<Vec<_>>().join(" ");
        measure("a.txt", rows.iter().map(row).collect::<Vec<_>>().join("\n").as_bytes());
    }

    #[test]
    fn broken_npy(bytes in broken(npy_of("<f4", "(9, 9)", &waves(9).iter().flat_map(|z| (*z as f32).to_le_bytes()).collect::<Vec<_>>()))) {
        measure("a.npy", &bytes);
    }

    #[test]
    fn any_npy_header(header in "\\{('descr': '[<>|][fiu][1248]', |'fortran_order': (True|False), |'shape': \\([0-9]{1,3}, ?[0-9]{0,20}\\), |[a-z(){}',:]){0,6}\\}") {
        measure("a.npy", &npy(&header, &[63; 64]));
    }

    #[test]
    fn broken_sur(bytes in broken(Sur { size: [9, 9], ..Sur::default() }.bytes(&waves(9)))) {
        measure("a.sur", &bytes);
    }

    #[test]
    fn broken_x3p(bytes in broken(x3p_of(&X3p { size: [9, 9], data: waves(9).iter().flat_map(|z| z.to_le_bytes()).collect(), ..X3p::default() }))) {
        measure("a.x3p", &bytes);
    }

    #[test]
    fn broken_main_xml(bytes in broken(X3p { size: [9, 9], ..X3p::default() }.xml().into_bytes())) {
        let data: Vec<u8> = waves(9).iter().flat_map(|z| z.to_le_bytes()).collect();
        measure("a.x3p", &archive(&[("main.xml", &bytes), ("bindata/data.bin", &data)]));
    }

    #[test]
    fn broken_text(bytes in broken(b"# Width: 9 um\n# Height: 9 um\n# Value units: nm\n1 2 4 7\n3 nan 1 2\n9 8 1 3\n5 1 2 7\n".to_vec())) {
        measure("a.txt", &bytes);
    }

    #[test]
    fn broken_header(bytes in broken(b"pixel size=3e-7 m\ndata unit=rad\nheight factor=3e-8\n1 2 4 7\n3 1 1 2\n9 8 1 3\n".to_vec())) {
        measure("a.txt", &bytes);
    }

    /// Cut, doubled and other bytes: heights of another size than the header states are refused.
    #[test]
    fn garbled_text_keeps_its_size(at in 0..1500usize, length in 0..9usize, other in prop::collection::vec(any::<u8>(), 0..9), doubled in any::<bool>(), end in 0..3000usize) {
        let head = "# File Format = ASCII\n# x-pixels = 9\n# y-pixels = 9\n# x-length = 9\n# y-length = 9\n# z-unit = nm\n";
        let row = |row: &[f64]| row.iter().map(|z| format!("{z:.3}")).collect::<Vec<_>>().join("\t") + "\n";
        let mut bytes = (head.to_owned() + &waves(9).chunks(9).map(row).collect::<String>()).into_bytes();
        let (from, to) = (at.min(bytes.len()), (at + length).min(bytes.len()));
        let new = if doubled { [&bytes[from..to]; 2].concat() } else { other };
        bytes.splice(from..to, new);
        bytes.truncate(end);
        measure("a.txt", &bytes);
        if let Ok(surface) = read_bytes("a.txt", &bytes, &lenient()) {
            assert_eq!((surface.columns(), surface.rows()), (9, 9), "{:?}", String::from_utf8_lossy(&bytes));
        }
    }

    /// A text without counts keeps its columns and rows, unless a byte makes a comment of a row.
    #[test]
    fn garbled_rows_are_refused(at in 0..700usize, other in any::<u8>().prop_filter("a comment", |byte| !b"#%".contains(byte))) {
        let row = |row: &[f64]| row.iter().map(|z| format!("{z:.3}")).collect::<Vec<_>>().join(" ") + "\n";
        let mut bytes = waves(9).chunks(9).map(row).collect::<String>().into_bytes();
        let at = at % bytes.len();
        bytes[at] = other;
        let found = read_bytes("a.txt", &bytes, &lenient());
        let size = found.map_or((9, 9), |surface| (surface.columns(), surface.rows()));
        assert_eq!(size, (9, 9), "{:?}", String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn broken_xyz(bytes in broken(b"x_um y_um z_nm\n0 0 1\n1 0 4\n2 0 3\n0 1 7\n1 1 2\n2 1 8\n0 2 1\n1 2 9\n2 2 4\n".to_vec())) {
        measure("a.xyz", &bytes);
    }
}

/// A mark in the place of any byte, before it or twice, changes no size; but one that makes a
/// comment of a row.
#[test]
fn a_mark_anywhere_keeps_the_size_or_is_refused() {
    let row = |row: &[f64]| row.iter().map(|z| format!("{z:.2}")).collect::<Vec<_>>();
    for delimiter in [" ", ","] {
        let rows: Vec<_> = waves(5).chunks(5).map(|line| row(line).join(delimiter)).collect();
        let good = rows.join("\n");
        for (at, mark) in
            (0..good.len()).flat_map(|at| "\"',;\t\n .-ex".bytes().map(move |m| (at, m)))
        {
            for (removed, added) in [(1, 1), (0, 1), (1, 2), (0, 2)] {
                let mut bytes = good.clone().into_bytes();
                bytes.splice(at..at + removed, vec![mark; added]);
                let found = read_bytes("a.txt", &bytes, &lenient());
                let size = found.map_or((5, 5), |surface| (surface.columns(), surface.rows()));
                assert_eq!(size, (5, 5), "{:?}", String::from_utf8_lossy(&bytes));
            }
        }
    }
}
