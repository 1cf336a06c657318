//! The curve of each model, the same in every figure, and the paper's scenes.

use anyhow::Result;
use asperity::{Body, Interface, Model, Scene, Surface};

use asperity_plot::Curve;

/// The models of the paper's figures.
pub const PAPER: [&str; 9] = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af", "gao", "at"];

/// The curve of a model.
pub fn curve(id: &str) -> Result<Curve> {
    let model: Model = id.parse()?;
    let beside = if id == "ghaednia" { 10 } else { 9 };
    let slot = PAPER.iter().position(|p| *p == id).unwrap_or(beside);
    let label = match id {
        "at" => "AT (as printed)",
        "etsion" => "Etsion",
        _ => model.name(),
    };
    Ok(Curve::new(slot, id, label))
}

/// The paper's interface: E = 116 GPa and G = 41 GPa are taken as the equivalent moduli.
pub fn interface() -> Interface {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    interface.pressure_factor = Some(0.58);
    interface
}

/// The paper's plasticity index.
pub const PLASTICITY_INDEX: f64 = 6.0;
/// Assumed: the paper does not give it.
pub const ROUGHNESS_PARAMETER: f64 = 0.04;
/// The paper's nominal area [m²].
pub const NOMINAL_AREA: f64 = 3e-5;

/// The paper's scene at this standard deviation of asperity heights [m].
pub fn scene(asperity_height_std: f64) -> Result<Scene> {
    let interface = interface();
    let surface = Surface::from_plasticity_index(
        PLASTICITY_INDEX,
        ROUGHNESS_PARAMETER,
        asperity_height_std,
        &interface,
    )?;
    Ok(Scene::new(interface, surface, NOMINAL_AREA))
}

/// Kucharski's steel on a rigid flat, on an assumed surface.
pub fn kucharski() -> Result<Scene> {
    let steel = Body::yielding(200e9, 0.3, 400e6);
    let (radius, std) = (60e-6, 3e-6);
    let surface = Surface::new(radius, ROUGHNESS_PARAMETER / (radius * std), std);
    Ok(Scene::new(Interface::against_rigid(&steel)?, surface, 1e-4))
}

/// The inputs of the paper's scene, for captions.
pub const INPUTS: &str = "E\u{a0}=\u{a0}116\u{a0}GPa and G\u{a0}=\u{a0}41\u{a0}GPa taken as equivalent moduli (inconsistent for equal materials), ν\u{a0}=\u{a0}0.31, H\u{a0}=\u{a0}1.12\u{a0}GPa, S\u{a0}=\u{a0}0.58, plasticity index 6, A_n\u{a0}=\u{a0}3·10⁻⁵\u{a0}m². Assumed: β_z\u{a0}=\u{a0}ηRσ_z\u{a0}=\u{a0}0.04, Gaussian heights, d measured from the mean of the asperity heights.";

/// The meaning of the markers, for captions.
pub const MARKERS: &str = "Markers distinguish the curves; they are not data points.";
