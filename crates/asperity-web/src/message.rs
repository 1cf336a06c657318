//! Messages to the desk and its answers, in json.

use std::collections::BTreeMap;

use asperity::Quantity;
use serde::{Deserialize, Serialize};

use crate::dialect::FindingShown;
use crate::link::PageState;
use crate::random::RandomKeys;
use crate::refusal::Refusal;

/// What the page asks.
#[derive(Debug, Deserialize)]
#[serde(tag = "call", rename_all = "kebab-case")]
pub(crate) enum Message {
    /// Reads the text of a scene, which is the scene of later messages.
    Show { text: String },
    /// The text of an example that was changed.
    Changed { text: String },
    /// The text with other values.
    Edit { text: String, changes: Vec<Change> },
    /// The fields of the form.
    Form,
    /// The materials of the list.
    Materials,
    /// The text with another material of a body, or with the numbers of its material.
    Material { text: String, body: usize, changes: Vec<Change> },
    /// The text with the surface described in another way.
    Surface { text: String, way: String },
    /// The text whose surface is a file that was handed over.
    UseScan { text: String, name: String },
    /// Whether a file of this size \[bytes\] can be handed over, before its bytes are read.
    Admit { name: String, size: u64 },
    /// Whether a file that was handed over can be the surface of a scene, in place of the scan of
    /// the scene `kept`, if that has values.
    Usable { name: String, kept: Option<String> },
    /// Makes a random surface and hands it over.
    Random { keys: RandomKeys },
    /// The values of models at one load.
    Answer { models: Vec<String>, load: LoadKeys },
    /// The rows of models at the loads of the picture.
    Curve { models: Vec<String> },
    /// The picture of rows.
    Draw { rows: Vec<String>, view: String, load: LoadKeys, solved: Vec<[f64; 2]> },
    /// The map and the numbers of the scan.
    Scan,
    /// Findings at a load.
    Check { models: Vec<String>, load: LoadKeys },
    /// Which model to trust, and how far the models are from a load that was solved.
    Advise { load: LoadKeys, solved: Option<OnScreen> },
    /// A table for a finite-element program.
    Export { model: String, form: String, units: String },
    /// The same calculation in a shell, in Python and in Rust.
    Code { models: Vec<String>, load: LoadKeys },
    /// The law of one asperity.
    Law { model: String },
    /// The link of a state of the page.
    Link { state: PageState },
    /// The state of a link.
    Unlink { link: String },
}

/// A new value of a key; none removes the key.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Change {
    /// `surface.m0`, `body[2].hardness`.
    pub(crate) path: String,
    pub(crate) value: Option<String>,
}

/// A load as typed, or as the place of the slider from 0 to 1.
#[derive(Debug, Clone, Default, Deserialize)]
pub(crate) struct LoadKeys {
    #[serde(default)]
    pub(crate) text: String,
    #[serde(default)]
    pub(crate) position: Option<f64>,
    /// `N` or `Pa`, of a plain number and of the slider.
    #[serde(default)]
    pub(crate) unit: String,
    /// The unit in which the load is shown, if it is another one.
    #[serde(default)]
    pub(crate) show: Option<String>,
}

/// What boundary elements and models give at the load of the page.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct OnScreen {
    /// Values of boundary elements, by quantity.
    pub(crate) bem: BTreeMap<String, f64>,
    /// Codes of the notes of the solution.
    pub(crate) notes: Vec<String>,
    /// Values of the chosen models, by model and quantity, with all digits.
    pub(crate) models: Vec<(String, BTreeMap<String, String>)>,
}

/// A material of the list.
#[derive(Debug, Serialize)]
pub(crate) struct MaterialShown {
    pub(crate) id: &'static str,
    pub(crate) name: &'static str,
    /// Its numbers.
    pub(crate) shown: String,
    pub(crate) source: &'static str,
}

/// A scene as read.
#[derive(Debug, Serialize)]
pub(crate) struct Shown {
    /// The values of all keys, as typed.
    pub(crate) fields: BTreeMap<String, String>,
    /// How the surface is described.
    pub(crate) way: &'static str,
    /// Names of the files that the text names.
    pub(crate) files: Vec<String>,
    pub(crate) error: Option<Refusal>,
    pub(crate) findings: Vec<FindingShown>,
    /// Derived numbers.
    pub(crate) numbers: Vec<NumberShown>,
    pub(crate) models: Vec<ModelShown>,
    /// The model that tables begin with.
    pub(crate) usual: &'static str,
    /// Those that every scene has, if it has an error.
    pub(crate) views: Vec<View>,
    /// Whether boundary elements can solve the scan.
    pub(crate) scan: Option<ScanShown>,
}

/// A derived number.
#[derive(Debug, Serialize)]
pub(crate) struct NumberShown {
    pub(crate) name: String,
    pub(crate) digits: String,
    pub(crate) shown: String,
    pub(crate) meaning: String,
}

/// A model, and why it cannot be used.
#[derive(Debug, Serialize)]
pub(crate) struct ModelShown {
    pub(crate) id: String,
    pub(crate) name: String,
    /// A sentence about it.
    pub(crate) about: String,
    /// Whether its laws take long to prepare.
    pub(crate) slow: bool,
    /// Whether it describes the whole surface, without a law of one asperity.
    pub(crate) whole: bool,
    pub(crate) reason: Option<String>,
}

/// A quantity that can be drawn.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct View {
    pub(crate) id: String,
    pub(crate) label: String,
    pub(crate) definition: String,
}

/// The scan of a scene.
#[derive(Debug, Serialize)]
pub(crate) struct ScanShown {
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    /// Why boundary elements cannot solve it here.
    pub(crate) refused: Option<String>,
    /// Mean pressures over the range of the slider to solve it at \[Pa\], each with its load in
    /// words.
    pub(crate) pressures: Vec<(f64, String)>,
}

/// The values of models at a load.
#[derive(Debug, Serialize)]
pub(crate) struct Answer {
    pub(crate) load: LoadShown,
    pub(crate) views: Vec<View>,
    /// The head of a csv of model, load, pressure and cells.
    pub(crate) head: String,
    pub(crate) rows: Vec<AnswerRow>,
    /// Warnings of the answers.
    pub(crate) findings: Vec<FindingShown>,
}

/// A load on the scene.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct LoadShown {
    /// As it was typed, with its unit, or the text for the slider.
    pub(crate) text: String,
    /// `N` or `Pa`.
    pub(crate) unit: &'static str,
    pub(crate) newtons: f64,
    pub(crate) pascals: f64,
    /// The load in the other unit.
    pub(crate) other: String,
    /// The place of the slider.
    pub(crate) position: f64,
}

/// The values of a model.
#[derive(Debug, Serialize)]
pub(crate) struct AnswerRow {
    pub(crate) model: String,
    pub(crate) cells: Vec<AnswerCell>,
    /// Why there is no value at all.
    pub(crate) reason: Option<String>,
    /// Why no contact has these values.
    pub(crate) mark: Option<String>,
}

impl AnswerRow {
    /// The row of a model that cannot answer.
    pub(crate) fn without_values(id: &str, reason: &str) -> Self {
        Self { model: id.into(), cells: vec![], reason: Some(reason.into()), mark: None }
    }
}

/// A value, or the reason why there is none.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct AnswerCell {
    pub(crate) quantity: String,
    /// All digits, in SI units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) digits: Option<String>,
    /// Bound on the relative error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bound: Option<f64>,
    pub(crate) shown: String,
}

/// The separation beside the quantities of a view.
pub(crate) const SEPARATION: &str = "separation";

impl View {
    pub(crate) fn of(quantity: Quantity) -> Self {
        let (label, definition) = (quantity.label().into(), quantity.definition().into());
        Self { id: quantity.to_string(), label, definition }
    }

    pub(crate) fn separation(from: asperity::Datum) -> Self {
        let definition = format!("Distance of the surfaces, from {from} to the other surface.");
        Self { id: SEPARATION.into(), label: "separation".into(), definition }
    }
}
