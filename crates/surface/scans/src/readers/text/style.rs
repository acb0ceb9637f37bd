//! Text, its lines of numbers, their separators and decimal marks.

use std::borrow::Cow;

use crate::error::ScanReadError;
use crate::format::ScanFormat;

/// The format whose reader this is, for messages.
pub(crate) const FORMAT: ScanFormat = ScanFormat::Text;

/// Separator of the columns of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Separator {
    Semicolon,
    Tab,
    Comma,
    Blanks,
}

/// Words for a missing point, those of spreadsheets and of the printf of Windows among them.
const MISSING: [&str; 20] = [
    "nan", "inf", "infinity", "infinite", "bad", "na", "n/a", "null", "none", "missing", "invalid", "nodata",
    "no_data", "#n/a", "#num!", "#value!", "#div/0!", "1.#qnan", "1.#ind", "1.#inf",
];

/// UTF-16 with a byte order mark, UTF-8 with or without one, else Latin-1, in which older instruments write `µ`.
pub(crate) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, ScanReadError> {
    if let Some(text) = decode_utf16(bytes) {
        return Ok(Cow::Owned(text));
    }
    let is_text = |byte: u8| byte >= b' ' || b"\t\n\r\x0c\x1a".contains(&byte);
    if let Some(offset) = bytes.iter().position(|&byte| !is_text(byte)) {
        let line = 1 + bytes[..offset].iter().filter(|&&byte| byte == b'\n').count();
        return Err(ScanReadError::NotText { line, offset, byte: bytes[offset] });
    }
    Ok(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(_) => Cow::Owned(bytes.iter().map(|&byte| char::from(byte)).collect()),
    })
}

/// The characters of UTF-16 text behind its byte order mark, as the spreadsheets of some instruments are saved; none
/// where there is no such mark. What is not a character becomes one that no number contains.
fn decode_utf16(bytes: &[u8]) -> Option<String> {
    let to_unit = match bytes.first_chunk()? {
        [0xff, 0xfe] => u16::from_le_bytes,
        [0xfe, 0xff] => u16::from_be_bytes,
        _ => return None,
    };
    let (pairs, _) = bytes.as_chunks::<2>();
    let units = pairs.iter().skip(1).map(|pair| to_unit(*pair));
    let characters = char::decode_utf16(units).map(|found| found.unwrap_or(char::REPLACEMENT_CHARACTER));
    Some(characters.collect())
}

/// The lines that are neither blank nor comments, from 1, trimmed of blanks.
///
/// A tab at the ends is kept off too: an empty first or last column holds no number.
pub(crate) fn content(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim_matches(is_blank)));
    lines.filter(|(_, line)| !line.is_empty() && !is_comment(line))
}

/// The lines of numbers, from the first one on, with all that follows; lines of missing points above it are part of the
/// scan.
pub(crate) fn rows(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let first = first_row(text).unwrap_or(usize::MAX);
    content(text).skip_while(move |(number, _)| *number < first)
}

/// Splits a line with the separators at its ends, which mark empty fields.
pub(crate) fn whole_rows(text: &str, separator: Separator) -> impl Iterator<Item = (usize, &str)> {
    let first = first_row(text).unwrap_or(usize::MAX);
    let is_margin =
        move |character: char| is_blank(character) && !(separator == Separator::Tab && character == '\t');
    let lines = text.lines().enumerate().map(move |(index, line)| (index + 1, line.trim_matches(is_margin)));
    lines.filter(move |(number, line)| *number >= first && !line.is_empty() && !is_comment(line))
}

/// The first line of the scan: of numbers, or the first of the lines of missing points right above it with as many
/// fields.
fn first_row(text: &str) -> Option<usize> {
    let mut missing: Option<(usize, usize)> = None;
    for (number, line) in content(text) {
        let fields = count_of_fields(line);
        if holds_numbers(line) {
            return Some(missing.filter(|&(_, count)| count == fields).map_or(number, |(first, _)| first));
        }
        missing = match missing {
            _ if !holds_missing_points(line) => None,
            Some((first, count)) if count == fields => Some((first, count)),
            _ => Some((number, fields)),
        };
    }
    None
}

/// Returns true if a line consists of words for missing points. Dashes do not count: they underline headers.
fn holds_missing_points(line: &str) -> bool {
    let mut words = line.split(is_separator).filter(|word| !word.is_empty()).peekable();
    words.peek().is_some() && words.all(|word| is_missing(word) && word.contains(char::is_alphabetic))
}

/// The fields of a line that need not have the separator of the file.
fn count_of_fields(line: &str) -> usize {
    match line.chars().find(|character| ";\t".contains(*character)) {
        Some(separator) => line.split(separator).count(),
        None if line.contains(char::is_whitespace) => line.split_whitespace().count(),
        None => line.split(',').count(),
    }
}

fn is_separator(character: char) -> bool {
    character.is_whitespace() || ";,".contains(character)
}

pub(crate) fn is_comment(line: &str) -> bool {
    line.starts_with(['#', '%']) && !line.split(is_separator).next().is_some_and(is_missing)
}

fn is_blank(character: char) -> bool {
    character.is_whitespace() || character == '\u{1a}' || character == '\u{feff}'
}

/// Returns true if a field marks a missing point.
pub(crate) fn is_missing(field: &str) -> bool {
    let word = field.trim_start_matches(['+', '-']);
    let is_filler = |sign: char| !field.is_empty() && field.chars().all(|c| c == sign);
    MISSING.iter().any(|missing| missing.eq_ignore_ascii_case(word)) || "-*?".chars().any(is_filler)
}

/// Returns true if a line consists of numbers, whatever separates them.
fn holds_numbers(line: &str) -> bool {
    let mut has_number = false;
    line.split(is_separator).filter(|word| !word.is_empty()).all(|word| {
        let is_number = word.parse::<f64>().is_ok_and(f64::is_finite);
        has_number |= is_number;
        is_number || is_missing(word)
    }) && has_number
}

impl Separator {
    /// The separator of a file, by its lines of numbers.
    pub(crate) fn recognise(text: &str) -> Result<Self, ScanReadError> {
        let mut rows = rows(text);
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
    let may_be_decimal = words.clone().all(is_decimal);
    // A lone number with a decimal comma looks like two whole numbers.
    if may_be_decimal && words.nth(1).is_none() { None } else { Some(!may_be_decimal) }
}

pub(crate) fn shortened(text: &str) -> String {
    const MOST: usize = 60;
    match text.char_indices().nth(MOST) {
        None => text.to_owned(),
        Some((end, _)) => format!("{}...", &text[..end]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn utf16_is_told_by_its_mark() {
        let bytes = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
            "\u{feff}1 µm\n".encode_utf16().flat_map(order).chain([0x31]).collect()
        };
        assert_eq!(decode(&bytes(u16::to_le_bytes)).unwrap(), "1 µm\n");
        assert_eq!(decode(&bytes(u16::to_be_bytes)).unwrap(), "1 µm\n");
        assert_eq!(decode(&[0xff, 0xfe, 0x00, 0xd8]).unwrap(), "\u{fffd}");
    }

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
            ("0,5e-3", None),
            ("0 5", None),
        ] {
            assert_eq!(comma_separates(line), separates, "{line}");
        }
        assert_eq!(Separator::recognise("0,0\n0,5\n1,-2").unwrap(), Separator::Comma);
        assert!(matches!(
            Separator::recognise("0,0\n0,5"),
            Err(ScanReadError::AmbiguousComma { line: 1, .. })
        ));
    }

    #[test]
    fn words_and_fillers_mark_missing_points() {
        for field in ["***", "*", "-----", "??", "NaN", "-nan", "#N/A", "-1.#IND", "NULL", "missing"] {
            assert!(is_missing(field), "{field}");
        }
        assert!(["", "1", "-1", "*-", "m", "1.#"].iter().all(|field| !is_missing(field)));
        assert!(is_comment("# N/A") && is_comment("%") && !is_comment("#N/A 1"));
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
