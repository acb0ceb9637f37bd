//! TIFF as far as microscopes make use of it: pages of tags, of which the makers claim some for themselves.

mod image;

use std::collections::BTreeMap;

use crate::channel::MOST_TEXT;
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;

/// Files of instruments have some dozens of pages; a file with more is damaged.
const MOST_PAGES: usize = 1024;
const MOST_TAGS: usize = 1 << 16;

/// The pages of a file.
pub(super) struct Tiff<'b> {
    pub(super) pages: Vec<Page<'b>>,
}

/// The tags of a page, whose values are all there.
pub(super) struct Page<'b> {
    file: Cursor<'b>,
    format: ScanFormat,
    tags: BTreeMap<u16, Tag<'b>>,
}

/// A value: its type, its bytes, and where they are.
#[derive(Clone, Copy)]
struct Tag<'b> {
    kind: u16,
    bytes: &'b [u8],
    offset: usize,
}

/// The order of bytes of a file that begins as TIFF does.
fn byte_order(bytes: &[u8]) -> Option<ByteOrder> {
    match bytes.first_chunk()? {
        b"II*\0" => Some(ByteOrder::Little),
        b"MM\0*" => Some(ByteOrder::Big),
        _ => None,
    }
}

impl<'b> Tiff<'b> {
    pub(super) fn read(format: ScanFormat, bytes: &'b [u8]) -> Result<Self, ScanReadError> {
        let file = whole(format, bytes);
        let mut cursor = file.at(4);
        let mut pages: Vec<Page> = Vec::new();
        let mut tags = 0;
        loop {
            let offset = cursor.at;
            let place = cursor.u32("the place of a page")? as usize;
            if place == 0 {
                return Ok(Self { pages });
            }
            // Pages may point back at each other.
            if tags > MOST_TAGS || pages.len() == MOST_PAGES {
                let bound = format!("one of at most {MOST_PAGES} with at most {MOST_TAGS} tags in all");
                return Err(cursor.bad(offset, "the page", format!("page {}", pages.len() + 1), &bound));
            }
            cursor = file.at(place);
            let page = Page::read(format, file, &mut cursor)?;
            tags += page.tags.len();
            pages.push(page);
        }
    }
}

/// Reads the first page alone, by which formats are recognised.
pub(super) fn first_page<'b>(format: ScanFormat, bytes: &'b [u8]) -> Option<Page<'b>> {
    byte_order(bytes)?;
    let file = whole(format, bytes);
    let place = file.at(4).u32("the place of a page").ok()?;
    Page::read(format, file, &mut file.at(place as usize)).ok()
}

fn whole(format: ScanFormat, bytes: &[u8]) -> Cursor<'_> {
    Cursor::new(format, bytes, byte_order(bytes).unwrap_or(ByteOrder::Little))
}

impl<'b> Page<'b> {
    /// Reads the tags; the cursor then is at the place of the next page. Tags of an unknown type are passed over.
    fn read(format: ScanFormat, file: Cursor<'b>, cursor: &mut Cursor<'b>) -> Result<Self, ScanReadError> {
        let mut tags = BTreeMap::new();
        for _ in 0..cursor.u16("the number of tags")? {
            let number = cursor.u16("a tag")?;
            let kind = cursor.u16("the type of a tag")?;
            let count = cursor.u32("the number of values of a tag")? as usize;
            let Some(bytes_each) = bytes_of(kind) else {
                cursor.skip(4, "the value of a tag")?;
                continue;
            };
            let length = count.saturating_mul(bytes_each);
            // Values of up to four bytes stand where the place of others does.
            let inside = cursor.at;
            let place = cursor.u32("the value of a tag")? as usize;
            let offset = if length <= 4 { inside } else { place };
            let bytes = file.at(offset).take(length, &format!("the value of tag {number}"))?;
            tags.entry(number).or_insert(Tag { kind, bytes, offset });
        }
        Ok(Self { file, format, tags })
    }

    /// The bytes of a tag with the place where they are.
    pub(super) fn bytes(&self, tag: u16) -> Result<(&'b [u8], usize), ScanReadError> {
        self.tags.get(&tag).map(|tag| (tag.bytes, tag.offset)).ok_or_else(|| self.missing(tag))
    }

    /// A text in Latin-1, or in UTF-16 where every other byte is 0.
    pub(super) fn text(&self, tag: u16) -> Option<String> {
        let bytes = self.tags.get(&tag)?.bytes;
        let (pairs, _) = bytes.as_chunks::<2>();
        if pairs.first().is_some_and(|[low, high]| *low != 0 && *high == 0) && pairs.len() > 1 {
            return Some(utf16(bytes));
        }
        Some(latin1(bytes))
    }

    /// The first number of a tag.
    pub(super) fn number(&self, tag: u16) -> Option<f64> {
        let tag = self.tags.get(&tag)?;
        self.numbers(tag).next()
    }

    fn numbers(&self, tag: &Tag<'b>) -> impl Iterator<Item = f64> {
        let mut cursor = self.file.at(tag.offset);
        let (kind, end) = (tag.kind, tag.offset + tag.bytes.len());
        std::iter::from_fn(move || {
            if cursor.at >= end {
                return None;
            }
            let what = "a number";
            match kind {
                1 | 7 => cursor.u8(what).map(f64::from),
                3 => cursor.u16(what).map(f64::from),
                4 => cursor.u32(what).map(f64::from),
                6 => cursor.i8(what).map(f64::from),
                8 => cursor.i16(what).map(f64::from),
                9 => cursor.i32(what).map(f64::from),
                11 => cursor.f32(what).map(f64::from),
                12 => cursor.f64(what),
                _ => return None,
            }
            .ok()
        })
    }

    fn missing(&self, tag: u16) -> ScanReadError {
        self.format.missing(FilePlace::File, format!("tag {tag}"), "export the file again")
    }
}

/// Length of a value of a type.
fn bytes_of(kind: u16) -> Option<usize> {
    Some(match kind {
        1 | 2 | 6 | 7 => 1,
        3 | 8 => 2,
        4 | 9 | 11 => 4,
        5 | 10 | 12 => 8,
        _ => return None,
    })
}

/// UTF-16 in the order of Intel up to the first zero, without blanks around it.
pub(super) fn utf16(bytes: &[u8]) -> String {
    let (pairs, _) = bytes.get(..MOST_TEXT).unwrap_or(bytes).as_chunks::<2>();
    let letters = pairs.iter().map(|pair| u16::from_le_bytes(*pair)).take_while(|&letter| letter != 0);
    let text: String =
        char::decode_utf16(letters).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER)).collect();
    text.trim().to_owned()
}
