//! The pictures of the model pages: the laws of one asperity, or the area of a whole surface.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use asperity::{
    Asperity, At, Body, Interface, Model, ProfileMoments, Quantity, Request, Scene, Surface,
    Tolerance,
};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel, draw};

use crate::figures;
use crate::folder::figures_folder;
use crate::table::{Field, Table};

/// Which laws a picture shows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Laws {
    /// Those of these models beside GW, in units of the critical interference.
    Of(&'static [&'static str]),
    /// Those of bodies with three tangent moduli.
    Hardening,
    /// Those with adhesion.
    Adhesion,
    /// The real area of an elastic surface against its pressure.
    ElasticArea,
}

/// A picture with the text that stands for it.
pub struct Picture {
    /// The svg.
    pub svg: String,
    /// What it shows.
    pub alt: String,
}

impl Laws {
    /// Draws the laws.
    ///
    /// # Errors
    /// A law or a picture that cannot be computed.
    pub fn draw(self) -> Result<Picture> {
        let (figure, csv, alt) = match self {
            Self::Of(ids) => of(ids)?,
            Self::Hardening => hardening()?,
            Self::Adhesion => adhesion()?,
            Self::ElasticArea => elastic_area()?,
        };
        Ok(Picture { svg: draw(&figure, &csv)?, alt })
    }
}

type Drawing = (Figure, String, String);

/// From the numbers of the figure of all laws.
fn of(ids: &[&str]) -> Result<Drawing> {
    let path = figures_folder().join("laws-single-asperity.csv");
    let all = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let mut keys = vec!["gw"];
    keys.extend(ids.iter().filter(|id| **id != "gw"));
    let mut csv = String::new();
    for (number, line) in all.lines().enumerate() {
        if number == 0 || keys.iter().any(|key| line.split(',').next() == Some(key)) {
            // Writing to a string cannot fail.
            let _ = writeln!(csv, "{line}");
        }
    }
    let figure = figures::some_laws(&keys)?;
    let names = keys.join(", ");
    let alt =
        format!("Force, area and mean pressure of one asperity against interference: {names}");
    Ok((figure, csv, alt))
}

/// `count` numbers from `from` to `to`, each the same multiple of the one before.
fn decades(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    let steps = f64::from(count - 1);
    (0..count).map(move |k| from * (to / from).powf(f64::from(k) / steps))
}

/// Two panels of force and area against interference, with these scales.
fn force_and_area(x: &Axis, force: Axis, area: Axis, curves: &[Curve], caption: &str) -> Figure {
    let panels = [force, area].map(|y| {
        let mut panel = Panel::new(x.clone(), y);
        panel.curves = curves.to_vec();
        panel
    });
    let mut figure = Figure::new("", &[caption], panels.to_vec());
    figure.columns = 2;
    figure
}

const COLUMNS: [&str; 4] = ["curve", "interference_m", "force_N", "area_m2"];

/// Adds force and area of an asperity at these interferences.
fn push_law(
    table: &mut Table,
    key: &str,
    model: &Model,
    asperity: &Asperity,
    interferences: impl Iterator<Item = f64>,
) -> Result<()> {
    let law = |quantity| model.law(asperity, quantity, Tolerance::default());
    let (force, area) = (law(Quantity::Force)?, law(Quantity::Area)?);
    for w in interferences {
        let numbers = [w, force.value(w)?, area.value(w)?].map(Field::Number);
        table.push(&[&[Field::Word(key)], numbers.as_slice()].concat())?;
    }
    Ok(())
}

fn hardening() -> Result<Drawing> {
    let mut table = Table::new(&COLUMNS);
    let cases =
        [("t0", "E_t = 0", 0.0), ("t1", "E_t = 0.01 E_b", 0.01), ("t2", "E_t = 0.1 E_b", 0.1)];
    let mut curves = vec![Curve::new(0, "gw", "GW, elastic")];
    let (radius, modulus) = (1e-3, 200e9);
    for (slot, (key, label, share)) in cases.into_iter().enumerate() {
        let mut steel = Body::yielding(modulus, 0.3, 400e6);
        steel.tangent_modulus = Some(share * modulus);
        let asperity = Asperity::new(&Interface::between(&steel, &steel)?, radius)?;
        let interferences = || decades(1e-9, 1e-5, 121);
        if slot == 0 {
            push_law(&mut table, "gw", &"gw".parse()?, &asperity, interferences())?;
        }
        push_law(&mut table, key, &"ghaednia".parse()?, &asperity, interferences())?;
        curves.push(Curve::new(slot + 1, key, label));
    }
    let x = Axis::new(COLUMNS[1], "interference (µm)").times(1e6).log();
    let force = Axis::new(COLUMNS[2], "force (N)").log();
    let area = Axis::new(COLUMNS[3], "area (µm²)").times(1e12).log();
    let caption = "One asperity of R = 1 mm between two bodies of E_b = 200 GPa, ν = 0.3, S_y = 400 MPa and three tangent moduli E_t.";
    let figure = force_and_area(&x, force, area, &curves, caption);
    let alt = "Force and area of one asperity against interference, for three tangent moduli";
    Ok((figure, table.into_text(), alt.into()))
}

fn adhesion() -> Result<Drawing> {
    let mut table = Table::new(&COLUMNS);
    let mut rubber = Interface::elastic(1e6, 0.5);
    rubber.work_of_adhesion = Some(0.05);
    let asperity = Asperity::new(&rubber, 1e-4)?;
    let names = [
        ("gw", "GW, no adhesion"),
        ("dmt", "DMT"),
        ("jkr", "JKR on approach"),
        ("jkr-separation", "JKR on separation"),
    ];
    let mut curves = vec![];
    for (slot, (id, label)) in names.into_iter().enumerate() {
        let model: Model = id.parse()?;
        // Only contacts that exist are drawn: their laws start with a jump.
        let start = if id == "jkr-separation" { -1.1e-6 } else { 0.0 };
        let law = model.law(&asperity, Quantity::Area, Tolerance::default())?;
        let steps = (0..=400).map(|k| start + (3e-6 - start) * f64::from(k) / 400.0);
        let mut touching = vec![];
        for w in steps {
            if law.value(w)? > 0.0 {
                touching.push(w);
            }
        }
        push_law(&mut table, id, &model, &asperity, touching.into_iter())?;
        curves.push(Curve::new(slot, id, label));
    }
    let x = Axis::new(COLUMNS[1], "interference (µm)").times(1e6);
    let force = Axis::new(COLUMNS[2], "force (µN)").times(1e6);
    let area = Axis::new(COLUMNS[3], "area (µm²)").times(1e12);
    let caption = "One asperity of R = 0.1 mm on an elastomer of E = 1 MPa (equivalent modulus), with a work of adhesion of 0.05 J/m². Each curve starts where the contact forms, or ends when the bodies separate.";
    let mut figure = force_and_area(&x, force, area, &curves, caption);
    figure.panels[0].horizontals = vec![Mark::new(0.0, "")];
    let alt =
        "Force and area of one asperity against interference: GW, DMT and the two branches of JKR";
    Ok((figure, table.into_text(), alt.into()))
}

fn elastic_area() -> Result<Drawing> {
    let columns = ["curve", "pressure_over_modulus_and_gradient", "area_fraction"];
    let moments = ProfileMoments { m0: 1e-12, m2: 0.005, m4: 1.875e8 };
    let (modulus, gradient) = (1e11, (2.0 * moments.m2).sqrt());
    let scene =
        Scene::new(Interface::elastic(modulus, 0.3), Surface::from_moments(&moments)?, 1e-4);
    let mut table = Table::new(&columns);
    let mut curves = vec![];
    for (slot, id) in ["gw", "gw-random", "persson", "persson-fudge"].into_iter().enumerate() {
        let model: Model = id.parse()?;
        let ratios: Vec<f64> = decades(1e-3, 1.0, 61).collect();
        let pressures = ratios.iter().map(|ratio| At::Pressure(ratio * modulus * gradient));
        let answer = model.solve(&scene, &Request::new([Quantity::AreaFraction]).at(pressures))?;
        for (ratio, value) in ratios.iter().zip(answer.values(Quantity::AreaFraction)?) {
            // Asperities do not merge: their area has no meaning beyond the nominal one.
            if value <= 1.0 {
                table.push(&[Field::Word(id), Field::Number(*ratio), Field::Number(value)])?;
            }
        }
        curves.push(Curve::new(slot, id, model.name()));
    }
    let x = Axis::new(columns[1], "nominal pressure over E g").log();
    let mut panel = Panel::new(x, Axis::new(columns[2], "real area over nominal area").log());
    panel.curves = curves;
    let caption = "An elastic, isotropic Gaussian surface of bandwidth α = 7.5: E is the equivalent modulus, g the root mean square gradient.";
    let figure = Figure::new("", &[caption], vec![panel]);
    let alt = "Share of the nominal area in contact against pressure: GW, GW on a random surface, Persson, Persson corrected";
    Ok((figure, table.into_text(), alt.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_picture_has_a_curve_for_every_law() {
        let curves = [
            (Laws::Of(&["jg", "jg-cosine"]), 3),
            (Laws::Of(&["gw"]), 1),
            (Laws::Hardening, 4),
            (Laws::Adhesion, 4),
            (Laws::ElasticArea, 4),
        ];
        for (laws, count) in curves {
            let (figure, csv, _) = match laws {
                Laws::Of(ids) => of(ids).unwrap(),
                Laws::Hardening => hardening().unwrap(),
                Laws::Adhesion => adhesion().unwrap(),
                Laws::ElasticArea => elastic_area().unwrap(),
            };
            assert_eq!(figure.panels[0].curves.len(), count);
            assert!(draw(&figure, &csv).unwrap().contains("<polyline"));
        }
    }

    #[test]
    fn tension_is_largest_where_the_papers_say() {
        let (_, csv, _) = adhesion().unwrap();
        let least = |id: &str| {
            let forces = csv.lines().filter(|line| line.split(',').next() == Some(id));
            let force = |line: &str| line.split(',').nth(2).unwrap().parse::<f64>().unwrap();
            forces.map(force).fold(f64::INFINITY, f64::min)
        };
        // π w_a R = 15.7 µN: times 2 for DMT, 4/3 for JKR on approach, 3/2 on separation.
        let unit = std::f64::consts::PI * 0.05 * 1e-4;
        for (id, factor) in [("dmt", 2.0), ("jkr", 4.0 / 3.0), ("jkr-separation", 1.5)] {
            assert!((least(id) / unit + factor).abs() < 0.01, "{id}: {}", least(id));
        }
    }
}
