//! Options of models: written, read and changed by name.

use std::fmt;
use std::sync::Arc;

use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

use super::{Asperities, Model};
use crate::{ContactError, ContactModel, Described};

/// A model with options that can be written and read.
pub(super) trait Configurable: fmt::Debug + Send + Sync {
    /// All options, with their values.
    fn options(&self) -> Value;
    /// The same model with these options in place of its own.
    fn with(&self, options: &Map<String, Value>) -> Result<Model, serde_json::Error>;
}

impl<M: ContactModel + Serialize + DeserializeOwned + 'static> Configurable for M {
    fn options(&self) -> Value {
        // A unit struct has none.
        match serde_json::to_value(self) {
            Ok(Value::Object(options)) => Value::Object(options),
            _ => Value::Object(Map::new()),
        }
    }

    fn with(&self, options: &Map<String, Value>) -> Result<Model, serde_json::Error> {
        if options.is_empty() && serde_json::to_value(self)?.is_null() {
            return Ok(Model::known(serde_json::from_value::<M>(Value::Null)?));
        }
        let Value::Object(mut all) = self.options() else {
            return Err(serde_json::Error::custom("the options are not a map"));
        };
        for (name, value) in options {
            if !all.contains_key(name) {
                let known: Vec<&str> = all.keys().map(String::as_str).collect();
                return Err(unknown_option(self.id(), name, &known));
            }
            all.insert(name.clone(), value.clone());
        }
        Ok(Model::known(serde_json::from_value::<M>(Value::Object(all))?))
    }
}

/// Options of the laws on other asperities than equal ones.
#[derive(Debug)]
pub(super) struct Rearranged {
    pub(super) equal: Arc<Model>,
    pub(super) asperities: Asperities,
}

impl Configurable for Rearranged {
    fn options(&self) -> Value {
        self.equal.options().unwrap_or_default()
    }

    fn with(&self, options: &Map<String, Value>) -> Result<Model, serde_json::Error> {
        let equal = self.equal.with_options(options).map_err(serde_json::Error::custom)?;
        Ok(equal.on(self.asperities))
    }
}

fn unknown_option(id: &str, name: &str, known: &[&str]) -> serde_json::Error {
    let listed = if known.is_empty() { "it has none".into() } else { known.join(", ") };
    serde_json::Error::custom(format!("{id} has no option {name:?}: {listed}"))
}

impl Model {
    /// All options with their values; `None` for a model of your own.
    #[must_use]
    pub fn options(&self) -> Option<Value> {
        self.known.as_ref().map(|known| known.options())
    }

    /// The same model with these options in place of its own.
    ///
    /// # Errors
    /// [`ContactError::Refused`] naming the option that the model does not have, or its value.
    pub fn with_options(&self, options: &Map<String, Value>) -> Result<Self, ContactError> {
        let refused = |reason: String| ContactError::Refused { model: self.id().into(), reason };
        match &self.known {
            Some(known) => known.with(options).map_err(|error| refused(error.to_string())),
            None if options.is_empty() => Ok(self.clone()),
            None => Err(refused("its options are not known".into())),
        }
    }
}

/// `{"id": .., "options": {..}}`.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    id: String,
    #[serde(default)]
    options: Map<String, Value>,
}

impl Serialize for Model {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.options() {
            Some(Value::Object(options)) => {
                Written { id: self.id().into(), options }.serialize(serializer)
            }
            _ => {
                Err(serde::ser::Error::custom(format!("{}: its options are not known", self.id())))
            }
        }
    }
}

impl<'de> Deserialize<'de> for Model {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Written { id, options } = Written::deserialize(deserializer)?;
        let model = id.parse::<Self>().and_then(|model| model.with_options(&options));
        model.map_err(D::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_model_goes_to_its_id_and_options_and_back() {
        for model in Model::all() {
            let text = serde_json::to_string(&model).unwrap();
            let back: Model = serde_json::from_str(&text).unwrap();
            assert_eq!((back.id(), back.options()), (model.id(), model.options()), "{text}");
            assert_eq!(format!("{back:?}"), format!("{model:?}"));
        }
        let refused = |text: &str| serde_json::from_str::<Model>(text).unwrap_err().to_string();
        let message = refused(r#"{"id": "gao", "options": {"sitck": "clamped"}}"#);
        assert!(message.contains("\"sitck\"") && message.contains("stick"));
        let message = refused(r#"{"id": "gao", "options": {"stick": "loose"}}"#);
        assert!(message.contains("loose") && message.contains("clamped"), "{message}");
        let message = refused(r#"{"id": "ke", "options": {"stick": "clamped"}}"#);
        assert!(message.contains("\"stick\""), "{message}");
    }
}
