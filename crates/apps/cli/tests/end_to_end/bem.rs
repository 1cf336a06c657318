//! `bem`: the scan of a scene, pixel by pixel.

use crate::bench::{Bench, cells, column};

/// A scene on `scan.txt`.
pub const SCAN: &str = include_str!("scenes/scan.toml");

/// A seal of that scan.
const SEAL: &str = include_str!("scenes/seal.toml");

/// A folder with that scene, that scan, and the scene of a seal.
pub fn bench() -> Bench {
    let bench = Bench::new();
    bench.write("scan.toml", SCAN);
    bench.write("scan.txt", &crate::surface::scan(0.0));
    bench.write("seal.toml", &format!("{SCAN}{SEAL}"));
    bench
}

#[test]
fn pressures_are_written_and_drawn() {
    let bench = bench();
    bench.data("bem scan.toml --pressure 1e9 --map one.npy --picture one.svg");
    bench.data("bem scan.toml --pressure 1e9,2e9 --map two.npy --elastic");
    let read = |name: &str, shape: &str| {
        let bytes = std::fs::read(bench.path(name)).unwrap();
        let (head, data) = bytes[10..].split_at(usize::from(bytes[8]));
        assert!(bytes.starts_with(b"\x93NUMPY\x01\x00") && (10 + head.len()) % 64 == 0);
        let wanted = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
        assert_eq!(std::str::from_utf8(head).unwrap().trim_end(), wanted);
        let numbers =
            data.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()));
        numbers.collect::<Vec<f64>>()
    };
    let one = read("one.npy", "(96, 96)");
    assert_eq!(one.len(), 96 * 96);
    let mean = |map: &[f64]| map.iter().sum::<f64>() / map.len() as f64;
    assert!((mean(&one) / 1e9 - 1.0).abs() < 1e-9 && one.iter().all(|p| (0.0..=5e9).contains(p)));
    let two = read("two.npy", "(2, 96, 96)");
    assert_eq!(two.len(), 2 * 96 * 96);
    for (map, pressure) in two.chunks(96 * 96).zip([1e9, 2e9]) {
        assert!((mean(map) / pressure - 1.0).abs() < 1e-9);
    }
    let svg = bench.read("one.svg");
    for arguments in
        ["pressure (GPa)", ">10 µm<", "white: no contact", "Black is plastic", "data:image/png"]
    {
        assert!(svg.contains(arguments), "{arguments}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_list_keeps_the_solved_loads() {
    let bench = bench();
    let arguments = "bem scan.toml --boundary free --pressure 1e6:2e9:5000 --format csv";
    let run = bench.interrupted(arguments);
    assert_eq!(run.code, Some(130), "{}", run.messages);
    let areas = cells(&run.out, "area_fraction");
    assert!(!areas.is_empty() && areas.len() < 5000 && areas.iter().all(|a| !a.is_empty()));
    assert!(run.messages.contains(&format!("{} of 5000", areas.len())), "{}", run.messages);
    // From the greatest load down.
    assert_eq!(column(&run.out, "pressure_Pa").last(), Some(&2e9));
}
