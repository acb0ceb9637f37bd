//! Entries of the tree: a tag of two bytes, a length of eight, and data or further entries.

use super::FORMAT;
use crate::channel::MOST_TEXT;
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};

/// Texts begin with this byte.
const TEXT: u8 = 4;

/// The content of an entry, with its place in the stream.
#[derive(Clone, Copy)]
pub(super) struct Entry<'b> {
    stream: &'b [u8],
    pub(super) offset: usize,
    end: usize,
}

impl<'b> Entry<'b> {
    /// The whole stream.
    pub(super) fn root(stream: &'b [u8]) -> Self {
        Self { stream, offset: 0, end: stream.len() }
    }

    /// A reader of the content.
    pub(super) fn cursor(&self) -> Cursor<'b> {
        let content = self.stream.get(..self.end).unwrap_or(self.stream);
        Cursor::new(FORMAT, content, ByteOrder::Little).at(self.offset)
    }

    /// Skips the first bytes.
    pub(super) fn after(&self, bytes: usize, what: &str) -> Result<Self, ScanReadError> {
        let mut cursor = self.cursor();
        cursor.skip(bytes, what)?;
        Ok(Self { offset: cursor.at, ..*self })
    }

    /// The entry that a path of tags leads to, of each tag the first; none where one of them is missing.
    pub(super) fn optional(&self, path: &[u16]) -> Result<Option<Self>, ScanReadError> {
        let mut entry = *self;
        for tag in path {
            match entry.child(*tag)? {
                Some(child) => entry = child,
                None => return Ok(None),
            }
        }
        Ok(Some(entry))
    }

    /// Returns an entry that must be there.
    pub(super) fn required(&self, path: &[u16]) -> Result<Self, ScanReadError> {
        self.optional(path)?.ok_or_else(|| {
            FORMAT.missing(
                FilePlace::Byte(self.offset as u64),
                format!("entry {path:x?} in this part of the document"),
                "export the surface from MountainsMap as SUR or X3P",
            )
        })
    }

    fn child(&self, tag: u16) -> Result<Option<Self>, ScanReadError> {
        let mut cursor = self.cursor();
        while !cursor.rest().is_empty() {
            let (own, child) = self.next(&mut cursor)?;
            if own == tag {
                return Ok(Some(child));
            }
        }
        Ok(None)
    }

    /// The entries with the tag 1 of a list, each behind a number of eight bytes.
    pub(super) fn listed(&self) -> Result<Vec<Self>, ScanReadError> {
        let mut cursor = self.cursor();
        let mut found = Vec::new();
        while !cursor.rest().is_empty() {
            cursor.skip(8, "the number of an entry")?;
            let (tag, child) = self.next(&mut cursor)?;
            if tag == 1 {
                found.push(child);
            }
        }
        Ok(found)
    }

    fn next(&self, cursor: &mut Cursor<'b>) -> Result<(u16, Self), ScanReadError> {
        let tag = cursor.u16("the tag of an entry")?;
        let length = cursor.u64("the length of an entry")?;
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let offset = cursor.at;
        cursor.skip(length, "an entry")?;
        Ok((tag, Self { stream: self.stream, offset, end: cursor.at }))
    }

    pub(super) fn u32(&self, what: &str) -> Result<u32, ScanReadError> {
        self.cursor().u32(what)
    }

    pub(super) fn f64(&self, what: &str) -> Result<f64, ScanReadError> {
        self.cursor().f64(what)
    }

    pub(super) fn count(&self, what: &str) -> Result<usize, ScanReadError> {
        self.cursor().count(what)
    }

    /// The text of an entry, where it is one.
    pub(super) fn text(&self) -> Option<String> {
        let (&TEXT, text) = self.cursor().rest().split_first()? else { return None };
        let text = text.get(..MOST_TEXT).unwrap_or(text);
        let units: Vec<u16> = text.as_chunks().0.iter().copied().map(u16::from_le_bytes).collect();
        Some(String::from_utf16_lossy(&units).trim_end_matches('\0').trim().to_owned())
    }
}
