//! Wyko and Vision of Veeco and Bruker: `.opd`.
//!
//! A directory of blocks with a name, a type and a length each, then the blocks one after the other, little-endian, as
//! the readers of Gwyddion and SurfaceTopography take them. Arrays are stored column after column from the bottom, in
//! wavelengths (over a factor where there is one).

use crate::channel::{Channel, Lateral, MOST_TEXT, Quantity, refuse_many, shortened};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::numbers;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Order, Raster};
use crate::readers::Reader;
use units::LengthUnit;

pub(super) const FORMAT: ScanFormat = ScanFormat::Wyko;
/// The name of the first block, which lists the others.
const MAGIC: &[u8] = b"Directory\0";
/// The directory begins after two bytes.
const DIRECTORY: usize = 2;
const ENTRY_BYTES: usize = 24;
/// Files have some hundreds.
const MOST_BLOCKS: usize = 10_000;

/// Names of arrays with heights, and of those with intensities.
pub(super) const HEIGHTS: [&str; 5] = ["Raw", "RAW_DATA", "RAW DATA", "OPD", "SAMPLE_DATA"];
const INTENSITIES: [&str; 3] = ["Image", "Intensity", "SecArr_0"];
/// Texts that people write.
const TEXTS: [&str; 4] = ["Title", "Note", "Comment", "UserNote"];

/// Floating-point numbers and counts of two bytes from these on mark points without a height.
const MISSING_F32: f64 = 1e38_f32 as f64;
const MISSING_I16: f64 = 32766.0;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.get(DIRECTORY..).is_some_and(|directory| directory.starts_with(MAGIC))
}

/// An entry of the directory with the bytes of its block that the file holds.
struct Block<'b> {
    name: String,
    kind: u16,
    offset: usize,
    bytes: &'b [u8],
}

/// Types of blocks.
const ARRAY: u16 = 3;
const TEXT: u16 = 5;
const SHORT: u16 = 6;
const FLOAT: u16 = 7;
const DOUBLE: u16 = 8;
const LONG: u16 = 12;

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let blocks = blocks(bytes)?;
    let wavelengths = number(&blocks, "Wavelength").map(|wavelength_nm| {
        let factor = number(&blocks, "Mult").filter(|&factor| factor != 0.0);
        wavelength_nm / factor.unwrap_or(1.0)
    });
    let (lateral, free_text) = (lateral(&blocks), free_text(&blocks));
    let mut channels = Vec::new();
    for block in blocks.iter().filter(|block| block.kind == ARRAY) {
        let (quantity, scale) = if HEIGHTS.contains(&block.name.as_str()) {
            (Quantity::Heights(Some(LengthUnit::NANOMETRE)), wavelengths.ok_or_else(no_wavelength))
        } else if INTENSITIES.contains(&block.name.as_str()) {
            (Quantity::Other(String::new()), Ok(1.0))
        } else {
            continue;
        };
        refuse_many(FORMAT, channels.len() + 1)?;
        let samples = scale.and_then(|scale| raster(block, scale)).into();
        channels.push(Channel {
            probe: Some(Probe::Microscope),
            free_text: free_text.clone(),
            ..Channel::new(Some(block.name.clone()), quantity, lateral.clone(), samples)
        });
    }
    Ok(channels)
}

fn no_wavelength() -> ScanReadError {
    FORMAT.missing(FilePlace::File, "block 'Wavelength', which scales the heights", "export the file again")
}

/// The blocks that are not empty, in the order of the file.
fn blocks(bytes: &[u8]) -> Result<Vec<Block<'_>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(DIRECTORY);
    let directory = entry(&mut cursor)?;
    let length_offset = DIRECTORY + 18;
    let entries = (directory.length / ENTRY_BYTES)
        .checked_sub(1)
        .filter(|entries| directory.length.is_multiple_of(ENTRY_BYTES) && *entries <= MOST_BLOCKS);
    let entries = entries.ok_or_else(|| {
        let bound = format!("a multiple of {ENTRY_BYTES}, for at least 1 and at most {MOST_BLOCKS} blocks");
        cursor.bad(length_offset, "the length of the directory", directory.length, &bound)
    })?;
    let mut blocks = Vec::new();
    let mut offset = DIRECTORY.saturating_add(directory.length);
    for _ in 0..entries {
        let Entry { name, kind, length } = entry(&mut cursor)?;
        if length > 0 {
            let there = bytes.get(offset..).unwrap_or_default();
            blocks.push(Block { name, kind, offset, bytes: &there[..there.len().min(length)] });
        }
        offset = offset.saturating_add(length);
    }
    Ok(blocks)
}

struct Entry {
    name: String,
    kind: u16,
    /// 0 for blocks without content.
    length: usize,
}

fn entry(cursor: &mut Cursor) -> Result<Entry, ScanReadError> {
    let name = cursor.text(16, "the name of a block")?;
    let kind = cursor.u16("the type of a block")?;
    let length = cursor.i32("the length of a block")?;
    cursor.skip(2, "the attribute of a block")?;
    Ok(Entry { name, kind, length: usize::try_from(length).unwrap_or(0) })
}

fn free_text(blocks: &[Block]) -> String {
    let text = |name: &&str| {
        let found = blocks.iter().find(|block| block.kind == TEXT && block.name == **name)?;
        Some(latin1(found.bytes)).filter(|text| !text.is_empty())
    };
    shortened(TEXTS.iter().filter_map(text).collect::<Vec<_>>().join("\n"), MOST_TEXT)
}

/// The numbers of columns and rows and the bytes of a point, then the points.
fn raster<'b>(block: &Block<'b>, scale: f64) -> Result<Raster<'b>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, block.bytes, ByteOrder::Little);
    let columns = usize::from(cursor.u16("the number of columns")?);
    let rows = usize::from(cursor.u16("the number of rows")?);
    if columns == 0 || rows == 0 {
        let value = format!("{columns} x {rows}");
        return Err(cursor.bad(block.offset, "the number of points", &value, "above 0 along both axes"));
    }
    let (number, missing) = match cursor.u16("the bytes of a point")? {
        1 => (NumberType::U8, MissingMark::None),
        2 => (NumberType::I16, MissingMark::AtLeast(MISSING_I16)),
        4 => (NumberType::F32, MissingMark::AtLeast(MISSING_F32)),
        other => {
            let offset = block.offset + 4;
            return Err(cursor.bad(offset, "the number of bytes of a point", other, "1, 2 or 4"));
        }
    };
    let offset = block.offset + cursor.at;
    let raster = Raster::new(number, columns, rows, cursor.rest(), offset);
    Ok(Raster { order: Order::ColumnsFromBottom, scale, missing, ..raster })
}

/// The distance of columns in mm, and how much larger that of rows is.
fn lateral(blocks: &[Block]) -> Lateral {
    let positive = |name: &str| number(blocks, name).and_then(numbers::positive);
    match positive("Pixel_size") {
        None => Lateral::Unknown,
        Some(spacing) => {
            let x_m = LengthUnit::MILLIMETRE.to_m(spacing);
            Lateral::Spacing { x_m, y_m: Some(x_m * positive("Aspect").unwrap_or(1.0)) }
        }
    }
}

/// The number in a block. Some files give a type that its length contradicts; the length counts.
fn number(blocks: &[Block], name: &str) -> Option<f64> {
    let block = blocks.iter().find(|block| block.name == name)?;
    match (block.kind, block.bytes) {
        (SHORT | FLOAT | LONG, &[a, b]) => Some(f64::from(i16::from_le_bytes([a, b]))),
        (SHORT | LONG, &[a, b, c, d, ..]) => Some(f64::from(i32::from_le_bytes([a, b, c, d]))),
        (FLOAT, &[a, b, c, d, ..]) => Some(f64::from(f32::from_le_bytes([a, b, c, d]))),
        (DOUBLE, &[a, b, c, d, e, f, g, h, ..]) => Some(f64::from_le_bytes([a, b, c, d, e, f, g, h])),
        _ => None,
    }
}
