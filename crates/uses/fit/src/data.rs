//! Measured values: loads or separations, and quantities there, with standard deviations if known.

use std::ops::Deref;

use asperity_core::{At, Datum, short};

use crate::columns::Columns;
use crate::observation::{CLOSURE, MeasuredTable, Observation, Position};
use crate::{DataColumn, FitError};

/// Measured values, all with a standard deviation or all without.
///
/// ```
/// use asperity_core::Datum;
/// use asperity_fit::Data;
///
/// let columns = [("load_N", [10.0, 100.0]), ("area_m2", [1e-8, 9e-8])];
/// let columns = columns.map(|(name, values)| (name.to_string(), values.map(Some).to_vec()));
/// let data = Data::from_columns(&columns, Datum::AsperityMean)?;
/// assert_eq!((data.len(), data[1].row), (2, 2));
/// # Ok::<(), asperity_fit::FitError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Data {
    observations: Vec<Observation>,
    pub(crate) from: Datum,
    /// The lines of the rows in their file.
    lines: Vec<usize>,
    /// Rows with a load and a pressure.
    both_loads: Vec<(usize, [f64; 2])>,
    /// Whether separations are known as closures.
    closure: bool,
    over_area: bool,
}

/// Loads and pressures times the nominal area may differ by this much, relative, as both may be
/// rounded.
const SAME_LOAD: f64 = 0.01;

impl Deref for Data {
    type Target = [Observation];

    fn deref(&self) -> &[Observation] {
        &self.observations
    }
}

impl Data {
    /// The measured values of a table whose columns have the names of `asperity curve`:
    /// `load_N`, `pressure_Pa` or `separation_m` from the plane `from`, and any quantities
    /// (`area_m2`, `unloading_stiffness_N_per_m`), each with `<column>_std` if known. A cell may be
    /// empty.
    ///
    /// `pressure_Pa` beside `load_N` is compared with it by [`check_loads`](Self::check_loads);
    /// `separation_over_sigma` and `model` are ignored.
    /// Separations have no relative error: without `separation_m_std`, a separation beside a load
    /// is compared by the load at that separation. `closure_m`, the approach since any reading,
    /// above 0 where the surfaces are closer, is a separation with the other sign and an unknown
    /// offset.
    ///
    /// # Errors
    /// [`FitError`] naming the column or the row, its value and what is required.
    pub fn from_columns(columns: &[DataColumn], from: Datum) -> Result<Self, FitError> {
        Self::from_table(&MeasuredTable { columns: columns.to_vec(), lines: vec![] }, from, None)
    }

    /// The measured values of a table, whose messages name the lines of its file; those over the
    /// nominal area, as `tangent (GPa/um)`, are multiplied by it \[m²\].
    ///
    /// # Errors
    /// The errors of [`from_columns`](Self::from_columns).
    pub fn from_table(
        table: &MeasuredTable,
        from: Datum,
        nominal_area: Option<f64>,
    ) -> Result<Self, FitError> {
        let lines = table.lines.clone();
        let table = Columns::read(table, nominal_area)?;
        let (mut observations, mut both_loads) = (vec![], vec![]);
        for row in 0..table.rows {
            both_loads.extend(table.both_loads(row)?.map(|both| (row, both)));
            table.observations(row, from, &mut observations)?;
        }
        if observations.is_empty() {
            let reason = "the data have no measured quantity: a column of a quantity with a value was required, for example area_m2";
            return Err(FitError::Data(reason.into()));
        }
        if let Some(known) = observations.iter().find(|one| one.std.is_some())
            && let Some(unknown) = observations.iter().find(|one| one.std.is_none())
        {
            let [position, other] = [unknown, known].map(|one| Position::of(&lines, one.row - 1));
            let column = unknown.measured.column();
            let known = match known.measured == unknown.measured {
                true => other.to_string(),
                false => format!("{} of {other}", known.measured.column()),
            };
            return Err(FitError::Data(format!(
                "{position} has no standard deviation of {column}, but {known} has one: give {column}_std in every {}, or in none",
                position.name
            )));
        }
        let closure = table.has(CLOSURE);
        let over_area = table.over_area;
        Ok(Self { observations, from, lines, both_loads, closure, over_area })
    }

    /// Whether values were given over the nominal area.
    #[must_use]
    pub fn is_over_area(&self) -> bool {
        self.over_area
    }

    /// Checks that loads and pressures of the same row agree, for this nominal area \[m²\].
    ///
    /// # Errors
    /// [`FitError::Data`] for the first row whose load differs from the pressure times the area by
    /// more than 1 %.
    pub fn check_loads(&self, nominal_area: f64) -> Result<(), FitError> {
        for (row, [load, pressure]) in &self.both_loads {
            let here = pressure * nominal_area;
            if (here / load - 1.0).abs() > SAME_LOAD {
                let position = Position::of(&self.lines, *row);
                let [load, pressure, area, here] =
                    [*load, *pressure, nominal_area, here].map(short);
                return Err(FitError::Data(format!(
                    "{position}: load_N = {load} and pressure_Pa = {pressure} contradict each other: on the nominal area of {area} m2 this pressure is a load of {here} N; leave one of the two columns out, or correct the area"
                )));
            }
        }
        Ok(())
    }

    /// Whether separations are known as closures, which need a free `separation_offset`.
    #[must_use]
    pub fn has_closure(&self) -> bool {
        self.closure
    }

    /// Whether standard deviations are given.
    #[must_use]
    pub fn has_std(&self) -> bool {
        self.observations.iter().any(|one| one.std.is_some())
    }

    /// The same quantities at `count` places in equal ratios (of separations in equal steps) from
    /// the smallest to the largest, with values of 1: for curves between the data.
    #[must_use]
    pub fn between(&self, count: usize) -> Self {
        let mut curves: Vec<(Observation, [f64; 2])> = vec![];
        for one in self.iter() {
            let (place, x) = one.place();
            let same = |(other, _): &&mut (Observation, [f64; 2])| {
                other.measured == one.measured && other.place().0 == place
            };
            match curves.iter_mut().find(same) {
                Some((_, [low, high])) => (*low, *high) = (low.min(x), high.max(x)),
                None => curves.push((*one, [x; 2])),
            }
        }
        let mut found = vec![];
        for (one, [low, high]) in curves {
            for k in 0..count {
                let share = k as f64 / count.saturating_sub(1).max(1) as f64;
                let x = match one.at {
                    At::Separation(_) => low + (high - low) * share,
                    _ => low * (high / low).powf(share),
                };
                found.push(Observation { row: k + 1, value: 1.0, std: None, ..one.placed_at(x) });
            }
        }
        Self { observations: found, both_loads: vec![], ..self.clone() }
    }
}
