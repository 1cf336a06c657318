//! A column of the data, and the units in which it may be recorded.

use asperity_core::{OTHER_UNITS, Quantity, short, units_of};

use crate::observation::{LOAD, PRESSURE};
use crate::{Data, Measured, Observation};

/// A column of the data: a place, or measured values.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Recorded {
    Place(&'static str),
    Measured(Measured),
}

impl Recorded {
    /// The columns of the data: those of places first.
    pub(crate) fn all(data: &Data) -> Vec<Self> {
        let places = data.iter().map(|one| Self::Place(one.place().0));
        let measured = data.iter().map(|one| Self::Measured(one.measured));
        let mut found: Vec<Self> = vec![];
        for column in places.chain(measured) {
            if !found.contains(&column) {
                found.push(column);
            }
        }
        found
    }

    pub(crate) fn name(self) -> String {
        match self {
            Self::Place(name) => name.into(),
            Self::Measured(measured) => measured.column(),
        }
    }

    pub(crate) fn si(self) -> &'static str {
        match self {
            Self::Place(name) => name.rsplit('_').next().unwrap_or_default(),
            Self::Measured(Measured::Separation) => "m",
            Self::Measured(Measured::Quantity(quantity)) => quantity.unit(),
        }
    }

    /// The other units of the column; of pure numbers, only fractions are recorded in per cent.
    pub(crate) fn units(self, nominal_area: Option<f64>) -> Vec<(&'static str, f64)> {
        let is_fraction = self == Self::Measured(Measured::Quantity(Quantity::AreaFraction));
        let si = self.si();
        let known = if is_fraction || !si.is_empty() { units_of(si) } else { vec![] };
        let load = self.other_load().zip(nominal_area);
        let load =
            load.map(|((unit, per_area), area)| (unit, if per_area { area } else { 1.0 / area }));
        let mut units: Vec<(&str, f64)> = vec![];
        for (unit, factor) in load.into_iter().chain(known) {
            // kN/mm and MN/m are N/um, and N on 1 cm2 is N/cm2.
            let same = |other: f64| (factor / other - 1.0).abs() < 1e-9;
            if !same(1.0) && units.iter().all(|(_, other)| !same(*other)) {
                units.push((unit, factor));
            }
        }
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
}

/// A column in another unit.
#[derive(Clone, Copy)]
pub(crate) struct Rescaled {
    pub(crate) column: Recorded,
    pub(crate) unit: &'static str,
    /// The unit in SI units.
    pub(crate) factor: f64,
}

impl Rescaled {
    /// The column in each of its other units.
    pub(crate) fn all(column: Recorded, nominal_area: Option<f64>) -> Vec<Self> {
        let units = column.units(nominal_area).into_iter();
        units.map(|(unit, factor)| Self { column, unit, factor }).collect()
    }

    pub(crate) fn is_place(&self) -> bool {
        matches!(self.column, Recorded::Place(_))
    }

    /// Whether scenes do not read this unit, as few use it.
    pub(crate) fn is_other(&self) -> bool {
        OTHER_UNITS.iter().any(|(_, unit, ..)| *unit == self.unit)
    }

    /// The observation with this column in the other unit.
    pub(crate) fn apply(&self, one: Observation) -> Observation {
        match self.column {
            Recorded::Place(name) if one.place().0 == name => one.moved(self.factor),
            Recorded::Measured(measured) if one.measured == measured => Observation {
                value: one.value * self.factor,
                std: one.std.map(|std| std * self.factor),
                ..one
            },
            _ => one,
        }
    }

    /// The largest value of the column with its line, in this unit and in that of the column.
    pub(crate) fn sentence(&self, data: &Data, nominal_area: Option<f64>) -> String {
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
