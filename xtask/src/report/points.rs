//! The points at which times are taken.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Model, Quantity, Scene, Surface};

use super::problem::Problem;
use crate::figures::models::{NOMINAL_AREA, interface};

/// w_c/σ_z at which times are taken.
const SCALES: [f64; 7] = [3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0, 3.0];
/// d/σ_z at which times are taken.
pub const SEPARATIONS: [f64; 8] = [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

/// The paper's asperity on surfaces of different roughness, one for each w_c/σ_z: the law is the
/// same on all.
///
/// # Errors
/// Only if the paper's asperity is refused.
pub fn scenes() -> Result<Vec<Scene>> {
    let radius = 3.6e-4;
    let scene = |std: f64| Scene::new(interface(), Surface::new(radius, 1e8, std), NOMINAL_AREA);
    let critical = scene(1e-6).asperity()?.critical_interference()?;
    Ok(SCALES.iter().map(|scale| scene(critical / scale)).collect())
}

/// The points at which times are taken, in an order that branch predictors cannot learn.
///
/// # Errors
/// What the model refuses.
pub fn points(model: &Model, quantity: Quantity) -> Result<Vec<Arc<Problem>>> {
    let scenes = scenes()?;
    let first = Problem::new(model, quantity, scenes[0].clone(), SEPARATIONS[0])?;
    let count = scenes.len() * SEPARATIONS.len();
    let point = |k: usize| {
        let scene = scenes[k / SEPARATIONS.len()].clone();
        let separation = SEPARATIONS[k % SEPARATIONS.len()];
        Arc::new(Problem { scene, separation, ..first.clone() })
    };
    // 23 and 56 have no common factor, so every point occurs once.
    Ok((0..count).map(|k| point(k * 23 % count)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Scope;

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

    #[test]
    fn everything_that_is_measured_has_a_law() -> Result<()> {
        let pairs = Scope::Full.pairs();
        assert_eq!(pairs.len(), 4 * Model::of_asperities().len());
        // Inclined contacts are left out: their laws take long to build.
        for (model, quantity) in pairs.iter().filter(|(model, _)| !model.validity().angles) {
            points(model, *quantity)?;
        }
        Ok(())
    }
}
