//! Text and its lines: which hold numbers, comments, marks of missing points.

use std::borrow::Cow;

use memchr::memmem;

use crate::error::ScanReadError;
use crate::format::ScanFormat;

/// The format whose reader this is, for messages.
pub(crate) const FORMAT: ScanFormat = ScanFormat::Text;

/// Words for a missing point, those of spreadsheets and of the printf of Windows among them.
const MISSING: [&str; 35] = [
    "nan",
    "inf",
    "infinity",
    "infinite",
    "bad",
    "na",
    "n/a",
    "n.a.",
    "nd",
    "n.d.",
    "null",
    "nil",
    "none",
    "missing",
    "masked",
    "invalid",
    "void",
    "empty",
    "undef",
    "undefined",
    "nodata",
    "no_data",
    "no-data",
    "no data",
    "#n/a",
    "#nv",
    "#num!",
    "#value!",
    "#wert!",
    "#zahl!",
    "#div/0!",
    "1.#qnan",
    "1.#snan",
    "1.#ind",
    "1.#inf",
];

/// UTF-16 with a byte order mark, UTF-8 with or without one, else Latin-1, in which older instruments write `µ`.
pub(crate) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, ScanReadError> {
    if let Some(text) = decode_utf16(bytes) {
        return Ok(with_whole_marks(Cow::Owned(text)));
    }
    let is_text = |byte: u8| byte >= b' ' || b"\t\n\r\x0c\x1a".contains(&byte);
    if let Some(offset) = bytes.iter().position(|&byte| !is_text(byte)) {
        let line = 1 + bytes[..offset].iter().filter(|&&byte| byte == b'\n').count();
        return Err(ScanReadError::NotText { line, offset, byte: bytes[offset] });
    }
    Ok(with_whole_marks(match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(_) => Cow::Owned(bytes.iter().map(|&byte| char::from(byte)).collect()),
    }))
}

/// Ends lines as lines end where returns alone do, and makes one word of the mark of missing points that is two, which
/// blanks would separate.
fn with_whole_marks(text: Cow<'_, str>) -> Cow<'_, str> {
    let has = |byte: u8| memchr::memchr(byte, text.as_bytes()).is_some();
    let text = if has(b'\r') && !has(b'\n') { Cow::Owned(text.replace('\r', "\n")) } else { text };
    const MARKS: [&str; 3] = ["No Data", "no data", "NO DATA"];
    let is_in = |mark: &&str| memmem::find(text.as_bytes(), mark.as_bytes()).is_some();
    let found: Vec<&str> = MARKS.into_iter().filter(is_in).collect();
    found.into_iter().fold(text, |text, mark| Cow::Owned(text.replace(mark, "NoData")))
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

/// Most columns of a text that is no map.
const MOST_COLUMNS_OF_A_TABLE: usize = 3;

/// Returns true if a line consists of marks of missing points, or of the separators of a map. Dashes count in maps
/// alone: elsewhere they underline headers.
pub(super) fn holds_missing_points(line: &str) -> bool {
    let mut words = line.split(is_separator).filter(|word| !word.is_empty()).peekable();
    let is_wide = count_of_fields(line) > MOST_COLUMNS_OF_A_TABLE;
    let is_of_separators = is_wide && line.chars().all(is_separator);
    let says_so = |word: &str| is_wide || word.contains(|c: char| c.is_alphabetic() || "*?".contains(c));
    is_of_separators
        || words.peek().is_some()
            && words.all(|word| is_missing(word) && says_so(word) && word != NOT_MEASURED)
}

/// The fields of a line that need not have the separator of the file.
pub(super) fn count_of_fields(line: &str) -> usize {
    match line.chars().find(|character| ";\t".contains(*character)) {
        Some(separator) => line.split(separator).count(),
        None if line.contains(char::is_whitespace) => line.split_whitespace().count(),
        None => line.split(',').count(),
    }
}

pub(super) fn is_separator(character: char) -> bool {
    character.is_whitespace() || ";,".contains(character)
}

pub(crate) fn is_comment(line: &str) -> bool {
    let begins_with_mark =
        || line.split(is_separator).next().is_some_and(|word| is_missing(word) && !is_narrow_cell(word));
    line.starts_with(['#', '%']) && !is_narrow_cell(line) && !begins_with_mark()
}

/// Returns true for what spreadsheets show in a cell that is too narrow for its number.
fn is_narrow_cell(field: &str) -> bool {
    field.len() >= 3 && field.bytes().all(|byte| byte == b'#')
}

pub(super) fn is_blank(character: char) -> bool {
    character.is_whitespace() || character == '\u{1a}' || character == '\u{feff}'
}

/// The mark `not measured`, which in small letters is a unit.
const NOT_MEASURED: &str = "NM";

/// Returns true if a field marks a missing point.
pub(crate) fn is_missing(field: &str) -> bool {
    let word = field.trim_start_matches(['+', '-']);
    let is_filler = |sign: char| !field.is_empty() && field.chars().all(|c| c == sign);
    MISSING.iter().any(|missing| missing.eq_ignore_ascii_case(word))
        || word == NOT_MEASURED
        || "-*?".chars().any(is_filler)
        || is_narrow_cell(field)
}

/// Returns true if a line consists of numbers, whatever separates them.
pub(super) fn holds_numbers(line: &str) -> bool {
    let mut has_number = false;
    line.split(is_separator).filter(|word| !word.is_empty()).all(|word| {
        let is_number = word.parse::<f64>().is_ok_and(f64::is_finite);
        has_number |= is_number;
        is_number || is_missing(word)
    }) && has_number
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
    fn words_and_fillers_mark_missing_points() {
        for field in ["***", "*", "-----", "??", "NaN", "-nan", "#N/A", "-1.#IND", "NULL", "missing"] {
            assert!(is_missing(field), "{field}");
        }
        assert!(["", "1", "-1", "*-", "m", "1.#"].iter().all(|field| !is_missing(field)));
        assert!(is_comment("# N/A") && is_comment("%") && !is_comment("#N/A 1"));
    }
}
