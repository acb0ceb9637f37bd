//! Images of Park Systems, which were PSIA: TIFF with a picture for the eye, and the numbers in tags of the maker's
//! own.
//!
//! The layout of the header is that which Gwyddion's importer and SurfaceTopography's reader follow.

use crate::channel::{Channel, Lateral, Quantity, Samples, ScanAxis};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Order, Raster};
use crate::readers::Reader;
use crate::readers::tiff::{first_page, utf16};
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::ParkTiff;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

const MAGIC_TAG: u16 = 50_432;
const VERSION_TAG: u16 = 50_433;
const DATA_TAG: u16 = 50_434;
const HEADER_TAG: u16 = 50_435;
const COMMENT_TAG: u16 = 50_436;
const MAGIC: f64 = 235_082_497.0;
/// First version whose header gives the type of the numbers.
const TYPED_VERSION: f64 = 16_777_218.0;

fn recognises(bytes: &[u8]) -> bool {
    first_page(FORMAT, bytes).is_some_and(|page| page.number(MAGIC_TAG) == Some(MAGIC))
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let Some(page) = first_page(FORMAT, bytes) else {
        return Err(FORMAT.missing(FilePlace::File, "page of tags", "export it again"));
    };
    let (own, offset) = page.bytes(HEADER_TAG)?;
    // The header is little-endian (Intel); places in errors are those in the file.
    let file = bytes.get(..offset.saturating_add(own.len())).unwrap_or_default();
    let is_typed = page.number(VERSION_TAG).is_some_and(|version| version >= TYPED_VERSION);
    let header = Header::read(Cursor::new(FORMAT, file, ByteOrder::Little).at(offset), is_typed)?;
    let (data, data_offset) = page.bytes(DATA_TAG)?;
    let raster = Raster {
        order: Order::RowsFromBottom,
        scale: header.gain * header.scale,
        zero: header.gain * header.zero,
        ..Raster::new(header.number, header.columns, header.rows, data, data_offset)
    };
    let quantity = Quantity::named(&header.name, &header.unit, LengthUnit::parse(&header.unit));
    let [x_m, y_m] = header.size_um.map(|length| LengthUnit::MICROMETRE.to_m(length.abs()));
    let is_sized = [x_m, y_m].iter().all(|length| length.is_finite() && *length > 0.0);
    let lateral = if is_sized { Lateral::Size(ScanSize { x_m, y_m: Some(y_m) }) } else { Lateral::Unknown };
    Ok(vec![Channel {
        probe: Some(Probe::Tip),
        fast_axis: Some(if header.is_swapped { ScanAxis::Y } else { ScanAxis::X }),
        free_text: page.text(COMMENT_TAG).unwrap_or_default(),
        ..Channel::new(Some(header.name), quantity, lateral, Samples::Raster(raster))
    }])
}

/// Header of the one image.
struct Header {
    name: String,
    columns: usize,
    rows: usize,
    number: NumberType,
    /// True if the instrument scanned along y.
    is_swapped: bool,
    size_um: [f64; 2],
    /// A value is the gain times what the scale and the zero make of a number.
    gain: f64,
    scale: f64,
    zero: f64,
    unit: String,
}

impl Header {
    fn read(mut cursor: Cursor, is_typed: bool) -> Result<Self, ScanReadError> {
        let start = cursor.at;
        let kind = cursor.u32("the kind of the image")?;
        // Images of spectroscopy have a map beside their curves.
        if ![0, 2].contains(&kind) {
            return Err(cursor.bad(start, "the kind of the image", kind, "0 or 2: profiles are not read"));
        }
        let name = utf16(cursor.take(64, "the name of the signal")?);
        cursor.skip(16 + 8 + 4 + 4, "the mode of the scan")?;
        let columns = cursor.count("the number of columns")?;
        let rows = cursor.count("the number of rows")?;
        cursor.skip(8 + 4 + 8 + 4 + 4, "the way of the scan")?;
        let is_swapped = cursor.u32("the direction of the lines")? != 0;
        let size_um = [cursor.f64("the size along x")?, cursor.f64("the size along y")?];
        cursor.skip(4 * 8 + 16 + 2 * 8, "the settings of the scan")?;
        let gain = cursor.f64("the gain of the numbers")?;
        let scale = cursor.f64("the scale of the numbers")?;
        let zero = cursor.f64("the zero of the numbers")?;
        let unit = utf16(cursor.take(16, "the unit of the values")?);
        let number = if is_typed { number_type(&mut cursor.at(start + 348))? } else { NumberType::I16 };
        // Files without a scale or a unit are of the first versions.
        let scale = if scale == 0.0 { 1.0 } else { scale };
        let unit = if unit.is_empty() { "um".to_owned() } else { unit };
        Ok(Self { name, columns, rows, number, is_swapped, size_um, gain, scale, zero, unit })
    }
}

fn number_type(cursor: &mut Cursor) -> Result<NumberType, ScanReadError> {
    let offset = cursor.at;
    Ok(match cursor.u32("the type of the numbers")? {
        0 => NumberType::I16,
        1 => NumberType::I32,
        2 => NumberType::F32,
        other => return Err(cursor.bad(offset, "the type of the numbers", other, "0, 1 or 2")),
    })
}
