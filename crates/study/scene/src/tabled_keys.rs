//! Sections that have the keys of a table besides their own: options of models, properties of bodies.

use std::fmt;
use std::marker::PhantomData;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeSeed, Deserializer, Error, IntoDeserializer, MapAccess, Visitor};

/// The keys of a table that a section has.
pub(super) trait TabledKeys: Default {
    /// Returns true if the table has a key.
    fn has(key: &str) -> bool;

    /// Reads the value of a key that the table has.
    fn read<'de, D: Deserializer<'de>>(&mut self, key: &str, value: D) -> Result<(), D::Error>;
}

/// Reads a section: its own keys, and those of a table. `fields` are the keys of both.
pub(super) fn read_section<'de, K, T, D>(
    deserializer: D,
    name: &'static str,
    fields: &'static [&'static str],
) -> Result<(K, T), D::Error>
where
    K: Deserialize<'de>,
    T: TabledKeys,
    D: Deserializer<'de>,
{
    deserializer.deserialize_struct(name, fields, Section { name, fields, of: PhantomData })
}

struct Section<K, T> {
    name: &'static str,
    fields: &'static [&'static str],
    of: PhantomData<(K, T)>,
}

impl<'de, K: Deserialize<'de>, T: TabledKeys> Visitor<'de> for Section<K, T> {
    type Value = (K, T);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "struct {}", self.name)
    }

    fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Self::Value, A::Error> {
        let mut table = T::default();
        let own = OwnKeys { keys, fields: self.fields, table: &mut table };
        let own = K::deserialize(MapAccessDeserializer::new(own))?;
        Ok((own, table))
    }
}

/// The keys of a section but for those of the table, which is filled on the way.
struct OwnKeys<'t, A, T> {
    keys: A,
    fields: &'static [&'static str],
    table: &'t mut T,
}

impl<'de, A: MapAccess<'de>, T: TabledKeys> MapAccess<'de> for OwnKeys<'_, A, T> {
    type Error = A::Error;

    fn next_key_seed<S: DeserializeSeed<'de>>(&mut self, mut seed: S) -> Result<Option<S::Value>, A::Error> {
        loop {
            let next = NextKey { seed, fields: self.fields, table: PhantomData::<T> };
            match self.keys.next_key_seed(next)? {
                None => return Ok(None),
                Some(Key::Own(key)) => return Ok(Some(key)),
                Some(Key::Tabled(key, unused)) => {
                    self.keys.next_value_seed(TabledValue { key, table: self.table })?;
                    seed = unused;
                }
            }
        }
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, A::Error> {
        self.keys.next_value_seed(seed)
    }
}

/// A key of a section, with its unused seed if it is one of the table.
enum Key<S, V> {
    Own(V),
    Tabled(String, S),
}

struct NextKey<S, T> {
    seed: S,
    fields: &'static [&'static str],
    table: PhantomData<T>,
}

impl<'de, S: DeserializeSeed<'de>, T: TabledKeys> DeserializeSeed<'de> for NextKey<S, T> {
    type Value = Key<S, S::Value>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<'de, S: DeserializeSeed<'de>, T: TabledKeys> Visitor<'de> for NextKey<S, T> {
    type Value = Key<S, S::Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a key")
    }

    // Unknown keys are refused here, where the error gets the place of the key.
    fn visit_str<E: Error>(self, key: &str) -> Result<Self::Value, E> {
        if !self.fields.contains(&key) {
            return Err(E::unknown_field(key, self.fields));
        }
        match T::has(key) {
            true => Ok(Key::Tabled(key.to_owned(), self.seed)),
            false => self.seed.deserialize(key.into_deserializer()).map(Key::Own),
        }
    }
}

struct TabledValue<'t, T> {
    key: String,
    table: &'t mut T,
}

impl<'de, T: TabledKeys> DeserializeSeed<'de> for TabledValue<'_, T> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, value: D) -> Result<(), D::Error> {
        self.table.read(&self.key, value)
    }
}
