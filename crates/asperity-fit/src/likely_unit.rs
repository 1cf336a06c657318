//! The unit in which a column may be written whose data no values of the parameters describe.

use asperity_core::{Quantity, short, units_of};

use crate::distance::distance;
use crate::doubt::with_unit;
use crate::problem::{Problem, squares};
use crate::search::{PATIENCE, search};
use crate::{Data, FitError, Observation};

/// Another unit explains the misfit if it leaves less than this share of it, and less than this
/// share of the largest with which data count as described.
const SHARE: f64 = 0.2;
const EXPLAINED: f64 = 0.3;
/// Units explain the data alike whose misfits differ by less than this factor, or are this small.
const ALIKE: f64 = 1.5;
const ACCURACY: f64 = 1e-6;
/// Evaluations for a free parameter after which a unit is left out if it is farther than so many
/// times the largest distance that explains the data.
const FEW_STEPS: usize = 15;
const NEARLY: f64 = 3.0;

/// A column in another unit.
struct Rescaled {
    column: String,
    si: &'static str,
    unit: &'static str,
    factor: f64,
}

impl Rescaled {
    /// Each column of the data in each of its other units; of pure numbers, only fractions are in
    /// per cent.
    fn all(data: &Data) -> Vec<Self> {
        let mut found: Vec<Self> = vec![];
        for (column, si, _) in data.iter().flat_map(Observation::columns) {
            let is_pure = si.is_empty() && column != Quantity::AreaFraction.column();
            for (unit, factor) in if is_pure { vec![] } else { units_of(si) } {
                // kN/mm and MN/m are N/um.
                let same = |known: &Self| {
                    known.column == column && (factor / known.factor - 1.0).abs() < 1e-9
                };
                if (factor - 1.0).abs() > 1e-9 && !found.iter().any(same) {
                    found.push(Self { column: column.clone(), si, unit, factor });
                }
            }
        }
        found
    }

    /// The observation with this column in the other unit.
    fn apply(&self, one: &Observation) -> Observation {
        let [(place, _, number), (column, ..)] = one.columns();
        if place == self.column {
            return one.placed_at(number * self.factor);
        }
        let factor = if column == self.column { self.factor } else { 1.0 };
        Observation { value: one.value * factor, std: one.std.map(|std| std * factor), ..*one }
    }

    /// `load_N = 10 (row 5) looks like kN; 10 kN is 1e4 N`, of the largest value.
    fn sentence(&self, data: &Data) -> Option<String> {
        let Self { column, si, unit, factor } = self;
        let numbers = data.iter().flat_map(|one| one.columns().map(|column| (one, column)));
        let own = numbers.filter(|(_, (name, ..))| name == column);
        let (one, (.., value)) = own.max_by(|a, b| a.1.2.abs().total_cmp(&b.1.2.abs()))?;
        let (line, given, meant) =
            (data.position(one), short(value), with_unit(value * factor, si));
        Some(format!("{column} = {given} ({line}) looks like {unit}; {given} {unit} is {meant}"))
    }
}

/// The column and the unit that explain data at this distance from a fit best; of several that
/// explain them alike, that with which the parameters stay nearest to their start.
pub(crate) fn likely_unit(problem: &Problem<'_>, far: f64) -> Result<Option<String>, FitError> {
    let most = if far.is_infinite() { 1.0 } else { EXPLAINED.min(SHARE * far) };
    let given = problem.start();
    let searched = |other: &Problem<'_>, patience| match search(other, 1, patience) {
        Err(error @ FitError::Interrupted) => Err(error),
        found => Ok(found.ok().and_then(|found| {
            let best = found.best.coordinates;
            let change: Vec<f64> = best.iter().zip(&given).map(|(a, b)| a - b).collect();
            Some((distance(other.data, &other.predicted(&best).ok()?), squares(&change)))
        })),
    };
    // Most units are far off after few steps.
    let refitted = |other: &Problem<'_>| match searched(other, FEW_STEPS)? {
        Some((distance, _)) if distance < NEARLY * most => searched(other, PATIENCE),
        _ => Ok(None),
    };
    let mut found = vec![];
    for unit in Rescaled::all(problem.data) {
        let fit = problem.with(|one| Some(unit.apply(one)), refitted).transpose()?.flatten();
        found.extend(fit.map(|(distance, change)| (distance, change, unit)));
    }
    let least = found.iter().map(|one| one.0).fold(most, f64::min);
    let alike = found.iter().filter(|one| one.0 < most && one.0 <= ALIKE * least + ACCURACY);
    let nearest = alike.min_by(|a, b| a.1.total_cmp(&b.1));
    Ok(nearest.and_then(|(.., unit)| unit.sentence(problem.data)))
}
