//! Conversion of errors of the TOML reader to errors of a scene.

use toml::de::Error;

use super::error::{SceneError, SceneProblem};
use super::spelling::meant;

/// Type names of the TOML reader, and the words that a person would write for them.
const WANTED: [(&str, &str); 17] = [
    ("f64", "a number"),
    ("i64", "a whole number"),
    ("u32", "a whole number from 0 on"),
    ("a string", "text in quotes"),
    ("a boolean", "true or false"),
    ("a sequence", "a list in brackets"),
    ("struct RawSurface", "a section [surface]"),
    ("struct RawMaterial", "a section [material]"),
    ("struct RawLayer", "a section [material.layer]"),
    ("struct RawCounterface", "a section [counterface]"),
    ("struct RawLoads", "a section [loads]"),
    ("struct RawCurve", "a section [[curve]]"),
    ("struct RawFigure", "a section [[figure]]"),
    ("struct RawLoadRange", "{ from = \"1e-6 H\", to = \"1 H\", points = 41 }"),
    ("struct RawCutoffs", "a section [cutoffs]"),
    ("struct RawJudge", "a section [judge]"),
    ("struct RawUncertainty", "a section [uncertainty]"),
];

/// Makes an error with its place. The TOML reader describes what it expected only in words, with names between
/// backticks.
pub(super) fn scene_error(error: &Error) -> SceneError {
    SceneError { problem: problem(error.message()), span: error.span() }
}

fn problem(message: &str) -> SceneProblem {
    let unknown = |rest: &str| {
        let mut names = rest.split('`').skip(1).step_by(2).map(str::to_owned);
        let given = names.next()?;
        let known: Vec<String> = names.collect();
        let meant = meant(&given, known.iter().map(String::as_str)).map(str::to_owned);
        Some((given, known, meant))
    };
    if let Some((key, known, meant)) = message.strip_prefix("unknown field").and_then(unknown) {
        return SceneProblem::UnknownKey { key, known, meant };
    }
    if let Some((value, known, meant)) = message.strip_prefix("unknown variant").and_then(unknown) {
        return SceneProblem::UnknownValue { value, known, meant };
    }
    if let Some(key) = message.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`')) {
        return SceneProblem::MissingKey { key: key.to_owned() };
    }
    let wrong = message.strip_prefix("invalid type: ").or_else(|| message.strip_prefix("invalid value: "));
    if let Some((found, expected)) = wrong.and_then(|rest| rest.split_once(", expected ")) {
        let wanted = WANTED.iter().find(|(name, _)| *name == expected).map_or(expected, |(_, words)| words);
        return SceneProblem::WrongType { found: found.replace('`', ""), wanted: wanted.to_owned() };
    }
    SceneProblem::Text(message.to_owned())
}
