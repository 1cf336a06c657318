//! The models of the figures, each with the same curve in all, the paper's scenes, and panels.

use anyhow::{Context, Result};
use asperity::{
    At, Body, Interface, Model, Quantity, Request, Response, Scene, Surface, Tolerance, linspace,
};
use asperity_plot::{Axis, Curve, Figure, Panel, look_of};

/// The models of the paper's figures.
pub const PAPER: [&str; 9] = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af", "gao", "at"];
/// Far below the width of a line, and below the guard of 1e-7.
pub const TOLERANCE: f64 = 1e-9;

/// Quantities of a model at separations or loads.
pub fn solve(
    id: &str,
    scene: &Scene,
    quantities: &[Quantity],
    at: impl IntoIterator<Item = impl Into<At>>,
) -> Result<Response> {
    let request = Request::new(quantities.iter().copied()).within(Tolerance::new(TOLERANCE)?);
    Ok(id.parse::<Model>()?.solve(scene, &request.at(at))?)
}

/// Numbers from one to another, each the same multiple of the one before.
pub fn geometric(from: f64, to: f64, count: usize) -> Vec<f64> {
    linspace(from.log10(), to.log10(), count).into_iter().map(|x| 10f64.powf(x)).collect()
}

/// The curve of each model.
pub fn curves(ids: &[&str]) -> Result<Vec<Curve>> {
    let curve = |id: &&str| {
        let model: Model = id.parse()?;
        let label = match *id {
            "at" => "AT (as printed)",
            "etsion" => "Etsion",
            _ => model.name(),
        };
        Ok(Curve::new(look_of(id).with_context(|| format!("{id} has no look"))?, id, label))
    };
    ids.iter().map(curve).collect()
}

/// Curves of no model, with their keys and looks; their labels stand in `captions.txt`.
pub fn named(curves: &[(&str, usize)]) -> Vec<Curve> {
    curves.iter().map(|(key, look)| Curve::new(*look, key, "")).collect()
}

/// A panel with these curves.
pub fn panel(x: &Axis, y: Axis, curves: &[Curve]) -> Panel {
    let mut panel = Panel::new(x.clone(), y);
    panel.curves = curves.to_vec();
    panel
}

/// The same panel, of the rows with this key in a column, with a title.
pub fn of(column: &str, key: &str, title: &str, mut panel: Panel) -> Panel {
    panel.only = Some((column.into(), key.into()));
    panel.title = title.into();
    panel
}

/// A figure with so many panels beside each other; its words stand in `captions.txt`.
pub fn beside(columns: usize, panels: impl Into<Vec<Panel>>) -> Figure {
    let mut figure = Figure::new("", &[], panels.into());
    figure.columns = columns;
    figure
}

/// The pressure on the nominal area.
pub fn pressure_axis() -> Axis {
    Axis::new("pressure_Pa", "pressure F/A_n (MPa)").times(1e-6).log()
}

/// The separation from the mean of the asperity heights.
pub fn separation_axis() -> Axis {
    Axis::new("separation_m", "separation d (µm)").times(1e6)
}

/// The paper's interface: E = 116 GPa and G = 41 GPa are taken as the equivalent moduli.
pub fn interface() -> Interface {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    interface.pressure_factor = Some(0.58);
    interface
}

/// The paper's plasticity index.
const PLASTICITY_INDEX: f64 = 6.0;
/// Assumed: the paper does not give it.
const ROUGHNESS_PARAMETER: f64 = 0.04;
/// The paper's nominal area \[m²\].
pub const NOMINAL_AREA: f64 = 3e-5;

/// The paper's scene at this standard deviation of asperity heights \[m\].
pub fn scene(std: f64) -> Result<Scene> {
    let interface = interface();
    let (index, parameter) = (PLASTICITY_INDEX, ROUGHNESS_PARAMETER);
    let surface = Surface::from_plasticity_index(index, parameter, std, &interface)?;
    Ok(Scene::new(interface, surface, NOMINAL_AREA))
}

/// Kucharski's steel on a rigid flat, on an assumed surface.
pub fn kucharski() -> Result<Scene> {
    let steel = Body::yielding(200e9, 0.3, 400e6);
    let (radius, std) = (60e-6, 3e-6);
    let surface = Surface::new(radius, ROUGHNESS_PARAMETER / (radius * std), std);
    Ok(Scene::new(Interface::against_rigid(&steel)?, surface, 1e-4))
}
