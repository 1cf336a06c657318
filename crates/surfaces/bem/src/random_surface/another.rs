//! Another surface like a map.

use super::{mix, waves::Waves};
use crate::HeightMap;

/// Heights and waves are made those of the map by turns, so often.
const TURNS: usize = 10;

impl HeightMap {
    /// Another surface like this periodic one, by the seed: with all of its spectrum, and nearly
    /// its distribution of heights, but random phases (Schreiber & Schmitz 1996 \[recalled\]).
    #[must_use]
    pub fn another(&self, seed: u64) -> Self {
        let count = self.heights().len();
        let waves = Waves::of(self.heights(), self.shape());
        let mut sorted = self.heights().to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let key = mix(seed);
        let mut heights: Vec<f64> = (0..count).map(|k| mix(key ^ k as u64) as f64).collect();
        let mut order: Vec<usize> = (0..count).collect();
        for _ in 0..TURNS {
            order.sort_unstable_by(|a, b| heights[*a].total_cmp(&heights[*b]));
            order.iter().zip(&sorted).for_each(|(at, height)| heights[*at] = *height);
            heights = waves.with_phases_of(&heights).heights();
        }
        heights.iter_mut().for_each(|height| *height /= count as f64);
        self.with_heights(heights)
    }
}
