//! The rows of `asperity conductance`: models, and correlations beside them.

use anyhow::{Result, anyhow};
use asperity::joints::conductance::{Correlation, GapRoughness, gap_conductance};
use asperity::{At, ContactModel, Datum, Model, Request, SeparationUnit};

use super::conductance_picture::{CONDUCTANCE, column};
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{print_message, summary};
use crate::scene::{LoadedScene, NamedModel};

/// A gas in the gap.
#[derive(Debug, Clone, Copy)]
pub struct Gas {
    /// Its thermal conductivity \[W/(m K)\].
    pub conductivity: f64,
    /// Its temperature-jump distance \[m\].
    pub jump: f64,
}

/// A load, and the same as a pressure.
struct Loaded {
    at: At,
    load: f64,
    pressure: f64,
}

/// The scene, the loads and the gas, and the rows found for them.
pub struct Case<'c> {
    scene: &'c LoadedScene,
    loads: Vec<Loaded>,
    gas: Option<Gas>,
    /// Whether the list has one model or correlation, whose failure is an error.
    alone: bool,
    pub table: Table,
}

impl<'c> Case<'c> {
    /// A case without rows, at loads and pressures.
    pub fn new(scene: &'c LoadedScene, places: &[At], gas: Option<Gas>, alone: bool) -> Self {
        let contact = &scene.file.scene;
        let loaded = |at: &At| {
            let (load, pressure) = at.load(contact).zip(at.pressure(contact))?;
            Some(Loaded { at: *at, load, pressure })
        };
        let mut table = Table::new(&["model", "load_N", "pressure_Pa", "relative_pressure"]);
        table.head.extend([CONDUCTANCE.column(), "holds".into()]);
        if gas.is_some() {
            table.head.extend([column("gas"), column("total")]);
        }
        Self { scene, loads: places.iter().filter_map(loaded).collect(), gas, alone, table }
    }

    /// A row; `in_gas` are the conductances of the gas and in total.
    fn row(
        &self,
        id: &str,
        at: &Loaded,
        [relative, found]: [Option<f64>; 2],
        holds: &str,
        in_gas: Option<[f64; 2]>,
    ) -> Vec<Cell> {
        let numbers = [Some(at.load), Some(at.pressure), relative, found];
        let mut row = vec![Cell::from(id)];
        row.extend(numbers.map(Cell::Number));
        row.push(holds.into());
        if self.gas.is_some() {
            row.extend([0, 1].map(|k| Cell::Number(in_gas.map(|both| both[k]))));
        }
        row
    }

    /// Adds the rows of models, and returns the models that have them.
    ///
    /// # Errors
    /// The reason of a single model without rows; others are left out with a warning.
    pub fn add_models<'m>(&mut self, models: &'m [NamedModel]) -> Result<Vec<&'m NamedModel>> {
        let mut answered = vec![];
        for named @ (id, model) in models {
            match self.model_rows(id, model) {
                Ok(rows) => {
                    self.table.rows.extend(rows);
                    answered.push(named);
                }
                Err(reason) => self.leave_out(id, reason)?,
            }
        }
        Ok(answered)
    }

    fn model_rows(&self, id: &str, model: &Model) -> Result<Vec<Vec<Cell>>> {
        let contact = &self.scene.file.scene;
        let request = Request::new([CONDUCTANCE]).at(self.loads.iter().map(|load| load.at));
        let compiled = model.compile(contact, &request)?;
        let row = |load: &Loaded| {
            let contacts = compiled.evaluate(CONDUCTANCE, load.at)?.value();
            let in_gas = match self.gas {
                Some(Gas { conductivity, jump }) => {
                    let (unit, plane) = (SeparationUnit::Metres, Datum::SurfaceMean);
                    let gap = compiled.separation(load.at)?.measured_in(unit, plane, contact)?;
                    let gas = gap_conductance(conductivity, gap.value.max(0.0), jump)?;
                    Some([gas, contacts + gas])
                }
                None => None,
            };
            Ok(self.row(id, load, [None, Some(contacts)], "", in_gas))
        };
        self.loads.iter().map(row).collect()
    }

    /// Adds the rows of correlations, and returns the correlations that have them; warns where one
    /// does not hold.
    ///
    /// # Errors
    /// The reason of a single correlation without rows; others are left out with a warning.
    pub fn add_correlations(
        &mut self,
        correlations: &[Correlation],
        roughness: &GapRoughness,
    ) -> Result<Vec<&'static str>> {
        let mut answered = vec![];
        for &correlation in correlations {
            let id = correlation.id();
            match self.correlation_rows(correlation, roughness) {
                Ok((rows, outside)) => {
                    self.table.rows.extend(rows);
                    answered.push(id);
                    let reason = correlation.reason_against(&self.scene.file.scene);
                    for reason in outside.into_iter().chain(reason) {
                        print_message("warning", &format!("{id}: {reason}"));
                    }
                }
                Err(reason) => self.leave_out(id, reason)?,
            }
        }
        Ok(answered)
    }

    /// The rows of a correlation, and the first place outside its range.
    fn correlation_rows(
        &self,
        correlation: Correlation,
        roughness: &GapRoughness,
    ) -> Result<(Vec<Vec<Cell>>, Option<String>)> {
        let ([from, to], mut rows, mut outside) = (correlation.range(), vec![], None);
        for load in &self.loads {
            let found = correlation.at(&self.scene.file.scene, roughness, load.pressure)?;
            let relative = found.relative_pressure;
            if outside.is_none() && !(from..=to).contains(&relative) {
                outside = Some(format!(
                    "{} is {} at {}, outside the range of the correlation, {from:e} to {to}",
                    correlation.relative_pressure(),
                    rounded(relative),
                    load.at
                ));
            }
            let holds = if found.holds { "yes" } else { "no" };
            let numbers = [relative, found.conductance].map(Some);
            rows.push(self.row(correlation.id(), load, numbers, holds, None));
        }
        Ok((rows, outside))
    }

    /// Names a model or correlation without a conductance in this scene, and the reason.
    ///
    /// # Errors
    /// The reason, if no other is in the list.
    pub fn leave_out(&self, id: &str, reason: anyhow::Error) -> Result<()> {
        let (name, reason) = (&self.scene.name, summary(&reason));
        let reason = reason.strip_prefix(&format!("{name}: ")).unwrap_or(&reason);
        if self.alone {
            return Err(anyhow!("{name}: {id}: {reason}"));
        }
        print_message("warning", &format!("left out: {id}: {reason}"));
        Ok(())
    }
}
