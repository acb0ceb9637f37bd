//! The image of a page of TIFF: one number a point, in strips that are not packed, as the sixth revision of the format
//! lays them down.

use std::borrow::Cow;

use super::Page;
use crate::error::{FilePlace, ScanReadError};
use crate::raster::{NumberType, Raster};

/// Bytes of a table of strips, of which an image has no more than rows.
const LARGEST_STRIP_TABLE: usize = 1 << 19;

const WIDTH: u16 = 256;
const LENGTH: u16 = 257;
const BITS: u16 = 258;
const COMPRESSION: u16 = 259;
const STRIP_OFFSETS: u16 = 273;
const SAMPLES_PER_PIXEL: u16 = 277;
const STRIP_BYTES: u16 = 279;
const SAMPLE_FORMAT: u16 = 339;

impl<'b> Page<'b> {
    /// Width and length of the image in points, where stated.
    pub(in crate::readers) fn size(&self) -> [Option<f64>; 2] {
        [WIDTH, LENGTH].map(|tag| self.number(tag))
    }

    /// The image of the page: one number a point, not packed.
    ///
    /// `left` counts the bytes down that may be copied of the file, at first its size.
    pub(in crate::readers) fn raster(&self, left: &mut usize) -> Result<Raster<'b>, ScanReadError> {
        let first = |tag: u16| {
            let found = self.tags.get(&tag).ok_or_else(|| self.missing(tag))?;
            Ok::<_, ScanReadError>(self.numbers(found).next().map_or(0, |number| number as usize))
        };
        let or =
            |tag: u16, default: usize| if self.tags.contains_key(&tag) { first(tag) } else { Ok(default) };
        if or(COMPRESSION, 1)? != 1 {
            return Err(self.bad(
                "the packing of the image",
                first(COMPRESSION)?.to_string(),
                "1, which is none",
            ));
        }
        if or(SAMPLES_PER_PIXEL, 1)? != 1 {
            let found = first(SAMPLES_PER_PIXEL)?.to_string();
            return Err(self.bad("the number of values of a point", &found, "1"));
        }
        let (bits, format) = (or(BITS, 1)?, or(SAMPLE_FORMAT, 1)?);
        let number = match (bits, format) {
            (8, 1) => NumberType::U8,
            (8, 2) => NumberType::I8,
            (16, 1) => NumberType::U16,
            (16, 2) => NumberType::I16,
            (32, 1) => NumberType::U32,
            (32, 2) => NumberType::I32,
            (32, 3) => NumberType::F32,
            (64, 3) => NumberType::F64,
            _ => {
                let found = format!("{bits} bits of format {format}");
                return Err(self.bad(
                    "the type of the numbers",
                    &found,
                    "8, 16 or 32 bits, or a floating-point number",
                ));
            }
        };
        let (columns, rows) = (first(WIDTH)?, first(LENGTH)?);
        if columns == 0 || rows == 0 {
            return Err(self.bad(
                "the size of the image",
                format!("{columns} x {rows} points"),
                "at least one point",
            ));
        }
        let (bytes, offset) = self.strips(left)?;
        let raster = Raster::new(number, columns, rows, bytes, offset);
        Ok(Raster { byte_order: self.file.order, ..raster })
    }

    /// The bytes of the image, which may stand in several strips, and where the first is. Strips that do not follow
    /// each other are copied, of all pages together no more than the file holds.
    fn strips(&self, left: &mut usize) -> Result<(Cow<'b, [u8]>, usize), ScanReadError> {
        let (offsets, lengths) = (self.strip_table(STRIP_OFFSETS)?, self.strip_table(STRIP_BYTES)?);
        let strips = || offsets.iter().copied().zip(lengths.iter().copied());
        let Some((first, _)) = strips().next() else { return Ok((Cow::Borrowed(&[]), 0)) };
        let total = strips().fold(0usize, |total, (_, length)| total.saturating_add(length));
        let mut end = first;
        let follow_each_other = strips().all(|(offset, length)| {
            let follows = offset == end;
            end = offset.saturating_add(length);
            follows
        });
        if follow_each_other {
            return Ok((Cow::Borrowed(self.file.at(first).take(total, "the strips of the image")?), first));
        }
        *left = left.checked_sub(total).ok_or_else(|| {
            let bound = format!("{left}, what the strips of the pages before leave of the size of the file");
            self.bad("the size of the strips", total, &bound)
        })?;
        let mut bytes = Vec::with_capacity(total);
        for (offset, length) in strips() {
            bytes.extend_from_slice(self.file.at(offset).take(length, "a strip of the image")?);
        }
        Ok((Cow::Owned(bytes), first))
    }

    fn strip_table(&self, tag: u16) -> Result<Vec<usize>, ScanReadError> {
        let found = self.tags.get(&tag).ok_or_else(|| self.missing(tag))?;
        if found.bytes.len() > LARGEST_STRIP_TABLE {
            let bound = format!("at most {LARGEST_STRIP_TABLE}");
            return Err(self.bad(&format!("the size of tag {tag}"), found.bytes.len(), &bound));
        }
        self.require(tag)
    }

    /// The numbers of a tag that must be there.
    fn require(&self, tag: u16) -> Result<Vec<usize>, ScanReadError> {
        let found = self.tags.get(&tag).ok_or_else(|| self.missing(tag))?;
        Ok(self.numbers(found).map(|number| number as usize).collect())
    }

    fn bad(&self, field: &str, value: impl ToString, bound: &str) -> ScanReadError {
        let mend = "export the file again without packing its data";
        self.format.bad(FilePlace::File, field, value, bound, mend)
    }
}
