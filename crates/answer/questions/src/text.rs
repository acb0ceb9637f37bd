//! Quantities and names as text, for values that have a unit or a name of their own.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};
use study::models::{MODELS, ModelEntry};
use units::Pressure;

/// A pressure with its unit; the digits survive the way there and back.
fn in_words(pressure: &Pressure) -> String {
    match pressure {
        Pressure::Pascals(pa) => format!("{pa} Pa"),
        Pressure::Hardnesses(multiple) => format!("{multiple} H"),
    }
}

pub(crate) mod pressure {
    use super::*;

    pub fn serialize<S: Serializer>(pressure: &Pressure, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&in_words(pressure))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Pressure, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(D::Error::custom)
    }
}

pub(crate) mod optional_pressure {
    use super::*;

    pub fn serialize<S: Serializer>(pressure: &Option<Pressure>, serializer: S) -> Result<S::Ok, S::Error> {
        match pressure {
            Some(pressure) => serializer.serialize_some(&in_words(pressure)),
            None => serializer.serialize_none(),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Pressure>, D::Error> {
        let text = Option::<String>::deserialize(deserializer)?;
        text.map(|text| text.parse()).transpose().map_err(D::Error::custom)
    }
}

pub(crate) mod model {
    use super::*;

    pub fn serialize<S: Serializer>(
        model: &Option<&'static ModelEntry>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        match model {
            Some(model) => serializer.serialize_some(model.name),
            None => serializer.serialize_none(),
        }
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<&'static ModelEntry>, D::Error> {
        let Some(name) = Option::<String>::deserialize(deserializer)? else { return Ok(None) };
        let found = MODELS.iter().find(|entry| entry.name == name);
        found.map(Some).ok_or_else(|| D::Error::custom(format!("no model is called {name}")))
    }
}
