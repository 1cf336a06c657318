//! The load at a separation, where solved surfaces determine the mean gap.

use super::contact::{BestContact, FOUND};
use super::model::Answering;
use crate::evidence::Compared;
use asperity_core::{Datum, Separation, SeparationUnit};

/// Ratio of neighbouring pressures between which a gap is looked for.
const STEP: f64 = 2.0;
/// Pressures over the equivalent modulus that are searched.
const LIGHTEST: f64 = 1e-15;
const HEAVIEST: f64 = 1.0;
const MOST_STEPS: usize = 60;

impl<M: Answering> BestContact<M> {
    /// The mean gap that is expected at a mean pressure.
    fn gap_at(&self, pressure: f64) -> Option<f64> {
        let of = Compared::MeanGap;
        let expected = self.expected_of(&[of], pressure, None).ok()?;
        let estimate = expected.estimate(of).filter(|_| !expected.extrapolated);
        let known = || Some(self.expected_value(of, pressure).ok()??.value);
        estimate.map(|one| one.value).or_else(known)
    }

    fn gaps(&self) -> &[[f64; 2]] {
        self.gaps.get_or_init(|| {
            let modulus = self.scene.asperity().map_or(f64::NAN, |one| one.equivalent_modulus);
            let next = |p: &f64| Some(p * STEP).filter(|p| *p < HEAVIEST * modulus);
            let all = std::iter::successors(Some(LIGHTEST * modulus), next);
            let mut found: Vec<[f64; 2]> = vec![];
            for pressure in all {
                match (self.gap_at(pressure), found.last()) {
                    // Falling gaps alone can be inverted.
                    (Some(gap), Some([_, last])) if gap >= *last => {}
                    (Some(gap), _) => found.push([pressure.ln(), gap]),
                    (None, None) => {}
                    (None, Some(_)) => break,
                }
            }
            found
        })
    }

    /// The mean pressure at a separation; `None` at one that no pressure is expected to have.
    pub(super) fn pressure_at(&self, separation: Separation) -> Option<f64> {
        let unit = SeparationUnit::Metres;
        let gap = separation.measured_in(unit, Datum::SurfaceMean, &self.scene).ok()?.value;
        let gaps = self.gaps();
        let above = gaps.partition_point(|[_, known]| *known > gap);
        let (Some([mut low, mut over]), Some([mut high, mut under])) =
            (gaps.get(above.checked_sub(1)?).copied(), gaps.get(above).copied())
        else {
            return None;
        };
        (over, under) = (over - gap, under - gap);
        // The false position with halved weights (Illinois): nearly straight in ln p.
        let mut side = 0;
        for _ in 0..MOST_STEPS {
            let middle = (low * under - high * over) / (under - over);
            let off = self.gap_at(middle.exp())? - gap;
            if off > 0.0 {
                under = if side == 1 { 0.5 * under } else { under };
                (low, over, side) = (middle, off, 1);
            } else {
                over = if side == 2 { 0.5 * over } else { over };
                (high, under, side) = (middle, off, 2);
            }
            if off == 0.0 || high - low <= FOUND {
                return Some(middle.exp());
            }
        }
        Some((0.5 * (low + high)).exp())
    }
}
