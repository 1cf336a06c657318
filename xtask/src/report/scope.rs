//! How much is measured, and the points on which times are taken.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Model, Quantity, Request, Scene, Surface, Tolerance};

use super::cases::tightest;
use super::methods::{Kind, Method, Setting};
use super::problem::Problem;
use super::timing::Effort;
use crate::figures::models::{NOMINAL_AREA, interface};

/// w_c/σ_z at which times are taken.
const SCALES: [f64; 7] = [3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0, 3.0];
/// d/σ_z at which times are taken.
pub const SEPARATIONS: [f64; 8] = [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

/// What a run measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every model and quantity.
    Full,
    /// A few, in seconds: to see that all of it works.
    Quick,
}

impl Scope {
    /// The models.
    ///
    /// # Errors
    /// None, as long as the names are right.
    pub fn models(self) -> Result<Vec<Model>> {
        match self {
            Self::Full => Ok(Model::all()),
            Self::Quick => {
                Ok(["ke", "jg", "at"].iter().map(|id| id.parse()).collect::<Result<_, _>>()?)
            }
        }
    }

    /// The quantities.
    #[must_use]
    pub fn quantities(self) -> &'static [Quantity] {
        match self {
            Self::Full => &Quantity::ALL,
            Self::Quick => &[Quantity::Force, Quantity::Tangent],
        }
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
    pub fn settings(self, method: &Method, model: &Model) -> Vec<Setting> {
        match (method.kind, self) {
            (Kind::Adaptive, _) => {
                self.tolerances(model).into_iter().map(Setting::Tolerance).collect()
            }
            (Kind::Panels, Self::Full) => [16, 32, 64, 128].map(Setting::Points).to_vec(),
            (Kind::Panels, Self::Quick) => [16, 128].map(Setting::Points).to_vec(),
            (Kind::Fixed, _) => vec![Setting::Fixed],
        }
    }

    /// How long each row is measured.
    #[must_use]
    pub fn effort(self) -> Effort {
        match self {
            Self::Full => Effort::FULL,
            Self::Quick => Effort::QUICK,
        }
    }
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

/// The points on which times are taken, scrambled.
///
/// # Errors
/// What the model refuses.
pub fn points(model: &Model, quantity: Quantity) -> Result<Vec<Arc<Problem>>> {
    let scenes = scenes()?;
    let request = Request::new([quantity]).within(Tolerance::new(tightest(model))?);
    let law = Arc::new(model.compile(&scenes[0], &request)?.law(quantity)?.clone());
    let count = scenes.len() * SEPARATIONS.len();
    // 23 has no factor in common with 56, so that every point comes once.
    let order = (0..count).map(|k| k * 23 % count);
    let point = |k: usize| Problem {
        model: model.clone(),
        quantity,
        scene: scenes[k / SEPARATIONS.len()].clone(),
        separation: SEPARATIONS[k % SEPARATIONS.len()],
        law: law.clone(),
    };
    Ok(order.map(|k| Arc::new(point(k))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_points_are_the_whole_grid_each_once() -> Result<()> {
        let points = points(&"jg".parse()?, Quantity::Force)?;
        let critical = points[0].scene.asperity()?.critical_interference()?;
        let mut seen: Vec<String> =
            points.iter().map(|p| format!("{:.1e} {}", critical / p.std(), p.separation)).collect();
        seen.sort();
        seen.dedup();
        assert!(seen.len() == 56, "{}", seen.len());
        assert!(seen.contains(&"3.0e-3 -1".into()) && seen.contains(&"3.0e0 6".into()));
        Ok(())
    }
}
