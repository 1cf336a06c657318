//! How much is measured, the points on which times are taken, and how.

use std::sync::Arc;
use std::time::{Duration, Instant};

use anyhow::Result;
use asperity::{Model, Quantity, Scene, Surface};

use super::cases::tightest;
use super::methods::{Method, Setting};
use super::ours::law_behind;
use super::problem::{Asked, Problem};
use crate::figures::models::{NOMINAL_AREA, interface};

/// w_c/σ_z at which times are taken.
const SCALES: [f64; 7] = [3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0, 3.0];
/// d/σ_z at which times are taken.
pub const SEPARATIONS: [f64; 8] = [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

/// The quantities that are one integral of one law; all others follow from these.
const INTEGRALS: [Quantity; 4] =
    [Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::Tangent];

/// What a run measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every model and integral.
    Full,
    /// A few, in seconds: to see that all of it works.
    Quick,
}

impl Scope {
    /// The pairs of model and quantity.
    ///
    /// # Errors
    /// None, as long as the names of models are right.
    pub fn pairs(self) -> Result<Vec<(Model, Quantity)>> {
        let (models, quantities) = match self {
            Self::Full => (Model::all(), &INTEGRALS[..]),
            Self::Quick => {
                let models = ["ke", "jg", "gao"].map(str::parse);
                let models = models.into_iter().collect::<Result<Vec<Model>, _>>()?;
                (models, &[Quantity::Force, Quantity::Tangent][..])
            }
        };
        let pairs = |model: Model| quantities.iter().map(move |q| (model.clone(), *q));
        Ok(models.into_iter().flat_map(pairs).collect())
    }

    /// Tolerances for a model, loosest first; none is asked that is not promised.
    #[must_use]
    pub fn tolerances(self, model: &Model) -> Vec<f64> {
        let all: &[f64] = match self {
            Self::Full => &[1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-13],
            Self::Quick => &[1e-3, 1e-10],
        };
        all.iter().copied().filter(|tolerance| *tolerance >= tightest(model)).collect()
    }

    /// What a method is set to, row by row.
    #[must_use]
    pub fn settings(self, method: Method, model: &Model) -> Vec<Setting> {
        let points: &[usize] = if self == Self::Full { &[16, 32, 64, 128] } else { &[16, 128] };
        method.settings(&self.tolerances(model), points)
    }

    /// How long each row is measured.
    #[must_use]
    pub fn effort(self) -> Effort {
        let (repeats, batch, most) = if self == Self::Full { (21, 300, 60) } else { (3, 50, 5) };
        let (batch, most) = (Duration::from_micros(batch), Duration::from_millis(most));
        Effort { repeats, batch, most }
    }
}

/// How long to measure: so many batches, each of at least so long, until so much time is gone.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    repeats: usize,
    batch: Duration,
    most: Duration,
}

impl Effort {
    /// Median time of one call \[ns\], after two that warm up; of three batches at least.
    #[must_use]
    pub fn median_ns(&self, mut call: impl FnMut()) -> f64 {
        let mut time = |calls: u32| {
            let start = Instant::now();
            (0..calls).for_each(|_| call());
            start.elapsed()
        };
        let once = time(1).min(time(1)).max(Duration::from_nanos(20));
        let calls = self.batch.as_nanos().div_ceil(once.as_nanos()).clamp(1, 1_000_000) as u32;
        let (start, mut batches) = (Instant::now(), vec![]);
        while batches.len() < self.repeats && (batches.len() < 3 || start.elapsed() < self.most) {
            batches.push(time(calls).as_nanos() as f64 / f64::from(calls));
        }
        median(batches).unwrap_or(0.0)
    }
}

/// The middle one, if there is any.
#[must_use]
pub fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied()
}

/// The paper's asperity on surfaces of different roughness, one for each w_c/σ_z: the law is the
/// same on all.
///
/// # Errors
/// None, as long as the asperity is the paper's.
pub fn scenes() -> Result<Vec<Scene>> {
    let radius = 3.6e-4;
    let scene = |std: f64| Scene::new(interface(), Surface::new(radius, 1e8, std), NOMINAL_AREA);
    let critical = scene(1e-6).asperity()?.critical_interference()?;
    Ok(SCALES.iter().map(|scale| scene(critical / scale)).collect())
}

/// The points on which times are taken, in an order that no branch predictor learns.
///
/// # Errors
/// What the model refuses.
pub fn points(model: &Model, quantity: Quantity) -> Result<Vec<Arc<Problem>>> {
    let scenes = scenes()?;
    let law = Arc::new(law_behind(model, quantity, &scenes[0].asperity()?, tightest(model))?);
    let count = scenes.len() * SEPARATIONS.len();
    let point = |k: usize| {
        let scene = scenes[k / SEPARATIONS.len()].clone();
        let separation = SEPARATIONS[k % SEPARATIONS.len()];
        let asked = Asked { model: model.clone(), quantity, scene, separation };
        Arc::new(Problem { asked, law: law.clone() })
    };
    // 23 has no factor in common with 56, so that every point comes once.
    Ok((0..count).map(|k| point(k * 23 % count)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_points_are_the_whole_grid_each_once() -> Result<()> {
        let points = points(&"jg".parse()?, Quantity::Force)?;
        let critical = points[0].asked.scene.asperity()?.critical_interference()?;
        let mut seen: Vec<String> = points
            .iter()
            .map(|p| format!("{:.1e} {}", critical / p.std(), p.asked.separation))
            .collect();
        seen.sort();
        seen.dedup();
        assert!(seen.len() == 56, "{}", seen.len());
        assert!(seen.contains(&"3.0e-3 -1".into()) && seen.contains(&"3.0e0 6".into()));
        Ok(())
    }

    #[test]
    fn whatever_is_measured_has_a_law() -> Result<()> {
        let pairs = Scope::Full.pairs()?;
        assert_eq!(pairs.len(), 4 * Model::all().len());
        // Those whose laws take long to make are like Gao's.
        for (model, quantity) in pairs.iter().filter(|(model, _)| !model.validity().angles) {
            points(model, *quantity)?;
        }
        Ok(())
    }

    #[test]
    fn a_call_that_sleeps_takes_as_long_as_it_sleeps() {
        let nap = Duration::from_millis(2);
        let found = Scope::Quick.effort().median_ns(|| std::thread::sleep(nap));
        assert!((2e6..2e7).contains(&found), "{found}");
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    }
}
