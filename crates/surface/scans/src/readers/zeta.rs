//! Zeta profilometers of KLA: `.zmg`.
//!
//! A header of fixed length, a comment, then counts of two bytes row after row, little-endian, lengths in µm, as the
//! readers of Gwyddion and SurfaceTopography take it.

use crate::channel::{Channel, Lateral, Quantity, Samples};
use crate::cursor::{ByteOrder, Cursor, latin1};
use crate::error::ScanReadError;
use crate::format::ScanFormat;
use crate::metadata::Probe;
use crate::options::ScanOptions;
use crate::raster::{NumberType, Raster};
use crate::readers::Reader;
use units::LengthUnit;

const FORMAT: ScanFormat = ScanFormat::Zeta;
const MAGIC: &[u8] = b"Zeta-Instruments";
/// Offset of the first field in use.
const FIELDS: usize = 85;

pub(super) const READER: Reader = Reader { format: FORMAT, recognises, channels };

fn recognises(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

fn channels<'b>(bytes: &'b [u8], _: &ScanOptions) -> Result<Vec<Channel<'b>>, ScanReadError> {
    let mut cursor = Cursor::new(FORMAT, bytes, ByteOrder::Little).at(FIELDS);
    let columns = cursor.count("the number of columns")?;
    let rows = cursor.count("the number of rows")?;
    cursor.skip(4, "unused bytes")?;
    let x_m = step_m(&mut cursor, "the distance of columns")?;
    let y_m = step_m(&mut cursor, "the distance of rows")?;
    let scale = step_m(&mut cursor, "the height of a count")?;
    cursor.skip(8, "unused bytes")?;
    let comment_bytes = cursor.u32("the length of the comment")? as usize;
    cursor.skip(84, "the name of the recipe")?;
    let comment = latin1(cursor.take(comment_bytes, "the comment")?);
    let raster = Raster::within(NumberType::U16, columns, rows, bytes, cursor.at);
    let raster = Raster { scale, ..raster };
    let lateral = Lateral::Spacing { x_m, y_m: (rows > 1).then_some(y_m) };
    Ok(vec![Channel {
        probe: Some(Probe::Microscope),
        free_text: comment,
        ..Channel::new(None, Quantity::HEIGHTS_IN_M, lateral, Samples::Raster(raster))
    }])
}

/// A length in µm, above 0.
fn step_m(cursor: &mut Cursor, what: &str) -> Result<f64, ScanReadError> {
    let offset = cursor.at;
    let step = cursor.f32(what)?;
    match step.is_finite() && step > 0.0 {
        true => Ok(LengthUnit::MICROMETRE.to_m(f64::from(step))),
        false => Err(cursor.bad(offset, what, step, "a number above 0")),
    }
}
