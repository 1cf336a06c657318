//! The gallery: the figures of the paper, each with links that open its scenes in the explorer.

use std::path::Path;

use anyhow::{Context, Result};
use asperity::Scene;
use asperity_scene::SceneFile;
use asperity_web::Desk;
use serde_json::{Value, json};

use crate::figures::{FIGURES, captions, models, paper};
use crate::folder::{copy, figures_folder, read, write as save};

/// Where the figures go in the gallery's page.
const PLACE: &str = "<!-- figures -->";
/// What the explorer draws in place of a quantity of two of the papers.
const OTHER_STIFFNESS: &str =
    " (tangents; for Gao and AT the figure shows the papers' average of asperity stiffnesses)";

/// A scene of a figure: what its link says, the scene, the models and the quantity.
struct LinkedScene {
    label: String,
    scene: Scene,
    models: &'static [&'static str],
    view: &'static str,
}

/// Writes the pictures and fills the gallery's page.
pub(super) fn write(folder: &Path) -> Result<()> {
    let mut sections = String::new();
    for (name, ..) in FIGURES.iter().filter(|figure| figure.0.starts_with("fig")) {
        let file = format!("{name}.svg");
        copy(&figures_folder().join(&file), &folder.join("gallery").join(&file))?;
        let title = captions::of(name)?.0;
        let link = |one: &LinkedScene| -> Result<String> {
            let label = one.label.replace("_z", "<sub>z</sub>");
            Ok(format!("<a href=\"index.html#s={}\">{label}</a>", link(one)?))
        };
        let links = scenes(name)?.iter().map(link).collect::<Result<Vec<_>>>()?.join(", ");
        let other = if title.contains("stiffness") { OTHER_STIFFNESS } else { "" };
        let number = name.trim_start_matches(['f', 'i', 'g', '0']).split('-').next();
        let number = number.unwrap_or_default();
        sections += &format!(
            "<section><h2>Figure {number}: {title}</h2><p>Open in the explorer: {links}{other}</p>\
             <figure><img src=\"gallery/{file}\" alt=\"{title}\" loading=\"lazy\"></figure></section>\n"
        );
    }
    let path = folder.join("gallery.html");
    save(&path, read(&path)?.replace(PLACE, &sections))
}

/// The scenes of a figure of the paper.
fn scenes(figure: &str) -> Result<Vec<LinkedScene>> {
    let mut words = figure.split('-').skip(1);
    // Loads lie on the explorer's axis, against which the force is the separation.
    let view = match words.next() {
        Some("force") => "separation",
        Some("area") => "area-fraction",
        _ => "tangent",
    };
    let all = |label: &str, scene| {
        vec![LinkedScene { label: label.into(), scene, models: &models::PAPER, view }]
    };
    let of_at = |(std, _, label): (f64, &str, &str)| {
        let scene = models::scene(std)?;
        Ok(LinkedScene { label: label.into(), scene, models: &["at"], view })
    };
    match words.next() {
        Some("kucharski") => Ok(all("Kucharski's steel", models::kucharski()?)),
        Some("models") => Ok(all("nine models", models::scene(paper::ROUGHNESS)?)),
        _ => paper::ROUGHNESSES.into_iter().map(of_at).collect(),
    }
}

/// The state of the explorer behind `#s=`.
fn link(opened: &LinkedScene) -> Result<String> {
    let scene = SceneFile::from(opened.scene.clone()).to_toml(&[])?;
    let state = json!({
        "scene": scene, "models": opened.models, "load": "", "view": opened.view, "scan": null,
    });
    let answer = Desk::default().call(&json!({ "call": "link", "state": state }).to_string());
    let answer: Value = serde_json::from_str(&answer)?;
    Ok(answer["ok"].as_str().with_context(|| answer.to_string())?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figures::FigureSpec;

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
                let state =
                    call(&mut desk, json!({ "call": "unlink", "link": link(&opened).unwrap() }));
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
                let (found, wanted) = match opened.view {
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
    fn every_figure_of_the_paper_has_a_picture_and_links() {
        let folder = tempfile::tempdir().unwrap();
        save(&folder.path().join("gallery.html"), format!("<main>{PLACE}</main>")).unwrap();
        write(folder.path()).unwrap();
        let page = read(&folder.path().join("gallery.html")).unwrap();
        assert_eq!(page.matches("<section>").count(), 7);
        assert_eq!(page.matches("index.html#s=").count(), 3 * 4 + 4);
        assert!(folder.path().join("gallery/fig10-area-kucharski.svg").is_file());
    }
}
