//! Fits of a scene: free parameters by the keys of scene files.

use std::ops::ControlFlow;

use asperity::fit::{
    Data, Fit, FitError, Fitted, MeasuredTable, Parameter, Progress, Rig, Role, USUAL_FACTOR,
    places, predict,
};
use asperity::{Best, Body, Described, Findings, Model, Severity, unusual};

use crate::error::{Place, SceneError};
use crate::keys::{BODY, Field, Key, key_of_input};
use crate::quantity::{quantity, quantity_of, unit_of, without_unit};
use crate::scene_file::SceneFile;

/// A free parameter: an input of a scene by its name, `separation_offset` or `series_compliance`,
/// with its bounds in SI units if they are given.
///
/// ```
/// use asperity_scene::Free;
///
/// let free: Free = "asperity_height_std=0.1um:5um".parse()?;
/// assert_eq!(free.bounds, Some([1e-7, 5e-6]));
/// assert_eq!("hardness".parse::<Free>()?.bounds, None);
/// # Ok::<(), String>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Free {
    /// The name.
    pub name: String,
    /// The smallest and the largest value.
    pub bounds: Option<[f64; 2]>,
    /// Whether the bounds were given with a unit, so that they are in no other.
    pub has_unit: bool,
}

impl std::str::FromStr for Free {
    type Err = String;

    /// Reads `name` or `name=low:high`, with or without units.
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, bounds) = text.split_once('=').map_or((text, None), |(a, b)| (a, Some(b)));
        let name = name.trim();
        if name.is_empty() {
            let example = "write name or name=low:high, for example hardness=1GPa:4GPa";
            return Err(format!("a free parameter has no name: {example}"));
        }
        let Some(bounds) = bounds else {
            return Ok(Self { name: name.into(), bounds: None, has_unit: false });
        };
        let refused = |reason: String| format!("{name}: {reason}");
        let number = |text: &str| match Role::of(name) {
            Role::Scene => quantity_of(key_of_input(name), text),
            _ => quantity(text, unit_of_free(name).unwrap_or_default()),
        };
        let Some((low, high)) = bounds.split_once(':') else {
            return Err(refused(format!(
                "{bounds:?} is one value: write {name}=low:high for bounds, or {name} alone"
            )));
        };
        let has_unit = [low, high].map(|text| text.trim().parse::<f64>().is_err());
        let bounds = [number(low).map_err(refused)?, number(high).map_err(refused)?];
        if let Some(bare) = without_unit(bounds, has_unit) {
            return Err(refused(format!(
                "{} has no unit; give both bounds a unit",
                [low, high][bare]
            )));
        }
        let (bounds, has_unit) = (Some(bounds), has_unit.contains(&true));
        Ok(Self { name: name.into(), bounds, has_unit })
    }
}

/// The SI unit of a free parameter; `None` for pure numbers.
#[must_use]
pub(crate) fn unit_of_free(name: &str) -> Option<&'static str> {
    match Role::of(name) {
        Role::SeparationOffset => Some("m"),
        Role::SeriesCompliance => Some("m/N"),
        _ => unit_of(key_of_input(name)),
    }
}

impl SceneFile {
    /// The measured values of a table, whose separations are measured from the plane of this scene.
    ///
    /// # Errors
    /// [`SceneError::Fit`] naming the column or the line, the value and what is required.
    pub fn data(&self, table: &MeasuredTable) -> Result<Data, SceneError> {
        let area = Some(self.scene.nominal_area);
        Ok(Data::from_table(table, self.spec.separation_from, area)?)
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
        let role = Role::of(&free.name);
        let (start, usual, scale) = match role.usual(data, &self.scene)? {
            Some((start, bounds, scale)) => (Some(start), Some(bounds), scale),
            None => {
                let input = self.inputs([free.name.as_str()])?;
                let value = input.first().and_then(|input| self.value_of(*input));
                // Even where the contact depends on the softer body only: which one that is may
                // change in a fit.
                let is_of = |field: &Field<Body>| {
                    self.bodies().iter().any(|one| (field.get)(one).is_some())
                };
                if value.is_none() && Field::of(BODY, &free.name).is_some_and(is_of) {
                    let name = &free.name;
                    let reason =
                        format!("the bodies differ in it: free body1_{name} or body2_{name}");
                    return Err(refused(name, reason));
                }
                let range = || self.unknowns().into_iter().find(|one| one.name == free.name);
                let value = value.or_else(|| Some(range()?.middle()));
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
        let key = Key::find("", key_of_input(&free.name));
        let unusual = |bound| unusual(key?.name, bound)?.likely_unit;
        let is_plain = !free.has_unit && role == Role::Scene;
        if let (true, Some(unit), Some(_)) = (is_plain, unusual(low), unusual(high)) {
            return Err(refused(&free.name, format!("{unit}: give both bounds a unit")));
        }
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * (low + high) };
        let start = start.unwrap_or(middle);
        Ok(Parameter::new(free.name.clone(), unit, start, [low, high], scale)?)
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
        } else if data.is_over_area() {
            let reason = "values over the nominal area were measured; give them in N/m";
            return Err(refused("nominal_area", reason.into()));
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
        let unusual = file.judge(&**model, None, &places).at_least(Severity::Warning);
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

fn refused(parameter: &str, reason: String) -> SceneError {
    FitError::Parameter { parameter: parameter.into(), reason }.into()
}
