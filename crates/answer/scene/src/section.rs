//! Sections some of whose keys stand in a table of the program: properties of bodies, options of models.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, Visitor};

/// A section with keys that are known only when the program runs.
pub(super) trait Section: Default {
    /// The section, as errors name it.
    const WANTED: &'static str;

    /// Returns every key, in the order of messages.
    fn keys() -> &'static [&'static str];

    /// Reads the value of a key, which comes next.
    fn read<'de, A: MapAccess<'de>>(&mut self, key: &str, values: &mut A) -> Result<(), A::Error>;

    /// Returns a key that is needed and missing.
    fn missing(&self) -> Option<&'static str> {
        None
    }
}

pub(super) fn read_section<'de, S: Section, D: Deserializer<'de>>(deserializer: D) -> Result<S, D::Error> {
    deserializer.deserialize_map(Reader(S::default()))
}

struct Reader<S>(S);

impl<'de, S: Section> Visitor<'de> for Reader<S> {
    type Value = S;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(S::WANTED)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut values: A) -> Result<S, A::Error> {
        let Reader(mut section) = self;
        while let Some(key) = values.next_key_seed(KnownKey(S::keys()))? {
            section.read(key, &mut values)?;
        }
        section.missing().map_or(Ok(section), |key| Err(A::Error::missing_field(key)))
    }
}

/// A key out of these. It refuses others while the reader is at the key, so that the error gets its place.
struct KnownKey(&'static [&'static str]);

impl<'de> DeserializeSeed<'de> for KnownKey {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, key: D) -> Result<&'static str, D::Error> {
        key.deserialize_identifier(self)
    }
}

impl Visitor<'_> for KnownKey {
    type Value = &'static str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a key")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<&'static str, E> {
        let known = self.0.iter().find(|known| **known == key);
        known.copied().ok_or_else(|| E::unknown_field(key, self.0))
    }
}
