//! The gallery: the figures of the paper, each with links that open its scenes in the explorer.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, anyhow};
use asperity::Scene;
use asperity_inputs::SceneFile;
use asperity_web::Desk;
use serde_json::{Value, json};

use crate::figures::{FIGURES, FigureSpec, models, paper};
use crate::folder::figures_folder;
use crate::html::escape;

/// Where the figures go in the gallery's page.
const PLACE: &str = "<!-- figures -->";
/// What the explorer draws in place of a quantity of two of the papers.
const OTHER_STIFFNESS: &str =
    " (tangents; for Gao and AT the figure shows the papers' average of asperity stiffnesses)";
/// The models of the paper that are drawn at once.
const MODELS: &[&str] = &models::PAPER;

/// A scene of a figure: what its link says, the scene, the models and the quantity.
struct LinkedScene {
    label: String,
    scene: Scene,
    models: &'static [&'static str],
    view: &'static str,
}

/// Writes the pictures and fills the gallery's page.
pub(super) fn write(folder: &Path) -> Result<()> {
    let pictures = folder.join("gallery");
    fs::create_dir_all(&pictures)?;
    let mut sections = String::new();
    for figure in &FIGURES {
        let scenes = scenes(figure.name)?;
        if scenes.is_empty() {
            continue;
        }
        let file = format!("{}.svg", figure.name);
        let from = figures_folder().join(&file);
        fs::copy(&from, pictures.join(&file)).with_context(|| from.display().to_string())?;
        let title = (figure.style)(&csv(figure)?)?.title;
        let (title, mut links) = (escape(&title), String::new());
        for one in scenes {
            let label = escape(&one.label).replace("_z", "<sub>z</sub>");
            let link = link(&one)?;
            write!(links, "<a href=\"index.html#s={link}\">{label}</a>, ")?;
        }
        let links = links.trim_end_matches(", ");
        let other = if title.contains("stiffness") { OTHER_STIFFNESS } else { "" };
        let number = figure.name.trim_start_matches("fig").split('-').next().unwrap_or_default();
        let number = number.trim_start_matches('0');
        writeln!(
            sections,
            "<section><h2>Figure {number}: {title}</h2><p>Open in the explorer: {links}{other}</p>\
             <figure><img src=\"gallery/{file}\" alt=\"{title}\" loading=\"lazy\"></figure></section>"
        )?;
    }
    let path = folder.join("gallery.html");
    let page = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    fs::write(&path, page.replace(PLACE, &sections)).with_context(|| path.display().to_string())
}

fn csv(figure: &FigureSpec) -> Result<String> {
    let path = figures_folder().join(format!("{}.csv", figure.name));
    fs::read_to_string(&path).with_context(|| path.display().to_string())
}

/// The scenes of a figure; none for a figure that is not the curve of a scene.
fn scenes(figure: &str) -> Result<Vec<LinkedScene>> {
    let of = |label: String, scene, models, view| LinkedScene { label, scene, models, view };
    let kind = figure.split_once('-').map_or("", |(_, kind)| kind);
    // Loads lie on the explorer's axis, against which the force is the separation.
    let view = match kind.split('-').next() {
        Some("force") => "separation",
        Some("area") => "area-fraction",
        _ => "tangent",
    };
    Ok(match kind {
        _ if !figure.starts_with("fig") => vec![],
        "area-kucharski" => {
            vec![of("Kucharski's steel".into(), models::kucharski()?, MODELS, view)]
        }
        _ if kind.ends_with("-models") => {
            vec![of("nine models".into(), models::scene(paper::ROUGHNESS)?, MODELS, view)]
        }
        _ => paper::ROUGHNESSES
            .iter()
            .map(|std| {
                let label = format!("σ_z = {:.1} µm", std * 1e6);
                Ok(of(label, models::scene(*std)?, &["at"], view))
            })
            .collect::<Result<_>>()?,
    })
}

/// The state of the explorer behind `#s=`.
fn link(opened: &LinkedScene) -> Result<String> {
    let scene = SceneFile::from(opened.scene.clone()).to_toml(&[])?;
    let state = json!({
        "scene": scene, "models": opened.models, "load": "", "view": opened.view, "scan": null,
    });
    let answer = Desk::default().call(&json!({ "call": "link", "state": state }).to_string());
    let answer: Value = serde_json::from_str(&answer)?;
    answer["ok"].as_str().map(str::to_string).ok_or_else(|| anyhow!("{answer}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn call(desk: &mut Desk, message: Value) -> Value {
        let answer: Value = serde_json::from_str(&desk.call(&message.to_string())).unwrap();
        assert!(answer["error"].is_null(), "{answer}");
        answer["ok"].clone()
    }

    #[test]
    fn the_scenes_of_the_links_give_the_curves_of_the_figures() {
        let mut compared = 0;
        for figure in FIGURES.iter().filter(|figure| figure.name.contains("models")) {
            for opened in scenes(figure.name).unwrap() {
                let mut desk = Desk::default();
                let state =
                    call(&mut desk, json!({ "call": "unlink", "link": link(&opened).unwrap() }));
                let shown = call(&mut desk, json!({ "call": "show", "text": state["scene"] }));
                assert!(shown["error"].is_null(), "{shown}");
                // The load of a point of figure 5 gives the point of each figure.
                let force = FIGURES.iter().find(|figure| figure.name.starts_with("fig05")).unwrap();
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
                let (found, wanted) = match opened.view {
                    "separation" => (of("separation"), wanted[0]),
                    "area-fraction" => (of("area-fraction") * 3e-5, wanted[1]),
                    view => (of(view), wanted[1]),
                };
                assert!((found / wanted - 1.0).abs() < 1e-6, "{}: {found} {wanted}", figure.name);
                compared += 1;
            }
        }
        assert_eq!(compared, 3);
    }

    #[test]
    fn every_figure_of_the_paper_has_a_picture_and_links() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("gallery.html"), format!("<main>{PLACE}</main>")).unwrap();
        write(folder.path()).unwrap();
        let page = fs::read_to_string(folder.path().join("gallery.html")).unwrap();
        assert_eq!(page.matches("<section>").count(), 7);
        assert_eq!(page.matches("index.html#s=").count(), 3 * 4 + 4);
        assert!(folder.path().join("gallery/fig10-area-kucharski.svg").is_file());
    }
}
