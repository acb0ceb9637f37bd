//! Decoding of text and classification of its lines.

use crate::read::error::{Encoding, LineProblem, ReadError};

/// Decodes a file: checks that it is UTF-8 without zero bytes, which mark binary files, and removes its byte-order
/// mark.
pub(crate) fn decode(bytes: &[u8]) -> Result<&str, ReadError> {
    let (text, end) = match std::str::from_utf8(bytes) {
        Ok(text) => (text, text.find('\0')),
        Err(error) => ("", Some(error.valid_up_to())),
    };
    let Some(end) = end else { return Ok(text.strip_prefix('\u{feff}').unwrap_or(text)) };
    let line = 1 + bytes[..end].iter().filter(|&&byte| byte == b'\n').count();
    let encoding = Encoding::guess(bytes);
    Err(LineProblem::NotText { offset: end + 1, byte: bytes[end], encoding }.at(line))
}

/// Returns the text of a comment line, without `#` and surrounding blanks.
pub(crate) fn comment(line: &str) -> Option<&str> {
    line.trim_start().strip_prefix('#').map(|rest| rest.trim_start_matches('#').trim())
}

/// Returns true if a line holds no row.
pub(crate) fn is_blank_or_comment(line: &str) -> bool {
    let line = line.trim_start();
    line.is_empty() || line.starts_with('#')
}

/// Returns true if a field holds a number.
pub(crate) fn is_number(field: Option<&str>) -> bool {
    field.is_some_and(|field| field.parse::<f64>().is_ok())
}
