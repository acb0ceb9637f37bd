//! Parsers from a typed word to its value.

use std::ffi::OsStr;
use std::num::NonZeroU32;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use study::models::{self, Framework, MODELS, ModelEntry};
use study::plan::Tolerance;
use units::{QuantityError, TypedSpread, without_comma};

use crate::place::Place;

pub(super) fn parse_place(text: &str) -> Result<Place, std::convert::Infallible> {
    Ok(Place::from(text))
}

pub(super) fn parse_count(text: &str) -> Result<NonZeroU32, String> {
    text.parse().map_err(|_| format!("'{text}' must be a whole number from 1 to {}", u32::MAX))
}

/// A Poisson's ratio: one number, and no spread, which is for scenes.
pub(super) fn parse_poisson_ratio(text: &str) -> Result<f64, String> {
    text.parse().map_err(|error: std::num::ParseFloatError| {
        let typed = text.to_owned();
        if TypedSpread::parse(text).is_some() {
            return QuantityError::OneValueWanted { text: typed, what: "Poisson's ratio" }.to_string();
        }
        match without_comma(text) {
            Some(meant) => QuantityError::Comma { text: typed, meant }.to_string(),
            None => error.to_string(),
        }
    })
}

pub(super) fn parse_tolerance(text: &str) -> Result<Tolerance, String> {
    let tolerance = text.parse().map_err(|_| format!("'{text}' is not a number"))?;
    Tolerance::new(tolerance).map_err(|error| error.to_string())
}

/// A parser of the names of a framework's models.
pub(super) fn model_of(framework: Framework) -> impl TypedValueParser<Value = &'static ModelEntry> {
    ModelName(models::of_framework(framework).map(|entry| entry.name).collect())
        .try_map(move |name| models::named(framework, &name))
}

/// A parser of these names of models, and of what else people call the models: reports print their full names.
#[derive(Clone)]
pub(super) struct ModelName(pub Vec<&'static str>);

impl TypedValueParser for ModelName {
    type Value = String;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &OsStr,
    ) -> Result<String, clap::Error> {
        let text = value.to_str().unwrap_or_default();
        let known = MODELS.iter().filter(|entry| self.0.contains(&entry.name));
        match known.into_iter().find(|entry| entry.answers_to(text)) {
            Some(entry) => Ok(entry.name.to_owned()),
            None => PossibleValuesParser::new(self.0.clone()).parse_ref(command, arg, value),
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(PossibleValue::new)))
    }
}

/// A parser of the names that `values` display as.
pub(super) fn one_of<T, E>(values: &'static [T]) -> impl TypedValueParser<Value = T>
where
    T: std::fmt::Display + std::str::FromStr<Err = E> + Clone + Send + Sync + 'static,
    E: std::error::Error + Send + Sync + 'static,
{
    PossibleValuesParser::new(values.iter().map(|value| PossibleValue::new(value.to_string())))
        .try_map(|name| name.parse::<T>())
}
