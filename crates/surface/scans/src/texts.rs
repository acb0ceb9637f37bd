//! Texts in binary files, truncated to a length that people write.

/// Most bytes kept of a text that people wrote; every channel of a file has a copy.
pub(crate) const MOST_TEXT: usize = 1 << 14;

/// Truncates a text to so many bytes, in memory of its own.
pub(crate) fn shortened(text: String, most_bytes: usize) -> String {
    if text.len() <= most_bytes {
        return text;
    }
    let end = text.floor_char_boundary(most_bytes);
    text[..end].to_owned()
}

/// Decodes Latin-1 up to the first zero byte, without blanks around it, and no more than [`MOST_TEXT`] bytes.
pub(crate) fn latin1(bytes: &[u8]) -> String {
    latin1_at_most(bytes, MOST_TEXT)
}

/// Decodes Latin-1 up to the first zero byte, without blanks around it, and no more than so many bytes.
pub(crate) fn latin1_at_most(bytes: &[u8], most_bytes: usize) -> String {
    let bytes = bytes.get(..most_bytes).unwrap_or(bytes);
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    bytes[..end].iter().map(|&byte| char::from(byte)).collect::<String>().trim().to_owned()
}
