//! The requirements of the fuzzers on the readers of scans and scenes: no panic, no endless loop,
//! no excessive memory, and a result that can be used.
//!
//! A minute of each, from this folder, with cargo-fuzz and a nightly toolchain:
//!
//! ```sh
//! for target in $(cargo fuzz list --fuzz-dir .); do
//!     mkdir -p corpus/$target
//!     cargo +nightly fuzz run --fuzz-dir . $target corpus/$target seeds/$target -- -max_total_time=60
//! done
//! ```
//!
//! Each finding becomes a test of the crate concerned (`tests/suite/hostile.rs`).

use asperity_topography::{Estimator, LengthUnit, Level, ReadOptions, read_bytes};

/// Reads a surface and measures it in every way.
pub fn measure(name: &str, bytes: &[u8]) {
    let stated = ReadOptions { max_missing: 1.0, ..ReadOptions::default() };
    let given = ReadOptions {
        unit: Some(LengthUnit::Micrometre),
        pixel_size: Some([1.0.into(); 2]),
        ..stated.clone()
    };
    for options in [stated, given] {
        let Ok(surface) = read_bytes(name, bytes, &options) else { continue };
        for level in [Level::None, Level::Mean, Level::Plane, Level::Quadratic] {
            let Ok(levelled) = surface.clone().level(level) else { continue };
            for estimator in [Estimator::Moments, Estimator::Summits] {
                if let Ok(statistics) = levelled.statistics(estimator) {
                    assert!(statistics.sq.is_finite());
                    assert!(statistics.surface().is_ok_and(|surface| surface.check().is_ok()));
                    assert!(statistics.mean_plane_offset.is_none_or(f64::is_finite));
                }
            }
            if let Ok(density) = levelled.height_density() {
                assert!(density.density_per_m.iter().all(|density| *density >= 0.0));
            }
            let cutoff = 3.0 * levelled.pixel_size()[0];
            let _ = levelled.filter(cutoff).map(|rough| rough.statistics(Estimator::Moments));
        }
    }
}
