//! The material ratio curve and the functional parameters of ISO 25178-2 and ISO 21920-2.

use crate::glance::{Number, reported};
use crate::{Reported, Topography, TopographyError};

/// Width of the secant of least slope, as a material ratio.
const CORE: f64 = 0.4;
/// Material ratios that bound the core of the volumes.
const VOLUMES: [f64; 2] = [0.1, 0.8];

/// The heights above which a share of the surface lies: the share is 0 at the highest point, 1 at
/// the lowest.
///
/// Between the points the curve is linear, as quantiles of NumPy and the curve of surfalize are.
/// Volumes are means over the points, of which n each stand for 1/n of the surface: the area under
/// the line gives the highest and the lowest point half of that, and Spk and Svk of 32 x 32 points
/// of a Gaussian surface are 1.8 % too low by it, here within 0.3 %. \[derived\]
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialRatio {
    /// Heights about their mean \[m\], falling.
    heights: Vec<f64>,
}

/// Points of the curve in its csv, less one.
const DRAWN: usize = 400;

impl Topography {
    /// The material ratio curve of the measured points, about their mean.
    ///
    /// # Errors
    /// [`TopographyError::Flat`] when all heights are equal.
    pub fn material_ratio(&self) -> Result<MaterialRatio, TopographyError> {
        let mean = self.mean();
        let measured = self.heights().iter().filter(|z| !z.is_nan());
        let mut heights: Vec<f64> = measured.map(|z| z - mean).collect();
        heights.sort_unstable_by(|a, b| b.total_cmp(a));
        if heights.first() <= heights.last() {
            return Err(TopographyError::Flat { points: heights.len() });
        }
        Ok(MaterialRatio { heights })
    }

    /// Functional parameters of the surface, which should be [levelled](Self::level) and filtered,
    /// in SI units: `sk` to `vvv`; of a profile `rk` to `rmr2`, `rz`, `rsm` and `rdq`.
    ///
    /// # Errors
    /// [`TopographyError::Flat`] when all heights are equal.
    pub fn functional(&self) -> Result<Vec<Reported>, TopographyError> {
        let values = self.material_ratio()?.functional();
        let profile = usize::from(self.is_profile());
        let row =
            |(row, value): ([&'static str; 4], f64)| (row[profile], Some(value), row[2], row[3]);
        let mut rows: Vec<Number> = FUNCTIONAL.into_iter().zip(values).map(row).collect();
        rows.retain(|(name, ..)| !name.is_empty());
        if self.is_profile() {
            let [rz, rsm] = self.profile_elements();
            let [[rdq, _], _] = self.at_distance(1);
            rows.extend([
                ("rz", rz, "m", "mean height from lowest to highest point, of five sections"),
                ("rsm", rsm, "m", "mean width of a hill with a dale"),
                ("rdq", rdq, "", "rms slope between neighbouring points"),
            ]);
        }
        Ok(rows.into_iter().map(reported).collect())
    }
}

impl MaterialRatio {
    fn intervals(&self) -> f64 {
        (self.heights.len() - 1) as f64
    }

    /// The interval of a share and the place in it.
    fn place(&self, share: f64) -> (usize, f64) {
        let at = share.clamp(0.0, 1.0) * self.intervals();
        let interval = (at as usize).min(self.heights.len() - 2);
        (interval, at - interval as f64)
    }

    /// The height above the mean \[m\] above which this share of the surface lies.
    #[must_use]
    pub fn height(&self, share: f64) -> f64 {
        let (k, t) = self.place(share);
        self.heights[k] + t * (self.heights[k + 1] - self.heights[k])
    }

    /// The share of the surface above this height above the mean \[m\].
    #[must_use]
    pub fn share(&self, height: f64) -> f64 {
        let below = self.heights.partition_point(|z| *z > height);
        match below.checked_sub(1) {
            None => 0.0,
            Some(_) if below == self.heights.len() => 1.0,
            Some(k) => {
                let [above, below] = [self.heights[k], self.heights[below]];
                (k as f64 + (above - height) / (above - below)) / self.intervals()
            }
        }
    }

    /// The volume of material above a height and that of voids below it \[m\]: means over the
    /// points, each of which stands for the same share of the surface.
    fn volumes(&self, height: f64) -> [f64; 2] {
        let mean = |part: fn(f64) -> f64| {
            self.heights.iter().map(|z| part(z - height)).sum::<f64>() / self.heights.len() as f64
        };
        [mean(|above| above.max(0.0)), mean(|above| (-above).max(0.0))]
    }

    /// The share at which the window of 40 % begins in which the curve falls least, of several the
    /// first; and the line of the core, by least squares over the points of this window: its
    /// heights at the shares 0 and 1.
    fn core(&self) -> (f64, [f64; 2]) {
        let step = 1.0 / self.intervals();
        let last = ((1.0 - CORE) / step).floor() as usize;
        let fall = |k: usize| self.heights[k] - self.height(k as f64 * step + CORE);
        let falls = (0..=last).map(|k| (k, fall(k)));
        let (first, _) = falls
            .fold((0, f64::INFINITY), |least, next| if next.1 < least.1 { next } else { least });
        let n = (CORE / step + 1e-9).floor() as usize + 1;
        let points = &self.heights[first..(first + n).min(self.heights.len())];
        let n = points.len() as f64;
        let (middle, mean) = (0.5 * (n - 1.0), points.iter().sum::<f64>() / n);
        let product = |(k, z): (usize, &f64)| (k as f64 - middle) * (z - mean);
        let square = n * (n * n - 1.0) / 12.0;
        let products = points.iter().enumerate().map(product).sum::<f64>();
        let slope = if square > 0.0 { products / square / step } else { 0.0 };
        let top = mean - slope * (first as f64 + middle) * step;
        (first as f64 * step, [top, top + slope])
    }

    /// The curve, the secant of least slope and the line of the core as csv text with the columns
    /// `curve,material_ratio,height_m`: shares from 0 to 1, and heights above the mean \[m\].
    #[must_use]
    pub fn csv(&self) -> String {
        let (first, [top, bottom]) = self.core();
        let curve = (0..=DRAWN).map(|k| k as f64 / DRAWN as f64);
        let curve = curve.map(|share| ("curve", share, self.height(share)));
        let secant = [first, first + CORE].map(|share| ("secant", share, self.height(share)));
        let rows = curve.chain(secant).chain([("core", 0.0, top), ("core", 1.0, bottom)]);
        let row = |(name, share, height)| format!("{name},{share:.8},{height:.8e}\n");
        "curve,material_ratio,height_m\n".to_owned() + &rows.map(row).collect::<String>()
    }

    /// Sk, Spk, Svk, Smr1, Smr2, Vmp, Vmc, Vvc and Vvv, in the order of the table of their names:
    /// Sk \[m\], the height of the core by the line fitted to the secant of least slope over 40 %
    /// of the curve; Spk and Svk \[m\], reduced heights of the peaks above and the dales below it;
    /// Smr1 and Smr2, material ratios from 0 to 1 at its top and bottom; Vmp, Vmc, Vvc and Vvv
    /// \[m³/m²\], the material above the height of 10 % and between those of 10 and 80 %, the
    /// voids there and below 80 %.
    #[must_use]
    pub fn functional(&self) -> [f64; 9] {
        let (_, [top, bottom]) = self.core();
        // A core that is a plateau belongs to neither peaks nor dales, however its heights round.
        let rounding = 1e-10 * (self.heights[0] - self.heights[self.heights.len() - 1]);
        let rounding = if top - bottom < rounding { rounding } else { 0.0 };
        let [smr1, smr2] = [top + rounding, bottom - rounding].map(|height| self.share(height));
        // Triangles of the same areas above and below the core, on the share of a point or more.
        let triangle =
            |area: f64, base: f64| 2.0 * area / base.max(1.0 / self.heights.len() as f64);
        let [[vmp, above], [material, vvv]] = VOLUMES.map(|share| self.volumes(self.height(share)));
        let [spk, svk] = [self.volumes(top)[0], self.volumes(bottom)[1]];
        let [spk, svk] = [triangle(spk, smr1), triangle(svk, 1.0 - smr2)];
        [top - bottom, spk, svk, smr1, smr2, vmp, material - vmp, above - vvv, vvv]
    }
}

/// A functional parameter: its names for a surface and a profile, unit and meaning.
const FUNCTIONAL: [[&str; 4]; 9] = [
    ["sk", "rk", "m", "height of the core, by the line of the 40 % of least slope"],
    ["spk", "rpk", "m", "reduced height of the peaks above the core"],
    ["svk", "rvk", "m", "reduced depth of the dales below the core"],
    ["smr1", "rmr1", "", "material ratio at the top of the core"],
    ["smr2", "rmr2", "", "material ratio at the bottom of the core"],
    ["vmp", "", "m3/m2", "material above the height of a ratio of 10 %"],
    ["vmc", "", "m3/m2", "material between the heights of 10 and 80 %"],
    ["vvc", "", "m3/m2", "voids between the heights of 10 and 80 %"],
    ["vvv", "", "m3/m2", "voids below the height of 80 %"],
];

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(heights: Vec<f64>) -> MaterialRatio {
        let columns = heights.len();
        Topography::new(heights, columns, [1e-6; 2]).unwrap().material_ratio().unwrap()
    }

    #[test]
    fn plateaus_are_no_peaks_and_no_dales() {
        // 70 % at 0 and 30 % at -1, one peak of 1 on a flat, and one pit.
        for count in [30, 1000, 4096, 99_991] {
            let low = count * 3 / 10;
            let two = (0..count).map(|k| if k < low { -1.0 } else { 0.0 });
            let [_, _, svk, _, smr2, ..] = curve(two.collect()).functional();
            let share = (count - low) as f64 / count as f64;
            assert!((smr2 - share).abs() < 2.0 / count as f64, "{count} {smr2}");
            assert!((svk - 2.0).abs() < 0.2, "{count} {svk}");
            for sign in [1.0, -1.0] {
                let one = (0..count).map(|k| if k == 7 { sign } else { 0.0 });
                let [_, spk, svk, ..] = curve(one.collect()).functional();
                let size = if sign > 0.0 { spk } else { svk };
                assert!((size - 2.0).abs() < 0.2, "{count} {size}");
            }
        }
    }

    #[test]
    fn a_straight_curve_is_all_core() {
        let found = curve((0..1001).map(|k| f64::from((k * 5) % 1001) * 1e-9).collect());
        let [sk, spk, svk, smr1, smr2, vmp, vmc, vvc, vvv] = found.functional();
        let close = |found: f64, right: f64| {
            assert!((found - right).abs() < 1e-12 * (1.0 + right), "{found} {right}");
        };
        for (found, right) in [(sk, 1e-6), (spk, 0.0), (svk, 0.0)] {
            close(found / 1e-6, right / 1e-6);
        }
        close(smr1, 0.0);
        close(smr2, 1.0);
        // Triangles of a unit square cut at .1 and .8: sums of 1 to 100, 200, 800 and 900.
        let volumes = [(vmp, 5_050.0), (vmc, 315_350.0), (vvc, 385_350.0), (vvv, 20_100.0)];
        volumes.into_iter().for_each(|(found, right)| close(found / 1e-6, right / 1_001e3));
        close(found.share(found.height(0.37)), 0.37);
    }

    #[test]
    fn a_plateau_with_grooves_has_deep_dales() {
        // 9 of 10 points within 0.1 um, the others down to -4 um.
        let height = |k: u32| match k % 10 {
            0 => -4e-6 * f64::from(k) / 1000.0,
            _ => 1e-7 * f64::from(k) / 1000.0,
        };
        let [sk, spk, svk, _, smr2, ..] = curve((0..1000).map(height).collect()).functional();
        assert!((sk / 1.1e-7 - 1.0).abs() < 0.02, "{sk}");
        assert!(svk > 30.0 * spk && (smr2 - 0.9).abs() < 0.02, "{spk} {svk} {smr2}");
    }

    #[test]
    fn few_points_have_the_areas_of_many() {
        // Quantiles of the logistic distribution.
        let of = |n: u32| {
            let share = |k: u32| (f64::from(k) + 0.5) / f64::from(n);
            let found = curve((0..n).map(|k| (share(k) / (1.0 - share(k))).ln()).collect());
            let [sk, spk, svk, _, _, vmp, .., vvv] = found.functional();
            [sk, spk, svk, vmp, vvv]
        };
        let (few, many) = (of(1024), of(1 << 18));
        for (few, many) in few.into_iter().zip(many) {
            assert!((few / many - 1.0).abs() < 3e-3, "{few} {many}");
        }
    }

    #[test]
    fn flat_surfaces_are_refused() {
        let flat = Topography::new(vec![1.0; 9], 3, [1.0; 2]).unwrap();
        assert!(flat.material_ratio().is_err());
    }
}
