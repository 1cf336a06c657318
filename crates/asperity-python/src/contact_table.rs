//! Contact tables for finite-element codes.

use asperity::{
    ConductanceAgainst, ContactTable, SeparationUnit, TableFormat, Tolerance, UnitSystem,
};
use pyo3::prelude::*;

use crate::convert::axis::Axis;
use crate::convert::error::{refused, value_error};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Clearances [m], pressures [Pa], tangents [Pa/m], the relative errors of pressure and tangent
/// between the nodes, and the text.
type Table = (Vec<f64>, Vec<f64>, Vec<f64>, f64, f64, String);

fn format_of(name: &str) -> PyResult<TableFormat> {
    Ok(match name {
        "csv" => TableFormat::Csv,
        "abaqus" => TableFormat::Abaqus,
        "calculix" => TableFormat::Calculix,
        "ansys" => TableFormat::Ansys,
        other => {
            let needed = "\"csv\", \"abaqus\", \"calculix\" or \"ansys\" was required";
            return Err(value_error(format!("format is {other:?}: {needed}")));
        }
    })
}

fn against_of(name: &str) -> PyResult<ConductanceAgainst> {
    match name {
        "pressure" => Ok(ConductanceAgainst::Pressure),
        "clearance" => Ok(ConductanceAgainst::Clearance),
        other => {
            let needed = "\"pressure\" or \"clearance\" was required";
            Err(value_error(format!("conductance is {other:?}: {needed}")))
        }
    }
}

/// A table between two places, with nodes at equal distances or, if an error is given, as many as
/// that error needs; conductance and friction are added to the text, if given.
#[pyfunction]
pub(crate) fn contact_table(
    py: Python<'_>,
    engine: &Engine,
    scene: &SceneFile,
    ends: (Axis, f64, f64),
    spacing: (usize, Option<f64>, f64),
    form: (&str, &str),
    beside: (Option<String>, Option<f64>),
) -> PyResult<Table> {
    let (model, format, file) = (engine.on(&scene.0)?, format_of(form.0)?, &scene.0);
    let units: UnitSystem = form.1.parse().map_err(|e| value_error(format!("units: {e}")))?;
    let (from, contact) = (file.separation_from, &file.scene);
    let (nodes, max_error, rtol) = spacing;
    let tolerance = Tolerance::new(rtol).map_err(refused)?;
    let (axis, first, last) = ends;
    let range = (axis.at(first, from), axis.at(last, from), nodes);
    let between = format.interpolation();
    let table = py.detach(|| match max_error {
        Some(error) => ContactTable::within(&model, contact, tolerance, range, error, between),
        None => ContactTable::even(&model, contact, tolerance, range, between),
    });
    let table = table.map_err(value_error)?;
    let title = format!("asperity {}, model {}", env!("CARGO_PKG_VERSION"), model_name(&model));
    let mut text = table.text((format, units), contact, from, &title).map_err(value_error)?;
    let (conductance, friction) = beside;
    if let Some(against) = conductance {
        let (against, place) = (against_of(&against)?, (&model as _, contact, from));
        let added = table.conductance_text((format, units), against, place, tolerance);
        text += &added.map_err(value_error)?;
    }
    if let Some(friction) = friction {
        let added = table.friction_text((format, units), friction, (&model, contact), tolerance);
        text += &added.map_err(value_error)?;
    }
    let clearance = |node: &asperity::ContactNode| {
        let separation = asperity::Separation::sigmas(node.separation);
        Ok(separation.measured_in(SeparationUnit::Metres, from, contact).map_err(refused)?.value)
    };
    let clearances = table.nodes.iter().map(clearance).collect::<PyResult<Vec<f64>>>()?;
    let pressures = table.nodes.iter().map(|node| node.pressure).collect();
    let tangents = table.nodes.iter().map(|node| node.stiffness).collect();
    Ok((clearances, pressures, tangents, table.pressure_error, table.stiffness_error, text))
}

fn model_name(model: &asperity::Model) -> String {
    asperity::Described::id(model).to_string()
}
