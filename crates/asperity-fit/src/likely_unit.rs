//! The unit in which data may be written that no values of the parameters describe.

use asperity_core::{Quantity, short};

use crate::distance::distance;
use crate::forward::Forward;
use crate::observation::{LOAD, PRESSURE};
use crate::problem::Problem;
use crate::search::search;
use crate::units::UNITS;
use crate::{Data, FitError, Measured, Observation};

/// Another unit explains the misfit if it leaves less than this share of it, and less than this
/// share of the largest with which data count as described.
const SHARE: f64 = 0.2;
const EXPLAINED: f64 = 0.3;
/// Units explain the data alike whose misfits differ by less than this factor, or are this small.
const ALIKE: f64 = 1.5;
const ACCURACY: f64 = 1e-6;
/// A value is near the predicted one within this difference of logarithms.
const NEAR: f64 = 0.2;

/// The column and the unit that explain the data best; of several that explain them alike, the one
/// with which the parameters stay nearest to their start.
pub(crate) fn likely_unit(problem: &Problem<'_>, here: f64) -> Result<Option<String>, FitError> {
    let mut columns: Vec<Column> = vec![];
    for one in problem.data.iter() {
        let place = Column::Place(one.place().0);
        for column in [place, Column::Measured(one.measured)] {
            if !columns.contains(&column) {
                columns.push(column);
            }
        }
    }
    let given: Vec<f64> = problem.parameters.iter().map(|p| p.coordinate(p.start)).collect();
    let nominal_area = problem.at(&given).ok().map(|(scene, _)| scene.nominal_area);
    // Separations in a wrong unit may leave no contact at the start, where a search cannot move.
    let has_separations = problem.data.iter().any(|one| one.measured.is_difference());
    let more_starts = usize::from(here.is_infinite() || has_separations);
    let most = if here.is_infinite() { 1.0 } else { EXPLAINED.min(SHARE * here) };
    let mut found: Vec<Explained> = vec![];
    for column in columns {
        for (unit, factor) in column.units(nominal_area) {
            let data = problem.data.iter().map(|one| column.scaled(one, factor)).collect();
            let data = problem.data.with(data);
            let Ok(forward) = Forward::new(problem.model, &data) else { continue };
            let other = Problem { data: &data, forward: &forward, ..*problem };
            let best = match search(&other, more_starts) {
                Ok(found) => found.best.coordinates,
                Err(error @ FitError::Interrupted) => return Err(error),
                Err(_) => continue,
            };
            let Ok(values) = other.predicted(&best) else { continue };
            let change = best.iter().zip(&given).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let distance = distance(&data, &values);
            if distance < most {
                found.push(Explained { distance, change, column, unit, factor });
            }
        }
    }
    let least = found.iter().map(|one| one.distance).fold(f64::INFINITY, f64::min);
    found.retain(|one| one.distance <= ALIKE * least + ACCURACY);
    found.sort_by(|a, b| a.change.total_cmp(&b.change));
    Ok(found.first().map(|one| one.sentence(problem.data, nominal_area)))
}

/// The unit in which one value is near the predicted one.
pub(crate) fn unit_of_value(one: &Observation, predicted: f64) -> Option<String> {
    let column = Column::Measured(one.measured);
    let is_near = |factor: f64| (predicted / (factor * one.value)).ln().abs() < NEAR;
    let (unit, factor) = column.units(None).into_iter().find(|(_, factor)| is_near(*factor))?;
    let (si, [given, meant]) = (column.si(), [one.value, factor * one.value].map(short));
    let gap = if si.is_empty() { "" } else { " " };
    Some(format!("{given} looks like {unit}; {given} {unit} is {meant}{gap}{si}"))
}

/// A unit that explains the data.
struct Explained {
    /// What it leaves of the misfit.
    distance: f64,
    /// The largest change of a parameter, as a coordinate.
    change: f64,
    column: Column,
    unit: &'static str,
    factor: f64,
}

impl Explained {
    /// The largest value of the column with its line, in this unit and in that of the column.
    fn sentence(&self, data: &Data, nominal_area: Option<f64>) -> String {
        let (column, unit) = (self.column, self.unit);
        let values = data.iter().filter_map(|one| Some((one, column.value(one)?)));
        let largest = values.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let (line, largest) = largest.map_or((String::new(), 0.0), |(one, value)| {
            (format!(" ({})", data.position(one)), value)
        });
        let (name, si) = (column.name(), column.si());
        let gap = if si.is_empty() { "" } else { " " };
        let [given, meant] = [largest, largest * self.factor].map(short);
        let on_area = match (column.other_load(), nominal_area) {
            (Some((other, _)), Some(area)) if unit == other => {
                format!(" on the nominal area of {} m2", short(area))
            }
            _ => String::new(),
        };
        format!(
            "{name} = {given}{line} looks like {unit}; {given} {unit}{on_area} is {meant}{gap}{si}"
        )
    }
}

/// A column of the data: a place, or measured values.
#[derive(Clone, Copy, PartialEq)]
enum Column {
    Place(&'static str),
    Measured(Measured),
}

impl Column {
    fn name(self) -> String {
        match self {
            Self::Place(name) => name.into(),
            Self::Measured(measured) => measured.column(),
        }
    }

    fn si(self) -> &'static str {
        match self {
            Self::Place(name) => name.rsplit('_').next().unwrap_or_default(),
            Self::Measured(Measured::Separation) => "m",
            Self::Measured(Measured::Quantity(quantity)) => quantity.unit(),
        }
    }

    /// The other units of the column; of pure numbers, only fractions are recorded in per cent.
    fn units(self, nominal_area: Option<f64>) -> Vec<(&'static str, f64)> {
        let is_fraction = self == Self::Measured(Measured::Quantity(Quantity::AreaFraction));
        let si = self.si();
        let known = UNITS.iter().find(|(known, _)| *known == si && (is_fraction || !si.is_empty()));
        let mut units: Vec<(&str, f64)> = vec![];
        for (unit, factor) in known.map_or(&[][..], |(_, units)| units) {
            // kN/mm and MN/m are N/um.
            if units.iter().all(|(_, other)| other.total_cmp(factor).is_ne()) {
                units.push((unit, *factor));
            }
        }
        units.extend(
            self.other_load()
                .zip(nominal_area)
                .map(|((unit, per_area), area)| (unit, if per_area { area } else { 1.0 / area })),
        );
        units
    }

    /// The unit of a load in a column of pressures, and the other way round; and whether that unit
    /// is per area.
    fn other_load(self) -> Option<(&'static str, bool)> {
        match self {
            Self::Place(PRESSURE) | Self::Measured(Measured::Quantity(Quantity::Pressure)) => {
                Some(("N", false))
            }
            Self::Place(LOAD) | Self::Measured(Measured::Quantity(Quantity::Force)) => {
                Some(("Pa", true))
            }
            _ => None,
        }
    }

    fn value(self, one: &Observation) -> Option<f64> {
        match self {
            Self::Place(name) => Some(one.place()).filter(|(known, _)| *known == name).map(|p| p.1),
            Self::Measured(measured) => Some(one.value).filter(|_| one.measured == measured),
        }
    }

    /// The observation with this column in another unit.
    fn scaled(self, one: &Observation, factor: f64) -> Observation {
        let mut one = *one;
        match self {
            Self::Place(name) if one.place().0 == name => one = one.moved(factor),
            Self::Measured(measured) if one.measured == measured => {
                one.value *= factor;
                one.std = one.std.map(|std| std * factor);
            }
            _ => {}
        }
        one
    }
}
