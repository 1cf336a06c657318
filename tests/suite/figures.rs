//! The committed figures equal the models, and the guard detects differences.

use std::fs;
use std::path::{Path, PathBuf};

use xtask::figures::FIGURES;
use xtask::files::{fresh, stale};
use xtask::folder::figures_folder;

#[test]
fn committed_figures_are_up_to_date() {
    assert_eq!(stale(&figures_folder()).unwrap(), Vec::<String>::new());
}

/// A copy of the committed figures of one name, in a folder that is removed on drop.
struct Copy(PathBuf);

impl Copy {
    fn of(name: &str, label: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("asperity-{label}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        for ending in ["csv", "svg"] {
            let file = format!("{name}.{ending}");
            fs::copy(figures_folder().join(&file), folder.join(&file)).unwrap();
        }
        Self(folder)
    }

    fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The text with every number multiplied by 1 + `change`.
fn perturbed(text: &str, change: f64) -> String {
    let field = |field: &str| match field.parse::<f64>() {
        Ok(number) => format!("{:e}", number * (1.0 + change)),
        Err(_) => field.to_owned(),
    };
    let lines = text.lines().map(|line| line.split(',').map(field).collect::<Vec<_>>().join(","));
    lines.collect::<Vec<_>>().join("\n") + "\n"
}

#[test]
fn the_guard_fails_at_1e_6_and_passes_at_1e_12() {
    let name = "fig07-area-models";
    let copy = Copy::of(name, "guard");
    let csv = copy.path().join(format!("{name}.csv"));
    let committed = fs::read_to_string(&csv).unwrap();
    let figure = FIGURES.iter().find(|figure| figure.0 == name).unwrap();
    let made = |text: &str| {
        fs::write(&csv, text).unwrap();
        fresh(copy.path(), figure).unwrap().map(|(_, text)| text)
    };
    assert_ne!(made(&perturbed(&committed, 1e-6))[0], perturbed(&committed, 1e-6));
    // The csv may stay unchanged; a picture is drawn from its exact text.
    let nudged = perturbed(&committed, 1e-12);
    assert_eq!(made(&nudged)[0], nudged);
    let svg = fs::read_to_string(copy.path().join(format!("{name}.svg"))).unwrap();
    assert_eq!(made(&committed), [committed, svg]);
}
