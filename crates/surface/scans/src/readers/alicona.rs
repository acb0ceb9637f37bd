//! Alicona Imaging, InfiniteFocus: `.al3d`.
//!
//! A list of tags of fixed length, a comment, then pictures at the places that the tags tell, little-endian, as the
//! maker's description and the readers of Gwyddion and SurfaceTopography have it. Lengths are in m.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;

const FORMAT: ScanFormat = ScanFormat::Alicona;
const MAGIC: &[u8] = b"AliconaImaging\0\r\n";
/// Files have some dozens.
const MOST_TAGS: usize = 10_000;
/// Rows are filled up to a multiple of so many bytes.
const ROW_BYTES: usize = 8;
/// Relative precision of the mark of missing points.
const MARK_DIGITS: f64 = 2e-7;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// A key and its value, with the place of the value.
struct Tag {
    key: String,
    value: String,
    offset: usize,
}

struct Tags<'b> {
    tags: Vec<Tag>,
    cursor: Cursor<'b>,
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(MAGIC.len());
    let tags = Tags { tags: tags(&mut cursor)?, cursor };
    let comment = cursor.text(256, "the comment")?;
    let [columns, rows] = [tags.count("Cols")?, tags.count("Rows")?];
    let offset = tags.count("DepthImageOffset")?;
    let stride =
        columns.checked_mul(NumberType::F32.bytes()).and_then(|row| row.checked_next_multiple_of(ROW_BYTES));
    let raster = Raster::within(NumberType::F32, columns, rows, bytes, offset);
    let raster = Raster { stride, missing: missing(&tags)?, ..raster };
    Ok(vec![Channel {
        probe: Some(Probe::Microscope),
        free_text: comment,
        ..Channel::new(None, Quantity::HEIGHTS_IN_M, lateral(&tags)?, Samples::Raster(raster))
    }])
}

/// The version, the number of tags, and so many more.
fn tags(cursor: &mut Cursor) -> Result<Vec<Tag>, ScanReadError> {
    let version = tag(cursor, Some("Version"))?;
    let count = tag(cursor, Some("TagCount"))?;
    let number = count.value.parse().ok().filter(|&number: &usize| number <= MOST_TAGS);
    let number = number.ok_or_else(|| bad(cursor, &count, &format!("a whole number up to {MOST_TAGS}")))?;
    let mut tags = vec![version];
    for _ in 0..number {
        tags.push(tag(cursor, None)?);
    }
    Ok(tags)
}

fn tag(cursor: &mut Cursor, expected: Option<&str>) -> Result<Tag, ScanReadError> {
    let start = cursor.at;
    let key = cursor.text(20, "the key of a tag")?;
    if let Some(expected) = expected.filter(|expected| *expected != key) {
        return Err(cursor.bad(start, "the key of a tag", format!("'{key}'"), &format!("'{expected}'")));
    }
    let offset = cursor.at;
    let value = cursor.text(30, "the value of a tag")?;
    let end = cursor.at;
    if cursor.take(2, "the end of a tag")? != b"\r\n" {
        return Err(cursor.bad(end, "the end of a tag", "another", "a line break"));
    }
    Ok(Tag { key, value, offset })
}

/// Points without a height hold the number of a tag. A large one is told by its size, since it may be written with
/// fewer digits than it has: no surface is a metre high.
fn missing<'b>(tags: &Tags) -> Result<MissingMark<'b>, ScanReadError> {
    Ok(match tags.number("InvalidPixelValue")? {
        Some(mark) if mark >= 1.0 => MissingMark::AtLeast(mark * (1.0 - MARK_DIGITS)),
        Some(mark) if mark <= -1.0 => MissingMark::AtMost(mark * (1.0 - MARK_DIGITS)),
        Some(mark) if mark.is_finite() => MissingMark::Equal(f64::from(mark as f32)),
        _ => MissingMark::None,
    })
}

fn lateral(tags: &Tags) -> Result<Lateral, ScanReadError> {
    let spacing_m = |key| {
        let number = tags.number(key)?;
        Ok::<_, ScanReadError>(number.and_then(numbers::positive))
    };
    Ok(match (spacing_m("PixelSizeXMeter")?, spacing_m("PixelSizeYMeter")?) {
        (Some(x_m), Some(y_m)) => Lateral::Spacing { x_m, y_m: Some(y_m) },
        _ => Lateral::Unknown,
    })
}

impl Tags<'_> {
    fn get(&self, key: &str) -> Option<&Tag> {
        self.tags.iter().find(|tag| tag.key == key)
    }

    /// The number in a tag, which may be missing; some writers leave what is not a number.
    fn number(&self, key: &str) -> Result<Option<f64>, ScanReadError> {
        let Some(tag) = self.get(key) else { return Ok(None) };
        tag.value.parse().map(Some).map_err(|_| bad(&self.cursor, tag, "a number"))
    }

    fn count(&self, key: &str) -> Result<usize, ScanReadError> {
        let tag = self.get(key).ok_or_else(|| {
            let mend = "export the file again with its depth image";
            FORMAT.missing(FilePlace::File, format!("tag '{key}'"), mend)
        })?;
        numbers::count(&tag.value).ok_or_else(|| bad(&self.cursor, tag, "a whole number above 0"))
    }
}

fn bad(cursor: &Cursor, tag: &Tag, bound: &str) -> ScanReadError {
    cursor.bad(tag.offset, &format!("'{}'", tag.key), format!("'{}'", tag.value), bound)
}
