//! The text of a scene as sections and keys, which are set as values.

use std::fmt;

use serde::Serialize;
use toml_edit::ser::{Error, ValueSerializer};
use toml_edit::{DocumentMut, Item, Table, TomlError};

use super::error::{SceneError, SceneProblem};

/// The text of a scene as sections and keys. What is not set anew stays as it was typed, comments too.
#[derive(Debug, Clone, Default)]
pub struct SceneText(pub(super) DocumentMut);

impl SceneText {
    /// Parses a text, without a look at the keys in it.
    ///
    /// # Errors
    /// [`SceneError`] for a text that is not TOML.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        text.parse().map(SceneText).map_err(|error: TomlError| SceneError {
            problem: SceneProblem::Text(error.message().to_owned()),
            span: error.span(),
        })
    }

    /// Sets a section, or a key by its place, such as `material.poisson_ratio`. Repeated sections are a list of sections.
    ///
    /// # Errors
    /// [`Error`] for a value that TOML cannot hold.
    pub fn set(&mut self, place: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Error> {
        let item = Item::Value(value.serialize(ValueSerializer::new())?);
        let (section, key) =
            place.split_once('.').map_or((place, None), |(section, key)| (section, Some(key)));
        if let Some(key) = key {
            let mut implied = Table::new();
            implied.set_implicit(true);
            let section = self.0.entry(section).or_insert(Item::Table(implied));
            section[key] = if section.is_table() { as_section(item) } else { item };
        } else {
            self.0.insert(section, as_section(item));
        }
        Ok(())
    }

    /// Sets a section anew except for one key, which stays.
    ///
    /// # Errors
    /// [`Error`] for a value that TOML cannot hold.
    pub fn set_except(&mut self, section: &str, value: &impl Serialize, kept: &str) -> Result<(), Error> {
        let old = self.0.get(section).and_then(|section| section.get(kept)).cloned();
        self.set(section, value)?;
        if let Some(old) = old {
            self.0[section][kept] = old;
        }
        Ok(())
    }

    /// Removes a section, or a key by its place.
    pub fn remove(&mut self, place: &str) {
        match place.split_once('.') {
            None => drop(self.0.remove(place)),
            Some((section, key)) => {
                let section = self.0.get_mut(section).and_then(Item::as_table_like_mut);
                section.and_then(|section| section.remove(key));
            }
        }
    }

    /// Returns true if there is a section of this name, or a key at this place.
    #[must_use]
    pub fn has(&self, place: &str) -> bool {
        let (section, key) =
            place.split_once('.').map_or((place, None), |(section, key)| (section, Some(key)));
        self.0.get(section).is_some_and(|found| key.is_none_or(|key| found.get(key).is_some()))
    }
}

impl fmt::Display for SceneText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// A section of a table in braces, and a list of sections of a list of them; any other value as it is.
fn as_section(value: Item) -> Item {
    let mut item = value.into_table().map_or_else(|item| item, Item::Table);
    item = item.into_array_of_tables().map_or_else(|item| item, Item::ArrayOfTables);
    if let Item::Table(section) = &mut item {
        section.iter_mut().for_each(|(_, value)| spread(value));
    }
    item
}

/// Gives each table in a list a line of its own.
fn spread(value: &mut Item) {
    let Some(list) = value.as_array_mut().filter(|list| list.iter().any(|one| one.is_inline_table())) else {
        return;
    };
    list.iter_mut().for_each(|one| one.decor_mut().set_prefix("\n    "));
    list.set_trailing_comma(true);
    list.set_trailing("\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_are_written_as_a_person_would() {
        let mut text = SceneText::default();
        text.set("title", "a \"b\"").unwrap();
        let scans = toml::Value::Array(
            vec!["{ file = \"a\" }", "{ file = \"b\" }"]
                .into_iter()
                .map(|scan| toml::Value::Table(toml::from_str(scan.trim_matches(['{', '}', ' '])).unwrap()))
                .collect(),
        );
        text.set("surface", &std::collections::BTreeMap::from([("scans", scans)])).unwrap();
        text.set("seal", &toml::Table::new()).unwrap();
        let written = "title = 'a \"b\"'\n\n[surface]\nscans = [\n    { file = \"a\" },\n    { file = \"b\" },\n]\n\n[seal]\n";
        assert_eq!(text.to_string(), written);
        assert!(text.has("surface.scans") && !text.has("surface.psd") && text.has("seal"));
        text.set("surface.hurst", &0.8).unwrap();
        text.set_except("surface", &toml::Table::new(), "hurst").unwrap();
        text.remove("surface.hurst");
        text.remove("seal");
        assert_eq!(text.to_string(), "title = 'a \"b\"'\n\n[surface]\n");
    }
}
