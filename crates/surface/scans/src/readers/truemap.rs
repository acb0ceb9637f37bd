//! TrueMap of TrueGage and GelSight, `.tmd`, as their own programs for reading it describe it: little-endian, lengths
//! in mm.

use crate::channel::Channel;
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use crate::scan_size::ScanSize;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::TrueMap;
const TITLES: [&[u8]; 2] = [b"Binary TrueMap Data File v", b"TrueMap Data File v1"];
/// The title with the zero bytes behind it.
const TITLE_BYTES: usize = 32;
/// Bytes between the comment and the heights.
const HEADER_BYTES: usize = 24;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    TITLES.iter().any(|title| bytes.starts_with(title))
        && bytes.iter().take(TITLE_BYTES).any(|&byte| byte == 0)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let rest = bytes.get(TITLE_BYTES..).unwrap_or_default();
    let comment = rest.iter().position(|&byte| byte == 0).map_or(0, |end| end + 1);
    // Writers end the comment with a zero byte, pad it to 24 or 32 bytes, or leave it out: the length of the file
    // tells.
    let starts = [comment, 24, 32, 0].map(|comment| TITLE_BYTES + comment);
    let fits = |start: &usize| {
        header(bytes, *start).is_ok_and(|header| {
            let size = header.columns.checked_mul(header.rows).and_then(|points| points.checked_mul(4));
            size.and_then(|size| size.checked_add(start + HEADER_BYTES)) == Some(bytes.len())
        })
    };
    let start = starts.into_iter().find(fits).unwrap_or(TITLE_BYTES + comment);
    let Header { columns, rows, size } = header(bytes, start)?;
    let raster = Raster {
        scale: LengthUnit::MILLIMETRE.to_m(1.0),
        ..Raster::within(NumberType::F32, columns, rows, bytes, start + HEADER_BYTES)
    };
    let free_text = latin1(bytes.get(TITLE_BYTES..start).unwrap_or_default());
    Ok(vec![Channel { free_text, probe: Some(Probe::Microscope), ..Channel::heights_in_m("", size, raster) }])
}

struct Header {
    columns: usize,
    rows: usize,
    size: ScanSize,
}

fn header(bytes: &[u8], start: usize) -> Result<Header, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(start);
    let (columns, rows) = (cursor.count("the number of columns")?, cursor.count("the number of rows")?);
    let mut length_m = |what| cursor.f32(what).map(|length| LengthUnit::MILLIMETRE.to_m(f64::from(length)));
    let size = ScanSize { x_m: length_m("the length along x")?, y_m: Some(length_m("the length along y")?) };
    cursor.skip(8, "the offsets")?;
    Ok(Header { columns, rows, size })
}
