//! The keys of a scene file as read, to be written again.

use std::path::{Path, PathBuf};

use asperity::{Body, Interface, Surface, TabulatedHeights};
use toml::{Table, Value};

use crate::document::Document;

/// A scene file as read, whose keys are written again if the scene has not changed.
#[derive(Debug)]
pub(crate) struct Read {
    /// The keys in SI units, with absolute paths of scans.
    pub(crate) table: Table,
    pub(crate) interface: Interface,
    pub(crate) bodies: Vec<Body>,
    pub(crate) surface: Surface,
    /// The heights of the summits of a scan.
    pub(crate) summits: Option<TabulatedHeights>,
    /// The scans and the table of heights that the scene names.
    pub(crate) files: Vec<PathBuf>,
}

impl Read {
    pub(crate) fn new(
        document: &Document<'_>,
        (interface, bodies): (Interface, &[Body]),
        surface: Surface,
        heights: Option<&TabulatedHeights>,
    ) -> Self {
        let mut table = document.table.clone();
        let mut named = vec![];
        let mut whole = |path: &mut Value| {
            if let Value::String(text) = path {
                named.push(document.whole_path(Path::new(text)));
                *text = document.whole_path(Path::new(text)).to_string_lossy().into_owned();
            }
        };
        let mut summits = None;
        if let Some(keys) = table.get_mut("surface").and_then(Value::as_table_mut) {
            keys.get_mut("file").into_iter().for_each(&mut whole);
            let files = keys.get_mut("files").and_then(Value::as_array_mut);
            files.into_iter().flatten().for_each(&mut whole);
            for part in ["counterface", "heights"] {
                let file = keys.get_mut(part).and_then(|keys| keys.get_mut("file"));
                file.into_iter().for_each(&mut whole);
            }
            let measured = keys.get("heights").and_then(Value::as_str) == Some("measured");
            summits = heights.filter(|_| measured).cloned();
            // These keys follow from the scene when written.
            for own in ["heights", "separation_from", "mean_plane_offset"] {
                keys.remove(own);
            }
        }
        table.remove("options");
        table.remove("gap");
        Self { table, interface, bodies: bodies.to_vec(), surface, summits, files: named }
    }
}
