//! Thermal contact conductance: models, and published correlations beside them.

use asperity::joints::conductance::{Correlation, GapRoughness, gap_conductance};
use asperity::{
    ATOMIC_DISTANCE, At, ContactModel, Datum, Finding, Model, Quantity, Request, SeparationUnit,
    usual_reference,
};
use asperity_inputs::SceneFile;

use crate::models::{once, one_or_usual};
use crate::number::rounded;
use crate::subject::Outcome;
use crate::{AnswerError, Cell, Sheet};

const CONDUCTANCE: Quantity = Quantity::ThermalConductancePerArea;

/// A gas in the gap.
#[derive(Debug, Clone, Copy)]
pub struct Gas {
    /// Its thermal conductivity \[W/(m K)\].
    pub conductivity: f64,
    /// Its temperature-jump distance \[m\].
    pub jump: f64,
}

/// What conducts.
#[derive(Debug, Clone)]
pub struct Conductance<'a> {
    /// The scene, with a thermal conductivity.
    pub file: &'a SceneFile,
    /// The name of the scene in messages.
    pub name: &'a str,
    /// Models and correlations by id; none for the usual model and all correlations.
    pub ids: &'a [String],
    /// The roughness of the correlations, if it is not that of the scene.
    pub roughness: Option<GapRoughness>,
    /// A gas in the gap of the models.
    pub gas: Option<Gas>,
}

impl Conductance<'_> {
    /// Fills a sheet with the conductance per area of each model and correlation at loads or
    /// pressures; those that cannot tell are left out with a warning.
    ///
    /// # Errors
    /// The reason of a single model or correlation, and where none has a conductance.
    pub fn answer(&self, places: &[At], sheet: &mut Sheet) -> Result<(), AnswerError> {
        self.warn_units(sheet);
        sheet.extend(self.file.conduction_findings(&[CONDUCTANCE]));
        let of_contacts = CONDUCTANCE.column();
        let heads = ["model", "load_N", "pressure_Pa", "relative_pressure", &of_contacts, "holds"];
        sheet.under(&[&heads]);
        if self.gas.is_some() {
            sheet.heads.extend(["gas", "total"].map(|part| format!("{part}_{of_contacts}")));
        }
        let is_asked =
            |known: &Correlation| self.ids.is_empty() || self.ids.iter().any(|id| id == known.id());
        let correlations: Vec<Correlation> =
            Correlation::ALL.into_iter().filter(is_asked).collect();
        let is_model = |id: &String| Correlation::ALL.iter().all(|known| *id != known.id());
        let ids: Vec<String> = once(self.ids).into_iter().filter(is_model).collect();
        let ids: Vec<Option<&str>> = match self.ids {
            [] => vec![None],
            _ => ids.iter().map(|id| Some(&**id)).collect(),
        };
        let alone = ids.len() + correlations.len() == 1;
        let leave_out = |sheet: &mut Sheet, rows, id: &str, error: AnswerError| -> Outcome {
            sheet.rows.truncate(rows);
            if alone {
                return Err(format!("{id}: {error}").into());
            }
            sheet.warn("left-out", format!("left out: {id}: {error}"));
            Ok(())
        };
        let mut answered = vec![];
        for id in ids {
            let rows = sheet.rows.len();
            let found = one_or_usual(self.file, self.name, id, sheet).and_then(|(id, model)| {
                self.add_model(sheet, places, &id, &model)?;
                Ok(model)
            });
            let id = id.unwrap_or(usual_reference(&self.file.scene));
            match found {
                Ok(model) => answered.push(model),
                Err(error) => leave_out(sheet, rows, id, error)?,
            }
        }
        let found = answered.iter().flat_map(|model| self.file.findings_at(model, places));
        sheet.report(self.file, found.collect());
        let mut used = vec![];
        for correlation in correlations {
            let rows = sheet.rows.len();
            match self.add_correlation(sheet, places, correlation) {
                Ok(()) => used.push(correlation.id()),
                Err(error) => leave_out(sheet, rows, correlation.id(), error)?,
            }
        }
        if sheet.rows.is_empty() {
            return Err("no model or correlation of the list has a conductance".into());
        }
        if !used.is_empty() {
            self.note_roughness(sheet, &used.join(", "));
        }
        Ok(())
    }

    fn add_model(&self, sheet: &mut Sheet, places: &[At], id: &str, model: &Model) -> Outcome {
        let scene = &self.file.scene;
        let request = Request::new([CONDUCTANCE]).at(places.iter().copied());
        let compiled = model.compile(scene, &request)?;
        for at in places {
            let contacts = compiled.evaluate(CONDUCTANCE, *at)?.value();
            let mut beside = vec!["".into()];
            if let Some(Gas { conductivity, jump }) = self.gas {
                let (unit, plane) = (SeparationUnit::Metres, Datum::SurfaceMean);
                let gap = compiled.separation_in(unit, plane, *at)?;
                let is_open = gap > ATOMIC_DISTANCE;
                let gas = is_open.then(|| gap_conductance(conductivity, gap, jump)).transpose()?;
                beside.extend([gas, gas.map(|gas| contacts + gas)].map(Cell::from));
                if !is_open {
                    let gap = rounded(gap);
                    sheet.warn("atomic", format!("{id}: the mean gap at {at} is {gap} m: no even gap is left for the gas, and its conductance is blank"));
                }
            }
            let numbers = [at.load(scene), at.pressure(scene), None, Some(contacts)];
            sheet.add(&[id], numbers.map(Cell::from).into_iter().chain(beside));
        }
        Ok(())
    }

    /// Adds the rows of a correlation; warns of the first place outside its range, and of contacts
    /// of another kind.
    fn add_correlation(
        &self,
        sheet: &mut Sheet,
        places: &[At],
        correlation: Correlation,
    ) -> Outcome {
        let ([from, to], id, scene) = (correlation.range(), correlation.id(), &self.file.scene);
        let mut outside = None;
        for at in places {
            let Some(pressure) = at.pressure(scene) else { continue };
            let found = correlation.at(scene, &self.roughness(), pressure)?;
            let relative = found.relative_pressure;
            if outside.is_none() && !(from..=to).contains(&relative) {
                outside = Some(format!(
                    "{} is {} at {}, outside the range of the correlation, {from:e} to {to}",
                    correlation.relative_pressure(),
                    rounded(relative),
                    at
                ));
            }
            let holds = if found.holds { "yes" } else { "no" };
            let numbers = [at.load(scene), Some(pressure), Some(relative), Some(found.conductance)];
            sheet.add(&[id], numbers.map(Cell::from).into_iter().chain([holds.into()]));
        }
        for reason in outside.into_iter().chain(correlation.reason_against(scene)) {
            sheet.warn("correlation", format!("{id}: {reason}"));
        }
        Ok(())
    }

    /// Warns of numbers that look like those of another unit.
    fn warn_units(&self, sheet: &mut Sheet) {
        let sigma = self.roughness.map_or(0.0, |found| found.height_std);
        let Gas { conductivity, jump } = self.gas.unwrap_or(Gas { conductivity: 0.0, jump: 0.0 });
        // Liquids have no jump, and conduct better than any gas.
        let gas = if jump > 0.0 { conductivity } else { 0.0 };
        for (name, value, most, si, advice) in [
            ("sigma", sigma, 1e-3, "m", "um is written 1.4um"),
            ("the conductivity of the gas", gas, 0.3, "W/(m K)", "air has 0.026"),
            ("the temperature-jump distance", jump, 1e-3, "m", "air at 1 bar has about 0.37um"),
        ] {
            let found = Finding::warning("likely-unit", name, value).usual([0.0, most]).unit(si);
            sheet.findings.extend((value > most).then(|| found.advice(advice)));
        }
    }

    fn roughness(&self) -> GapRoughness {
        self.roughness.unwrap_or_else(|| self.file.gap_roughness())
    }

    /// Notes the roughness of the correlations used, and what they lack.
    fn note_roughness(&self, sheet: &mut Sheet, used: &str) {
        let GapRoughness { height_std, mean_slope, .. } = self.roughness();
        let [sigma, slope] = [height_std, mean_slope].map(rounded);
        let of = match (self.roughness, &self.file.measured) {
            (Some(_), _) => "as given",
            (_, Some(_)) => "of the scan",
            _ => "of a Gaussian surface with these asperities; a measured surface may differ",
        };
        let text = format!("{used}: sigma is {sigma} m and the mean slope m {slope}, {of}");
        sheet.note("gap-roughness", text);
    }
}
