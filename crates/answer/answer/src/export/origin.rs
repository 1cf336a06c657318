//! Where a table is from, in its comments.

use asperity::{At, Best, ContactEngine, Described, Model, Quantity};

use super::{ContactNode, Export};
use crate::number::rounded;

impl Export<'_> {
    /// Program and model.
    pub(super) fn title(&self) -> String {
        format!("asperity {}, model {}", env!("CARGO_PKG_VERSION"), self.subject.model.id())
    }

    /// Lines about the scene: what is in contact, its files with their checksums, its warnings, the
    /// plane of the asperities, and of `best` what its intervals are.
    pub(super) fn origin(&self, sign: &str, nodes: &[ContactNode]) -> String {
        let file = self.subject.file;
        let area = rounded(1e4 * file.scene.nominal_area);
        let mut lines = vec![format!(
            "scene {}: {}, nominal area {area} cm2",
            self.subject.name,
            file.in_words()
        )];
        for path in file.files() {
            // A file that is gone since has no checksum.
            if let Ok(bytes) = std::fs::read(path) {
                lines.push(format!("file {}, md5 {:x}", path.display(), md5::compute(bytes)));
            }
        }
        let found = crate::scene_findings(file, self.subject.model.validity().asperities);
        let codes: Vec<&str> = found.iter().map(|one| one.code.name()).collect();
        if !codes.is_empty() {
            lines.push(format!("warnings of the scene: {}", crate::once(&codes).join(", ")));
        }
        let offset = rounded(file.scene.mean_plane_offset());
        lines.push(format!(
            "the mean plane of the asperities is {offset} m above that of the surface"
        ));
        lines.extend(self.known(nodes));
        let lines = lines.into_iter().map(|line| format!("{sign} {line}\n"));
        lines.collect()
    }

    /// What stands behind the numbers of `best` in the middle of a table.
    fn known(&self, nodes: &[ContactNode]) -> Option<String> {
        let middle = nodes.get(nodes.len() / 2)?;
        if self.subject.model.id() != Best::<Model>::ID {
            return None;
        }
        let file = self.subject.file;
        let best = file.best().on(&file.scene, self.subject.tolerance).ok()?;
        let at = At::Pressure(middle.pressure);
        let of = crate::basis(&best, &[Quantity::Tangent], at);
        let ends = best.interval_at(None, at).map_or_else(String::new, |gap| {
            let [low, high] = [gap.lower, gap.upper].map(rounded);
            format!("; mean gap there {low} to {high} m")
        });
        Some(format!("at {} Pa by {}{ends}", rounded(middle.pressure), of.by))
    }
}
