//! The chapters of the guide, in the order of its contents.

use super::laws::Laws;
use super::source::Part;

/// One page of the guide.
pub struct Chapter {
    /// The name of its file, without `.html`.
    pub slug: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The files that it shows, one after the other.
    pub parts: &'static [(&'static str, Part)],
    /// Whether `w_c` and `x^2` in its text are an index and a power.
    pub equations: bool,
    /// What stands between or behind the parts.
    pub extra: Extra,
}

/// What a chapter has beside its text.
pub enum Extra {
    /// Nothing.
    None,
    /// The laws of a model, drawn before its range of validity.
    Laws(Laws),
    /// The list of models.
    Models,
    /// All figures.
    Figures,
}

/// Chapters under one heading of the contents.
pub struct Group {
    /// The heading.
    pub title: &'static str,
    /// The chapters.
    pub chapters: &'static [Chapter],
}

const fn text(
    slug: &'static str,
    title: &'static str,
    parts: &'static [(&'static str, Part)],
) -> Chapter {
    Chapter { slug, title, parts, equations: true, extra: Extra::None }
}

const fn model(
    slug: &'static str,
    title: &'static str,
    parts: &'static [(&'static str, Part)],
    laws: Laws,
) -> Chapter {
    Chapter { extra: Extra::Laws(laws), ..text(slug, title, parts) }
}

use Part::{Code, Head, Section, Whole};

/// All chapters.
pub const GROUPS: &[Group] = &[
    Group {
        title: "Start",
        chapters: &[
            text("index", "Start here", &[("crates/asperity-web/guide/start.md", Whole)]),
            text("page", "The page", &[("crates/asperity-web/guide/page.md", Whole)]),
            text("inputs", "What to enter", &[("crates/asperity-web/guide/inputs.md", Whole)]),
            text(
                "scan-to-stiffness",
                "From scan to stiffness",
                &[
                    ("crates/asperity-web/guide/scan-to-stiffness.md", Whole),
                    ("crates/asperity-cli/README.md", Section("A measured surface")),
                ],
            ),
            text(
                "which-model",
                "Which model",
                &[
                    ("crates/asperity-web/guide/which-model.md", Whole),
                    ("crates/asperity-cli/README.md", Section("Which model is accurate enough?")),
                ],
            ),
        ],
    },
    Group {
        title: "Topics",
        chapters: &[
            text(
                "joints",
                "Joints: stiffness, cycles, slip",
                &[
                    ("crates/asperity-web/guide/joints.md", Whole),
                    ("crates/asperity-cli/README.md", Section("A bolted joint")),
                    ("crates/asperity-joints/src/lib.rs", Head),
                ],
            ),
            text(
                "conductance",
                "Thermal and electrical conductance",
                &[
                    ("crates/asperity-web/guide/conductance.md", Whole),
                    ("crates/asperity-joints/src/conductance.rs", Head),
                ],
            ),
            text(
                "boundary-elements",
                "Boundary elements",
                &[("crates/asperity-web/guide/boundary-elements.md", Whole)],
            ),
            text(
                "fit",
                "From measurements to a scene",
                &[
                    ("crates/asperity-cli/README.md", Section("From measurements to a scene")),
                    ("crates/asperity-fit/README.md", Whole),
                ],
            ),
            text("limits", "Limits", &[("crates/asperity-web/guide/limits.md", Whole)]),
            text(
                "accuracy",
                "Accuracy and speed",
                &[("crates/asperity-web/guide/accuracy.md", Whole)],
            ),
            Chapter {
                extra: Extra::Figures,
                ..text("figures", "Figures", &[("figures/README.md", Whole)])
            },
        ],
    },
    Group {
        title: "Reference",
        chapters: &[
            text("definitions", "Definitions", &[("crates/asperity/DEFINITIONS.md", Whole)]),
            text(
                "scene-files",
                "Scene files",
                &[
                    ("crates/asperity-inputs/README.md", Whole),
                    ("crates/asperity-web/guide/scene-template.md", Whole),
                    ("crates/asperity-inputs/src/template.toml", Code("toml")),
                ],
            ),
            text(
                "surface-files",
                "Files of surfaces",
                &[("crates/asperity-topography/README.md", Whole)],
            ),
            text("program", "The program", &[("crates/asperity-cli/README.md", Whole)]),
            text("python", "Python", &[("crates/asperity-python/README.md", Whole)]),
            text("rust", "Rust", &[("crates/asperity/README.md", Whole)]),
        ],
    },
    Group {
        title: "Models",
        chapters: &[
            Chapter {
                extra: Extra::Models,
                ..text("models", "All models", &[("crates/asperity-web/guide/models.md", Whole)])
            },
            model(
                "gw",
                "Greenwood & Williamson",
                &[("crates/asperity-gw/README.md", Whole)],
                Laws::Of(&["gw"]),
            ),
            model(
                "ceb",
                "Chang, Etsion & Bogy",
                &[("crates/asperity-ceb/README.md", Whole)],
                Laws::Of(&["ceb"]),
            ),
            model(
                "zmc",
                "Zhao, Maietta & Chang",
                &[("crates/asperity-zmc/README.md", Whole)],
                Laws::Of(&["zmc"]),
            ),
            model(
                "ke",
                "Kogut & Etsion",
                &[("crates/asperity-ke/README.md", Whole)],
                Laws::Of(&["ke"]),
            ),
            model(
                "etsion",
                "Etsion, Kligerman & Kadin",
                &[("crates/asperity-etsion/README.md", Whole)],
                Laws::Of(&["etsion"]),
            ),
            model(
                "jg",
                "Jackson & Green",
                &[("crates/asperity-jg/README.md", Whole)],
                Laws::Of(&["jg", "jg-cosine"]),
            ),
            model(
                "af",
                "Abdo & Farhang",
                &[("crates/asperity-af/README.md", Whole)],
                Laws::Of(&["af"]),
            ),
            model(
                "gao",
                "Gao, Fu, Wang and others",
                &[("crates/asperity-gao/README.md", Whole)],
                Laws::Of(&["gao"]),
            ),
            model(
                "at",
                "Amini & Tehrani",
                &[("crates/asperity-at/README.md", Whole)],
                Laws::Of(&["gao", "at"]),
            ),
            model(
                "ghaednia",
                "Ghaednia, Brake, Berryhill & Jackson",
                &[("crates/asperity-ghaednia/README.md", Whole)],
                Laws::Hardening,
            ),
            model(
                "adhesion",
                "Adhesion: DMT and JKR",
                &[("crates/asperity-adhesion/README.md", Whole)],
                Laws::Adhesion,
            ),
            model(
                "random",
                "Asperities of a random surface",
                &[("crates/asperity-random/README.md", Whole)],
                Laws::ElasticArea,
            ),
            model(
                "persson",
                "Persson's theory",
                &[("crates/asperity-persson/README.md", Whole)],
                Laws::ElasticArea,
            ),
            text(
                "add-a-model",
                "Add a model",
                &[
                    ("crates/asperity-web/guide/add-a-model.md", Whole),
                    ("crates/asperity/examples/own_model.rs", Head),
                    ("crates/asperity/examples/own_model.rs", Code("rust")),
                ],
            ),
        ],
    },
    Group {
        title: "Project",
        chapters: &[
            text(
                "integrals",
                "Integrals and roots",
                &[("crates/asperity-quadrature/README.md", Whole)],
            ),
            text(
                "benches",
                "What the benches measure",
                &[("crates/asperity-bench/README.md", Whole)],
            ),
            text(
                "measured-speed",
                "Speed against error, measured",
                &[("figures/speed-vs-error.md", Whole)],
            ),
            text(
                "measured-models",
                "Models beside boundary elements",
                &[("figures/truth.md", Whole)],
            ),
            text("contributing", "Contributing", &[(".github/CONTRIBUTING.md", Whole)]),
            text("changes", "Changes", &[("crates/asperity/CHANGELOG.md", Whole)]),
            text("cite", "How to cite", &[("crates/asperity-web/guide/cite.md", Whole)]),
        ],
    },
];

/// All chapters, in order.
pub fn all() -> impl Iterator<Item = &'static Chapter> {
    GROUPS.iter().flat_map(|group| group.chapters)
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::{Described, Model};

    #[test]
    fn every_crate_with_a_law_has_a_chapter() {
        let laws = std::fs::read_dir(super::super::source::root().join("crates")).unwrap();
        let readmes: Vec<String> = laws
            .map(|entry| entry.unwrap().path().join("README.md"))
            .filter(|path| {
                std::fs::read_to_string(path).is_ok_and(|text| text.contains("\n## Law\n"))
            })
            .map(|path| {
                let name = path.parent().unwrap().file_name().unwrap().to_str().unwrap();
                format!("crates/{name}/README.md")
            })
            .collect();
        assert!(readmes.len() > 10, "{readmes:?}");
        for readme in readmes {
            let shown = all().any(|chapter| {
                matches!(chapter.extra, Extra::Laws(_)) && chapter.parts[0].0 == readme
            });
            assert!(shown, "{readme} has no chapter with its laws");
        }
        for model in Model::all() {
            let stem = model.id().split('-').next().unwrap();
            assert!(all().any(|chapter| chapter.slug == stem), "{model} has no chapter");
        }
    }
}
