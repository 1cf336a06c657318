//! Declared sizes allocate no memory before the data are there. One test alone in its process,
//! because the peak memory is that of the process.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "tests")]

use asperity_topography::{ReadOptions, read_bytes};

#[path = "suite/files.rs"]
mod files;
use files::{Sur, X3p, archive, gwy, gwy_field, gzip, item, sdf, sdf_text, x3p_of};

/// Resident memory (`VmRSS`) or its peak (`VmHWM`) \[kB\].
fn memory(name: &str) -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with(name)).unwrap();
    line.split_whitespace().nth(1).unwrap().parse().unwrap()
}

#[test]
fn bombs_are_refused_in_little_memory() {
    let zeros = vec![0; 96 << 20];
    let xml = X3p::default().xml();
    let bombs = [
        // 20 points are declared; 96 MiB would come out.
        ("a.x3p", archive(&[("main.xml", xml.as_bytes()), ("bindata/data.bin", &zeros)])),
        ("a.x3p", archive(&[("main.xml", &zeros)])),
        // 100 million points are declared, one is there.
        ("a.x3p", x3p_of(&X3p { size: [10_000, 10_000], data: vec![0; 8], ..X3p::default() })),
        ("a.sur", Sur { size: [10_000, 10_000], ..Sur::default() }.bytes(&[0.0])),
        ("a.sur", Sur { size: [10_000, 10_000], streams: 1, ..Sur::default() }.bytes(&[0.0])),
        ("a.txt.gz", gzip(&zeros)),
        ("a.gwy", gwy(&[item("/0/data", b'o', &gwy_field(&[0.0; 3], "m", "m"))])),
        ("a.gwy", gwy(&[item("many", b'S', &[0xff; 4])])),
        ("a.sdf", sdf("bISO-2.0", [10_000, 10_000], 7, &[0; 8])),
        ("a.sdf", sdf_text("aISO-1.0", [10_000, 10_000], "1 2 3").into_bytes()),
        ("a.npy", b"\x93NUMPY\x01\x00\x45\x00{'descr': '<f8', 'fortran_order': False, 'shape': (10000, 10000), } ".to_vec()),
        ("a.npy", b"\x93NUMPY\x02\x00\xff\xff\xff\x7f{'descr': ".to_vec()),
        ("a.xyz", b"0 0 1\n1 1 1\n9999 9999 1\n2 2 1\n".to_vec()),
    ];
    assert!(bombs[0].1.len() < 1 << 20);
    drop(zeros);
    // Making the files has set a peak; memory is filled up to it, so that later growth is visible.
    let mut ballast = Vec::new();
    while memory("VmRSS") + 1024 < memory("VmHWM") {
        ballast.push(vec![1u8; 1 << 20]);
    }
    let before = memory("VmHWM");
    for (name, bytes) in &bombs {
        let options = ReadOptions { max_missing: Some(1.0), ..ReadOptions::default() };
        let error = read_bytes(name, bytes, &options).unwrap_err().to_string();
        assert!(error.contains("required") || error.contains("damaged"), "{error}");
    }
    let grown = memory("VmHWM") - before;
    assert!(grown < 24 << 10, "{grown} kB");
    drop(ballast);
}
