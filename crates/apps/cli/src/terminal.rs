//! Standard output on a terminal: text of files is shown there, never obeyed.

use std::io::{self, IsTerminal, Write};

use units::printable::printable;

/// Standard output. A terminal gets printable characters alone; files and pipes get every byte.
pub(crate) fn standard_output() -> Box<dyn Write> {
    let stdout = io::stdout();
    if stdout.is_terminal() { Box::new(PrintableText::new(stdout.lock())) } else { Box::new(stdout.lock()) }
}

/// Writer that replaces what terminals obey.
struct PrintableText<W: Write> {
    out: W,
    /// The begin of a character whose end has not been written yet.
    held: Vec<u8>,
}

impl<W: Write> PrintableText<W> {
    fn new(out: W) -> Self {
        PrintableText { out, held: Vec::new() }
    }
}

impl<W: Write> Write for PrintableText<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.held.extend_from_slice(bytes);
        let whole = match std::str::from_utf8(&self.held) {
            Err(error) if error.error_len().is_none() => error.valid_up_to(),
            _ => self.held.len(),
        };
        let text = String::from_utf8_lossy(&self.held[..whole]).into_owned();
        self.held.drain(..whole);
        self.out.write_all(printable(&text).as_bytes())?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_gets_no_control_character_however_the_bytes_are_split() {
        let text = "a\u{1b}[2J,\u{9b}µm\t\u{202e}z\n";
        for size in 1..=text.len() {
            let mut shown = PrintableText::new(Vec::new());
            text.as_bytes().chunks(size).for_each(|chunk| shown.write_all(chunk).unwrap());
            assert_eq!(shown.out, "a\u{fffd}[2J,\u{fffd}µm\t\u{fffd}z\n".as_bytes());
        }
    }

    #[test]
    fn bytes_that_are_no_text_are_replaced() {
        let mut shown = PrintableText::new(Vec::new());
        shown.write_all(b"a\x9b2Jb").unwrap();
        assert_eq!(shown.out, "a\u{fffd}2Jb".as_bytes());
    }
}
