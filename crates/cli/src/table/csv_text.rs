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
    let names = reader.headers().map_err(|error| refuse(source, &error))?.iter().map(str::to_owned).collect();
    let rows = reader
        .into_records()
        .map(|record| {
            let record = record.map_err(|error| refuse(source, &error))?;
            Ok((record.position().map_or(0, csv::Position::line), record))
        })
        .collect::<Result<_, Failure>>()?;
    Ok(Fields { names, rows })
}

fn refuse(source: &str, error: &csv::Error) -> Failure {
    let line = error.position().map_or(String::new(), |position| format!(", line {}", position.line()));
    Failure::input(match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!(
                "{source}{line}: {len} fields; the header has {expected_len}, and every row must have as many"
            )
        }
        _ => format!("{source}{line}: {error}"),
    })
}

pub(super) fn write(table: &Table, comments: &[String], out: &mut dyn Write) -> io::Result<()> {
    for comment in comments {
        writeln!(out, "# {comment}")?;
    }
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(table.columns().map(|(name, _)| name))?;
    let mut number = String::new();
    for row in 0..table.rows() {
        for (_, cells) in table.columns() {
            number.clear();
            match cells {
                Cells::Typed(cells) => writer.write_field(cells[row].text().as_ref())?,
                Cells::Words(words) => writer.write_field(words[row])?,
                Cells::Numbers(numbers) => {
                    if let Some(value) = numbers[row] {
                        write_number(&mut number, value);
                    }
                    writer.write_field(&number)?;
                }
            }
        }
        writer.write_record(None::<&[u8]>)?;
    }
    writer.flush()
}

impl From<&str> for Cell {
    fn from(field: &str) -> Self {
        Cell::Field(field.to_owned())
    }
}
