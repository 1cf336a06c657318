//! Options of the models: one door for scene files, keywords and command lines.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use asperity::{
    AbdoFarhang, AminiTehrani, AngleDensity, Displacement, FlowPressure, ForceComponent, Gao,
    GeometricHardness, JacksonGreen, LateralOptions, Model, Reading, Stick,
};
use serde::{Deserialize, Serialize};

use crate::words::{Words, meaning, nearest, quoted, shortened};
use crate::{Place, SceneError};

/// What the ids `jg`, `af`, `gao` and `at` stand for; the defaults are the models' own.
///
/// As a scene file's `[options]`, as keywords and in serde formats, it is a map from the names
/// [`NAMES`](Self::NAMES) to [`OptionValue`]s, each of which may be left out.
///
/// ```
/// use asperity_scene::ModelOptions;
///
/// let mut options = ModelOptions::default();
/// options.set("at_reading", &"additive".into())?;
/// options.set("displacement", &"zeta=0.1, xi=0.1".parse()?)?;
/// assert_eq!(options.model("at")?.name(), "AT additive");
/// let mistyped = options.set("at_reading", &"aditive".into()).unwrap_err();
/// assert!(mistyped.to_string().contains("did you mean \"additive\"?"));
/// # Ok::<(), asperity_scene::SceneError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(into = "BTreeMap<String, OptionValue>", try_from = "BTreeMap<String, OptionValue>")]
pub struct ModelOptions {
    /// What the id `at` stands for (`at-additive` and `at-overlap` stand for themselves).
    pub at_reading: Reading,
    /// Angles, displacement, stick and the force's component, of Gao and AT.
    pub lateral: LateralOptions,
    /// What the id `jg` stands for (`jg-cosine` stands for itself).
    pub jg_hardness: GeometricHardness,
    /// The pressure under AF's embedded plastic asperity.
    pub af_flow_pressure: FlowPressure,
}

/// The value of one option: a word, or named numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum OptionValue {
    /// As in `stick = "unlimited"`.
    Word(String),
    /// As in `displacement = { zeta = 0.1, xi = 0.1 }`.
    Numbers(BTreeMap<String, f64>),
}

impl From<&str> for OptionValue {
    fn from(word: &str) -> Self {
        Self::Word(word.into())
    }
}

impl FromStr for OptionValue {
    type Err = SceneError;

    /// Reads a word, or numbers as `zeta=0.1,xi=0.1`.
    fn from_str(text: &str) -> Result<Self, SceneError> {
        if !text.contains('=') {
            return Ok(text.trim().into());
        }
        let number = |pair: &str| {
            let parsed = pair.split_once('=').and_then(|(name, number)| {
                Some((name.trim().to_string(), number.trim().parse().ok()?))
            });
            parsed.ok_or_else(|| SceneError::Value {
                at: Place::field("option").into(),
                found: quoted(pair),
                near: None,
                needed: "name=number".into(),
            })
        };
        text.split(',').map(number).collect::<Result<_, _>>().map(Self::Numbers)
    }
}

impl fmt::Display for OptionValue {
    /// As TOML.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => write!(f, "{word:?}"),
            Self::Numbers(numbers) => {
                let pair = |(name, number): (&String, &f64)| format!("{name} = {number:?}");
                let pairs: Vec<String> = numbers.iter().map(pair).collect();
                write!(f, "{{ {} }}", pairs.join(", "))
            }
        }
    }
}

const READINGS: [(&str, Reading); 3] =
    [("printed", Reading::Printed), ("additive", Reading::Additive), ("overlap", Reading::Overlap)];
const STICKS: [(&str, Stick); 2] = [("clamped", Stick::Clamped), ("unlimited", Stick::Unlimited)];
const FORCES: [(&str, ForceComponent); 2] =
    [("size", ForceComponent::Size), ("vertical", ForceComponent::Vertical)];
const HARDNESSES: [(&str, GeometricHardness); 2] =
    [("2005", GeometricHardness::Original), ("cosine", GeometricHardness::Cosine)];
const FLOW_PRESSURES: [(&str, FlowPressure); 2] =
    [("SH", FlowPressure::PressureFactor), ("H", FlowPressure::Hardness)];
const ANGLES: [(&str, AngleDensity); 1] = [("upright", AngleDensity::Upright)];
const DISPLACEMENTS: [(&str, Displacement); 2] =
    [("vertical", Displacement::Vertical), ("none", Displacement::None)];

impl ModelOptions {
    /// The names of all options.
    pub const NAMES: [&'static str; 7] = [
        "at_reading",
        "angle_density",
        "displacement",
        "stick",
        "force",
        "jg_hardness",
        "af_flow_pressure",
    ];

    /// Sets one option; where that fails, all stay as they were.
    ///
    /// # Errors
    /// [`SceneError::UnknownKey`] and [`SceneError::Value`], with a near match and what is allowed.
    pub fn set(&mut self, name: &str, value: &OptionValue) -> Result<(), SceneError> {
        self.set_at(&Place::field(name), name, value)
    }

    /// The same, for an option that stands in a file.
    pub(crate) fn set_at(
        &mut self,
        at: &Place,
        name: &str,
        value: &OptionValue,
    ) -> Result<(), SceneError> {
        match name {
            "at_reading" => self.at_reading = word(at, value, &READINGS, "")?,
            "stick" => self.lateral.stick = word(at, value, &STICKS, "")?,
            "force" => self.lateral.force = word(at, value, &FORCES, "")?,
            "jg_hardness" => self.jg_hardness = word(at, value, &HARDNESSES, "")?,
            "af_flow_pressure" => self.af_flow_pressure = word(at, value, &FLOW_PRESSURES, "")?,
            "angle_density" => {
                const NUMBERS: &str = "{ a20 = -0.5, a21 = 1.0, b21 = 1.0 }";
                let density = match value {
                    OptionValue::Numbers(given) => {
                        let [a20, a21, b21] = numbers(at, given, ["a20", "a21", "b21"])?;
                        AngleDensity::Harmonic { a20, a21, b21 }
                    }
                    value => word(at, value, &ANGLES, NUMBERS)?,
                };
                let place = |field: &str| at.inside(field);
                density.check().map_err(|error| SceneError::from_contact(error, place))?;
                self.lateral.angle_density = density;
            }
            "displacement" => {
                self.lateral.displacement = match value {
                    OptionValue::Numbers(given) => {
                        let [zeta, xi] = numbers(at, given, ["zeta", "xi"])?;
                        not_negative(at, "zeta", zeta)?;
                        not_negative(at, "xi", xi)?;
                        Displacement::Given { zeta, xi }
                    }
                    value => word(at, value, &DISPLACEMENTS, "{ zeta = 0.1, xi = 0.1 }")?,
                };
            }
            _ => {
                let near = nearest(name, Self::NAMES).map(Into::into);
                let allowed = format!("the options are {}", Self::NAMES.join(", "));
                return Err(SceneError::UnknownKey { at: Box::new(at.clone()), near, allowed });
            }
        }
        Ok(())
    }

    /// The options that differ from the defaults, by name.
    #[must_use]
    pub fn changed(&self) -> BTreeMap<String, OptionValue> {
        let (all, defaults) = (self.all(), Self::default().all());
        all.into_iter().filter(|(name, value)| defaults.get(name) != Some(value)).collect()
    }

    fn all(&self) -> BTreeMap<String, OptionValue> {
        let LateralOptions { angle_density, displacement, stick, force } = self.lateral;
        let numbers = |pairs: &[(&str, f64)]| {
            OptionValue::Numbers(pairs.iter().map(|(n, v)| ((*n).to_string(), *v)).collect())
        };
        let angles = match angle_density {
            AngleDensity::Harmonic { a20, a21, b21 } => {
                numbers(&[("a20", a20), ("a21", a21), ("b21", b21)])
            }
            AngleDensity::Upright => "upright".into(),
        };
        let displacement = match displacement {
            Displacement::Given { zeta, xi } => numbers(&[("zeta", zeta), ("xi", xi)]),
            named => spelled(&DISPLACEMENTS, named),
        };
        let values = [
            spelled(&READINGS, self.at_reading),
            angles,
            displacement,
            spelled(&STICKS, stick),
            spelled(&FORCES, force),
            spelled(&HARDNESSES, self.jg_hardness),
            spelled(&FLOW_PRESSURES, self.af_flow_pressure),
        ];
        Self::NAMES.iter().map(|name| (*name).to_string()).zip(values).collect()
    }

    /// The model of an id, with these options.
    ///
    /// # Errors
    /// [`SceneError::Contact`] for an unknown id, with a near match and all ids.
    pub fn model(&self, id: &str) -> Result<Model, SceneError> {
        let at = |reading| Model::new(AminiTehrani { reading, options: self.lateral });
        let jg = |hardness| Model::new(JacksonGreen { hardness });
        let known: Model = id
            .parse()
            .map_err(|source| SceneError::Contact { at: Place::field("model").into(), source })?;
        Ok(match known.id() {
            "jg" => jg(self.jg_hardness),
            "jg-cosine" => jg(GeometricHardness::Cosine),
            "af" => Model::new(AbdoFarhang { flow_pressure: self.af_flow_pressure }),
            "gao" => Model::new(Gao { options: self.lateral }),
            "at" => at(self.at_reading),
            "at-additive" => at(Reading::Additive),
            "at-overlap" => at(Reading::Overlap),
            _ => known,
        })
    }

    /// Every model with these options, each once: where `jg_hardness` or `at_reading` make `jg` or
    /// `at` stand for a model with an id of its own, that one takes the place of the other.
    #[must_use]
    pub fn models(&self) -> Vec<Model> {
        let mut models: Vec<Model> = vec![];
        for known in Model::all() {
            let model = self.model(known.id()).unwrap_or(known);
            if !models.iter().any(|m| m.id() == model.id()) {
                models.push(model);
            }
        }
        models
    }
}

impl From<ModelOptions> for BTreeMap<String, OptionValue> {
    fn from(options: ModelOptions) -> Self {
        options.all()
    }
}

impl TryFrom<BTreeMap<String, OptionValue>> for ModelOptions {
    type Error = SceneError;

    fn try_from(values: BTreeMap<String, OptionValue>) -> Result<Self, SceneError> {
        let mut options = Self::default();
        values.iter().try_for_each(|(name, value)| options.set(name, value))?;
        Ok(options)
    }
}

fn spelled<T: PartialEq>(words: &[(&str, T)], value: T) -> OptionValue {
    words.iter().find(|(_, v)| *v == value).map_or("", |(word, _)| *word).into()
}

fn word<T: Copy>(
    at: &Place,
    value: &OptionValue,
    words: &Words<'_, T>,
    or: &str,
) -> Result<T, SceneError> {
    let word = match value {
        OptionValue::Word(word) => Ok(word.as_str()),
        numbers => Err(shortened(&numbers.to_string()).into_owned()),
    };
    meaning(at, word, words, or)
}

fn numbers<const N: usize>(
    at: &Place,
    given: &BTreeMap<String, f64>,
    names: [&str; N],
) -> Result<[f64; N], SceneError> {
    if let Some(unknown) = given.keys().find(|name| !names.contains(&name.as_str())) {
        let near = nearest(unknown, names).map(Into::into);
        let allowed = format!("the keys here are {}", names.join(", "));
        return Err(SceneError::UnknownKey { at: at.inside(&shortened(unknown)), near, allowed });
    }
    let mut values = [0.0; N];
    for (value, name) in values.iter_mut().zip(names) {
        let needed = || format!("{} needs {}", at.field, names.join(", "));
        let missing = || SceneError::Missing { at: at.inside(name), needed: needed() };
        *value = *given.get(name).ok_or_else(missing)?;
    }
    Ok(values)
}

fn not_negative(at: &Place, name: &str, value: f64) -> Result<(), SceneError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(());
    }
    let at = at.inside(name);
    let (found, needed) = (format!("{value:?}"), "a finite number, at least 0,".into());
    Err(SceneError::Value { at, found, near: None, needed })
}
