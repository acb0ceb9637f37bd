//! Tables as comma-separated values.

use std::borrow::Cow;
use std::collections::HashSet;
use std::io::{self, Read, Write};

use units::printable::{printable, shortened};
use units::write_number;

use crate::error::TableError;
use crate::table::{Cells, Table};

/// Most letters of a column's name in a message.
const MOST_LETTERS_OF_COLUMN: usize = 80;

/// Reader of CSV rows.
pub(super) struct Rows<'s, R: Read> {
    /// The column names.
    pub names: Vec<String>,
    reader: csv::Reader<Window<R>>,
    source: &'s str,
}

impl<'s, R: Read> Rows<'s, R> {
    /// Reads the header.
    pub fn begin(text: R, source: &'s str) -> Result<Self, TableError> {
        let window = Window { inner: text, bytes: Vec::new(), before: None, delivered: 0 };
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(window);
        let names: Vec<String> = match reader.headers() {
            Ok(names) => names.iter().map(str::to_owned).collect(),
            Err(error) => return Err(refusal(source, 1, error)),
        };
        if names.iter().all(String::is_empty) {
            return Err(TableError::NoHeader { table: source.to_owned() });
        }
        let mut earlier = HashSet::with_capacity(names.len());
        if let Some(twice) = names.iter().find(|name| !earlier.insert(name.as_str())) {
            let column = shortened(twice, MOST_LETTERS_OF_COLUMN).into_owned();
            return Err(TableError::NamedTwice { table: source.to_owned(), column });
        }
        Ok(Rows { names, reader, source })
    }

    /// Reads the next row; returns it with the line that it ends on.
    pub fn next(&mut self) -> Result<Option<(u64, csv::StringRecord)>, TableError> {
        let mut record = csv::StringRecord::new();
        let more = self.reader.read_record(&mut record);
        // A record's own position is that of the comments before it, so the line it ends on is counted from its end.
        let behind = self.reader.position();
        let ended = self.reader.get_ref().byte_before(behind.byte());
        let line = behind.line() - u64::from(ended == Some(b'\n'));
        match more {
            Ok(true) => Ok(Some((line, record))),
            Ok(false) => Ok(None),
            Err(error) => Err(refusal(self.source, line, error)),
        }
    }
}

/// Reader that keeps its last block, to look back by one byte from any place in it.
struct Window<R> {
    inner: R,
    bytes: Vec<u8>,
    before: Option<u8>,
    delivered: u64,
}

impl<R: Read> Read for Window<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.inner.read(buffer)?;
        self.before = self.bytes.last().copied().or(self.before);
        self.bytes.clear();
        self.bytes.extend_from_slice(&buffer[..read]);
        self.delivered += read as u64;
        Ok(read)
    }
}

impl<R> Window<R> {
    /// Returns the byte before a position within the last block.
    fn byte_before(&self, position: u64) -> Option<u8> {
        let begin = self.delivered - self.bytes.len() as u64;
        match position.checked_sub(begin)? {
            0 => self.before,
            within => self.bytes.get(usize::try_from(within - 1).ok()?).copied(),
        }
    }
}

fn refusal(source: &str, line: u64, error: csv::Error) -> TableError {
    let table = source.to_owned();
    match *error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            TableError::UnequalRow { table, line, fields: len, columns: expected_len }
        }
        _ => TableError::Csv { table, line, error },
    }
}

pub(super) fn write_comments(comments: &[String], out: &mut dyn Write) -> io::Result<()> {
    for line in comments.iter().flat_map(|comment| comment.lines()) {
        // A carriage return would end the comment for some readers.
        writeln!(out, "# {}", printable(line))?;
    }
    Ok(())
}

/// Writes rows; `names` writes the column names first.
pub(super) fn write(table: &Table, names: bool, out: &mut dyn Write) -> io::Result<()> {
    if names {
        // A text that begins with a bracket is JSON; with a quotation mark before it, it is not.
        let first = table.columns().next();
        let is_json_like = first.is_some_and(|(name, _)| name.trim_start().starts_with('['));
        let style = if is_json_like { csv::QuoteStyle::Always } else { csv::QuoteStyle::Necessary };
        write_records(&mut *out, style, |writer| {
            let names = table.columns().map(|(name, _)| without_formula(name));
            writer.write_record(names.map(|name| name.into_owned()))
        })?;
    }
    write_records(out, csv::QuoteStyle::Necessary, |writer| write_rows(table, writer))
}

fn write_records(
    out: &mut dyn Write,
    style: csv::QuoteStyle,
    write: impl FnOnce(&mut csv::Writer<&mut dyn Write>) -> csv::Result<()>,
) -> io::Result<()> {
    // The writer must know the comment character: it quotes a first cell that begins with it.
    let mut writer = csv::WriterBuilder::new().comment(Some(b'#')).quote_style(style).from_writer(out);
    write(&mut writer).map_err(|error| match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    })?;
    writer.flush()
}

/// Puts an apostrophe before a text that a spreadsheet would run as a formula; numbers stay as they are.
fn without_formula(text: &str) -> Cow<'_, str> {
    let is_name =
        text.starts_with('-') && text.contains(char::is_alphabetic) && !text.contains(['(', '|', '!']);
    let may_run = text.starts_with(['=', '+', '-', '@', '\t', '\r']) && !is_name;
    match may_run && text.trim().parse::<f64>().is_err() {
        true => Cow::Owned(format!("'{text}")),
        false => Cow::Borrowed(text),
    }
}

fn write_rows(table: &Table, writer: &mut csv::Writer<&mut dyn Write>) -> csv::Result<()> {
    let mut number = String::new();
    for row in 0..table.rows() {
        for (_, cells) in table.columns() {
            number.clear();
            match cells {
                Cells::Typed(cells) => writer.write_field(without_formula(&cells[row].text()).as_ref())?,
                Cells::Words(words) => writer.write_field(words[row])?,
                Cells::Numbers(numbers) => {
                    if let Some(value) = numbers[row].filter(|value| value.is_finite()) {
                        write_number(&mut number, value);
                    }
                    writer.write_field(&number)?;
                }
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_that_spreadsheets_run_are_marked_and_numbers_are_not() {
        for formula in ["=1+1", "+cmd", "-2+3", "-cmd|x!A0", "@SUM(A1)", "\t=1"] {
            assert_eq!(without_formula(formula), format!("'{formula}"));
        }
        for harmless in ["-1.5e-9", "-5C.txt", "+3", "scan.txt", "", "a=b"] {
            assert_eq!(without_formula(harmless), harmless);
        }
    }
}
