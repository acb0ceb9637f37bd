//! Separators of columns, and whether a comma is one.

use super::body::Body;
use super::style::shortened;
use crate::error::ScanReadError;

/// Separator of the columns of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separator {
    Semicolon,
    Tab,
    Comma,
    Blanks,
}

impl Separator {
    /// The separator of a file, by its lines of numbers.
    pub(super) fn recognise(body: &Body<'_>) -> Result<Self, ScanReadError> {
        let mut rows = body.rows();
        let (first, line) = rows.next().ok_or(ScanReadError::NoRows)?;
        if line.contains(';') {
            return Ok(Self::Semicolon);
        }
        if line.contains('\t') {
            return Ok(Self::Tab);
        }
        if !line.contains(',') {
            return Ok(Self::Blanks);
        }
        let mut lines = std::iter::once(line).chain(rows.map(|(_, line)| line));
        lines.find_map(comma_separates).map_or_else(
            || Err(ScanReadError::AmbiguousComma { line: first, text: shortened(line) }),
            |separates| Ok(if separates { Self::Comma } else { Self::Blanks }),
        )
    }

    /// The fields of a line, empty ones among them.
    pub(crate) fn split(self, line: &str) -> impl Iterator<Item = &str> {
        let character = match self {
            Self::Semicolon => Some(';'),
            Self::Tab => Some('\t'),
            Self::Comma => Some(','),
            Self::Blanks => None,
        };
        let delimited = character.map(|character| line.split(character).map(str::trim));
        let blanks = character.is_none().then(|| line.split_whitespace());
        delimited.into_iter().flatten().chain(blanks.into_iter().flatten())
    }
}

/// Returns true if the commas of a line separate columns; none where the line is ambiguous.
fn comma_separates(line: &str) -> Option<bool> {
    if !line.contains(',') {
        return None;
    }
    if line.contains('.') {
        return Some(true);
    }
    let mut words = line.split_whitespace();
    let is_decimal = |word: &str| match word.split_once(',') {
        None => true,
        Some((whole, decimals)) => {
            whole.ends_with(|last: char| last.is_ascii_digit())
                && decimals.starts_with(|first: char| first.is_ascii_digit())
                && !whole.contains(['e', 'E'])
                && !decimals.contains(',')
        }
    };
    // Whole numbers have neither a sign before zero nor zeros before their digits.
    let is_surely_decimal = |word: &str| {
        word.split_once(',')
            .is_some_and(|(whole, decimals)| whole == "-0" || decimals.len() > 1 && decimals.starts_with('0'))
    };
    let may_be_decimal = words.clone().all(is_decimal);
    if may_be_decimal && words.clone().any(is_surely_decimal) {
        return Some(false);
    }
    // A lone number with a decimal comma looks like two whole numbers.
    if may_be_decimal && words.nth(1).is_none() { None } else { Some(!may_be_decimal) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_are_separators_or_decimals_by_what_surrounds_them() {
        for (line, separates) in [
            ("0.5,1.5", Some(true)),
            ("0, 1", Some(true)),
            ("0,1,2", Some(true)),
            ("0,-1", Some(true)),
            ("1e3,4", Some(true)),
            ("0,nan", Some(true)),
            ("0,5 1,25", Some(false)),
            ("0 1,25", Some(false)),
            ("0,5", None),
            ("0,05", Some(false)),
            ("-0,5", Some(false)),
            ("0,5e-3", None),
            ("0 5", None),
        ] {
            assert_eq!(comma_separates(line), separates, "{line}");
        }
        let recognised = |text| Separator::recognise(&Body::find(text).unwrap());
        assert_eq!(recognised("0,0\n0,5\n1,-2").unwrap(), Separator::Comma);
        assert!(matches!(recognised("0,0\n0,5"), Err(ScanReadError::AmbiguousComma { line: 1, .. })));
    }

    #[test]
    fn fields_are_split_with_empty_ones() {
        let split = |separator: Separator, line| separator.split(line).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(split(Separator::Comma, "1, 2,"), ["1", "2", ""]);
        assert_eq!(split(Separator::Comma, "1,2, ,"), ["1", "2", "", ""]);
        assert_eq!(split(Separator::Blanks, "1  2\t3"), ["1", "2", "3"]);
        assert_eq!(split(Separator::Semicolon, "1;;3"), ["1", "", "3"]);
    }
}
