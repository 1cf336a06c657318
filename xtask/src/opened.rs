//! Links beside the figures of the paper, which open their scenes in the explorer.

use anyhow::{Context, Result};
use asperity::Scene;
use asperity_scene::SceneFile;
use asperity_web::Desk;
use serde_json::{Value, json};

use crate::figures::{models, paper};

/// What the explorer draws in place of a quantity of two of the papers.
const OTHER_STIFFNESS: &str =
    " (tangents; for Gao and AT the figure shows the papers' average of asperity stiffnesses)";

/// A scene of a figure: what its link says, the scene, and the models.
type LinkedScene = (String, Scene, &'static [&'static str]);

/// The links of a figure of the paper, from a page of the guide; nothing of other figures.
///
/// # Errors
/// A scene that cannot be written.
pub fn links(figure: &str) -> Result<String> {
    if !figure.starts_with("fig") {
        return Ok(String::new());
    }
    let link = |one: &LinkedScene| -> Result<String> {
        let label = one.0.replace("_z", "<sub>z</sub>");
        Ok(format!("<a href=\"../index.html#s={}\">{label}</a>", link(one, view(figure))?))
    };
    let links = scenes(figure)?.iter().map(link).collect::<Result<Vec<_>>>()?.join(", ");
    let other = if figure.contains("stiffness") { OTHER_STIFFNESS } else { "" };
    Ok(format!("Open in the explorer: {links}{other}\n\n"))
}

/// The quantity of a figure. Loads lie on the explorer's axis, against which the force is the
/// separation.
fn view(figure: &str) -> &'static str {
    match figure.split('-').nth(1) {
        Some("force") => "separation",
        Some("area") => "area-fraction",
        _ => "tangent",
    }
}

/// The scenes of a figure of the paper.
fn scenes(figure: &str) -> Result<Vec<LinkedScene>> {
    let all = |label: &str, scene| Ok(vec![(label.into(), scene, &models::PAPER[..])]);
    let of_at = |std| Ok((paper::label(std), models::scene(1e-6 * std)?, &["at"][..]));
    match figure.split('-').nth(2) {
        Some("kucharski") => all("Kucharski's steel", models::kucharski()?),
        Some("models") => all("nine models", models::scene(paper::ROUGHNESS)?),
        _ => paper::ROUGHNESSES.into_iter().map(of_at).collect(),
    }
}

/// The state of the explorer behind `#s=`.
fn link((_, scene, models): &LinkedScene, view: &str) -> Result<String> {
    let scene = SceneFile::from(scene.clone()).to_toml()?;
    let state = json!({ "scene": scene, "models": models, "load": "", "view": view, "scan": null });
    let answer = Desk::default().call(&json!({ "call": "link", "state": state }).to_string());
    let answer: Value = serde_json::from_str(&answer)?;
    Ok(answer["ok"].as_str().with_context(|| answer.to_string())?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::{FIGURES, FigureSpec};
    use crate::folder::{figures_folder, read};

    fn csv(figure: &FigureSpec) -> Result<String> {
        read(&figures_folder().join(format!("{}.csv", figure.0)))
    }

    fn call(desk: &mut Desk, message: Value) -> Value {
        let answer: Value = serde_json::from_str(&desk.call(&message.to_string())).unwrap();
        assert!(answer["error"].is_null(), "{answer}");
        answer["ok"].clone()
    }

    #[test]
    fn the_scenes_of_the_links_give_the_curves_of_the_figures() {
        let mut compared = 0;
        for figure in FIGURES.iter().filter(|f| f.0.starts_with("fig") && f.0.contains("models")) {
            for opened in scenes(figure.0).unwrap() {
                let mut desk = Desk::default();
                let link = link(&opened, view(figure.0)).unwrap();
                let state = call(&mut desk, json!({ "call": "unlink", "link": link }));
                let shown = call(&mut desk, json!({ "call": "show", "text": state["scene"] }));
                assert!(shown["error"].is_null(), "{shown}");
                // The load of a point of figure 5 gives the point of each figure.
                let force = FIGURES.iter().find(|figure| figure.0.starts_with("fig05")).unwrap();
                let at = |figure: &FigureSpec| -> Vec<f64> {
                    let text = csv(figure).unwrap();
                    let row = text.lines().filter(|line| line.starts_with("ke,")).nth(80).unwrap();
                    row.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect()
                };
                let (load, wanted) = (at(force)[1], at(figure));
                let load = json!({ "text": format!("{load:e} N") });
                let answer =
                    call(&mut desk, json!({ "call": "answer", "models": ["ke"], "load": load }));
                let of = |quantity: &str| -> f64 {
                    let cells = answer["rows"][0]["cells"].as_array().unwrap();
                    let cell = cells.iter().find(|cell| cell["quantity"] == quantity).unwrap();
                    cell["digits"].as_str().unwrap().parse().unwrap()
                };
                let (found, wanted) = match view(figure.0) {
                    "separation" => (of("separation"), wanted[0]),
                    "area-fraction" => (of("area-fraction") * 3e-5, wanted[1]),
                    view => (of(view), wanted[1]),
                };
                assert!((found / wanted - 1.0).abs() < 1e-6, "{}: {found} {wanted}", figure.0);
                compared += 1;
            }
        }
        assert_eq!(compared, 3);
    }

    #[test]
    fn every_figure_of_the_paper_has_links() -> Result<()> {
        let all: String = FIGURES.iter().map(|f| links(f.0)).collect::<Result<_>>()?;
        assert_eq!(all.matches("Open in the explorer").count(), 7);
        assert_eq!(all.matches("index.html#s=").count(), 3 * 4 + 4);
        Ok(())
    }
}
