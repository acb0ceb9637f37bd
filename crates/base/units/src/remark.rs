//! Remarks: facts that a reader has to know about a result, as data, and their words in the vocabulary of a front end.

use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::display::{counted, length, percent, pressure, three_digits};
use crate::number;
use crate::printable::printable;
pub use crate::remark_codes::{RemarkCode, RemarkLevel};

/// Place that a remark is about, as far as it is known.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RemarkPlace {
    /// Names of the files or scans.
    pub files: Vec<String>,
    /// Name of one of the two surfaces of a contact.
    pub surface: Option<String>,
    /// Row of an array or a table, counted from 0.
    pub row: Option<usize>,
    /// Line of a scene, counted from 1.
    pub line: Option<usize>,
    /// Option of a question, in lower case with underscores between its words.
    pub option: Option<String>,
    /// Key of a scene with its section, e.g. `curve.strain_gradient`.
    pub key: Option<String>,
}

/// A value of a remark.
#[derive(Debug, Clone, PartialEq)]
pub enum RemarkValue {
    /// A number, whose name ends in its unit.
    Number(f64),
    /// A number of things.
    Count(usize),
    /// A name, a list, or what the user typed.
    Text(String),
}

/// A fact that a reader has to know about a result.
#[derive(Debug, Clone, PartialEq)]
pub struct Remark {
    /// The kind of fact.
    pub code: RemarkCode,
    /// The weight.
    pub level: RemarkLevel,
    /// The place.
    pub place: Box<RemarkPlace>,
    /// Values by name.
    pub numbers: Vec<(&'static str, RemarkValue)>,
}

/// A front end's way to write options, by default as keys of a scene.
pub trait Spelling {
    /// Spells an option, e.g. `--interference-law` or `interference_law`.
    fn option(&self, option: &str) -> String {
        option.to_owned()
    }

    /// Spells an option with a value, e.g. `--band 2d` or `band = "2d"`.
    fn with_value(&self, option: &str, value: &str) -> String {
        format!("{option} = \"{value}\"")
    }

    /// Spells the choice of a model, e.g. `--model hertz` or `model hertz`.
    fn model(&self, name: &str) -> String {
        format!("model {name}")
    }

    /// Says how a property of a scan is given, beside its file.
    fn of_scan(&self, option: &str, value: &str) -> String {
        let (flag, typed) = (option.replace('_', "-"), value.replace(' ', ""));
        format!("write FILE:{flag}={typed} (scene: {option} = \"{value}\")")
    }

    /// Returns words in front of options that belong to a material made by itself, e.g. `the material `.
    fn of_material(&self) -> &'static str {
        ""
    }
}

/// Keys of a scene, as `interference_law`.
pub struct SceneKeys;

impl Spelling for SceneKeys {
    fn option(&self, option: &str) -> String {
        // Reports are read by users of every front end.
        option.replace(
            "counterface_surface",
            "the counterface's surface (--counterface-scans, [counterface.surface])",
        )
    }
}

impl From<f64> for RemarkValue {
    fn from(number: f64) -> Self {
        RemarkValue::Number(number)
    }
}

impl From<usize> for RemarkValue {
    fn from(count: usize) -> Self {
        RemarkValue::Count(count)
    }
}

impl From<&str> for RemarkValue {
    fn from(text: &str) -> Self {
        RemarkValue::Text(text.to_owned())
    }
}

impl From<String> for RemarkValue {
    fn from(text: String) -> Self {
        RemarkValue::Text(text)
    }
}

impl Remark {
    /// Makes a remark of the usual weight of its kind.
    #[must_use]
    pub fn new(code: RemarkCode) -> Self {
        Remark { code, level: code.level(), place: Box::default(), numbers: Vec::new() }
    }

    /// Adds a value.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl Into<RemarkValue>) -> Self {
        self.numbers.push((name, value.into()));
        self
    }

    /// Sets the files or scans that the remark is about.
    #[must_use]
    pub fn about(mut self, files: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.place.files = files.into_iter().map(Into::into).collect();
        self
    }

    /// Sets the option that the remark is about.
    #[must_use]
    pub fn on(mut self, option: impl Into<String>) -> Self {
        self.place.option = Some(option.into());
        self
    }

    /// Sets the weight to that of a passed check if the check was passed.
    #[must_use]
    pub fn passed_if(mut self, is_passed: bool) -> Self {
        if is_passed {
            self.level = RemarkLevel::Passed;
        }
        self
    }

    /// Returns a number by its name.
    #[must_use]
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.value(name)? {
            RemarkValue::Number(number) => Some(*number),
            RemarkValue::Count(count) => Some(*count as f64),
            RemarkValue::Text(_) => None,
        }
    }

    /// Returns a text by its name.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.value(name)? {
            RemarkValue::Text(text) => Some(text),
            RemarkValue::Number(_) | RemarkValue::Count(_) => None,
        }
    }

    fn value(&self, name: &str) -> Option<&RemarkValue> {
        self.numbers.iter().find(|(other, _)| *other == name).map(|(_, value)| value)
    }

    /// Returns the public code of the remark, the same for every wording and value, e.g. `doubt.steep-surface`.
    #[must_use]
    pub fn code_name(&self) -> String {
        let name = self.code.name();
        match self.place.surface {
            Some(_) => {
                format!("surface.of-surface{}", name.strip_prefix("surface.scans").unwrap_or_default())
            }
            None => name.to_owned(),
        }
    }

    /// Words the remark in a sentence without a full stop. Keys of scenes are spelled as such in every front end.
    #[must_use]
    pub fn words(&self, spelling: &dyn Spelling) -> String {
        let spelling = if self.place.key.is_some() { &SceneKeys } else { spelling };
        let line = self.place.line.map_or_else(String::new, |line| format!("line {line}: "));
        let surface = self.place.surface.as_ref().map_or_else(String::new, |name| format!("{name}: "));
        line + &surface + &self.filled(self.code.words(), spelling)
    }

    /// Words the remark in a few words, for one line with others.
    #[must_use]
    pub fn in_short(&self) -> String {
        match self.code.short_words() {
            "" => self.words(&SceneKeys),
            short => self.filled(short, &SceneKeys),
        }
    }

    fn filled(&self, template: &str, spelling: &dyn Spelling) -> String {
        let filled = self.fill(template, spelling, false);
        debug_assert!(filled.is_some(), "a value of {self:?} is missing");
        printable(filled.as_deref().unwrap_or(template)).into_owned()
    }

    /// Fills the values into a template; `None` if one is missing. Parts in brackets are left out without theirs, and with a count
    /// of 0.
    fn fill(&self, template: &str, spelling: &dyn Spelling, is_part: bool) -> Option<String> {
        let (mut text, mut rest) = (String::new(), template);
        while let Some(at) = rest.find(['[', '{']) {
            let is_optional = rest[at..].starts_with('[');
            let end = at + rest[at..].find(if is_optional { ']' } else { '}' })?;
            let inner = &rest[at + 1..end];
            text += &rest[..at];
            text += &match is_optional {
                true => self.fill(inner, spelling, true).unwrap_or_default(),
                false => self.placeholder(inner, spelling, is_part)?,
            };
            rest = &rest[end + 1..];
        }
        Some(text + rest)
    }

    /// Words a value: `{name}`, `{name%}` of a share, `{name#}` with all digits, `{name|thing}` counted and `{name~thing}` counted
    /// in words; an option `{--name}`, `{--name=value}` or of a scan `{scan:name=value}`, where `@name` is a value; a model
    /// `{@name}`; and the place.
    fn placeholder(&self, inner: &str, spelling: &dyn Spelling, is_part: bool) -> Option<String> {
        let named = |word: &str| match word.strip_prefix('@') {
            Some(name) => self.in_print(name),
            None => Some(word.to_owned()),
        };
        let count =
            |name: &str| self.number(name).map(|count| count as usize).filter(|count| *count > 0 || !is_part);
        let thing = |thing: &str| self.fill(&thing.replace('(', "{").replace(')', "}"), spelling, false);
        if let Some(option) = inner.strip_prefix("--") {
            return Some(match option.split_once('=') {
                Some((option, value)) => spelling.with_value(option, &named(value)?),
                None => spelling.option(&named(option)?),
            });
        }
        if let Some((option, value)) = inner.strip_prefix("scan:").and_then(|given| given.split_once('=')) {
            return Some(spelling.of_scan(option, &named(value)?));
        }
        if let Some(model) = inner.strip_prefix('@') {
            return Some(spelling.model(&self.in_print(model)?));
        }
        if let Some((name, things)) = inner.split_once('|') {
            return Some(counted(count(name)?, &thing(things)?));
        }
        if let Some((name, things)) = inner.split_once('~') {
            return Some(in_words(count(name)?, &thing(things)?));
        }
        let RemarkPlace { files, option, key, .. } = &*self.place;
        match inner {
            "files" => (!files.is_empty()).then(|| some(files)),
            "first" => files.first().cloned(),
            "second" => files.get(1).cloned(),
            "elided first" => files.first().map(|name| elided(name)),
            "elided second" => files.get(1).map(|name| elided(name)),
            "option" => key.clone().or_else(|| Some(spelling.option(option.as_ref()?))),
            name => self.in_print(name),
        }
    }

    fn in_print(&self, name: &str) -> Option<String> {
        let (format, name) = match name.strip_suffix(['%', '#']) {
            Some(plain) => (&name[plain.len()..], plain),
            None => ("", name),
        };
        Some(match (self.value(name)?, format) {
            (RemarkValue::Text(text), _) => text.clone(),
            (RemarkValue::Count(count), _) => count.to_string(),
            (RemarkValue::Number(value), "%") => percent(*value),
            (RemarkValue::Number(value), "#") => number(*value),
            (RemarkValue::Number(value), _) if name.ends_with("_m") => length(*value),
            (RemarkValue::Number(value), _) if name.ends_with("_per_pa") => three_digits(*value),
            (RemarkValue::Number(value), _) if name.ends_with("_pa") => pressure(*value),
            (RemarkValue::Number(value), _) => three_digits(*value),
        })
    }
}

impl Serialize for RemarkValue {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            RemarkValue::Number(number) => number.serialize(serializer),
            RemarkValue::Count(count) => count.serialize(serializer),
            RemarkValue::Text(text) => text.serialize(serializer),
        }
    }
}

/// Writes the code of a remark and its values by name.
impl Serialize for Remark {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("code", self.code.name())?;
        self.numbers.iter().try_for_each(|(name, value)| map.serialize_entry(name, value))?;
        map.end()
    }
}

/// The most names in one sentence; the others are counted.
const MAX_NAMED: usize = 3;

/// Names, at most [`MAX_NAMED`] of them: `a, b and c`, or `a, b, c and 2 more`.
fn some(names: &[String]) -> String {
    match names {
        [one] => one.clone(),
        [first @ .., last] if names.len() <= MAX_NAMED => format!("{} and {last}", first.join(", ")),
        _ => {
            let (named, others) = names.split_at(MAX_NAMED);
            format!("{} and {} more", named.join(", "), others.len())
        }
    }
}

/// A name that fits into a line with others: a long one without its middle.
fn elided(name: &str) -> String {
    const LONGEST: usize = 24;
    const ENDS: [usize; 2] = [12, 9];
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= LONGEST {
        return name.to_owned();
    }
    let ends = [&letters[..ENDS[0]], &letters[letters.len() - ENDS[1]..]];
    ends.map(|end| end.iter().collect::<String>()).join("…")
}

/// `one scan`, `three scans`; numbers above twelve in digits.
fn in_words(number: usize, thing: &str) -> String {
    let things = counted(number, thing);
    match (number, things.split_once(' ')) {
        (1, Some((_, thing))) => format!("one {thing}"),
        (_, Some((_, things))) => format!("{} {things}", crate::display::number_word(number)),
        _ => things,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn short_surface(scans: usize) -> Remark {
        Remark::new(RemarkCode::FewScans).with("instrument", "AFM").with("scans", scans)
    }

    #[test]
    fn values_are_filled_into_words() {
        assert_eq!(
            short_surface(1).words(&SceneKeys),
            "Treat the range as a guess: one AFM scan cannot show how much the surface varies."
        );
        assert_eq!(short_surface(2).in_short(), "two AFM scans only");
        let overlap = Remark::new(RemarkCode::Overlap)
            .about(["a", "b"])
            .with("ratio", 1.5)
            .with("bins", 3)
            .with("longest_m", 2e-6)
            .with("shortest_m", 1e-6);
        assert_eq!(overlap.words(&SceneKeys), "a over b: 1.5 in the mean of 3 shared bins from 2 µm to 1 µm");
        let reading = |remark: Remark| remark.with("text", "unit um assumed").words(&SceneKeys);
        assert_eq!(reading(Remark::new(RemarkCode::Reading)), "unit um assumed");
        let files = ["a", "b", "c", "d", "e"];
        assert_eq!(
            reading(Remark::new(RemarkCode::ScanReading).about(files)),
            "a, b, c and 2 more: unit um assumed"
        );
    }

    #[test]
    fn options_are_spelled_as_the_place_is() {
        let unused = Remark::new(RemarkCode::NoSuchOption).with("model", "hertz").on("gamma");
        assert_eq!(unused.words(&SceneKeys), "gamma does not affect model hertz; leave it out");
        let place =
            RemarkPlace { line: Some(7), key: Some("curve.gamma".to_owned()), ..RemarkPlace::default() };
        let in_scene = Remark { place: Box::new(place), ..unused }.with("models", "persson");
        assert_eq!(
            in_scene.words(&SceneKeys),
            "line 7: curve.gamma does not affect model hertz, only persson; leave it out"
        );
    }

    #[test]
    fn codes_of_one_of_two_surfaces_say_so() {
        let mut remark = Remark::new(RemarkCode::ScanHoles).with("holes", "between 2 µm and 1 µm");
        assert_eq!(remark.code_name(), "surface.scans.holes");
        remark.place.surface = Some("a.csv".to_owned());
        assert_eq!(remark.code_name(), "surface.of-surface.holes");
        assert!(remark.words(&SceneKeys).starts_with("a.csv: nothing was measured between 2 µm and 1 µm: "));
    }

    #[test]
    fn every_template_is_well_formed() {
        for code in RemarkCode::ALL {
            for template in [code.words(), code.short_words()] {
                for [open, close] in [['{', '}'], ['[', ']']] {
                    assert_eq!(template.matches(open).count(), template.matches(close).count(), "{template}");
                }
            }
        }
    }
}
