//! The reader of scenes: values of TOML with their places, and errors as data.

use serde::de::{
    DeserializeSeed, Deserializer, Error, Expected, IntoDeserializer, MapAccess, SeqAccess, Unexpected,
    Visitor,
};
use serde_spanned::Spanned;
use serde_spanned::de::{SpannedDeserializer, is_spanned};
use toml::de::{DeString, DeTable, DeValue};

use super::error::{SceneError, SceneProblem};
use super::spelling::meant;

/// Names that serde has for types, and the words that a person would write for them.
const WANTED: [(&str, &str); 6] = [
    ("f64", "a number"),
    ("i64", "a whole number"),
    ("u32", "a whole number from 0 on"),
    ("a string", "text in quotes"),
    ("a boolean", "true or false"),
    ("a sequence", "a list in brackets"),
];

/// Reads the text of a scene.
pub(super) fn read<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, SceneError> {
    let parsed = DeTable::parse(text).map_err(|error| SceneError {
        problem: SceneProblem::Text(error.message().to_owned()),
        span: error.span(),
    })?;
    let span = parsed.span();
    T::deserialize(Node(&Spanned::new(span, DeValue::Table(parsed.into_inner()))))
}

/// Returns the keys of a section, in the order of messages.
pub(super) fn keys<T: serde::de::DeserializeOwned>() -> Vec<String> {
    let mut nobody = DeTable::new();
    nobody.insert(Spanned::new(0..0, "".into()), Spanned::new(0..0, DeValue::Boolean(true)));
    match T::deserialize(Node(&Spanned::new(0..0, DeValue::Table(nobody)))) {
        Err(SceneError { problem: SceneProblem::UnknownKey { known, .. }, .. }) => known,
        _ => Vec::new(),
    }
}

impl Error for SceneError {
    fn custom<M: std::fmt::Display>(message: M) -> Self {
        SceneError::anywhere(message.to_string())
    }

    fn invalid_type(found: Unexpected<'_>, wanted: &dyn Expected) -> Self {
        let wanted = wanted.to_string();
        let words = WANTED.iter().find(|(name, _)| *name == wanted).map(|(_, words)| (*words).to_owned());
        let found = found.to_string().replace('`', "");
        SceneError::anywhere(SceneProblem::WrongType { found, wanted: words.unwrap_or(wanted) })
    }

    /// A text that cannot be read, with what is wrong with it, or a number out of bounds.
    fn invalid_value(found: Unexpected<'_>, wanted: &dyn Expected) -> Self {
        let Unexpected::Other(text) = found else { return Self::invalid_type(found, wanted) };
        let (value, problem) = (text.to_owned(), wanted.to_string());
        SceneError::anywhere(SceneProblem::Value { key: String::new(), value, problem })
    }

    fn unknown_field(key: &str, known: &'static [&'static str]) -> Self {
        let (known, meant) = names(key, known);
        SceneError::anywhere(SceneProblem::UnknownKey { key: key.to_owned(), known, meant })
    }

    fn unknown_variant(value: &str, known: &'static [&'static str]) -> Self {
        let (known, meant) = names(value, known);
        SceneError::anywhere(SceneProblem::UnknownValue { value: value.to_owned(), known, meant })
    }

    fn missing_field(key: &'static str) -> Self {
        SceneError::anywhere(SceneProblem::MissingKey { key: key.to_owned() })
    }
}

fn names(given: &str, known: &[&str]) -> (Vec<String>, Option<String>) {
    let meant = meant(given, known.iter().copied()).map(str::to_owned);
    (known.iter().map(|name| (*name).to_owned()).collect(), meant)
}

/// A value and its place. Errors get the place of the innermost value that they concern.
struct Node<'n>(&'n Spanned<DeValue<'n>>);

impl<'de> Deserializer<'de> for Node<'_> {
    type Error = SceneError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, SceneError> {
        let overflows = |text: &str| SceneError::custom(format!("the number {text} is too large"));
        let found = match self.0.get_ref() {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Boolean(truth) => visitor.visit_bool(*truth),
            DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
                Ok(number) => visitor.visit_i64(number),
                Err(_) => Err(overflows(number.as_str())),
            },
            DeValue::Float(number) => match number.as_str().parse::<f64>() {
                Ok(value) if value.is_finite() || number.as_str().contains(['i', 'n']) => {
                    visitor.visit_f64(value)
                }
                _ => Err(overflows(number.as_str())),
            },
            DeValue::Datetime(date) => visitor.visit_str(&date.to_string()),
            DeValue::Array(values) => visitor.visit_seq(Elements(values.iter())),
            DeValue::Table(table) => visitor.visit_map(Entries { rest: table.iter(), entry: None }),
        };
        found.map_err(|error| error.or_at(self.0.span()))
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, SceneError> {
        visitor.visit_some(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, SceneError> {
        if is_spanned(name) {
            let span = self.0.span();
            return visitor.visit_map(SpannedDeserializer::new(self, span));
        }
        self.deserialize_any(visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, SceneError> {
        match self.0.get_ref() {
            DeValue::String(text) => visitor
                .visit_enum(IntoDeserializer::<SceneError>::into_deserializer(text.as_ref()))
                .map_err(|error| error.or_at(self.0.span())),
            _ => self.deserialize_any(visitor),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct newtype_struct
        seq tuple tuple_struct map identifier ignored_any
    }
}

impl IntoDeserializer<'_, SceneError> for Node<'_> {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// The values of a list.
struct Elements<'n>(std::slice::Iter<'n, Spanned<DeValue<'n>>>);

impl<'de> SeqAccess<'de> for Elements<'_> {
    type Error = SceneError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, SceneError> {
        let Some(value) = self.0.next() else { return Ok(None) };
        seed.deserialize(Node(value)).map(Some).map_err(|error| error.or_at(value.span()))
    }
}

/// The keys of a table and their values.
struct Entries<'n, I> {
    rest: I,
    entry: Option<(&'n str, &'n Spanned<DeValue<'n>>)>,
}

impl<'de, 'n, I> MapAccess<'de> for Entries<'n, I>
where
    I: Iterator<Item = (&'n Spanned<DeString<'n>>, &'n Spanned<DeValue<'n>>)>,
{
    type Error = SceneError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, SceneError> {
        let Some((key, value)) = self.rest.next() else { return Ok(None) };
        let name: &str = key.get_ref();
        self.entry = Some((name, value));
        seed.deserialize(IntoDeserializer::<SceneError>::into_deserializer(name))
            .map(Some)
            .map_err(|error| error.or_at(key.span()))
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, SceneError> {
        match self.entry.take() {
            Some((key, value)) => {
                seed.deserialize(Node(value)).map_err(|error| error.or_at(value.span()).below(key))
            }
            None => Err(SceneError::custom("a value is read before its key")),
        }
    }
}
