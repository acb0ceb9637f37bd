//! The types of the numbers of a variable, all of them big-endian.

use super::cursor::{Cursor, bad};
use crate::cursor::ByteOrder;
use crate::error::ScanReadError;
use crate::raster::NumberType;

/// A type, as `nc_type` of `netcdf.h` numbers them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Text,
    Number(NumberType),
}

impl Kind {
    pub(super) fn read(cursor: &mut Cursor) -> Result<Self, ScanReadError> {
        let offset = cursor.offset();
        Ok(Self::Number(match cursor.u32("a type")? {
            1 => NumberType::I8,
            2 => return Ok(Self::Text),
            3 => NumberType::I16,
            4 => NumberType::I32,
            5 => NumberType::F32,
            6 => NumberType::F64,
            7 => NumberType::U8,
            8 => NumberType::U16,
            9 => NumberType::U32,
            10 => NumberType::I64,
            11 => NumberType::U64,
            other => return Err(bad(offset, "a type", other, "between 1 and 11")),
        }))
    }

    /// Bytes of a number, or of a letter.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Text => 1,
            Self::Number(number) => number.bytes(),
        }
    }
}

/// Number that the NetCDF library writes where nobody has (NC_FILL_... of netcdf.h); bytes have none.
pub(super) fn default_fill(number: NumberType) -> Option<f64> {
    Some(match number {
        NumberType::I8 | NumberType::U8 | NumberType::F16 => return None,
        NumberType::I16 => -32_767.0,
        NumberType::I32 => -2_147_483_647.0,
        NumberType::I64 => -9_223_372_036_854_775_806_i64 as f64,
        NumberType::F32 | NumberType::F64 => 9.969_209_968_386_869e36,
        NumberType::U16 => 65_535.0,
        NumberType::U32 => 4_294_967_295.0,
        NumberType::U64 => 18_446_744_073_709_551_614_u64 as f64,
    })
}

/// Appends the numbers in these bytes.
pub(super) fn read_into(values: &mut Vec<f64>, number: NumberType, bytes: &[u8]) {
    let places = [number.bytes(), bytes.len() / number.bytes()];
    number.read(ByteOrder::Big, bytes, places, [1.0, 0.0], values);
}
