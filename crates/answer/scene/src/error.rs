//! Errors in a scene, with their places in its text.

use std::fmt;
use std::ops::Range;

use crate::file_content::FileContent;
use study::body_properties::BodyProperty;
use study::material::MaterialError;
use study::surface::SurfaceError;

/// Error in a scene, with its place in the text.
#[derive(Debug, thiserror::Error)]
#[error("{problem}")]
pub struct SceneError {
    /// The error itself.
    pub problem: SceneProblem,
    /// The bytes of the scene to point at; the whole of it where absent.
    pub span: Option<Range<usize>>,
}

/// Kind of error in a scene.
#[derive(Debug)]
#[non_exhaustive]
pub enum SceneProblem {
    /// The text, a key or a value does not belong in a scene.
    Text(String),
    /// The file is not a scene.
    NotAScene(FileContent),
    /// A text without quotes.
    NoQuotes {
        /// The value as typed.
        value: String,
        /// The text that it means.
        meant: String,
    },
    /// A number with a decimal comma.
    DecimalComma {
        /// The value as typed.
        value: String,
        /// The number that it means.
        meant: String,
    },
    /// A path with backslashes in double quotes, which begin escape sequences there.
    Backslash {
        /// The path as typed.
        path: String,
    },
    /// No section of this place has such a key.
    UnknownKey {
        /// The key.
        key: String,
        /// The accepted keys.
        known: Vec<String>,
        /// The most similar key.
        meant: Option<String>,
    },
    /// A choice that does not exist.
    UnknownValue {
        /// The value.
        value: String,
        /// The accepted values.
        known: Vec<String>,
        /// The most similar value.
        meant: Option<String>,
    },
    /// A value of another kind than its key takes.
    WrongType {
        /// Kind of value found, e.g. `string "a"`.
        found: String,
        /// Kind of value expected, e.g. `a number`.
        wanted: String,
    },
    /// A section lacks a key that it must have.
    MissingKey {
        /// The key.
        key: String,
    },
    /// A value that its key does not take.
    Value {
        /// The key with its section.
        key: String,
        /// The value as typed.
        value: String,
        /// Description of the error.
        problem: String,
    },
    /// The files of a curve or figure would replace others.
    FileNameTaken {
        /// Its name.
        name: String,
        /// The name that it is taken by.
        by: String,
    },
    /// A curve needs a property that the material lacks.
    Material(MaterialError),
    /// The spectrum or the scans cannot be had.
    Surface(Box<SurfaceError>),
}

impl SceneError {
    pub(super) fn at(span: Range<usize>, problem: impl Into<SceneProblem>) -> Self {
        SceneError { problem: problem.into(), span: Some(span) }
    }

    pub(super) fn anywhere(problem: impl Into<SceneProblem>) -> Self {
        SceneError { problem: problem.into(), span: None }
    }

    /// Points at a place unless a place is known.
    pub(super) fn or_at(self, span: Range<usize>) -> Self {
        SceneError { span: self.span.or(Some(span)), ..self }
    }

    /// Puts the key of a section before that of a value in it.
    pub(super) fn below(mut self, section: &str) -> Self {
        if let SceneProblem::Value { key, .. } = &mut self.problem {
            *key = if key.is_empty() { section.to_owned() } else { format!("{section}.{key}") };
        }
        self
    }

    /// The key at fault, if known.
    #[must_use]
    pub fn key(&self) -> Option<&str> {
        match &self.problem {
            SceneProblem::UnknownKey { key, .. }
            | SceneProblem::MissingKey { key }
            | SceneProblem::Value { key, .. } => Some(key),
            _ => None,
        }
    }

    /// The line of the scene that it points at, counted from 1.
    #[must_use]
    pub fn line(&self, scene: &str) -> Option<usize> {
        let before = scene.get(..self.span.as_ref()?.start)?;
        Some(1 + before.matches('\n').count())
    }
}

impl fmt::Display for SceneProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneProblem::Text(text) => f.write_str(text),
            SceneProblem::Material(error @ MaterialError::Missing(needed_for)) => {
                let key = match needed_for.property() {
                    BodyProperty::IndentationHardness => "indentation_hardness or yield_strength",
                    BodyProperty::YieldStrength => "yield_strength or indentation_hardness",
                    other => other.key(),
                };
                write!(f, "{error}: add {key} in [material]")
            }
            SceneProblem::Material(error @ MaterialError::HardnessOffStrength(_)) => {
                write!(f, "{error}: leave out indentation_hardness or yield_strength in [material]")
            }
            SceneProblem::UnknownKey { key, .. } if let Some(instead) = study::way_out(key) => {
                write!(f, "unknown key `{key}`: {instead}")
            }
            SceneProblem::UnknownKey { key, known, meant } => {
                write!(f, "unknown key `{key}`{} the keys here are {}", hint(meant), known.join(", "))
            }
            SceneProblem::UnknownValue { value, known, meant: Some(meant) } if *known == [meant.as_str()] => {
                write!(f, "unknown value `{value}`, did you mean `{meant}`?")
            }
            SceneProblem::UnknownValue { value, known, meant } => {
                write!(f, "unknown value `{value}`{} it may be {}", hint(meant), known.join(", "))
            }
            SceneProblem::WrongType { found, wanted } => {
                write!(f, "found {found}, expected {wanted}{}", instead(found, wanted))
            }
            SceneProblem::NotAScene(content) => write!(f, "this is {content}, not a scene"),
            SceneProblem::NoQuotes { value, meant } => write!(f, "{value} needs quotes; write \"{meant}\""),
            SceneProblem::DecimalComma { value, meant } => {
                write!(f, "{value} has a decimal comma; write {meant}")
            }
            SceneProblem::Backslash { path } => {
                write!(f, "backslashes need single quotes; write '{path}'")
            }
            SceneProblem::MissingKey { key } => write!(f, "the key {key} is missing here"),
            SceneProblem::Value { key, problem, .. } => write!(f, "key {key}: {problem}"),
            SceneProblem::FileNameTaken { name, by } if name == by => {
                write!(
                    f,
                    "{name:?} is the name of a file that the program writes itself; choose another name"
                )
            }
            SceneProblem::FileNameTaken { name, by } => {
                write!(
                    f,
                    "{name:?} and {by:?} name the same file on disks where case does not count; rename one"
                )
            }
            SceneProblem::Material(error) => error.fmt(f),
            SceneProblem::Surface(error) => error.fmt(f),
        }
    }
}

/// Words on what to write in place of a value of another kind than its key takes; they follow the error.
fn instead(found: &str, wanted: &str) -> String {
    let text = found.strip_prefix("string ").map(|text| text.trim_matches('"'));
    let share = |text: &str| Some(text.strip_suffix('%')?.trim().parse::<f64>().ok()? / 100.0);
    let slope = |text: &str| {
        let degrees = text
            .strip_suffix("degrees")
            .or_else(|| text.strip_suffix("deg"))
            .or_else(|| text.strip_suffix('°'));
        Some((degrees?.trim().parse::<f64>().ok()?.to_radians().tan() * 1e3).round() / 1e3)
    };
    match (text, wanted) {
        (Some(text), "a list in brackets") => {
            let values: Vec<&str> =
                text.split(" to ").flat_map(|part| part.split(',')).map(str::trim).collect();
            format!("; write [\"{}\"]", values.join("\", \""))
        }
        (Some(text), "a number") => match share(text).or_else(|| slope(text)) {
            Some(number) => format!("; write {number}"),
            None => "; write it without quotes and unit".to_owned(),
        },
        (None, "a list in brackets") if found == "map" => {
            "; write a section that may be repeated in double brackets, as in [[curve]]".to_owned()
        }
        (None, "text in quotes") if found == "sequence" => {
            "; write one value here, and a section of its own, as [[curve]], for each other one".to_owned()
        }
        _ => String::new(),
    }
}

/// Suggests a similar name, or returns the semicolon that separates the clauses if there is none.
fn hint(meant: &Option<String>) -> String {
    meant.as_ref().map_or_else(|| ";".to_owned(), |meant| format!(", did you mean `{meant}`?"))
}

impl From<String> for SceneProblem {
    fn from(text: String) -> Self {
        SceneProblem::Text(text)
    }
}

impl From<&str> for SceneProblem {
    fn from(text: &str) -> Self {
        SceneProblem::Text(text.to_owned())
    }
}

impl From<MaterialError> for SceneProblem {
    fn from(error: MaterialError) -> Self {
        SceneProblem::Material(error)
    }
}

impl From<SurfaceError> for SceneProblem {
    fn from(error: SurfaceError) -> Self {
        SceneProblem::Surface(Box::new(error))
    }
}

#[cfg(test)]
mod tests {
    use super::instead;

    #[test]
    fn numbers_and_lists_are_written_as_meant() {
        for (found, wanted, meant) in [
            ("string \"8.5 deg\"", "a number", "; write 0.149"),
            ("string \"30 %\"", "a number", "; write 0.3"),
            ("string \"1 MPa to 10 MPa\"", "a list in brackets", "; write [\"1 MPa\", \"10 MPa\"]"),
            ("string \"1 MPa\"", "a list in brackets", "; write [\"1 MPa\"]"),
            ("string \"a\"", "true or false", ""),
        ] {
            assert_eq!(instead(found, wanted), meant, "{found}");
        }
    }
}
