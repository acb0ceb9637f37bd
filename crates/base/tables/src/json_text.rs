//! Tables as a JSON array of row objects.

use std::io::{self, Read, Write};

use indexmap::IndexMap;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;

use units::write_number;

use crate::error::TableError;
use crate::table::{Cell, Cells, Table};

pub(super) type Row = IndexMap<String, Box<RawValue>>;

/// A row with its keys checked for repeats; a plain map would keep the last of two equal keys.
struct RowText(Row);

impl<'de> Deserialize<'de> for RowText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(RowVisitor).map(RowText)
    }
}

struct RowVisitor;

impl<'de> Visitor<'de> for RowVisitor {
    type Value = Row;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "a row object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Row, A::Error> {
        let mut row = Row::new();
        while let Some((key, value)) = entries.next_entry::<String, Box<RawValue>>()? {
            if row.contains_key(&key) {
                return Err(A::Error::custom(format!("key {key:?} appears twice in a row; keep one")));
            }
            row.insert(key, value);
        }
        Ok(row)
    }
}

/// Reads an array of rows one at a time.
pub(super) fn each_row<E: From<TableError>>(
    text: impl Read,
    source: &str,
    each: &mut dyn FnMut(Row) -> Result<(), E>,
) -> Result<(), E> {
    let mut stopped = None;
    let mut deserializer = serde_json::Deserializer::from_reader(text);
    let read = deserializer
        .deserialize_seq(RowsVisitor { each, stopped: &mut stopped })
        .and_then(|()| deserializer.end());
    match (stopped, read) {
        (Some(error), _) => Err(error),
        (None, Ok(())) => Ok(()),
        (None, Err(error)) => Err(TableError::Json { table: source.to_owned(), error }.into()),
    }
}

struct RowsVisitor<'e, E> {
    each: &'e mut dyn FnMut(Row) -> Result<(), E>,
    /// The error with which `each` stopped.
    stopped: &'e mut Option<E>,
}

impl<'de, E> Visitor<'de> for RowsVisitor<'_, E> {
    type Value = ();

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "a sequence")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut rows: A) -> Result<(), A::Error> {
        while let Some(RowText(row)) = rows.next_element()? {
            if let Err(error) = (self.each)(row) {
                *self.stopped = Some(error);
                return Err(A::Error::custom("stopped"));
            }
        }
        Ok(())
    }
}

/// Writes rows; `first` is true if none was written before.
pub(super) fn write(table: &Table, first: bool, out: &mut dyn Write) -> io::Result<()> {
    let keys: Vec<String> =
        table.columns().map(|(name, _)| serde_json::to_string(name)).collect::<Result<_, _>>()?;
    let mut text = String::new();
    for row in 0..table.rows() {
        text.push_str(if first && row == 0 { "\n{" } else { ",\n{" });
        for (column, (key, (_, cells))) in keys.iter().zip(table.columns()).enumerate() {
            text.push_str(if column == 0 { "" } else { "," });
            text.push_str(key);
            text.push(':');
            write_cell(&mut text, cells, row)?;
        }
        text.push('}');
        out.write_all(text.as_bytes())?;
        text.clear();
    }
    Ok(())
}

fn write_cell(text: &mut String, cells: &Cells, row: usize) -> io::Result<()> {
    match cells {
        Cells::Words(words) => text.push_str(&serde_json::to_string(words[row])?),
        Cells::Numbers(numbers) => write_finite(text, numbers[row]),
        Cells::Typed(cells) => match &cells[row] {
            Cell::Json(raw) => text.push_str(raw.get()),
            Cell::Computed(value) => write_finite(text, Some(*value)),
            Cell::Field(field) if field.is_empty() => text.push_str("null"),
            Cell::Field(field) if is_json_number(field) => text.push_str(field),
            Cell::Field(field) => text.push_str(&serde_json::to_string(field)?),
        },
    }
    Ok(())
}

/// Writes a number; infinities and NaN, which JSON lacks, become null.
fn write_finite(text: &mut String, value: Option<f64>) {
    match value.filter(|value| value.is_finite()) {
        Some(value) => write_number(text, value),
        None => text.push_str("null"),
    }
}

fn is_json_number(field: &str) -> bool {
    field.starts_with(|c: char| c.is_ascii_digit() || c == '-')
        && field.ends_with(|c: char| c.is_ascii_digit())
        && serde_json::from_str::<&RawValue>(field).is_ok()
}
