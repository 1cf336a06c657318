//! Data that no values of the parameters describe, and the unit in which they may be written.

use asperity_core::{Quantity, short};

use crate::problem::{Problem, squares};
use crate::remark::Remark;
use crate::search::search;
use crate::units::UNITS;
use crate::{Data, FitError, Measured, Observation};

/// Data are not described where the root mean square of ln(fitted/measured) is above this.
const HOPELESS: f64 = 1.0;
/// Differences, of separations, are not described beyond this many standard deviations.
const HOPELESS_DEVIATIONS: f64 = 30.0;
/// Another unit explains the misfit if it leaves less than this share of it, and less than this
/// share of the hopeless one.
const SHARE: f64 = 0.25;
const EXPLAINED: f64 = 0.5;

/// Root mean square of the logarithms of fitted over measured values.
pub(crate) fn rms(data: &Data, values: &[f64]) -> Option<f64> {
    let ratios = data.iter().zip(values).filter(|(one, _)| !one.measured.is_difference());
    let ratios: Vec<f64> = ratios.map(|(one, value)| (value / one.value).ln()).collect();
    let finite: Vec<f64> = ratios.into_iter().filter(|ratio| ratio.is_finite()).collect();
    (!finite.is_empty()).then(|| mean_square(&finite))
}

fn mean_square(values: &[f64]) -> f64 {
    (squares(values) / values.len() as f64).sqrt()
}

/// How far fitted values are from the data, in multiples of what is hopeless: infinite where values
/// are 0 that are not 0 in the data.
fn distance(data: &Data, values: &[f64]) -> f64 {
    let of = |is_difference: bool, share: &dyn Fn(&Observation, f64) -> f64| {
        let some = data.iter().zip(values);
        let some = some.filter(|(one, _)| one.measured.is_difference() == is_difference);
        let shares: Vec<f64> = some.map(|(one, value)| share(one, *value)).collect();
        match shares.iter().any(|share| !share.is_finite()) {
            true => f64::INFINITY,
            false if shares.is_empty() => 0.0,
            false => mean_square(&shares),
        }
    };
    let logarithm = |one: &Observation, value: f64| (value / one.value).ln() / HOPELESS;
    let deviations = |one: &Observation, value: f64| {
        one.std.map_or(0.0, |std| (value - one.value) / std / HOPELESS_DEVIATIONS)
    };
    of(false, &logarithm).max(of(true, &deviations))
}

/// A sentence about data that are not described by the fitted values, with the unit that explains
/// them.
pub(crate) fn misfit(
    problem: &Problem<'_>,
    values: &[f64],
    limits: &[Remark],
) -> Result<Option<String>, FitError> {
    let far = distance(problem.data, values);
    if far <= 1.0 {
        return Ok(None);
    }
    let advice = match likely_unit(problem, far)? {
        Some(unit) => unit,
        None => {
            let check = "check the columns and their units, and the other numbers of the scene";
            let limits = limits.iter().map(|limit| limit.sentence.as_str());
            limits.chain([check]).collect::<Vec<_>>().join("; ")
        }
    };
    let without_contact = data_without_contact(problem.data, values);
    let size = match (without_contact, rms(problem.data, values)) {
        (Some(place), _) => format!(": without contact at {place}"),
        (None, Some(rms)) if rms > HOPELESS => {
            format!(", which are off by a factor of {} (root mean square)", short(rms.exp()))
        }
        _ => {
            let deviations = short(HOPELESS_DEVIATIONS * far);
            format!(", which are off by {deviations} standard deviations (root mean square)")
        }
    };
    Ok(Some(format!("no values within the bounds describe the data{size}; {advice}")))
}

/// The first place at which the fitted value is 0 and the measured one is not.
fn data_without_contact(data: &Data, values: &[f64]) -> Option<String> {
    let is_0 = |(one, value): &(&Observation, &f64)| {
        !one.measured.is_difference() && (*value / one.value).ln().is_infinite()
    };
    let (one, _) = data.iter().zip(values).find(is_0)?;
    let (column, value) = one.place();
    Some(format!("{column} = {}", short(value)))
}

/// The column and the unit that explain the data best.
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
    // Without contact in the unit given, the start says little, and any contact says much.
    let has_separations = problem.data.iter().any(|one| one.measured.is_difference());
    let more_starts = usize::from(here.is_infinite() || has_separations);
    let least = if here.is_infinite() { 1.0 } else { EXPLAINED.min(SHARE * here) };
    let (mut least, mut likely) = (least, None);
    for column in columns {
        for (unit, factor) in column.units() {
            let data = problem.data.scaled(|one| column.scaled(one, *factor));
            let Ok(forward) = crate::forward::Forward::new(problem.model, &data) else { continue };
            let other = Problem { data: &data, forward: &forward, ..*problem };
            let values = match search(&other, more_starts) {
                Ok(found) => other.predicted(&found.best.coordinates),
                Err(error @ FitError::Interrupted) => return Err(error),
                Err(_) => continue,
            };
            if let Ok(values) = values
                && distance(&data, &values) < least
            {
                least = distance(&data, &values);
                likely = Some((column, *unit, *factor));
            }
        }
    }
    Ok(likely.map(|(column, unit, factor)| {
        let values = problem.data.iter().filter_map(|one| column.value(one));
        let largest = values.fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let (name, si) = (column.name(), column.si());
        let gap = if si.is_empty() { "" } else { " " };
        let [given, meant] = [largest, largest * factor].map(short);
        format!("{name} = {given} looks like {unit}; {given} {unit} is {meant}{gap}{si}")
    }))
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
    fn units(self) -> &'static [(&'static str, f64)] {
        let is_fraction = self == Self::Measured(Measured::Quantity(Quantity::AreaFraction));
        let si = self.si();
        let known = UNITS.iter().find(|(known, _)| *known == si && (is_fraction || !si.is_empty()));
        known.map_or(&[], |(_, units)| units)
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
