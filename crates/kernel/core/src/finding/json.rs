//! The keys of a finding in json.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::Finding;

impl Serialize for Finding {
    /// Writes code, severity, field, value, usual and message, and if set unit, model, also (other
    /// models with the same finding), quantity, law, at, count and origin.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("code", &self.code)?;
        map.serialize_entry("severity", &self.severity)?;
        map.serialize_entry("field", &self.field)?;
        map.serialize_entry("value", &self.value)?;
        map.serialize_entry("usual", &self.usual)?;
        map.serialize_entry("message", &self.to_string())?;
        if !self.unit.is_empty() {
            map.serialize_entry("unit", self.unit)?;
        }
        if let Some(model) = &self.model {
            map.serialize_entry("model", model)?;
        }
        if !self.also.is_empty() {
            map.serialize_entry("also", &self.also)?;
        }
        if let Some(quantity) = &self.quantity {
            map.serialize_entry("quantity", quantity)?;
        }
        if let Some(law) = &self.law {
            map.serialize_entry("law", law)?;
        }
        if let Some(at) = &self.at {
            map.serialize_entry("at", at)?;
            map.serialize_entry("count", &self.count)?;
        }
        if let Some(origin) = &self.origin {
            map.serialize_entry("origin", origin)?;
        }
        map.end()
    }
}
