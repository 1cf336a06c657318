//! The law of one asperity by a model: its picture, its kinks, its range and its source.

use asperity::{Described, Tolerance, short};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel, draw, look_of};
use asperity_scene::SceneFile;
use serde_json::{Value, json};

use crate::labels::{model_name, source};
use crate::refusal::Refusal;
use crate::shown::shown;

/// Drawn interferences over the critical one.
const OVER_CRITICAL: [f64; 2] = [0.1, 1000.0];
/// Drawn interferences over σ_z, for bodies that never yield.
const OVER_STD: [f64; 2] = [1e-3, 10.0];
const STEPS: u32 = 240;
/// The least ratio of two interferences that both have a label.
const ROOM: f64 = 2.2;

/// The chapter of the guide about a model, with its equations.
#[must_use]
pub fn chapter_of(id: &str) -> &str {
    match id.split('-').collect::<Vec<_>>()[..] {
        [.., arrangement @ ("random" | "pairs")] => arrangement,
        ["dmt" | "jkr", ..] => "adhesion",
        ["cmy" | "mikic", ..] => "conductance",
        ["best", ..] => "which-model",
        [first, ..] => first,
        [] => "models",
    }
}

/// Force and area of one asperity of the scene by a model, against the interference over the
/// critical one or, without hardness, over σ_z: the picture, the drawn interferences at which the
/// law has a kink or a jump, the range, and the asperity.
pub(crate) fn law(file: &SceneFile, id: &str) -> Result<Value, Refusal> {
    let model = file.model(id)?;
    let one = model.asperity_model().filter(|_| model.sum_of_contacts().is_none());
    let Some(asperity_model) = one else {
        let name = model_name(&model);
        return Err(Refusal::new(format!("{name} has no law of a single asperity")));
    };
    let asperity = file.scene.asperity()?;
    let (unit, axis, of, [first, last]) = match asperity.hardness {
        Some(_) => (
            asperity.critical_interference()?,
            "interference over critical interference",
            "critical interference w_c",
            OVER_CRITICAL,
        ),
        None => {
            let std = file.scene.surface.asperity_height_std;
            (std, "interference over σ_z", "height std σ_z", OVER_STD)
        }
    };
    let tolerance = Tolerance::default();
    let force = asperity_model.force(&asperity, tolerance)?;
    let area = asperity_model.area(&asperity, tolerance)?;
    let kinks = force.kinks().into_iter().map(|x| x * force.interference_unit / unit);
    let kinks: Vec<f64> = kinks.filter(|x| (first..last).contains(x)).collect();
    let step = |k| first * (last / first).powf(f64::from(k) / f64::from(STEPS));
    let mut at: Vec<f64> = (0..=STEPS).map(step).collect();
    at.extend(kinks.iter().flat_map(|x| [x * (1.0 - 1e-9), *x]));
    at.sort_by(f64::total_cmp);
    let mut csv = "curve,interference,force_N,area_m2\n".to_string();
    let mut readings = vec![];
    for x in at {
        let (f, a) = (force.value(x * unit)?, area.value(x * unit)?);
        csv += &format!("{id},{x},{f},{a}\n");
        let at = format!("interference {} ({} of the {})", shown(x * unit, "m"), short(x), of);
        let reading = format!("{at}\nforce {}\narea {}", shown(f, "N"), shown(a, "m2"));
        readings.push(Mark::new(x, &reading));
    }
    let panel = |column: &str, name: &str| {
        let x = Axis::new("interference", axis).log();
        let mut panel = Panel::new(x, Axis::new(column, name).log());
        panel.curves = vec![Curve::new(look_of(id).unwrap_or(0), id, "")];
        panel.verticals = marks(&kinks);
        panel.readings = readings.clone();
        panel
    };
    let panels = vec![panel("force_N", "force (N)"), panel("area_m2", "area (m²)")];
    let mut figure = Figure::new("", &[], panels);
    figure.columns = 2;
    let mut kinks: Vec<String> = kinks.iter().map(|x| short(*x)).collect();
    kinks.dedup();
    let validity = model.validity();
    let to = validity.holds_to.map(|to| format!("holds to {} w_c", short(to)));
    let stated = (!validity.valid_for.is_empty()).then(|| validity.valid_for.to_string());
    let defect = validity.known_defect.map(|defect| defect.summary.to_string());
    Ok(json!({
        "svg": draw(&figure, &csv)?,
        "source": source(&model),
        "kinks": kinks,
        "axis": axis,
        "range": stated.into_iter().chain(to).chain(defect).collect::<Vec<_>>().join("; "),
        "asperity": asperity_sentence(file),
        "guide": format!("guide/{}.html", chapter_of(id)),
    }))
}

/// Radius, modulus and hardness of the scene, by their symbols.
fn asperity_sentence(file: &SceneFile) -> String {
    let interface = &file.scene.interface;
    let critical = file.scene.asperity().and_then(|asperity| asperity.critical_interference());
    let numbers = [
        ("asperity radius R", Some(file.scene.surface.asperity_radius), "m"),
        ("equivalent modulus E", Some(interface.equivalent_modulus), "Pa"),
        ("hardness of the softer body H", interface.softer_hardness(), "Pa"),
        ("critical interference w_c", critical.ok(), "m"),
    ];
    let of = |(name, value, unit): (&str, Option<f64>, &str)| {
        Some(format!("{name} = {}", shown(value?, unit)))
    };
    let all: Vec<String> = numbers.into_iter().filter_map(of).collect();
    format!("One asperity on a rigid flat: {}.", all.join(", "))
}

/// Lines at kinks, in order; those close behind another have no room for a label.
fn marks(kinks: &[f64]) -> Vec<Mark> {
    let mut labelled = 0.0;
    let mark = |x: &f64| {
        let room = *x > ROOM * labelled;
        if room {
            labelled = *x;
        }
        Mark::new(*x, &if room { short(*x) } else { String::new() })
    };
    kinks.iter().map(mark).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> SceneFile {
        asperity_scene::parse(asperity_scene::template(), std::path::Path::new(".")).unwrap()
    }

    #[test]
    fn laws_are_drawn_with_their_kinks_and_have_a_page() {
        let found = law(&file(), "ke").unwrap();
        for text in [">6<", ">110<", "force (N)"] {
            assert!(found["svg"].as_str().unwrap().contains(text), "{text}");
        }
        assert_eq!(found["kinks"], json!(["1", "6", "110"]));
        assert!(law(&file(), "persson").is_err() && law(&file(), "ke-random").is_err());
        for (id, page) in
            [("jg-cosine", "jg"), ("ke-random", "random"), ("jkr-separation", "adhesion")]
        {
            assert_eq!(chapter_of(id), page);
        }
    }

    #[test]
    fn laws_of_bodies_without_hardness_are_drawn_against_the_height_std() {
        let text = include_str!("../../../answer/scene/examples/elastomer-on-glass.toml");
        let text = text.replace("rigid_", "work_of_adhesion = 0.05\nrigid_");
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        for id in ["gw", "dmt", "jkr"] {
            let found = law(&file, id).unwrap();
            assert!(found["svg"].as_str().unwrap().contains("interference over σ"), "{id}");
            assert!(!found["svg"].as_str().unwrap().contains("critical"), "{id}");
        }
        assert!(law(&file, "ke").unwrap_err().message.contains("hardness"));
    }
}
