//! The columns of a table of measurements by their meaning.

use asperity_core::{At, Datum, Quantity, Separation};

use crate::names::{Named, unknown_column, with_unit};
use crate::observation::{CLOSURE, LOAD, PRESSURE, Position, SEPARATION, STD};
use crate::{FitError, Measured, MeasuredTable, Observation};

/// Columns of `curve` without information: sigma is unknown, and a fit has its own models.
const IGNORED: [&str; 2] = ["separation_over_sigma", "model"];
/// Columns of places. Pressure is a quantity as well.
const PLACES: [&str; 4] = [LOAD, PRESSURE, SEPARATION, CLOSURE];

/// Whether a column of this name is one of a fit, also in another unit or mistyped, or one of
/// `asperity curve` that a fit ignores.
#[must_use]
pub fn is_column(name: &str) -> bool {
    let name = name.trim();
    // A column in another unit, or a mistyped one, is meant for the fit as well.
    let is_meant =
        |name: &str| !matches!(in_si(name), Err(FitError::UnknownColumn { near: None, .. }));
    IGNORED.contains(&name) || is_meant(name) || name.strip_suffix(STD).is_some_and(is_meant)
}

/// The column of a fit that is meant by a name, which may have another unit.
fn in_si(name: &str) -> Result<Named, FitError> {
    match PLACES.contains(&name) || quantity(name).is_some() {
        true => Ok(Named { column: name.to_string(), factor: 1.0, over_area: false }),
        false => with_unit(name).ok_or_else(|| unknown_column(name)),
    }
}

fn quantity(name: &str) -> Option<Quantity> {
    let mut of_contact = Quantity::ALL.into_iter().filter(|quantity| quantity.is_of_models());
    of_contact.find(|quantity| quantity.column() == name)
}

/// The columns of a table that a fit reads.
pub(crate) struct Columns<'c> {
    pub(crate) rows: usize,
    lines: &'c [usize],
    /// In SI units.
    columns: Vec<(String, Vec<Option<f64>>)>,
    /// Whether one was given over the nominal area.
    pub(crate) over_area: bool,
}

impl<'c> Columns<'c> {
    /// Those of a table; values over the nominal area are multiplied by this one \[m²\].
    pub(crate) fn read(
        table: &'c MeasuredTable,
        nominal_area: Option<f64>,
    ) -> Result<Self, FitError> {
        let MeasuredTable { columns, lines } = table;
        let rows = columns.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
        let refused =
            |column: &str, reason: String| Err(FitError::Column { column: column.into(), reason });
        let mut found = Self { rows, lines, columns: vec![], over_area: false };
        for (place, (name, values)) in columns.iter().enumerate() {
            let name = name.trim();
            if values.len() != rows {
                let found = plural(values.len(), "value");
                return Err(FitError::Data(format!(
                    "{name} has {found}: {rows} were required, as in the other columns"
                )));
            }
            let Named { column, factor, over_area } = match name.strip_suffix(STD) {
                _ if IGNORED.contains(&name) => continue,
                None => in_si(name)?,
                Some(of) => in_si(of)
                    .map(|found| Named { column: found.column + STD, ..found })
                    .map_err(|error| of_deviation(error, name))?,
            };
            let unit = match (over_area, nominal_area) {
                (false, _) => factor,
                (true, Some(area)) => factor * area,
                (true, None) => {
                    return refused(name, format!("over a nominal area; give {column}"));
                }
            };
            found.over_area |= over_area;
            let is_twice = columns[..place].iter().any(|(other, _)| other.trim() == name);
            if is_twice || found.has(&column) {
                return refused(name, "the column is given twice".into());
            }
            let values = values.iter().map(|value| value.map(|value| value * unit));
            found.columns.push((column, values.collect()));
        }
        let has = |name: &str| found.has(name);
        if has(CLOSURE) && has(SEPARATION) {
            let reason =
                format!("{SEPARATION} is the same with the other sign; leave one of the two out");
            return refused(CLOSURE, reason);
        }
        if !PLACES.into_iter().any(has) {
            // At separations, a load is what was measured.
            let renamed = match has("force_N") {
                true => format!("; name force_N {LOAD} if the other values were measured under it"),
                false => String::new(),
            };
            return Err(FitError::Data(format!(
                "the data have no load or separation: a column {LOAD}, {PRESSURE}, {SEPARATION} or {CLOSURE} was required{renamed}"
            )));
        }
        let is_alone = |name: &&String| name.strip_suffix(STD).is_some_and(|of| !has(of));
        match found.columns.iter().map(|(name, _)| name).find(is_alone) {
            Some(name) => refused(name, "the column of its values is missing".into()),
            None => Ok(found),
        }
    }

    /// Whether there is a column of this name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.columns.iter().any(|(known, _)| *known == name)
    }

    /// The value of a row, if it is given.
    fn number(&self, column: &str, row: usize) -> Result<Option<f64>, FitError> {
        let values = self.columns.iter().find(|(known, _)| *known == column);
        let (value, required) = match values.and_then(|(_, values)| values[row]) {
            Some(value) if !value.is_finite() => (value, "a finite number"),
            Some(value) if column.ends_with(STD) && value <= 0.0 => (value, "a number above 0"),
            value => return Ok(value),
        };
        self.refused(column, row, value, required)
    }

    /// The standard deviation of a row's value.
    fn std(&self, column: &str, row: usize) -> Result<Option<f64>, FitError> {
        self.number(&format!("{column}{STD}"), row)
    }

    /// The load and the pressure of a row that has both.
    pub(crate) fn both_loads(&self, row: usize) -> Result<Option<[f64; 2]>, FitError> {
        let [load, pressure] = [LOAD, PRESSURE].map(|column| self.number(column, row));
        Ok(load?.zip(pressure?).map(<[f64; 2]>::from))
    }

    /// Appends the measured values of a row.
    pub(crate) fn observations(
        &self,
        row: usize,
        from: Datum,
        found: &mut Vec<Observation>,
    ) -> Result<(), FitError> {
        // Beside a load, a pressure is only compared with it.
        let has_loads = self.columns.iter().any(|(column, _)| *column == LOAD);
        let carrier = if has_loads { LOAD } else { PRESSURE };
        let load = self.number(carrier, row)?;
        if let Some(value) = load.filter(|value| *value <= 0.0) {
            return self.refused(carrier, row, value, "a load above 0");
        }
        let closure = self.number(CLOSURE, row)?.map(|closure| -closure);
        let separation = self.number(SEPARATION, row)?.or(closure);
        let place = if self.has(CLOSURE) { CLOSURE } else { SEPARATION };
        let under = |value| if has_loads { At::Load(value) } else { At::Pressure(value) };
        let reading = |value| At::from(Separation { from, ..Separation::metres(value) });
        let at = load.map(under).or(separation.map(reading));
        let new = |at, measured, value, std| Observation { row: row + 1, at, measured, value, std };
        let quantities = self.columns.iter().filter(|(column, _)| !PLACES.contains(&&**column));
        for (column, quantity) in quantities.filter_map(|(name, _)| Some((name, quantity(name)?))) {
            let Some(value) = self.number(column, row)? else { continue };
            let std = self.std(column, row)?;
            let is_load = matches!(quantity, Quantity::Force | Quantity::Pressure);
            let required = match at {
                _ if std.is_none() && !quantity.is_absolute() && value <= 0.0 => {
                    "a number above 0, or its standard deviation,"
                }
                _ if quantity == Quantity::AreaFraction && value > 1.0 => {
                    "at most 1 (a number in per cent over 100)"
                }
                Some(_) if is_load && load.is_some() => "either the load or this quantity",
                Some(at) => {
                    found.push(new(at, Measured::Quantity(quantity), value, std));
                    continue;
                }
                None => "a load or a separation beside it",
            };
            return self.refused(column, row, value, required);
        }
        if let (Some(load), Some(separation)) = (load, separation) {
            found.push(match self.std(place, row)? {
                Some(std) => new(under(load), Measured::Separation, separation, Some(std)),
                None => {
                    let quantity = if has_loads { Quantity::Force } else { Quantity::Pressure };
                    let std = self.std(carrier, row)?;
                    new(reading(separation), Measured::Quantity(quantity), load, std)
                }
            });
        }
        Ok(())
    }

    fn refused<T>(
        &self,
        column: &str,
        row: usize,
        value: f64,
        required: &str,
    ) -> Result<T, FitError> {
        let (position, column) = (Position::of(self.lines, row), column.into());
        let required = required.into();
        Err(FitError::Value { position, column, value, required })
    }
}

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

/// A number of things: `1 value`, `2 values`.
pub(crate) fn plural(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Data;

    fn data(names: [&str; 4], numbers: [f64; 4]) -> Result<Data, FitError> {
        let columns = names.iter().zip(numbers);
        let columns = columns.map(|(name, number)| ((*name).to_owned(), vec![Some(number)]));
        let table = MeasuredTable { columns: columns.collect(), lines: vec![] };
        Data::from_table(&table, Datum::AsperityMean, Some(2e-6))
    }

    #[test]
    fn columns_have_si_units_or_those_of_their_names() {
        let si = ["load_N", "area_m2", "area_m2_std", "model"];
        let others = ["Load [kN]", "A (cm2)", "area_cm2_std", "model"];
        let (plain, found) =
            (data(si, [2e3, 3.0, 0.25, 1.0]), data(others, [2.0, 3e4, 2.5e3, 1.0]));
        assert_eq!(found.unwrap(), plain.unwrap());
        let twice = ["load_N", "Load [kN]", "area_m2", "area_m2_std"];
        assert!(data(twice, [1.0; 4]).unwrap_err().to_string().contains("given twice"));
        let with = |name, value| data(["load_N", name, "area_m2", "model"], [1.0, value, 1.0, 1.0]);
        let plain = with("unloading_stiffness_N_per_m", 2e9);
        let over = with("unloading_stiffness (GPa/um)", 1.0);
        assert_eq!(over.as_deref().unwrap()[0], plain.as_deref().unwrap()[0]);
        assert!(over.unwrap().is_over_area() && !plain.unwrap().is_over_area());
        for name in ["k (GPa/um)", "stiffness [N/um]", "load_N [kN]"] {
            let refused = data(["load_N", "separation_m", "area_m2", name], [1.0; 4]);
            assert!(matches!(refused, Err(FitError::Column { .. })), "{refused:?}");
        }
    }
}
