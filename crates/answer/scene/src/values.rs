//! Single values of a scene: quantities with their units, names, counts.

use std::num::NonZeroU32;
use std::str::FromStr;

use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use study::plan::Tolerance;
use units::Bound;

/// A quantity with its unit at `span`.
pub(super) fn quantity_at<T: FromStr<Err: std::fmt::Display>>(
    key: &str,
    value: &toml::Value,
    span: std::ops::Range<usize>,
) -> Result<T, SceneError> {
    let text = text_of(value);
    text.parse().map_err(|error| value_error(key, &text, span, error))
}

/// A value as text that a quantity is read from.
pub(super) fn text_of(value: &toml::Value) -> String {
    match value {
        toml::Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// Returns an error about the value of a key at `span`.
pub(super) fn value_error(
    key: &str,
    value: &str,
    span: std::ops::Range<usize>,
    problem: impl std::fmt::Display,
) -> SceneError {
    let (key, value, problem) = (key.to_owned(), value.to_owned(), problem.to_string());
    SceneError::at(span, SceneProblem::Value { key, value, problem })
}

/// A whole number from 1 on.
pub(super) fn count(key: &str, raw: &Spanned<i64>) -> Result<NonZeroU32, SceneError> {
    u32::try_from(*raw.get_ref()).ok().and_then(NonZeroU32::new).ok_or_else(|| {
        let message = format!("key {key}: {} must be a whole number from 1 on", raw.get_ref());
        SceneError::at(raw.span(), message)
    })
}

/// A number within a bound.
pub(super) fn number(
    key: &str,
    quantity: &'static str,
    raw: &Spanned<f64>,
    bound: Bound,
) -> Result<f64, SceneError> {
    let checked = bound.check(quantity, *raw.get_ref());
    checked.map_err(|error| value_error(key, &raw.get_ref().to_string(), raw.span(), error))
}

/// A whole number within a bound that admits none below 0, if it is given.
pub(super) fn whole_number(
    key: &str,
    quantity: &'static str,
    raw: &Option<Spanned<i64>>,
    bound: Bound,
) -> Result<Option<u64>, SceneError> {
    let Some(raw) = raw else { return Ok(None) };
    let checked = bound.check(quantity, *raw.get_ref() as f64);
    checked.map_err(|error| value_error(key, &raw.get_ref().to_string(), raw.span(), error))?;
    Ok(Some(raw.get_ref().unsigned_abs()))
}

/// The names of curves and figures become those of files.
pub(super) fn check_file_name(name: &str, span: std::ops::Range<usize>) -> Result<(), SceneError> {
    if name.chars().any(is_part_of_a_letter) {
        let message = format!(
            "{name:?} becomes the name of a file, and has letters in parts, which some disks join; type each as one letter"
        );
        return Err(SceneError::at(span, message));
    }
    let plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.');
    if is_device(name) || name.ends_with('.') {
        let message = format!("{name:?} becomes the name of a file, and Windows reserves it; choose another");
        return Err(SceneError::at(span, message));
    }
    if name.chars().all(plain) && name.starts_with(char::is_alphanumeric) {
        return Ok(());
    }
    let message = format!("{name:?} becomes the name of a file; use letters, digits, '-', '_' and '.' only");
    Err(SceneError::at(span, message))
}

/// Returns true for accents behind their letter and for the parts of Hangul: composed, they are another name of the same file
/// on some disks, and of another one elsewhere.
fn is_part_of_a_letter(c: char) -> bool {
    matches!(c, '\u{300}'..='\u{36f}' | '\u{1100}'..='\u{11ff}')
}

/// Returns true for names that Windows gives to devices, with any ending.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().to_lowercase();
    let is_port = |kind| {
        stem.strip_prefix(kind)
            .is_some_and(|port| port.len() == 1 && port.starts_with(|c: char| c.is_ascii_digit()))
    };
    ["con", "prn", "aux", "nul"].contains(&stem.as_str()) || is_port("com") || is_port("lpt")
}

pub(super) fn tolerance(raw: &Spanned<f64>) -> Result<Tolerance, SceneError> {
    Tolerance::new(*raw.get_ref())
        .map_err(|error| value_error("options.tolerance", &raw.get_ref().to_string(), raw.span(), error))
}
