//! The counts of an object: plain or packed.

use super::FORMAT;
use super::header::{Header, Inversion};
use crate::channel::Samples;
use crate::error::ScanReadError;
use crate::raster::{MissingMark, NumberType, Order, Raster};
use crate::room::Room;

/// Points without a height have this count less than the lowest.
const MISSING_BELOW_LOWEST: f64 = 2.0;

/// The counts of an object, and where they end.
pub(super) fn samples<'b>(
    header: &Header,
    bytes: &'b [u8],
    room: &mut Room,
) -> Result<(Samples<'b>, usize), ScanReadError> {
    let number = if header.bits == 16 { NumberType::I16 } else { NumberType::I32 };
    let sign = if header.inversion.turns_heights() { -1.0 } else { 1.0 };
    let missing = match header.has_special_points {
        true => MissingMark::Equal(f64::from(header.lowest_count) - MISSING_BELOW_LOWEST),
        false => MissingMark::None,
    };
    let raster = Raster {
        byte_order: header.order,
        order: match header.inversion {
            Inversion::HeightsAndRows => Order::RowsFromBottom,
            _ => Order::RowsFromTop,
        },
        is_mirrored: header.inversion == Inversion::HeightsAndColumns,
        scale: sign * header.scale,
        zero: sign * header.zero,
        missing,
        ..Raster::within(number, header.columns, header.rows, bytes, header.data)
    };
    let (raster, end) = if header.is_packed {
        let end = header.data.saturating_add(header.packed_bytes);
        match unpacked(header, &raster, bytes, room) {
            Ok(counts) => (Raster { bytes: counts.into(), ..raster }, end),
            Err(error) => return Ok((Samples::Unreadable(Box::new(error)), end)),
        }
    } else {
        let end = header.data.saturating_add(size(header, &raster).unwrap_or(usize::MAX));
        (raster, end)
    };
    Ok((Samples::Raster(raster), end))
}

/// Bytes of the counts where they are not packed.
fn size(header: &Header, raster: &Raster) -> Option<usize> {
    header.columns.checked_mul(header.rows)?.checked_mul(raster.number.bytes())
}

/// A table of streams, each with its length before and after packing, then the streams.
#[cfg(feature = "archives")]
fn unpacked(
    header: &Header,
    raster: &Raster,
    bytes: &[u8],
    room: &mut Room,
) -> Result<Vec<u8>, ScanReadError> {
    use crate::cursor::Cursor;
    use crate::inflate::{StreamPlace, inflated};

    let expected = size(header, raster).unwrap_or(usize::MAX);
    room.take(expected as u64, || format!("the {} x {} points", header.columns, header.rows))?;
    let mut cursor = Cursor::new(FORMAT, bytes, header.order).at(header.data);
    let streams = cursor.u32("the number of packed streams")?;
    let mut lengths = Vec::new();
    for _ in 0..streams {
        let length = cursor.u32("the length of a stream")? as usize;
        lengths.push((length, cursor.u32("the packed length of a stream")? as usize));
    }
    let mut counts = Vec::new();
    for (length, packed) in lengths {
        let offset = cursor.at;
        let left = expected - counts.len();
        if length > left {
            let bound = format!("at most the {left} bytes that the points leave");
            return Err(cursor.bad(offset, "the length of a stream", length, &bound));
        }
        let packed = cursor.take(packed, "a packed stream")?;
        counts.extend(inflated(&StreamPlace { format: FORMAT, offset }, packed, length)?);
    }
    Ok(counts)
}

#[cfg(not(feature = "archives"))]
fn unpacked(header: &Header, _: &Raster, _: &[u8], _: &mut Room) -> Result<Vec<u8>, ScanReadError> {
    let mend = "build with the feature 'archives', or export the file without compression";
    Err(FORMAT.unsupported(crate::error::FilePlace::Byte(header.data as u64), "packed data", mend))
}
