//! A history of turning points: the virgin curve, back, forth again on the same way, and on.

use asperity_core::{At, ContactError, Quantity};
use serde::Serialize;

use crate::asperity_laws::UnloadingQuantity;
use crate::{Joint, Unloading};

/// One point of a path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Point {
    /// The separation \[m\] from the mean of the asperity heights.
    pub separation: f64,
    /// The way between turning points on which it was reached, from 1; 0 at the first of them.
    pub way: usize,
    /// The smallest separation so far \[m\], this one included: all that the contact remembers.
    pub closest: f64,
    /// \[N\].
    pub force: f64,
    /// -dF/dd \[N/m\], of the way on which the point was reached.
    pub stiffness: f64,
}

/// What a history of separations makes of a joint.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Path {
    /// All points, in the order in which they are passed; where the way meets the virgin curve
    /// again there is one.
    pub points: Vec<Point>,
    /// The work \[J\] put in on each way between turning points; below 0 where it comes back.
    pub work: Vec<f64>,
}

impl Joint {
    /// The path through turning points: separations \[m\] from the mean of the asperity heights,
    /// with `steps` points on each way, at least one. The contact is new at the first of them.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a turning point that is no finite number; those of the
    /// evaluations.
    pub fn path(&self, turning_points: &[f64], steps: usize) -> Result<Path, ContactError> {
        let Some(&first) = turning_points.first() else {
            return Ok(Path { points: vec![], work: vec![] });
        };
        for &value in turning_points {
            if !value.is_finite() {
                let (field, required) = ("turning_points", "finite separations");
                return Err(ContactError::OutOfRange { field, value, required });
            }
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
            // Where the way meets the virgin curve again.
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
                if separation < closest {
                    path.points.push(self.virgin_point(number, separation)?);
                } else {
                    path.points.push(retraced((&way, number), separation, closest)?);
                }
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

/// A point above the closest approach, or on it.
fn retraced(
    (curve, way): (&Unloading, usize),
    separation: f64,
    closest: f64,
) -> Result<Point, ContactError> {
    let retreat = separation - closest;
    let of = |quantity| Ok(curve.of(quantity, retreat)?.value());
    let (force, stiffness) = (of(UnloadingQuantity::Force)?, of(UnloadingQuantity::Stiffness)?);
    Ok(Point { separation, way, closest, force, stiffness })
}
