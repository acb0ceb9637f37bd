//! Tables as comma-separated values.

use std::io::{self, Write};

use super::{Cell, Cells, Table};
use crate::failure::Failure;
use crate::number::write_number;

/// Column names, and rows with the line each began on.
pub(super) struct Fields {
    pub names: Vec<String>,
    pub rows: Vec<(u64, csv::StringRecord)>,
}

pub(super) fn read(text: &str, source: &str) -> Result<Fields, Failure> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let refuse = |error: &csv::Error, line: u64| refusal(source, line, error);
    let names = match reader.headers() {
        Ok(names) => names.iter().map(str::to_owned).collect(),
        Err(error) => return Err(refuse(&error, 1)),
    };
    let mut rows = Vec::new();
    loop {
        let mut record = csv::StringRecord::new();
        let more = reader.read_record(&mut record);
        // A record's own position is that of the comments before it: the line it ends on is counted from behind.
        let behind = reader.position();
        let ended =
            usize::try_from(behind.byte()).ok().and_then(|byte| text.as_bytes().get(byte.checked_sub(1)?));
        let line = behind.line() - u64::from(ended == Some(&b'\n'));
        match more {
            Ok(true) => rows.push((line, record)),
            Ok(false) => return Ok(Fields { names, rows }),
            Err(error) => return Err(refuse(&error, line)),
        }
    }
}

fn refusal(source: &str, line: u64, error: &csv::Error) -> Failure {
    Failure::input(match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!(
                "{source}, line {line}: {len} fields; the header has {expected_len}, and every row must have as many"
            )
        }
        _ => format!("{source}, line {line}: {error}"),
    })
}

pub(super) fn write(table: &Table, comments: &[String], out: &mut dyn Write) -> io::Result<()> {
    for line in comments.iter().flat_map(|comment| comment.lines()) {
        writeln!(out, "# {line}")?;
    }
    // A first cell that begins like a comment is quoted, or the next reader would take its row for one.
    let mut writer = csv::WriterBuilder::new().comment(Some(b'#')).from_writer(out);
    write_rows(table, &mut writer).map_err(|error| match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    })?;
    writer.flush()
}

fn write_rows(table: &Table, writer: &mut csv::Writer<&mut dyn Write>) -> csv::Result<()> {
    writer.write_record(table.columns().map(|(name, _)| name))?;
    let mut number = String::new();
    for row in 0..table.rows() {
        for (_, cells) in table.columns() {
            number.clear();
            match cells {
                Cells::Typed(cells) => writer.write_field(cells[row].text().as_ref())?,
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

impl From<&str> for Cell {
    fn from(field: &str) -> Self {
        Cell::Field(field.to_owned())
    }
}
