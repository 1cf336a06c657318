//! The units in which data may be written that no values of the parameters describe.

use asperity_core::{OTHER_UNITS, Quantity, short, units_of};

use crate::distance::distance;
use crate::doubt::with_unit;
use crate::observation::{LOAD, PRESSURE};
use crate::problem::{Problem, squares};
use crate::search::{PATIENCE, search};
use crate::{Data, FitError, Observation};

/// Units explain the data alike whose misfits differ by less than this factor, or are this small.
const ALIKE: f64 = 1.5;
const ACCURACY: f64 = 1e-6;
/// Evaluations for a free parameter after which a unit is left out if it is farther than so many
/// times the largest distance that explains the data.
const FEW_STEPS: usize = 15;
const NEARLY: f64 = 3.0;
/// A value is near the predicted one within this difference of logarithms.
const NEAR: f64 = 0.2;

/// A column in another unit.
#[derive(Clone)]
struct Rescaled {
    column: String,
    si: &'static str,
    unit: &'static str,
    factor: f64,
    /// For a load in a column of pressures, or the other way round: the nominal area.
    on_area: String,
}

impl Rescaled {
    /// A column in each of its other units; of pure numbers, only fractions are in per cent.
    fn all(column: &str, si: &'static str, area: Option<f64>) -> Vec<Self> {
        let is_pure = si.is_empty() && column != Quantity::AreaFraction.column();
        let known = if is_pure { vec![] } else { units_of(si) };
        let known = known.into_iter().map(|(unit, factor)| (unit, factor, String::new()));
        let on_area = area.and_then(|area| {
            let (unit, factor) = match column {
                LOAD | "force_N" => ("Pa", area),
                PRESSURE => ("N", 1.0 / area),
                _ => return None,
            };
            Some((unit, factor, format!(" on the nominal area of {} m2", short(area))))
        });
        let mut found: Vec<Self> = vec![];
        for (unit, factor, on_area) in on_area.into_iter().chain(known) {
            // kN/mm and MN/m are N/um, and N on 1 cm2 is N/cm2.
            let same = |other: f64| (factor / other - 1.0).abs() < 1e-9;
            if !same(1.0) && found.iter().all(|known| !same(known.factor)) {
                found.push(Self { column: column.into(), si, unit, factor, on_area });
            }
        }
        found
    }

    /// The observation with this column in the other unit.
    fn apply(&self, one: Observation) -> Observation {
        let [(place, _, number), (column, ..)] = one.columns();
        if place == self.column {
            return one.placed_at(number * self.factor);
        }
        if column != self.column {
            return one;
        }
        let std = one.std.map(|std| std * self.factor);
        Observation { value: one.value * self.factor, std, ..one }
    }

    /// `10 looks like MPa; 10 MPa is 1e7 Pa`, with words around the first number.
    fn sentence(&self, value: f64, [before, behind]: [&str; 2]) -> String {
        let Self { si, unit, factor, on_area, .. } = self;
        let (given, meant) = (short(value), with_unit(value * factor, si));
        format!("{before}{given}{behind} looks like {unit}; {given} {unit}{on_area} is {meant}")
    }

    /// The sentence about the largest value of the column, with its line.
    fn largest(&self, data: &Data) -> Option<String> {
        let numbers = data.iter().flat_map(|one| one.columns().map(|column| (one, column)));
        let own = numbers.filter(|(_, (column, ..))| *column == self.column);
        let (one, (column, _, value)) = own.max_by(|a, b| a.1.2.abs().total_cmp(&b.1.2.abs()))?;
        let around = [format!("{column} = "), format!(" ({})", data.position(one))];
        Some(self.sentence(value, [&around[0], &around[1]]))
    }
}

/// A fit to data in other units.
struct Explanation {
    /// Its [`distance`] from the data.
    distance: f64,
    /// How far the parameters are from their start, squared.
    change: f64,
    has_contacts: bool,
    units: Vec<Rescaled>,
}

/// The unit of a column that explains the data best, or the units of a column of places and one of
/// values: stiffness rises nearly as the load, so that a factor on both changes the misfit little.
/// An explanation leaves less than `most`, and contacts in every row; `anyhow` takes a fit without
/// contacts if no other is found.
pub(crate) fn likely_units(
    problem: &Problem<'_>,
    most: f64,
    anyhow: bool,
) -> Result<Option<String>, FitError> {
    let data = problem.data;
    let area = problem.at(&problem.start()).ok().map(|(scene, _)| scene.nominal_area);
    // Of places, and of values.
    let [places, values] = [0, 1].map(|which| {
        let mut known: Vec<String> = vec![];
        let mut units = vec![];
        for [place, value] in data.iter().map(Observation::columns) {
            let (column, si, _) = if which == 0 { place } else { value };
            if !known.contains(&column) {
                units.extend(Rescaled::all(&column, si, area));
                known.push(column);
            }
        }
        units
    });
    let single = places.iter().chain(&values).map(|one| vec![one.clone()]);
    let single = explanations(problem, single, most)?;
    if let Some(found) = best(data, &single, true) {
        return Ok(Some(found));
    }
    let pairs = places.iter().flat_map(|a| values.iter().map(|b| vec![a.clone(), b.clone()]));
    let pairs = explanations(problem, pairs, most)?;
    Ok(best(data, &pairs, true).or_else(|| best(data, &single, false).filter(|_| anyhow)))
}

/// The fits to data in other units that leave less than `most`.
fn explanations(
    problem: &Problem<'_>,
    candidates: impl Iterator<Item = Vec<Rescaled>>,
    most: f64,
) -> Result<Vec<Explanation>, FitError> {
    let given = problem.start();
    // Separations in a wrong unit may leave no contact at the start, where a search cannot move.
    let has_separations = problem.data.iter().any(|one| one.measured.is_difference());
    let more_starts = usize::from(most >= 1.0 || has_separations);
    let explained = |other: &Problem<'_>, units: &[Rescaled]| {
        let searched = |patience: usize| match search(other, more_starts, patience) {
            Err(error @ FitError::Interrupted) => Err(error),
            found => Ok(found.ok().and_then(|found| {
                let values = other.predicted(&found.best.coordinates).ok()?;
                Some((distance(other.data, &values), found.best.coordinates))
            })),
        };
        // Most units are far off after few steps.
        if searched(FEW_STEPS)?.is_none_or(|(distance, _)| distance > NEARLY * most) {
            return Ok(None);
        }
        let found = searched(PATIENCE)?.filter(|(distance, _)| *distance < most);
        Ok(found.map(|(distance, best)| {
            let change: Vec<f64> = best.iter().zip(&given).map(|(a, b)| a - b).collect();
            let (change, has_contacts) = (squares(&change), other.has_contacts(&best));
            Explanation { distance, change, has_contacts, units: units.to_vec() }
        }))
    };
    let mut found = vec![];
    for units in candidates {
        let scaled = |one: &Observation| Some(units.iter().fold(*one, |one, unit| unit.apply(one)));
        found.extend(problem.with(scaled, |other| explained(other, &units)).transpose()?.flatten());
    }
    Ok(found)
}

/// The units that explain the data best; of several that explain them alike, those that scenes
/// read, with which the parameters stay nearest to their start.
fn best(data: &Data, all: &[Explanation], with_contacts: bool) -> Option<String> {
    let possible = || all.iter().filter(|one| one.has_contacts || !with_contacts);
    let least = possible().map(|one| one.distance).fold(f64::INFINITY, f64::min);
    let alike = possible().filter(|one| one.distance <= ALIKE * least + ACCURACY);
    let is_rare = |unit: &Rescaled| OTHER_UNITS.iter().any(|(_, other, ..)| *other == unit.unit);
    let has_rare = |one: &Explanation| one.units.iter().any(is_rare);
    let nearest =
        alike.min_by(|a, b| has_rare(a).cmp(&has_rare(b)).then(a.change.total_cmp(&b.change)));
    let sentences = |one: &Explanation| -> Vec<String> {
        one.units.iter().filter_map(|unit| unit.largest(data)).collect()
    };
    nearest.map(|one| sentences(one).join(", and "))
}

/// The unit in which one value is near the predicted one.
pub(crate) fn unit_of_value(one: &Observation, predicted: f64) -> Option<String> {
    let is_near = |unit: &Rescaled| (predicted / (unit.factor * one.value)).ln().abs() < NEAR;
    let units = Rescaled::all(&one.measured.column(), one.measured.unit(), None);
    units.into_iter().find(is_near).map(|unit| unit.sentence(one.value, ["", ""]))
}
