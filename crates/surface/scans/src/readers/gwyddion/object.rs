//! Objects as Gwyddion writes them: a name, a size in bytes, and components of a name, a type and a value.

use super::damage::MEND;
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;

/// The format whose reader this is, for messages.
pub(super) const FORMAT: ScanFormat = ScanFormat::Gwyddion;

/// First bytes of the components of an object.
#[derive(Clone, Copy)]
enum Layout {
    /// A name, then the letter of a type.
    NameFirst,
    /// The number that GLib has for a type, then a name: the outermost container of versions before 2.0.
    TypeFirst,
}

/// An object whose bytes are all there; its components are looked at one by one.
#[derive(Clone, Copy)]
pub(super) struct Object<'b> {
    pub(super) class: &'b [u8],
    layout: Layout,
    components: Cursor<'b>,
}

/// The value of a component.
pub(super) enum Value<'b> {
    Integer(i64),
    Real(f64),
    Text(&'b [u8]),
    Object(Object<'b>),
    Objects(Objects<'b>),
    /// So many numbers of eight bytes from this byte of the file on.
    Reals {
        offset: usize,
        count: usize,
    },
    /// A value that no reader of heights needs; it is skipped.
    Other,
}

/// The objects of an array, one by one.
pub(super) struct Objects<'b> {
    owner: Object<'b>,
    cursor: Cursor<'b>,
    left: u32,
}

impl<'b> Iterator for Objects<'b> {
    type Item = Result<Object<'b>, ScanReadError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.left = self.left.checked_sub(1)?;
        Some(self.owner.inner(&mut self.cursor))
    }
}

/// A component.
pub(super) struct Component<'b> {
    pub(super) name: &'b [u8],
    pub(super) value: Value<'b>,
}

impl<'b> Object<'b> {
    /// The container that a whole file is, behind its mark.
    pub(super) fn of_file(bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little);
        let mark = cursor.take(super::MARK.len(), "the mark of the format")?;
        let layout = if mark == super::OLD_MARK { Layout::TypeFirst } else { Layout::NameFirst };
        Ok(Self { layout, ..Self::read(&mut cursor, bytes)? })
    }

    fn read(cursor: &mut Cursor<'b>, bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let class = cursor.zero_terminated("the name of an object")?;
        let size = cursor.u32("the size of an object")? as usize;
        let start = cursor.at;
        cursor.skip(size, &format!("the object '{}'", latin1(class)))?;
        let own = bytes.get(..cursor.at).unwrap_or_default();
        let components = Cursor::new(FORMAT, own, ByteOrder::Little).at(start);
        Ok(Self { class, layout: Layout::NameFirst, components })
    }

    /// The components in their order, up to the first that is damaged.
    pub(super) fn components(self) -> impl Iterator<Item = Result<Component<'b>, ScanReadError>> {
        let mut cursor = self.components;
        let mut is_whole = true;
        std::iter::from_fn(move || {
            if !is_whole || cursor.rest().is_empty() {
                return None;
            }
            let component = self.component(&mut cursor);
            is_whole = component.is_ok();
            Some(component)
        })
    }

    /// The text of a `GwySIUnit`; Gwyddion writes units without prefixes, other programs also with.
    pub(super) fn unit_text(self) -> Result<String, ScanReadError> {
        let mut text = String::new();
        for component in self.components() {
            if let (b"unitstr", Value::Text(found)) = component.map(|found| (found.name, found.value))? {
                text = utf8(found);
            }
        }
        Ok(text)
    }

    fn component(&self, cursor: &mut Cursor<'b>) -> Result<Component<'b>, ScanReadError> {
        let offset = cursor.at;
        let (name, kind) = match self.layout {
            Layout::NameFirst => {
                let name = cursor.zero_terminated("the name of a component")?;
                (name, cursor.u8("the type of a component")?)
            }
            Layout::TypeFirst => {
                let number = cursor.u32("the type of a component")?;
                let kind = letter_of(number).ok_or_else(|| unknown_type(offset, &number.to_string()))?;
                (cursor.zero_terminated("the name of a component")?, kind)
            }
        };
        let value = self.value(cursor, kind)?;
        Ok(Component { name, value })
    }

    fn value(&self, cursor: &mut Cursor<'b>, kind: u8) -> Result<Value<'b>, ScanReadError> {
        let what = "the value of a component";
        Ok(match kind {
            b'b' | b'c' => Value::Integer(cursor.u8(what)?.into()),
            b'i' => Value::Integer(cursor.i32(what)?.into()),
            b'q' => Value::Integer(cursor.i64(what)?),
            b'd' => Value::Real(cursor.f64(what)?),
            b's' => Value::Text(cursor.zero_terminated(what)?),
            b'o' => Value::Object(self.inner(cursor)?),
            b'D' => {
                let (offset, count) = array(cursor, 8)?;
                Value::Reals { offset, count }
            }
            b'C' => skipped_array(cursor, 1)?,
            b'I' => skipped_array(cursor, 4)?,
            b'Q' => skipped_array(cursor, 8)?,
            b'S' => {
                for _ in 0..cursor.u32(what)? {
                    cursor.zero_terminated(what)?;
                }
                Value::Other
            }
            b'O' => {
                let left = cursor.u32(what)?;
                let objects = Objects { owner: *self, cursor: *cursor, left };
                for _ in 0..left {
                    self.inner(cursor)?;
                }
                Value::Objects(objects)
            }
            _ => return Err(unknown_type(cursor.at - 1, &format!("'{}'", kind.escape_ascii()))),
        })
    }

    /// An object within this one, beyond which it cannot reach.
    fn inner(&self, cursor: &mut Cursor<'b>) -> Result<Self, ScanReadError> {
        let start = self.components.at(0);
        Self::read(cursor, start.rest())
    }
}

/// A text without blanks around it; bytes that are no UTF-8 are replaced.
pub(super) fn utf8(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}

/// Returns the bytes and the number of the elements of an array, all of which are there.
fn array(cursor: &mut Cursor, bytes_each: usize) -> Result<(usize, usize), ScanReadError> {
    let count = cursor.u32("the length of an array")? as usize;
    let offset = cursor.at;
    cursor.skip(count.saturating_mul(bytes_each), "an array")?;
    Ok((offset, count))
}

fn skipped_array<'b>(cursor: &mut Cursor<'b>, bytes_each: usize) -> Result<Value<'b>, ScanReadError> {
    array(cursor, bytes_each).map(|_| Value::Other)
}

/// The letter for one of GLib's fundamental types.
fn letter_of(number: u32) -> Option<u8> {
    Some(match number >> 2 {
        3 | 4 => b'c',
        5 => b'b',
        6 | 7 => b'i',
        10 | 11 => b'q',
        15 => b'd',
        16 => b's',
        20 => b'o',
        _ => return None,
    })
}

fn unknown_type(offset: usize, found: &str) -> ScanReadError {
    FORMAT.bad(
        FilePlace::Byte(offset as u64),
        "the type of a component",
        found,
        "one of the letters b, c, i, q, d, s, o, C, I, Q, D, S, O",
        MEND,
    )
}
