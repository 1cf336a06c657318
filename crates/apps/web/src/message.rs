//! Messages to the desk, in json.

use std::collections::BTreeMap;

use asperity::SolvedContact;
use asperity_answer::solved_contact;
use serde::Deserialize;
use serde_json::{Map, Value};

use crate::answer::{Column, Known, Row};
use crate::random::RandomKeys;
use crate::span::LoadKeys;

/// What the page asks.
#[derive(Debug, Deserialize)]
#[serde(tag = "call", rename_all = "kebab-case")]
pub(crate) enum Message {
    /// Reads the text of a scene, which is the scene of later messages.
    Show { text: String },
    /// The text with other values; `another`: the other surface is not like the first.
    Edit {
        text: String,
        changes: Vec<Change>,
        #[serde(default)]
        another: bool,
    },
    /// The fields of the form, and the materials of its list.
    Form,
    /// The text with the surface described in another way.
    Surface { text: String, way: String },
    /// The text whose surface is a file that was handed over.
    UseScan { text: String, name: String },
    /// Whether a file of this size \[bytes\] can be handed over, before its bytes are read.
    Admit { name: String, size: u64 },
    /// Whether a file, with which a scene has an error, can be its surface with other keys.
    Usable { name: String },
    /// Makes a random surface and hands it over.
    Random { keys: RandomKeys },
    /// The values of models at one load and the answer there, which knows what was solved.
    Answer {
        models: Vec<String>,
        load: LoadKeys,
        #[serde(default)]
        solved: Vec<Solved>,
    },
    /// The rows of models at the loads of the picture.
    Curve { models: Vec<String> },
    /// The picture of rows.
    Draw(Draw),
    /// The numbers of the scan and its pictures.
    Scan,
    /// A table for a finite-element program.
    Export { model: String, form: String, units: String },
    /// The link of a state of the page.
    Link { state: Map<String, Value> },
    /// The state of a link.
    Unlink { link: String },
}

/// Rows of models, of which those outside of their range have no part in the band, with solved
/// points, in a picture of this size in pixels.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Draw {
    pub(crate) rows: Vec<String>,
    pub(crate) view: String,
    pub(crate) load: LoadKeys,
    pub(crate) solved: Vec<[f64; 2]>,
    pub(crate) outside: Vec<String>,
    pub(crate) size: Option<[f64; 2]>,
}

/// A new value of a key; none removes the key.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Change {
    /// `surface.m0`, `body[2].hardness`.
    pub(crate) path: String,
    pub(crate) value: Option<String>,
}

/// What boundary elements gave at a load: values by quantity, with all digits.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct Solved {
    /// Mean pressure \[Pa\].
    pub(crate) pressure: f64,
    pub(crate) values: BTreeMap<String, String>,
    /// Codes of the notes of the solution.
    pub(crate) notes: Vec<String>,
}

/// Why a column has no value.
const NOT_GIVEN: &str = "boundary elements do not give this quantity";

impl Solved {
    /// As an input of the answer.
    pub(crate) fn contact(&self) -> SolvedContact {
        let value = |name: &str| self.values.get(name)?.parse().ok();
        solved_contact(self.pressure, value, &self.notes)
    }

    /// As the row of a model.
    pub(crate) fn row(&self, columns: &[Column]) -> Row {
        let known = |column: &Column| {
            let value = self.values.get(&column.id).and_then(|digits| digits.parse().ok());
            value.map(|value| Known::new(value, true)).ok_or_else(|| NOT_GIVEN.into())
        };
        let cells = columns.iter().map(known).collect();
        Row { model: "bem".into(), cells, ..Row::default() }
    }
}
