//! The tree of values: each has a name, a type, and content as its type has it.

use std::collections::HashMap;

use super::FORMAT;
use crate::channel::MOST_TEXT;
use crate::cursor::{ByteOrder, Cursor};
use crate::error::ScanReadError;

/// First bytes of every file.
pub(super) const MAGIC: &[u8] = b"VCA DATA\x01\x00\x00\x55";

/// Files nest their values four deep.
const DEEPEST: usize = 32;
/// Most values, and most bytes of their paths; files have some hundreds of some dozen letters.
const MOST_VALUES: usize = 50_000;
const LONGEST_PATH: usize = 512;

/// Values by the paths of their names, each with its place in the order of the file.
pub(super) struct Tree {
    values: HashMap<String, (usize, Value)>,
}

/// Content of a value, as far as it is of use; bytes are counted from the beginning of the file.
#[derive(Debug, PartialEq)]
pub(super) enum Value {
    Number(f64),
    Text(String),
    Quantity { value: f64, unit: String },
    Numbers { offset: usize, length: usize },
    Matrix { columns: usize, rows: usize, offset: usize, length: usize },
}

impl Tree {
    pub(super) fn read(bytes: &[u8]) -> Result<Self, ScanReadError> {
        let mut tree = Self { values: HashMap::new() };
        tree.take_items(bytes, MAGIC.len(), "", 0)?;
        Ok(tree)
    }

    pub(super) fn get(&self, path: &str) -> Option<&Value> {
        self.values.get(path).map(|(_, value)| value)
    }

    /// The paths in the order of the file.
    pub(super) fn paths(&self) -> impl Iterator<Item = &str> {
        let mut paths: Vec<_> =
            self.values.iter().map(|(path, (place, _))| (*place, path.as_str())).collect();
        paths.sort_unstable();
        paths.into_iter().map(|(_, path)| path)
    }

    pub(super) fn text(&self, path: &str) -> Option<&str> {
        match self.get(path)? {
            Value::Text(text) => Some(text),
            _ => None,
        }
    }

    pub(super) fn number(&self, path: &str) -> Option<f64> {
        match self.get(path)? {
            Value::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// A finite number with its unit.
    pub(super) fn quantity(&self, path: &str) -> Option<(f64, &str)> {
        match self.get(path)? {
            Value::Quantity { value, unit } if value.is_finite() => Some((*value, unit)),
            _ => None,
        }
    }

    /// The values up to the end of the bytes, or to the mark of an end.
    fn take_items(
        &mut self,
        bytes: &[u8],
        start: usize,
        parent: &str,
        depth: usize,
    ) -> Result<(), ScanReadError> {
        let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(start);
        if depth > DEEPEST {
            let bound = format!("at most {DEEPEST}");
            return Err(cursor.bad(start, "the depth of nested values", depth, &bound));
        }
        while !cursor.rest().is_empty() {
            let name_offset = cursor.at;
            let name = name(&mut cursor)?;
            let offset = cursor.at;
            let kind = cursor.u8("the type of a value")?;
            if kind == END {
                break;
            }
            if parent.len() + name.len() >= LONGEST_PATH {
                let bound = format!("below {LONGEST_PATH} with those of the values around it");
                return Err(cursor.bad(name_offset, "the length of a name", name.len(), &bound));
            }
            let path = format!("{parent}/{name}");
            if CONTAINERS.contains(&kind) {
                let length = length(&mut cursor)?;
                let start = cursor.at;
                cursor.skip(length, &format!("the values of '{path}'"))?;
                let within = bytes.get(..start.saturating_add(length)).unwrap_or(bytes);
                self.take_items(within, start, &path, depth + 1)?;
            } else if let Some(value) = value(&mut cursor, kind, offset)? {
                if self.values.len() >= MOST_VALUES {
                    let bound = format!("at most {MOST_VALUES}");
                    let found = format!("{MOST_VALUES} and more");
                    return Err(cursor.bad(name_offset, "the number of values", &found, &bound));
                }
                self.put(path, value);
            }
        }
        Ok(())
    }

    /// Adds a value; of several at one path the first counts.
    fn put(&mut self, path: String, value: Value) {
        let place = self.values.len();
        self.values.entry(path).or_insert((place, value));
    }
}

/// Groups of values, of which two are those of profiles and maps.
const CONTAINERS: [u8; 3] = [0x7d, 0x46, 0x47];
const END: u8 = 0x7f;

/// The content of a value; none where it is of no use.
fn value(cursor: &mut Cursor, kind: u8, offset: usize) -> Result<Option<Value>, ScanReadError> {
    const WHAT: &str = "a value";
    let number = |number: f64| Ok(Some(Value::Number(number)));
    match kind {
        0x01 => number(f64::from(cursor.u8(WHAT)?)),
        0x04 => number(f64::from(cursor.i16(WHAT)?)),
        0x05 => number(f64::from(cursor.u16(WHAT)?)),
        0x06 => number(f64::from(cursor.i32(WHAT)?)),
        0x07 => number(f64::from(cursor.u32(WHAT)?)),
        0x0a => number(cursor.i64(WHAT)? as f64),
        0x0b => number(cursor.u64(WHAT)? as f64),
        0x0c => number(f64::from(cursor.f32(WHAT)?)),
        0x0d => number(cursor.f64(WHAT)?),
        0x12 => {
            let length = length(cursor)?;
            Ok(Some(Value::Text(utf8(cursor.take(length, "a text")?))))
        }
        0x13 => quantity(cursor).map(Some),
        // The time, in nine bytes.
        0x15 => cursor.skip(9, "a time").map(|()| None),
        // A unit.
        0x18 => skip_counted(cursor),
        // A type, a list of texts, positions: named after their type.
        0x0e | 0x42 | 0x7c => {
            name(cursor)?;
            skip_counted(cursor)
        }
        0x40 => {
            name(cursor)?;
            let length = length(cursor)?;
            let offset = cursor.at;
            cursor.skip(length, "an array of numbers")?;
            Ok(Some(Value::Numbers { offset, length }))
        }
        0x00 => {
            name(cursor)?;
            cursor.skip(4, "the number of a type")?;
            name(cursor)?;
            matrix(cursor).map(Some)
        }
        0x45 => {
            name(cursor)?;
            matrix(cursor).map(Some)
        }
        other => {
            Err(cursor.bad(offset, "the type of a value", format!("0x{other:02x}"), "one that is known"))
        }
    }
}

fn skip_counted(cursor: &mut Cursor) -> Result<Option<Value>, ScanReadError> {
    let length = length(cursor)?;
    cursor.skip(length, "a value").map(|()| None)
}

/// A number, then the name and the sign of its unit.
fn quantity(cursor: &mut Cursor) -> Result<Value, ScanReadError> {
    let length = length(cursor)?;
    let mut within = *cursor;
    cursor.skip(length, "a quantity")?;
    let value = within.f64("a quantity")?;
    let word = name(&mut within)?;
    let sign = name(&mut within)?;
    Ok(Value::Quantity { value, unit: if sign.is_empty() { word } else { sign } })
}

/// The numbers of rows and columns, then the points row after row.
fn matrix(cursor: &mut Cursor) -> Result<Value, ScanReadError> {
    let length = length(cursor)?;
    let start = cursor.at;
    let mut within = *cursor;
    cursor.skip(length, "a matrix")?;
    let rows = within.count("the number of rows")?;
    let columns = within.count("the number of columns")?;
    let offset = within.at;
    Ok(Value::Matrix { columns, rows, offset, length: length.saturating_sub(offset - start) })
}

/// A text behind its length of four bytes.
fn name(cursor: &mut Cursor) -> Result<String, ScanReadError> {
    let length = cursor.u32("the length of a name")? as usize;
    Ok(utf8(cursor.take(length, "a name")?))
}

/// A length behind the number of its bytes.
fn length(cursor: &mut Cursor) -> Result<usize, ScanReadError> {
    const WHAT: &str = "a length";
    let offset = cursor.at;
    match cursor.u8(WHAT)? {
        1 => Ok(usize::from(cursor.u8(WHAT)?)),
        2 => Ok(usize::from(cursor.u16(WHAT)?)),
        4 => Ok(cursor.u32(WHAT)? as usize),
        other => Err(cursor.bad(offset, "the number of bytes of a length", other, "1, 2 or 4")),
    }
}

/// A text, or the beginning of one that is longer than any that people write.
fn utf8(bytes: &[u8]) -> String {
    let bytes = bytes.get(..MOST_TEXT).unwrap_or(bytes);
    String::from_utf8_lossy(bytes).into_owned()
}
