//! Memory use equals the documentation. One test, alone in its process: the peak belongs to the
//! process.

#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, reason = "tests")]

use asperity_bem::{Boundary, BoundaryElements, LoadCase, RandomSurface};

/// Peak of the resident memory \[kB\].
fn peak() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse().unwrap()
}

#[test]
fn a_handful_of_maps() {
    let n = 512;
    let map = RandomSurface::new(2.0, 4.0, 32.0).unwrap().heights(n).unwrap();
    let solver = BoundaryElements::new(map, 1.0).unwrap();
    let maps = |kilobytes: f64| kilobytes * 1024.0 / (n * n * 8) as f64;
    for (boundary, most) in [(Boundary::Periodic, 12.0), (Boundary::Free, 18.0)] {
        let before = peak();
        let solver = solver.clone().boundary(boundary).tolerance(1e-4).unwrap();
        solver.solve(LoadCase::MeanPressure(0.01)).unwrap();
        let grown = maps(peak() - before);
        println!("{boundary:?}: {grown:.1} maps");
        assert!(grown < most, "{boundary:?}: {grown}");
    }
}
