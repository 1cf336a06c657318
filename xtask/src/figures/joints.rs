//! Quantities from the sum of the contact radii against the pressure: three stiffnesses and thermal
//! conductance.

use anyhow::Result;
use asperity::joints::conductance::{
    CorrelationValue, GapRoughness, cooper_mikic_yovanovich, mikic_elastic,
};
use asperity::{Asperity, At, ContactModel, Model, Quantity, Request, Scene, Tolerance, linspace};
use rayon::prelude::*;

use super::models::{self, INPUTS, MARKERS, curve};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Panel};

/// The models with circular contacts.
const CIRCULAR: [&str; 7] = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"];
/// The place of KE among them.
const KE: usize = 3;
const KINDS: [(Quantity, &str, usize, &str); 3] = [
    (Quantity::Tangent, "tangent", 8, "first loading, -dF/dd"),
    (Quantity::UnloadingStiffness, "unloading", 9, "unloading"),
    (Quantity::TangentialStiffness, "tangential", 7, "tangential, no slip"),
];
const X: &str = "pressure_Pa";
/// Assumed, of the two bodies together \[W/(m K)\].
const CONDUCTIVITY: f64 = 50.0;

/// Pressures on the nominal area \[Pa\].
fn pressures() -> Vec<f64> {
    linspace(4.0, 8.0, 121).into_iter().map(|x| 10f64.powf(x)).collect()
}

/// Quantities of every model with circular contacts, in the order of [`CIRCULAR`].
fn solved(scene: &Scene, quantities: &[Quantity]) -> Result<Vec<Vec<Vec<f64>>>> {
    let at = || pressures().into_iter().map(At::Pressure);
    let request = Request::new(quantities.iter().copied()).within(Tolerance::new(1e-9)?);
    let solve = |id: &&str| {
        let answer = id.parse::<Model>()?.solve(scene, &request.clone().at(at()))?;
        let columns = quantities.iter().map(|quantity| Ok(answer.values(*quantity)?));
        columns.collect::<Result<Vec<_>>>()
    };
    CIRCULAR.par_iter().map(solve).collect()
}

/// Stiffnesses of KE, then the ratio of two of them for all models.
pub fn stiffness() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let all = solved(&scene, &KINDS.map(|(quantity, ..)| quantity))?;
    let mut table = Table::new(&["panel", "curve", X, "stiffness_N_per_m", "ratio"]);
    for (id, columns) in CIRCULAR.iter().zip(&all) {
        for ((_, key, ..), column) in KINDS.iter().zip(columns).filter(|_| *id == "ke") {
            for (p, value) in pressures().into_iter().zip(column) {
                let numbers = [Field::Number(p), Field::Number(*value), Field::Gap];
                table.push(&[&[Field::Word("kinds"), Field::Word(key)], &numbers[..]].concat())?;
            }
        }
        for (p, (tangent, unloading)) in
            pressures().into_iter().zip(columns[0].iter().zip(&columns[1]))
        {
            let numbers = [Field::Number(p), Field::Gap, Field::Number(unloading / tangent)];
            table.push(&[&[Field::Word("ratio"), Field::Word(id)], &numbers[..]].concat())?;
        }
    }
    Ok(table)
}

/// The pressure on the nominal area.
pub(super) fn pressure_axis() -> Axis {
    Axis::new(X, "pressure F/A_n (MPa)").times(1e-6).log()
}

/// The picture of [`stiffness`].
pub fn stiffness_figure(_: &str) -> Result<Figure> {
    let y = Axis::new("stiffness_N_per_m", "stiffness (N/µm)").times(1e-6).log();
    let mut kinds = Panel::new(pressure_axis(), y);
    kinds.title = "three stiffnesses of KE".into();
    kinds.curves = KINDS.map(|(_, key, look, label)| Curve::new(look, key, label)).to_vec();
    let y = Axis::new("ratio", "unloading over first loading").range(0.8, 4.0);
    let mut ratio = Panel::new(pressure_axis(), y);
    ratio.title = "unloading over first loading".into();
    ratio.curves = CIRCULAR.iter().map(|id| curve(id)).collect::<Result<_>>()?;
    for (panel, key) in [(&mut kinds, "kinds"), (&mut ratio, "ratio")] {
        panel.only = Some(("panel".into(), key.into()));
    }
    let caption = format!(
        "First loading has the stiffness -dF/dd; a modal or an ultrasonic test measures the unloading stiffness, 2E times the sum of the contact radii; small shifts have the tangential stiffness, 8G times that sum. For GW, which ignores yielding, the first two are equal. {INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm."
    );
    let title = "Stiffness in first loading, unloading and shear";
    let mut figure = Figure::new(title, &[&caption, MARKERS], vec![kinds, ratio]);
    figure.columns = 2;
    Ok(figure)
}

/// The usual correlations, with their looks and names in the legend.
pub(super) const CORRELATIONS: [(&str, usize, &str); 2] =
    [("cmy", 8, "CMY 1969, plastic"), ("mikic", 7, "Mikic 1974, elastic")];

/// Conductance of every model and of the correlations where they hold, and over that of KE.
pub fn conductance() -> Result<Table> {
    let mut scene = models::scene(1e-6)?;
    scene.interface.thermal_conductivity = Some(CONDUCTIVITY);
    let roughness = GapRoughness::of(&scene.surface.moments());
    let Asperity { equivalent_modulus: modulus, .. } = scene.asperity()?;
    let hardness = scene.asperity()?.hardness()?;
    let per_area = |columns: Vec<Vec<f64>>| {
        columns.into_iter().flatten().map(|h| Some(h / scene.nominal_area)).collect()
    };
    let all = solved(&scene, &[Quantity::ThermalConductance])?.into_iter().map(per_area);
    let mut curves: Vec<(&str, Vec<Option<f64>>)> = CIRCULAR.into_iter().zip(all).collect();
    let reference = curves[KE].1.clone();
    let held = |found: CorrelationValue| found.holds.then_some(found.conductance);
    for (id, ..) in CORRELATIONS {
        let of = |p: f64| match id {
            "cmy" => cooper_mikic_yovanovich(CONDUCTIVITY, &roughness, p, hardness),
            _ => mikic_elastic(CONDUCTIVITY, &roughness, p, modulus),
        };
        let found = pressures().into_iter().map(|p| Ok(held(of(p)?)));
        curves.push((id, found.collect::<Result<_>>()?));
    }
    let mut table = Table::new(&["curve", X, "conductance_W_per_m2K", "over_ke"]);
    for (id, column) in &curves {
        for ((p, h), ke) in pressures().into_iter().zip(column).zip(&reference) {
            let Some((h, ke)) = h.zip(*ke) else { continue };
            let numbers = [p, h, h / ke].map(Field::Number);
            table.push(&[&[Field::Word(id)], &numbers[..]].concat())?;
        }
    }
    Ok(table)
}

/// The picture of [`conductance`].
pub fn conductance_figure(_: &str) -> Result<Figure> {
    let mut curves = CIRCULAR.iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?;
    curves.extend(CORRELATIONS.map(|(key, look, label)| Curve::new(look, key, label)));
    let columns = [
        Axis::new("conductance_W_per_m2K", "conductance h (W/(m² K))").log(),
        Axis::new("over_ke", "conductance over that of KE"),
    ];
    let panels = columns.map(|y| {
        let mut panel = Panel::new(pressure_axis(), y);
        panel.curves.clone_from(&curves);
        panel
    });
    let caption = format!(
        "h\u{a0}=\u{a0}2k_s/A_n times the sum of the contact radii, in vacuum and for contacts far from each other (ψ\u{a0}=\u{a0}1). The correlations of Cooper, Mikic & Yovanovich (CMY), h\u{a0}=\u{a0}1.25k_s(m/σ)(p/H)^0.95, and of Mikic, h\u{a0}=\u{a0}1.55k_s(m/σ)(√2p/(Em))^0.94, have the σ and m of a Gaussian surface with these asperities, and are drawn in the range in which they fit their theories. Assumed: k_s\u{a0}=\u{a0}50\u{a0}W/(m\u{a0}K), the harmonic mean of both bodies', and σ_z\u{a0}=\u{a0}1.0\u{a0}µm. {INPUTS}"
    );
    let title = "Thermal conductance against pressure";
    let mut figure = Figure::new(title, &[&caption, MARKERS], panels.to_vec());
    figure.columns = 2;
    Ok(figure)
}
