//! The columns of a table of measurements by their meaning.

use asperity_core::{At, Datum, Quantity, Separation, nearest_name, short};

use crate::names::{STIFFNESS, usual_name};
use crate::observation::{LOAD, PRESSURE, SEPARATION, position};
use crate::units::{Named, per_area, with_unit};
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
    let name = name.trim();
    let lower = name.to_lowercase().replace(' ', "_");
    if DISPLACEMENTS.iter().any(|other| lower.starts_with(other)) {
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
    match name {
        LOAD => return Ok(Kind::Load),
        PRESSURE => return Ok(Kind::Pressure),
        SEPARATION => return Ok(Kind::Separation),
        _ => {}
    }
    if let Some((quantity, _)) = Quantity::ALL.into_iter().zip(&columns).find(|(_, c)| *c == name) {
        return Ok(Kind::Quantity(quantity));
    }
    let named = with_unit(name, &known);
    let usual = usual_name(name, false).unwrap_or_default();
    let stiffness = Quantity::Stiffness.column();
    let factor = match &named {
        Some(named) if named.column == stiffness => Some(named.factor),
        _ => (usual == STIFFNESS).then_some(1.0),
    };
    if let Some(factor) = factor {
        return Err(FitError::Column { column: name.into(), reason: which_stiffness(factor) });
    }
    if let Some(column) = per_area(name, &known) {
        let column = column.into();
        return Err(FitError::PerArea { name: name.into(), column, nominal_area: None });
    }
    let near = match named {
        Some(Named { column, unit, factor, .. }) if (factor - 1.0).abs() > f64::EPSILON => {
            return Err(FitError::ColumnUnit {
                name: name.into(),
                column: column.into(),
                unit,
                factor,
            });
        }
        // Its own unit, written in another way.
        Some(named) => Some(named.column),
        None => {
            // A name without its unit is nearest to the column that it begins.
            let begun = |name: &&str| name.starts_with(&usual) && usual.len() > 2;
            let begun = || known.iter().copied().find(begun);
            let near = || nearest_name(name, known.iter().copied());
            nearest_of_quantity(&usual, &known).or_else(near).or_else(begun)
        }
    };
    let (near, known) = (near.map(Into::into), known.join(", "));
    Err(FitError::UnknownColumn { name: name.into(), near, known })
}

/// The known column of this quantity, whose unit is missing or no unit.
fn nearest_of_quantity<'k>(usual: &str, known: &[&'k str]) -> Option<&'k str> {
    let is = |column: &&&str| column.strip_prefix(usual).is_some_and(|unit| unit.starts_with('_'));
    known.iter().find(is).copied().filter(|_| usual.len() > 2)
}

/// The names of a stiffness in N/m times `factor`, of which a header does not say the kind.
fn which_stiffness(factor: f64) -> String {
    let [unloading, tangent, tangential] =
        [Quantity::UnloadingStiffness, Quantity::Tangent, Quantity::TangentialStiffness]
            .map(Quantity::column);
    let multiply = match (factor - 1.0).abs() > f64::EPSILON {
        true => format!(", and multiply its values by {}", short(factor)),
        false => String::new(),
    };
    format!(
        "the name does not say which stiffness was measured: name the column {unloading} (small vibrations, ultrasound, start of unloading), {tangent} (first loading) or {tangential} (shear){multiply}"
    )
}

/// Whether a column of this name is one of a fit, also in another unit or mistyped, or one of
/// `asperity curve` that a fit ignores.
#[must_use]
pub fn is_column(name: &str) -> bool {
    let name = name.trim();
    let values = name.strip_suffix(STD).unwrap_or(name);
    // A column in another unit, or a mistyped one, is meant for the fit as well.
    let is_meant =
        |name: &str| !matches!(kind(name), Err(FitError::UnknownColumn { near: None, .. }));
    IGNORED.contains(&name) || is_meant(name) || is_meant(values)
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
