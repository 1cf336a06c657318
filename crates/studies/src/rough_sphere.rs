//! Models between rough spheres beside boundary elements on such spheres:
//! xtask/data/rough-sphere.csv.

use std::f64::consts::PI;
use std::path::PathBuf;

use crate::truth::family::{GRADIENT, MODULUS, scene};
use anyhow::{Context, Result};
use asperity::bem::{Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface};
use asperity::{Datum, Model, Quantity, Scene, Separation, SeparationUnit, Tolerance};
use asperity_curved::{Curved, Hertz, Shape};
use xtask::figures::curved::{ELASTIC, MODELS, SMOOTH, SOLVED, SPHERE, YIELDING};
use xtask::folder::{root, save};
use xtask::table::Table;

/// Pixels along a side, each of this length \[m\].
const PIXELS: usize = 1024;
const PIXEL: f64 = 1e-6;
/// Waves along the side: the longest, and the shortest, of 8 pixels.
const WAVES: [f64; 2] = [16.0, 128.0];
const SEEDS: u64 = 4;
/// Plasticity index of the roughness.
const INDEX: f64 = 2.0;
/// σ/(approach of smooth bodies), and the radius of their patch in pixels: what touches of rougher
/// bodies has to lie in the map.
const CASES: [[f64; 2]; 4] = [[0.05, 256.0], [0.1, 256.0], [0.3, 220.0], [1.0, 160.0]];
/// Residual of boundary elements, which leaves 1e-4 of the roughness in gaps.
const RESIDUAL: f64 = 1e-6;
/// Width of a ring \[pixels\] on which pressures are averaged for the effective radius.
const RING: f64 = 4.0;

/// A sphere under a load with its contact when smooth.
struct Sphere {
    alpha: f64,
    radius: f64,
    load: f64,
    hertz: Hertz,
    scene: Scene,
    surface: RandomSurface,
}

/// Of a contact: the local pressure in the middle over that of smooth bodies, half axis and
/// effective radius over Hertz' radius, approach beyond Hertz' over σ, real area over Hertz' patch.
type Numbers = [f64; 5];

/// Mean of pressures at distances from the middle, weighted by a bell of a quarter of Hertz'
/// radius: more than an asperity, less than the patch.
fn local(points: impl Iterator<Item = (f64, f64)>, radius: f64) -> f64 {
    let weight = |distance: f64| (-8.0 * (distance / radius).powi(2)).exp();
    let sums = points.fold([0.0; 2], |[sum, all], (distance, pressure)| {
        let weight = weight(distance);
        [sum + weight * pressure, all + weight]
    });
    sums[0] / sums[1]
}

/// Distances of pixels from the middle \[m\].
fn distances() -> impl Iterator<Item = f64> {
    let middle = (PIXELS / 2) as f64;
    let from = move |k: usize| (k as f64 - middle) * PIXEL;
    (0..PIXELS * PIXELS).map(move |k| from(k / PIXELS).hypot(from(k % PIXELS)))
}

impl Sphere {
    fn new([alpha, patch]: [f64; 2]) -> Result<Self> {
        let surface = RandomSurface::new(WAVES[0], WAVES[0], WAVES[1])?
            .side(PIXELS as f64 * PIXEL)?
            .gradient(GRADIENT)?;
        let scene = scene(&surface, INDEX)?;
        let a = patch * PIXEL;
        // δ = a²/R.
        let radius = alpha * a * a / scene.surface.asperity_height_std;
        let load = 4.0 / 3.0 * MODULUS * a.powi(3) / radius;
        let hertz = Hertz::new(&Shape::Point { radius_x: radius, radius_y: radius }, MODULUS, load);
        Ok(Self { alpha, radius, load, hertz, scene, surface })
    }

    /// From the local pressure, the half axis, the effective radius, the approach, counted from the
    /// mean of the asperity heights, and the area.
    fn numbers(&self, [local, axis, radius, approach, area]: [f64; 5]) -> Result<Numbers> {
        let a = self.hertz.axes[0];
        let smooth = self::local(distances().map(|r| (r, self.hertz.pressure([r, 0.0]))), a);
        let beyond = approach - self.hertz.approach.context("an approach")?;
        let sigma = self.scene.surface.asperity_height_std;
        Ok([local / smooth, axis / a, radius / a, beyond / sigma, area / (PI * a * a)])
    }

    /// By a model.
    fn model(&self, id: &str) -> Result<Numbers> {
        let model: Model = id.parse()?;
        let ball = Shape::Point { radius_x: self.radius, radius_y: self.radius };
        let (asked, tolerance) = ([Quantity::Area], Tolerance::new(1e-7)?);
        let curved = Curved::new(&model, &self.scene, ball, &asked, tolerance)?;
        let found = curved.at_load(self.load)?;
        let points = found.pressures().iter().enumerate();
        let points = points.map(|(k, p)| (found.place(k)[0].hypot(found.place(k)[1]), *p));
        self.numbers([
            local(points, self.hertz.axes[0]),
            found.axes()[0],
            found.effective_radius().context("a circle")?,
            found.approach().context("an approach")?,
            found.sum(Quantity::Area)?,
        ])
    }

    /// By boundary elements, on the rough surface of a seed or smooth.
    fn solved(&self, seed: Option<u64>, hardness: Option<f64>) -> Result<Numbers> {
        let rough = seed.map(|seed| self.surface.seed(seed).heights(PIXELS)).transpose()?;
        let rough = rough.map_or(vec![0.0; PIXELS * PIXELS], |map| map.heights().to_vec());
        let heights = distances().zip(&rough).map(|(r, z)| z - r * r / (2.0 * self.radius));
        let heights: Vec<f64> = heights.collect();
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        let map = HeightMap::new(heights, [PIXELS; 2], [PIXEL; 2])?;
        let elements = BoundaryElements::new(map, MODULUS)?.boundary(Boundary::Free);
        let mut elements = elements.tolerance(RESIDUAL)?;
        if let Some(hardness) = hardness {
            elements = elements.hardness(hardness)?;
        }
        let found = elements.solve(LoadCase::Load(self.load))?;
        let (mut rings, mut squares) = (vec![[0.0; 2]; PIXELS], 0.0);
        for (r, p) in distances().zip(&found.pressures) {
            squares += r * r * p * PIXEL * PIXEL;
            let [sum, count] = &mut rings[(r / (RING * PIXEL)) as usize];
            (*sum, *count) = (*sum + p, *count + 1.0);
        }
        let along: f64 = rings.iter().map(|[sum, count]| sum / count.max(1.0)).sum();
        // √(5 ⟨x²⟩) with ⟨r²⟩ = 2 ⟨x²⟩, and (3π/4) ∫ p r dr/∫ p dr.
        let axis = (2.5 * squares / self.load).sqrt();
        let radius = 0.375 * self.load / (along * RING * PIXEL);
        // From where the mean plane of the surface would touch.
        let plane = Separation::metres(found.separation + mean).from_surface_mean();
        let (metres, datum) = (SeparationUnit::Metres, Datum::AsperityMean);
        let approach = match seed {
            Some(_) => -plane.measured_in(metres, datum, &self.scene)?.value,
            None => -plane.value,
        };
        let area = found.area * (PIXELS as f64 * PIXEL).powi(2);
        eprintln!("alpha {}, seed {seed:?}: {} iterations", self.alpha, found.iterations);
        let pressures = distances().zip(found.pressures.iter().copied());
        self.numbers([local(pressures, self.hertz.axes[0]), axis, radius, approach, area])
    }
}

/// Solves all of them; returns the path.
///
/// # Errors
/// A contact that cannot be solved, a file that cannot be written.
pub fn write() -> Result<Vec<PathBuf>> {
    let mut rows: Vec<(&str, f64, Numbers)> = vec![];
    for case in CASES {
        let sphere = Sphere::new(case)?;
        let mut add = |curve, numbers: Numbers| rows.push((curve, sphere.alpha, numbers));
        for id in MODELS {
            add(id, sphere.model(id)?);
        }
        add(SMOOTH, sphere.solved(None, None)?);
        for (curve, hardness) in [(ELASTIC, None), (YIELDING, sphere.scene.interface.hardness)] {
            for seed in 1..=SEEDS {
                add(curve, sphere.solved(Some(seed), hardness)?);
            }
        }
    }
    let mut table = Table::new(&["panel", "curve", "alpha", "value"]);
    for (k, panel) in SPHERE.iter().enumerate() {
        for (curve, alpha, numbers) in &rows {
            table.push(&[panel, curve], [*alpha, numbers[k]])?;
        }
    }
    save(&root().join("xtask/data"), [(SOLVED.to_owned(), table.into_text())])
}

#[cfg(test)]
mod tests {
    use super::*;
    use xtask::table::rows_of;

    /// What the guide says of the committed numbers.
    #[test]
    fn models_deviate_by_what_the_guide_says() -> Result<()> {
        let rows: Vec<(String, String, f64, f64)> =
            rows_of(&root().join("xtask/data").join(SOLVED))?;
        let mean = |panel: &str, curve: &str, alpha: f64| {
            let own = rows.iter().filter(|row| row.0 == panel && row.1 == curve);
            let own: Vec<f64> =
                own.filter(|row| (row.2 - alpha).abs() < 1e-9).map(|row| row.3).collect();
            own.iter().sum::<f64>() / own.len() as f64
        };
        for [alpha, _] in CASES {
            for (panel, right, least) in
                [("pressure", 1.0, 2e-6), ("axis", 1.0, 4e-6), ("area", 1.0, 3e-4)]
            {
                assert!((mean(panel, SMOOTH, alpha) - right).abs() < least, "{panel}");
            }
            assert!(mean("approach", SMOOTH, alpha).abs() < 2e-5);
            for id in ["ke", "jg"] {
                for (panel, least, most) in [
                    ("pressure", -0.05, 0.0),
                    ("axis", 0.02, 0.04),
                    ("radius", -0.04, 0.04),
                    ("area", -0.04, 0.071),
                ] {
                    let off = mean(panel, id, alpha) / mean(panel, YIELDING, alpha) - 1.0;
                    assert!((least..=most).contains(&off), "{panel}, {id}, {alpha}: {off}");
                }
                let off = mean("approach", id, alpha) - mean("approach", YIELDING, alpha);
                assert!((0.1..0.71).contains(&off), "{id}, {alpha}: {off}");
            }
        }
        Ok(())
    }
}
