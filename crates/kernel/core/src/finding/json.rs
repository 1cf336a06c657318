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
        add(&mut map, "unit", Some(self.unit).filter(|unit| !unit.is_empty()))?;
        add(&mut map, "model", self.model.as_ref())?;
        add(&mut map, "also", Some(&self.also).filter(|also| !also.is_empty()))?;
        add(&mut map, "quantity", self.quantity)?;
        add(&mut map, "law", self.law.as_ref())?;
        add(&mut map, "at", self.at)?;
        add(&mut map, "count", self.at.map(|_| self.count))?;
        add(&mut map, "origin", self.origin.as_ref())?;
        map.end()
    }
}

fn add<M: SerializeMap>(
    map: &mut M,
    key: &str,
    value: Option<impl Serialize>,
) -> Result<(), M::Error> {
    value.map_or(Ok(()), |value| map.serialize_entry(key, &value))
}
