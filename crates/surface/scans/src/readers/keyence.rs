//! Keyence laser scanning microscopes, `.vk4` and its predecessor `.vk3`, and `.vk6` and `.vk7`, which pack a `.vk4`;
//! as a report of Sandia National Laboratories on the format describes it. Little-endian, lengths in pm.

use std::borrow::Cow;

use memchr::memmem;

use crate::channel::{Channel, Lateral, Quantity};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Keyence;
const PLAIN: [&[u8]; 2] = [b"VK4_", b"VK3_"];
const PACKED: [&[u8]; 2] = [b"VK6", b"VK7"];
/// The table of the places of parts.
const TABLE_OFFSET: usize = 12;
/// The places in the table of the conditions of the measurement, and of each image with its name.
const CONDITIONS: usize = 0;
const IMAGES: [(usize, &str, bool); 6] = [
    (6, "Height", true),
    (7, "Height 2", true),
    (8, "Height 3", true),
    (3, "Intensity", false),
    (4, "Intensity 2", false),
    (5, "Intensity 3", false),
];
/// Offsets of the lengths of a pixel in the conditions.
const PIXEL_OFFSET: usize = 168;
const PALETTE_BYTES: usize = 768;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    PLAIN.iter().any(|magic| bytes.starts_with(magic)) || is_packed(bytes)
}

/// Three letters may begin a text: what is packed has a name.
fn is_packed(bytes: &[u8]) -> bool {
    const NAME: &[u8] = b"Vk4File";
    PACKED.iter().any(|magic| bytes.starts_with(magic)) && memmem::find(bytes, NAME).is_some()
}

fn channels<'b>(bytes: &'b [u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    if is_packed(bytes) {
        return packed(bytes, options);
    }
    images(bytes, &mut |numbers| Ok(Cow::Borrowed(numbers)))
}

#[cfg(feature = "archives")]
fn packed<'b>(bytes: &[u8], options: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let content = crate::archive::Archive::open(bytes, options.unpacked_bound())?.read("Vk4File")?;
    // Images that do not overlap take no more than what they were packed in.
    let mut room = crate::room::Room::new(content.len() as u64);
    images(&content, &mut |numbers| {
        room.take(numbers.len() as u64, || "images that overlap".to_owned())?;
        Ok(Cow::Owned(numbers.to_vec()))
    })
}

#[cfg(not(feature = "archives"))]
fn packed<'b>(_: &[u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    Err(FORMAT.unsupported(FilePlace::File, "a packed file", "build with the feature 'archives'"))
}

/// Keeps the numbers of an image beyond the content of the file.
type Keep<'k, 'c, 'b> = &'k mut dyn FnMut(&'c [u8]) -> Result<Cow<'b, [u8]>, ScanReadError>;

fn images<'c, 'b>(bytes: &'c [u8], keep: Keep<'_, 'c, 'b>) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let start = Cursor::new(FORMAT, bytes, ByteOrder::Little);
    let place =
        |entry: usize, what: &str| start.at(TABLE_OFFSET + 4 * entry).u32(what).map(|place| place as usize);
    let conditions = place(CONDITIONS, "the place of the conditions")?;
    let mut pixel = start.at(conditions.saturating_add(PIXEL_OFFSET));
    let mut length_m = |what: &str| {
        let offset = pixel.at;
        match pixel.u32(what)? {
            0 => Err(pixel.bad(offset, what, "0", "above 0")),
            length_pm => Ok(LengthUnit::PICOMETRE.to_m(f64::from(length_pm))),
        }
    };
    let (x_m, y_m) = (length_m("the width of a pixel")?, length_m("the height of a pixel")?);
    let unit_m = length_m("the height of a digit")?;
    let mut channels = Vec::new();
    for (entry, name, is_height) in IMAGES {
        let at = place(entry, name)?;
        if at == 0 {
            continue;
        }
        let samples = raster(start.at(at), if is_height { unit_m } else { 1.0 }, keep).into();
        let quantity = match is_height {
            true => Quantity::HEIGHTS_IN_M,
            false => Quantity::Other(String::new()),
        };
        let lateral = Lateral::Spacing { x_m, y_m: Some(y_m) };
        let channel = Channel::new(Some(name.to_owned()), quantity, lateral, samples);
        channels.push(Channel { probe: Some(Probe::Microscope), ..channel });
    }
    Ok(channels)
}

/// An image: its size, a palette, its numbers.
fn raster<'c, 'b>(
    mut cursor: Cursor<'c>,
    scale: f64,
    keep: Keep<'_, 'c, 'b>,
) -> Result<Raster<'b>, ScanReadError> {
    let (columns, rows) = (cursor.count("the number of columns")?, cursor.count("the number of rows")?);
    let at = cursor.at;
    let number = match cursor.u32("the bits of a number")? {
        8 => NumberType::U8,
        16 => NumberType::U16,
        32 => NumberType::U32,
        other => return Err(cursor.bad(at, "the bits of a number", other, "8, 16 or 32")),
    };
    let at = cursor.at;
    let compression = cursor.u32("the compression")?;
    if compression != 0 {
        return Err(FORMAT.unsupported(
            FilePlace::Byte(at as u64),
            format!("compression {compression}"),
            "export it without compression",
        ));
    }
    cursor.skip(12 + PALETTE_BYTES, "the palette")?;
    let size = columns.saturating_mul(rows).saturating_mul(number.bytes());
    let data = cursor.rest();
    let data = data.get(..size).unwrap_or(data);
    Ok(Raster { scale, ..Raster::new(number, columns, rows, keep(data)?, cursor.at) })
}
