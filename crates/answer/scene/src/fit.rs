//! Fits of a scene: free parameters by the keys of scene files.

use std::ops::ControlFlow;

use asperity::fit::{
    Data, Fit, FitError, Fitted, Measured, MeasuredTable, Observation, Parameter, Progress, Rig,
    Role, USUAL_FACTOR, places, predict,
};
use asperity::{At, Best, Described, Findings, Interface, Model, Quantity, Scene, Severity, short};

use crate::error::{Place, SceneError};
use crate::free::{Free, bounds_in_other_unit, unit_of_free};
use crate::keys::{BODY, key_of_input};
use crate::scene_file::SceneFile;

impl SceneFile {
    /// The measured values of a table, whose separations are measured from the plane of this scene.
    ///
    /// # Errors
    /// [`SceneError::Fit`] naming the column or the line, the value and what is required.
    pub fn data(&self, table: &MeasuredTable) -> Result<Data, SceneError> {
        Ok(Data::from_table(table, self.spec.separation_from)?)
    }

    /// The free parameters, which start from the values of this scene. By default their bounds are
    /// a factor 30 either way, those of `separation_offset` 30 asperity_height_std beyond the
    /// readings, which is free, too, where closures were measured.
    ///
    /// # Errors
    /// Those of [`inputs`](Self::inputs), and [`SceneError::Fit`] for bounds that are out of order
    /// or those of another unit, a number without a value or bounds, and a parameter of the rig
    /// that the data do not contain.
    pub fn free_parameters(
        &self,
        free: &[Free],
        data: &Data,
    ) -> Result<Vec<Parameter>, SceneError> {
        let name = "separation_offset";
        let is_lacking = data.has_closure() && free.iter().all(|free| free.name != name);
        let offset = Free { name: name.into(), bounds: None, has_unit: false };
        let free = free.iter().chain(is_lacking.then_some(&offset));
        free.map(|free| self.free_parameter(free, data)).collect()
    }

    fn free_parameter(&self, free: &Free, data: &Data) -> Result<Parameter, SceneError> {
        let std = self.scene.surface.asperity_height_std;
        let (start, usual, scale) = match Role::of(&free.name) {
            Role::SeparationOffset => {
                let [low, high] =
                    readings(data).ok_or_else(|| without_effect(&free.name, "separation_m"))?;
                let beyond = USUAL_FACTOR * std;
                // Contacts carry most loads at separations of about twice the deviation.
                let start = 0.5 * (low + high) - 2.0 * std;
                (Some(start), Some([low - beyond, high + beyond]), std)
            }
            Role::SeriesCompliance => {
                let usual = usual_compliance(data, &self.scene).ok_or_else(|| {
                    without_effect(&free.name, "separation_m or a normal stiffness")
                })?;
                (Some(usual), Some([usual / USUAL_FACTOR, usual * USUAL_FACTOR]), usual)
            }
            _ => {
                let input = self.inputs([free.name.as_str()])?;
                if let Some(reason) = self.unlike_bodies(&free.name) {
                    return Err(refused(&free.name, reason));
                }
                let value = input.first().and_then(|input| self.value_of(*input));
                let value = value.or_else(|| self.derived(&free.name));
                let usual = value.filter(|value| *value > 0.0);
                let usual = usual.map(|value| [value / USUAL_FACTOR, value * USUAL_FACTOR]);
                let (usual, scale) = match key_of_input(&free.name) {
                    "poissons_ratio" => (usual.map(|[low, high]| [low, high.min(0.5)]), 1.0),
                    "skewness" => (Some([-1.0, 2.0]), 1.0),
                    _ => (usual, std),
                };
                (value, usual, scale)
            }
        };
        let unit = unit_of_free(&free.name).unwrap_or_default();
        let Some([low, high]) = free.bounds.or(usual) else {
            let reason = "the scene gives no value above 0 to start from: give bounds,";
            return Err(refused(&free.name, format!("{reason} {}=low:high", free.name)));
        };
        // What a rig adds has no value in the scene to compare with.
        let known = start.filter(|_| !free.has_unit && Role::of(&free.name) == Role::Scene);
        if let Some(reason) =
            known.and_then(|known| bounds_in_other_unit(&free.name, known, [low, high]))
        {
            return Err(refused(&free.name, reason));
        }
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * (low + high) };
        let start = start.unwrap_or(middle);
        Ok(Parameter::new(free.name.clone(), unit, start, [low, high], scale)?)
    }

    /// The reason against one value of both bodies for a number in which they differ, even where
    /// the contact depends on the softer one only: which one that is may change in a fit.
    fn unlike_bodies(&self, name: &str) -> Option<String> {
        let field = BODY.iter().find(|field| field.name == name)?;
        let [first, second] = self.bodies() else { return None };
        let values = [first, second].map(|body| (field.get)(body));
        let bits = values.map(|value| value.map(f64::to_bits));
        (bits[0] != bits[1]).then(|| {
            let unit = unit_of_free(name).map_or(String::new(), |unit| format!(" {unit}"));
            let shown = |value| format!("{}{unit}", short(value));
            let [one, two] = values.map(|value| value.map_or_else(|| "none".into(), shown));
            format!("the bodies differ in it ({one} and {two}): free body1_{name} or body2_{name}")
        })
    }

    /// A hardness that follows from the yield strength of the same body or interface, or that
    /// strength from the hardness.
    fn derived(&self, name: &str) -> Option<f64> {
        let key = key_of_input(name);
        let settled = self.spec.bodies.settled(&mut |one| one.middle());
        let body = match name.strip_suffix(key) {
            Some("body1_") => settled.list().first(),
            Some("body2_") => settled.list().get(1),
            _ => None,
        };
        let mut scene = self.scene.clone();
        if let Some(body) = body {
            scene.interface = Interface::against_rigid(body).ok()?;
        }
        let asperity = scene.asperity().ok()?;
        match key {
            "hardness" => asperity.hardness,
            "yield_strength" => asperity.yield_strength,
            _ => None,
        }
    }

    /// A model fitted to data from this scene, with unusual results where they were measured;
    /// `progress` is called before every evaluation and may end the fit.
    ///
    /// # Errors
    /// The errors of [`free_parameters`](Self::free_parameters) and [`inputs`](Self::inputs);
    /// [`SceneError::Fit`] for data that the model does not have, and where `progress` ended it.
    pub fn fit(
        &self,
        model: &Model,
        data: &Data,
        free: &[Free],
        progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Fitted, SceneError> {
        self.need_flat()?;
        if model.id() == Best::<Model>::ID {
            let reason = "best chooses its model by the scene, which a fit changes: fit one model";
            return Err(refused("model", reason.into()));
        }
        if free.iter().all(|free| free.name != "nominal_area") {
            data.check_loads(self.scene.nominal_area)?;
        }
        let parameters = self.free_parameters(free, data)?;
        let of_scene = parameters.iter().filter(|one| one.role == Role::Scene);
        let inputs = self.inputs(of_scene.map(|one| one.name.as_str()))?;
        let scene = |values: &[f64]| {
            let numbers = inputs.iter().copied().zip(values.iter().copied());
            Ok(self.with_inputs(numbers)?.scene)
        };
        let mut fitted = Fit::new(data, parameters, &scene)?.run_with(&**model, progress)?;
        let (mut file, rig) = self.fitted(&fitted)?;
        // Whether a law holds does not depend on what is accepted.
        file.spec.accept.clear();
        let places = places(&**model, &file.scene, rig, data);
        let unusual = file.findings_at(&**model, &places).at_least(Severity::Warning);
        fitted.findings.extend(unusual);
        Ok(fitted)
    }

    /// The values of a fitted model where data were measured, in their order; none where the model
    /// has no value.
    ///
    /// # Errors
    /// The errors of [`inputs`](Self::inputs) and [`with_inputs`](Self::with_inputs).
    pub fn fitted_values(
        &self,
        model: &Model,
        fitted: &Fitted,
        data: &Data,
    ) -> Result<Vec<Option<f64>>, SceneError> {
        let (file, rig) = self.fitted(fitted)?;
        let found = predict(&**model, &file.scene, rig, data);
        Ok(found.into_iter().map(Result::ok).collect())
    }

    /// The findings of fitted models, one for each cause, without those that the scene accepts.
    #[must_use]
    pub fn findings_of_fits(&self, models: &[Fitted]) -> Findings {
        self.accepted(models.iter().flat_map(|one| one.findings.iter().cloned()).collect())
    }

    /// The scene with the fitted numbers, and the rig.
    fn fitted(&self, fitted: &Fitted) -> Result<(Self, Rig), SceneError> {
        let (mut names, mut values, mut rig) = (vec![], vec![], Rig::default());
        for one in &fitted.parameters {
            match Role::of(&one.name) {
                Role::SeparationOffset => rig.separation_offset = one.value,
                Role::SeriesCompliance => rig.series_compliance = one.value,
                _ => {
                    names.push(one.name.as_str());
                    values.push(one.value);
                }
            }
        }
        let made = self.with_inputs(self.inputs(names)?.into_iter().zip(values));
        let made = made.map_err(|error| {
            SceneError::from_contact(error, |field| Box::new(Place::field(field)))
        })?;
        Ok((made, rig))
    }
}

fn without_effect(name: &str, needed: &str) -> SceneError {
    refused(name, format!("the data have no column that depends on it: {needed} was required"))
}

fn refused(parameter: &str, reason: String) -> SceneError {
    FitError::Parameter { parameter: parameter.into(), reason }.into()
}

/// The smallest and the largest reading of a separation.
fn readings(data: &Data) -> Option<[f64; 2]> {
    let reading = |one: &Observation| match (one.at, one.measured) {
        (At::Separation(reading), _) => Some(reading.value),
        (_, Measured::Separation) => Some(one.value),
        _ => None,
    };
    span(data.iter().filter_map(reading))
}

fn span(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let join = |found: Option<[f64; 2]>, value: f64| {
        let [low, high] = found.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    };
    values.fold(None, join)
}

/// A tenth of the smallest compliance that was measured, or of the readings over the loads.
fn usual_compliance(data: &Data, scene: &Scene) -> Option<f64> {
    let stiffness = |one: &&Observation| {
        let stiffnesses = [Quantity::Stiffness, Quantity::Tangent, Quantity::UnloadingStiffness];
        matches!(one.measured, Measured::Quantity(quantity) if stiffnesses.contains(&quantity))
    };
    if let Some([_, stiffest]) = span(data.iter().filter(stiffness).map(|one| one.value)) {
        return Some(0.1 / stiffest).filter(|usual| *usual > 0.0 && usual.is_finite());
    }
    let load = |one: &Observation| match (one.at, one.measured) {
        (at, Measured::Separation) => at.load(scene),
        (At::Separation(_), Measured::Quantity(Quantity::Force)) => Some(one.value),
        (At::Separation(_), Measured::Quantity(Quantity::Pressure)) => {
            At::Pressure(one.value).load(scene)
        }
        _ => None,
    };
    let ([near, far], [least, most]) = (readings(data)?, span(data.iter().filter_map(load))?);
    let usual = 0.1 * (far - near) / (most - least);
    Some(usual).filter(|usual| *usual > 0.0 && usual.is_finite())
}
