//! A history of turning points: virgin loading, unloading, reloading on the same curve.

use asperity_core::{At, ContactError, Quantity, require};
use serde::Serialize;

use crate::Joint;
use crate::asperity_laws::UnloadingQuantity;

/// One point of a path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Point {
    /// The separation \[m\] from the mean of the asperity heights.
    pub separation: f64,
    /// Number of the leg between two turning points, from 1; 0 at the first turning point.
    pub way: usize,
    /// The smallest separation so far \[m\], this one included: the state of the contact.
    pub closest: f64,
    /// The normal force \[N\].
    pub force: f64,
    /// -dF/dd \[N/m\] on the leg of the point.
    pub stiffness: f64,
}

/// The response of a joint to a history of separations.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Path {
    /// All points in the order of the history, with one where reloading reaches the virgin curve.
    pub points: Vec<Point>,
    /// The work \[J\] done on the joint on each leg; below 0 where the joint returns work.
    pub work: Vec<f64>,
}

impl Joint {
    /// The path through turning points: separations \[m\] from the mean of the asperity heights,
    /// with `steps` points on each leg, at least one. The contact is virgin at the first turning
    /// point.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a turning point that is not finite; the errors of the
    /// evaluations.
    pub fn path(&self, turning_points: &[f64], steps: usize) -> Result<Path, ContactError> {
        let Some(&first) = turning_points.first() else {
            return Ok(Path { points: vec![], work: vec![] });
        };
        for &value in turning_points {
            require(value.is_finite(), "turning_points", value, "finite separations")?;
        }
        let mut way = self.unloading(At::metres(first))?;
        let mut closest = first;
        let mut path = Path { points: vec![self.virgin_point(0, first)?], work: vec![] };
        for (leg, number) in turning_points.windows(2).zip(1..) {
            let (from, to) = (leg[0], leg[1]);
            let at = |k: usize| match k {
                k if k == steps.max(1) => to,
                k => from + (to - from) * k as f64 / steps.max(1) as f64,
            };
            let mut places: Vec<f64> = (1..=steps.max(1)).map(at).collect();
            // The point at which reloading reaches the virgin curve.
            if to < closest && closest < from {
                places.push(closest);
                places.sort_by(|a, b| b.total_cmp(a));
                places.dedup();
            }
            let mut work = 0.0;
            let last = to.max(closest);
            if from > closest || to > closest {
                let returned = |d: f64| Ok(way.returned(d - closest)?.value());
                work += returned(from)? - returned(last)?;
            }
            for separation in places {
                path.points.push(match separation < closest {
                    true => self.virgin_point(number, separation)?,
                    false => {
                        let of = |quantity| way.of(quantity, separation - closest);
                        let force = of(UnloadingQuantity::Force)?.value();
                        let stiffness = of(UnloadingQuantity::Stiffness)?.value();
                        Point { separation, way: number, closest, force, stiffness }
                    }
                });
            }
            if to < closest {
                work += self.closing(closest, to)?.value;
                (closest, way) = (to, self.unloading(At::metres(to))?);
            }
            path.work.push(work);
        }
        Ok(path)
    }

    fn virgin_point(&self, way: usize, separation: f64) -> Result<Point, ContactError> {
        let of = |quantity| self.virgin().evaluate(quantity, At::metres(separation));
        let (force, stiffness) = (of(Quantity::Force)?, of(Quantity::Tangent)?);
        let (force, stiffness) = (force.value(), stiffness.value());
        Ok(Point { separation, way, closest: separation, force, stiffness })
    }
}
