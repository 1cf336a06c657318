//! The pictures of the model pages: the laws of one asperity, or the area of a whole surface.

use anyhow::Result;
use asperity::{
    Asperity, At, Body, Interface, Model, ProfileMoments, Quantity, Scene, Surface, Tolerance,
};
use asperity_plot::{Axis, Figure, Mark, draw as drawn};

use crate::figures::models::{beside, geometric, named, panel, solve};
use crate::figures::{captions, some_laws};
use crate::table::Table;

/// The svg of laws, `laws ` and their name or the ids of models, and the text that stands for it.
///
/// # Errors
/// A law or a picture that cannot be computed.
pub fn draw(laws: &str) -> Result<(String, String)> {
    let (mut figure, csv) = picture(laws)?;
    let (alt, caption) = captions::of(laws).or_else(|_| {
        let (alt, caption) = captions::of("laws")?;
        let ids: Vec<&str> = figure.panels[0].curves.iter().map(|curve| &*curve.key).collect();
        anyhow::Ok((format!("{alt}: {}", ids.join(", ")), caption))
    })?;
    figure.caption = caption;
    Ok((drawn(&figure, &csv)?, alt))
}

type Picture = (Figure, String);

fn picture(laws: &str) -> Result<Picture> {
    match laws {
        "laws hardening" => hardening(),
        "laws adhesion" => adhesion(),
        "laws elastic area" => elastic_area(),
        models => {
            let others = models.split(' ').skip(1).filter(|id| *id != "gw");
            some_laws(&["gw"].into_iter().chain(others).collect::<Vec<_>>())
        }
    }
}

const COLUMNS: [&str; 4] = ["curve", "interference_m", "force_N", "area_m2"];

/// Force and area of an asperity against the interference, where there is contact: some laws start
/// with a jump. `laws` returns the model, asperity and interferences of a curve.
fn force_and_area(
    curves: &[(&'static str, usize, &str)],
    laws: impl Fn(&'static str) -> Result<(&'static str, Asperity, Vec<f64>)>,
    axes: [Axis; 3],
) -> Result<Picture> {
    let mut table = Table::new(&COLUMNS);
    for (key, ..) in curves {
        let (id, asperity, interferences) = laws(key)?;
        let model: Model = id.parse()?;
        let law = |quantity| model.law(&asperity, quantity, Tolerance::default());
        let (force, area) = (law(Quantity::Force)?, law(Quantity::Area)?);
        for w in interferences {
            let numbers = [w, force.value(w)?, area.value(w)?];
            if numbers[2] > 0.0 {
                table.push(&[key], numbers)?;
            }
        }
    }
    let [x, force, area] = axes;
    let panels = [force, area].map(|y| panel(&x, y, &named(curves)));
    Ok((beside(2, panels), table.into_text()))
}

fn hardening() -> Result<Picture> {
    let (radius, modulus) = (1e-3, 200e9);
    let curves = [
        ("gw", 0, "GW, elastic"),
        ("t0", 1, "E_t = 0"),
        ("t1", 2, "E_t = 0.01 E_b"),
        ("t2", 3, "E_t = 0.1 E_b"),
    ];
    let laws = |key| {
        let (id, share) = match key {
            "gw" => ("gw", 0.0),
            "t1" => ("ghaednia", 0.01),
            "t2" => ("ghaednia", 0.1),
            _ => ("ghaednia", 0.0),
        };
        let mut steel = Body::yielding(modulus, 0.3, 400e6);
        steel.tangent_modulus = Some(share * modulus);
        let asperity = Asperity::new(&Interface::between(&steel, &steel)?, radius)?;
        Ok((id, asperity, geometric(1e-9, 1e-5, 121)))
    };
    let x = Axis::new(COLUMNS[1], "interference (µm)").times(1e6).log();
    let force = Axis::new(COLUMNS[2], "force (N)").log();
    let area = Axis::new(COLUMNS[3], "area (µm²)").times(1e12).log();
    force_and_area(&curves, laws, [x, force, area])
}

fn adhesion() -> Result<Picture> {
    let mut rubber = Interface::elastic(1e6, 0.5);
    rubber.work_of_adhesion = Some(0.05);
    let asperity = Asperity::new(&rubber, 1e-4)?;
    let curves = [
        ("gw", 0, "GW, no adhesion"),
        ("dmt", 1, "DMT"),
        ("jkr", 2, "JKR on approach"),
        ("jkr-separation", 3, "JKR on separation"),
    ];
    let laws = |id| {
        let start = if id == "jkr-separation" { -1.1e-6 } else { 0.0 };
        let steps = (0..=400).map(|k| start + (3e-6 - start) * f64::from(k) / 400.0);
        Ok((id, asperity, steps.collect()))
    };
    let x = Axis::new(COLUMNS[1], "interference (µm)").times(1e6);
    let force = Axis::new(COLUMNS[2], "force (µN)").times(1e6);
    let area = Axis::new(COLUMNS[3], "area (µm²)").times(1e12);
    let (mut figure, csv) = force_and_area(&curves, laws, [x, force, area])?;
    figure.panels[0].horizontals = vec![Mark::new(0.0, "")];
    Ok((figure, csv))
}

fn elastic_area() -> Result<Picture> {
    let columns = ["curve", "pressure_over_modulus_and_gradient", "area_fraction"];
    let moments = ProfileMoments { m0: 1e-12, m2: 0.005, m4: 1.875e8 };
    let (modulus, gradient) = (1e11, (2.0 * moments.m2).sqrt());
    let scene =
        Scene::new(Interface::elastic(modulus, 0.3), Surface::from_moments(&moments)?, 1e-4);
    let (mut table, mut curves) = (Table::new(&columns), vec![]);
    for (slot, id) in ["gw", "gw-random", "persson", "persson-fudge"].into_iter().enumerate() {
        let model: Model = id.parse()?;
        let ratios = geometric(1e-3, 1.0, 61);
        let pressures = ratios.iter().map(|ratio| At::Pressure(ratio * modulus * gradient));
        let area = solve(id, &scene, &[Quantity::AreaFraction], pressures)?;
        for (ratio, value) in ratios.iter().zip(area.values(Quantity::AreaFraction)?) {
            // Asperities do not merge: their area has no meaning beyond the nominal one.
            if value <= 1.0 {
                table.push(&[id], [*ratio, value])?;
            }
        }
        curves.extend(named(&[(id, slot, model.name())]));
    }
    let x = Axis::new(columns[1], "nominal pressure over E g").log();
    let y = Axis::new(columns[2], "real area over nominal area").log();
    Ok((beside(1, [panel(&x, y, &curves)]), table.into_text()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_picture_has_a_curve_for_every_law() {
        let curves = [
            ("laws jg jg-cosine", 3),
            ("laws gw", 1),
            ("laws hardening", 4),
            ("laws adhesion", 4),
            ("laws elastic area", 4),
        ];
        for (laws, count) in curves {
            let (figure, csv) = picture(laws).unwrap();
            assert_eq!(figure.panels[0].curves.len(), count);
            assert!(drawn(&figure, &csv).unwrap().contains("<polyline"));
        }
    }

    #[test]
    fn tension_is_largest_where_the_papers_say() {
        let (_, csv) = adhesion().unwrap();
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
