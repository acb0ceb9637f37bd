//! OmniSurf3D of Digital Metrology: `.os3d`.
//!
//! Texts, the grid, then heights row after row in µm, little-endian, as the maker's description of the format lays it
//! down.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::options::ScanOptions;
use crate::raster::{MissingMark, NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::OmniSurf;
const MAGIC: &[u8] = b"OmniSurf3D";
/// Points without a height hold the least number there is; from here on none is a height.
const MISSING: f64 = -3e38;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(MAGIC.len());
    cursor.skip(8, "the version")?;
    let identification = text(&mut cursor, "the identification")?;
    text(&mut cursor, "the time")?;
    let columns = cursor.count("the number of columns")?;
    let rows = cursor.count("the number of rows")?;
    let x_m = spacing_m(&mut cursor, "the distance of columns")?;
    let y_m = spacing_m(&mut cursor, "the distance of rows")?;
    cursor.skip(16, "the origin")?;
    let raster = Raster::within(NumberType::F32, columns, rows, bytes, cursor.at);
    let raster = Raster { missing: MissingMark::AtMost(MISSING), ..raster };
    let lateral = Lateral::Spacing { x_m, y_m: (rows > 1).then_some(y_m) };
    let quantity = Quantity::Heights(Some(LengthUnit::MICROMETRE));
    let channel = Channel::new(None, quantity, lateral, Samples::Raster(raster));
    Ok(vec![Channel { free_text: identification, ..channel }])
}

/// A text behind its length of four bytes.
fn text(cursor: &mut Cursor, what: &str) -> Result<String, ScanReadError> {
    let length = cursor.u32(what)? as usize;
    cursor.text(length, what)
}

/// A distance in µm.
fn spacing_m(cursor: &mut Cursor, what: &str) -> Result<f64, ScanReadError> {
    let offset = cursor.at;
    let spacing = cursor.f64(what)?;
    let spacing_m = LengthUnit::MICROMETRE.to_m(spacing);
    match spacing_m.is_finite() && spacing_m > 0.0 {
        true => Ok(spacing_m),
        false => Err(cursor.bad(offset, what, spacing, "a number above 0")),
    }
}
