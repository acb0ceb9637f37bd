//! Common mistakes in TOML values: missing quotes, a decimal comma, the backslashes of a path.

use std::ops::Range;

use units::without_comma;

use super::error::{SceneError, SceneProblem};

/// Replaces an error in the words of the TOML reader by one on the value that it stopped at, if people mistype it so.
pub(super) fn explained(error: SceneError, text: &str) -> SceneError {
    match (&error.problem, &error.span) {
        (SceneProblem::Text(_), Some(span)) => mistyped(text, span.start).unwrap_or(error),
        _ => error,
    }
}

/// Finds the value at fault in the line of a scene that the TOML reader stopped in, at this byte.
fn mistyped(text: &str, at: usize) -> Option<SceneError> {
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let line = text[start..].lines().next()?;
    let (_, value) = line.split_once('=')?;
    let (value, problem) = of_value(value)?;
    let begin = value.as_ptr() as usize - text.as_ptr() as usize;
    Some(SceneError::at(Range { start: begin, end: begin + value.len() }, problem))
}

/// The part of a value that is at fault, and what is wrong with it.
fn of_value(value: &str) -> Option<(&str, SceneProblem)> {
    let value = value.trim();
    if value.starts_with('"') {
        let path = value.split('"').nth(1).filter(|path| path.contains('\\'))?;
        return Some((value, SceneProblem::Backslash { path: path.to_owned() }));
    }
    if !value.starts_with(['[', '{']) {
        let value = value.split('#').next().unwrap_or_default().trim_end();
        return Some((value, of_bare(value)?));
    }
    let mut items: Vec<&str> = Vec::new();
    for item in value.split(['[', ']', '{', '}', ',']) {
        let before = items.last().copied();
        let item = item.rsplit_once('=').map_or(item, |(_, item)| item);
        // A comma between two digits belongs to a number.
        match before.filter(|before| ends_in_digit(before) && item.starts_with(|c: char| c.is_ascii_digit()))
        {
            Some(before) => {
                let begin = before.as_ptr() as usize - value.as_ptr() as usize;
                *items.last_mut()? = &value[begin..begin + before.len() + 1 + item.len()];
            }
            None => items.push(item),
        }
    }
    items.into_iter().map(str::trim).find_map(|item| Some((item, of_bare(item)?)))
}

fn ends_in_digit(text: &str) -> bool {
    text.ends_with(|c: char| c.is_ascii_digit())
}

/// Finds the problem of a value without quotes; `None` for numbers, words of TOML, and text in quotes.
fn of_bare(value: &str) -> Option<SceneProblem> {
    let is_plain = value.replace('_', "").parse::<f64>().is_ok() || ["true", "false"].contains(&value);
    if value.is_empty() || is_plain || value.contains(['"', '\'']) {
        return None;
    }
    let meant = without_comma(value);
    let is_number = meant.as_ref().is_some_and(|meant| meant.parse::<f64>().is_ok());
    let value = value.to_owned();
    Some(match meant {
        Some(meant) if is_number => SceneProblem::DecimalComma { value, meant },
        meant => SceneProblem::NoQuotes { meant: meant.unwrap_or_else(|| value.clone()), value },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_value_at_fault_is_found_with_what_is_meant() {
        let found =
            |line: &str| mistyped(line, line.len() - 1).map(|error| (error.span.unwrap(), error.problem));
        for (line, at_fault, expected) in [
            ("a = 10 MPa", "10 MPa", "10 MPa"),
            ("a = 10,5 MPa # of the bolt", "10,5 MPa", "10.5 MPa"),
            ("a = hertz", "hertz", "hertz"),
            ("a = [\"1 MPa\", 10 MPa]", "10 MPa", "10 MPa"),
            ("a = [1 MPa, 10,5 MPa]", "1 MPa", "1 MPa"),
            ("a = [10,5 MPa]", "10,5 MPa", "10.5 MPa"),
            ("a = [{ file = trace.txt }]", "trace.txt", "trace.txt"),
        ] {
            let (span, problem) = found(line).unwrap_or_else(|| panic!("{line}"));
            assert_eq!(&line[span], at_fault, "{line}");
            assert!(
                matches!(&problem, SceneProblem::NoQuotes { meant, .. } if meant == expected),
                "{problem:?}"
            );
        }
        let (_, problem) = found("nu = 0,3").unwrap();
        assert!(matches!(problem, SceneProblem::DecimalComma { meant, .. } if meant == "0.3"));
        let (_, problem) = found("psd = \"C:\\Users\\me.csv\"").unwrap();
        assert!(matches!(problem, SceneProblem::Backslash { path } if path == "C:\\Users\\me.csv"));
        for line in ["a = 0.3", "a = [1, 2]", "a = \"x\"", "a = 'C:\\x'", "[surface", "a = true", "a"] {
            assert!(found(line).is_none(), "{line}");
        }
    }
}
