//! The columns of a table of measurements by their meaning.

use std::borrow::Cow;

use asperity_core::{At, Datum, Quantity, Separation, nearest_name};

use crate::observation::{LOAD, PRESSURE, SEPARATION, position};
use crate::units::{OtherUnit, in_other_unit, per_area};
use crate::{DataColumn, FitError, Measured, MeasuredTable, Observation};

/// The largest number of rows.
const MOST: usize = 100_000;
pub(crate) const STD: &str = "_std";
/// Columns of `curve` without information: sigma is unknown, and a fit has its own models.
const IGNORED: [&str; 2] = ["separation_over_sigma", "model"];

/// What a column holds.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Load,
    Pressure,
    Separation,
    Quantity(Quantity),
}

/// Other names of columns, in lower case, before a blank or a unit.
const OTHER_NAMES: [(&str, &str); 12] = [
    ("normal_force", "load"),
    ("preload", "load"),
    ("f", "load"),
    ("nominal_pressure", "pressure"),
    ("p", "pressure"),
    ("contact_area", "area"),
    ("real_area", "area"),
    ("a", "area"),
    ("area_percent", "area_fraction"),
    ("gap", "separation"),
    ("distance", "separation"),
    ("contact_stiffness", "stiffness"),
];

/// The name with the usual word for a quantity: separation_um for gap_um.
fn usual_name(name: &str) -> Cow<'_, str> {
    let lower = name.to_ascii_lowercase().replace(' ', "_");
    let known = OTHER_NAMES.into_iter().find_map(|(other, usual)| {
        let rest = lower.strip_prefix(other)?;
        // One letter has many meanings without its unit.
        let is_name =
            if rest.is_empty() { other.len() > 1 } else { rest.starts_with(['_', '[', '(']) };
        // Units keep their case.
        is_name.then(|| format!("{usual}{}", name.get(other.len()..).unwrap_or_default()))
    });
    known.map_or(name.into(), Cow::Owned)
}

/// Names of displacements, which no model has.
const DISPLACEMENTS: [&str; 5] =
    ["displacement", "approach", "indentation", "compression", "closure"];

/// An error of the column of a standard deviation, by its own name.
fn of_deviation(error: FitError, given: &str) -> FitError {
    match error {
        FitError::UnknownColumn { near, known, .. } => {
            let near = near.map(|near| near + STD);
            FitError::UnknownColumn { name: given.into(), near, known }
        }
        error => error,
    }
}

/// A place, or the measured quantity, of a column's name.
fn kind(name: &str) -> Result<Kind, FitError> {
    let plain = &*usual_name(name.trim());
    if DISPLACEMENTS.iter().any(|other| plain.to_ascii_lowercase().starts_with(other)) {
        let reason = format!(
            "a displacement grows where the separation falls: name the column {SEPARATION}, change the sign of its values, in m, and fit separation_offset"
        );
        return Err(FitError::Column { column: name.into(), reason });
    }
    let places = [LOAD, PRESSURE, SEPARATION];
    let columns = Quantity::ALL.map(Quantity::column);
    // Pressure is a place and a quantity.
    let quantities = columns.iter().map(String::as_str).filter(|name| !places.contains(name));
    let known: Vec<&str> = places.into_iter().chain(quantities).collect();
    let found = |name: &str| match name {
        LOAD => Some(Kind::Load),
        PRESSURE => Some(Kind::Pressure),
        SEPARATION => Some(Kind::Separation),
        name => {
            let quantity = Quantity::ALL.into_iter().zip(&columns).find(|(_, c)| *c == name);
            quantity.map(|(quantity, _)| Kind::Quantity(quantity))
        }
    };
    // A name without its unit is nearest to the column that it begins.
    let begun = || known.iter().copied().find(|known| known.starts_with(plain) && plain.len() > 2);
    // Pressure_Pa, or pressure [Pa].
    let letters = |name: &str| -> String {
        let name = name.to_lowercase().replace('\u{b2}', "2").replace('/', "per");
        name.chars().filter(char::is_ascii_alphanumeric).collect()
    };
    let same = known.iter().copied().find(|known| letters(known) == letters(plain));
    let per_area = || {
        let (name, column) = (name.into(), per_area(plain, &known)?.into());
        Some(FitError::PerArea { name, column, nominal_area: None })
    };
    found(name.trim()).ok_or_else(|| match in_other_unit(plain, &known) {
        Some(OtherUnit { column, unit, si, factor }) => {
            FitError::ColumnUnit { name: name.into(), column: column.into(), unit, si, factor }
        }
        None => per_area().unwrap_or_else(|| FitError::UnknownColumn {
            name: name.into(),
            near: same
                .or_else(|| nearest_name(plain, known.iter().copied()))
                .or_else(begun)
                .map(Into::into),
            known: known.join(", "),
        }),
    })
}

/// Whether a fit reads the column of this name, or ignores it as one of `asperity curve`.
#[must_use]
pub fn is_column(name: &str) -> bool {
    let name = name.trim();
    let values = name.strip_suffix(STD).unwrap_or(name);
    IGNORED.contains(&name) || kind(name).is_ok() || kind(values).is_ok()
}

/// The columns of a table by their meaning.
pub(crate) struct Columns<'c> {
    pub(crate) rows: usize,
    lines: &'c [usize],
    places: Vec<(Kind, &'c DataColumn)>,
    quantities: Vec<(Quantity, &'c DataColumn)>,
    deviations: Vec<(Kind, &'c DataColumn)>,
    /// The pressures of data with loads.
    beside_load: Option<&'c DataColumn>,
}

impl<'c> Columns<'c> {
    pub(crate) fn read(table: &'c MeasuredTable) -> Result<Self, FitError> {
        let MeasuredTable { columns, lines } = table;
        let rows = columns.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
        let mut found = Self {
            rows,
            lines,
            places: vec![],
            quantities: vec![],
            deviations: vec![],
            beside_load: None,
        };
        if rows > MOST {
            let reason = format!("{rows} rows: at most {MOST} were required");
            return Err(FitError::Column { column: "the data".into(), reason });
        }
        for (place, column) in columns.iter().enumerate() {
            let (name, values) = (column.0.trim(), &column.1);
            if columns[..place].iter().any(|(other, _)| other.trim() == name) {
                let reason = "the column is given twice".into();
                return Err(FitError::Column { column: name.into(), reason });
            }
            if values.len() != rows {
                let (column, found) = (name.into(), values.len());
                return Err(FitError::Length { column, found, required: rows });
            }
            if IGNORED.contains(&name) {
                continue;
            }
            match (name.strip_suffix(STD), kind(name)) {
                (Some(of), Err(_)) => {
                    let kind = kind(of).map_err(|error| of_deviation(error, name))?;
                    found.deviations.push((kind, column));
                }
                (_, kind) => match kind? {
                    Kind::Quantity(quantity) => found.quantities.push((quantity, column)),
                    place => found.places.push((place, column)),
                },
            }
        }
        // Beside a load, a pressure is only compared with it.
        let load = found.places.iter().any(|(kind, _)| *kind == Kind::Load);
        if let Some(pressure) = found.places.iter().position(|(kind, _)| *kind == Kind::Pressure)
            && load
        {
            found.beside_load = Some(found.places.remove(pressure).1);
        }
        // At separations, a load is what was measured.
        if found.places.is_empty() {
            let loads = [Quantity::Force, Quantity::Pressure];
            let load = found.quantities.iter().find(|(quantity, _)| loads.contains(quantity));
            let renamed = load.map(|(_, (column, _))| {
                format!(
                    "; name {} {LOAD} if the other values were measured under it",
                    column.trim()
                )
            });
            let renamed = renamed.unwrap_or_default();
            let needed =
                format!("a column {LOAD}, {PRESSURE} or {SEPARATION} was required{renamed}");
            return Err(FitError::NoData { missing: "load or separation", needed });
        }
        let known = |kind: &Kind| match kind {
            Kind::Quantity(quantity) => found.quantities.iter().any(|(q, _)| q == quantity),
            place => found.places.iter().any(|(p, _)| p == place),
        };
        if let Some((_, (column, _))) = found.deviations.iter().find(|(kind, _)| !known(kind)) {
            let reason = "the column of its values is missing".into();
            return Err(FitError::Column { column: column.clone(), reason });
        }
        Ok(found)
    }

    /// The standard deviation of a row's value.
    fn std(&self, kind: Kind, row: usize) -> Result<Option<f64>, FitError> {
        let Some((_, column)) = self.deviations.iter().find(|(known, _)| *known == kind) else {
            return Ok(None);
        };
        match self.finite(column, row)? {
            Some(value) if value <= 0.0 => {
                Err(self.refused(column, row, value, "a number above 0"))
            }
            other => Ok(other),
        }
    }

    /// The load and the pressure of a row that has both.
    pub(crate) fn both_loads(&self, row: usize) -> Result<Option<[f64; 2]>, FitError> {
        let load = self.places.iter().find(|(kind, _)| *kind == Kind::Load);
        let Some(((_, load), pressure)) = load.zip(self.beside_load) else { return Ok(None) };
        Ok(self.finite(load, row)?.zip(self.finite(pressure, row)?).map(<[f64; 2]>::from))
    }

    /// Appends the measured values of a row.
    pub(crate) fn observations(
        &self,
        row: usize,
        from: Datum,
        found: &mut Vec<Observation>,
    ) -> Result<(), FitError> {
        let (mut load, mut separation) = (None, None);
        for (kind, column) in &self.places {
            match (kind, self.finite(column, row)?) {
                (_, None) => {}
                (Kind::Separation, Some(value)) => separation = Some(value),
                (_, Some(value)) if value <= 0.0 => {
                    return Err(self.refused(column, row, value, "a load above 0"));
                }
                (Kind::Load, Some(value)) => load = Some((At::Load(value), Quantity::Force, value)),
                (_, Some(value)) => load = Some((At::Pressure(value), Quantity::Pressure, value)),
            }
        }
        let reading = |value| At::from(Separation { from, ..Separation::metres(value) });
        let at = load.map(|(at, ..)| at).or(separation.map(reading));
        let new = |at, measured, value, std| Observation { row: row + 1, at, measured, value, std };
        for (quantity, column) in &self.quantities {
            let Some(value) = self.finite(column, row)? else { continue };
            let std = self.std(Kind::Quantity(*quantity), row)?;
            if std.is_none() && !quantity.is_absolute() && value <= 0.0 {
                let required = "a number above 0, or its standard deviation,";
                return Err(self.refused(column, row, value, required));
            }
            if *quantity == Quantity::AreaFraction && value > 1.0 {
                let required = "at most 1 (a number in per cent over 100)";
                return Err(self.refused(column, row, value, required));
            }
            let Some(at) = at else {
                let required = "a load or a separation beside it";
                return Err(self.refused(column, row, value, required));
            };
            let is_load = matches!(quantity, Quantity::Force | Quantity::Pressure);
            if is_load && load.is_some() {
                let required = "either the load or this quantity";
                return Err(self.refused(column, row, value, required));
            }
            found.push(new(at, Measured::Quantity(*quantity), value, std));
        }
        if let (Some((at, quantity, carried)), Some(value)) = (load, separation) {
            found.push(match self.std(Kind::Separation, row)? {
                Some(std) => new(at, Measured::Separation, value, Some(std)),
                None => {
                    let kind =
                        if quantity == Quantity::Force { Kind::Load } else { Kind::Pressure };
                    let std = self.std(kind, row)?;
                    new(reading(value), Measured::Quantity(quantity), carried, std)
                }
            });
        }
        Ok(())
    }

    /// The number of a row, if it is given.
    fn finite(&self, column: &DataColumn, row: usize) -> Result<Option<f64>, FitError> {
        match column.1.get(row).copied().flatten() {
            Some(value) if !value.is_finite() => {
                Err(self.refused(column, row, value, "a finite number"))
            }
            other => Ok(other),
        }
    }

    fn refused(&self, column: &DataColumn, row: usize, value: f64, required: &str) -> FitError {
        let (column, required) = (column.0.trim().into(), required.into());
        FitError::Value { position: position(self.lines, row), column, value, required }
    }
}
