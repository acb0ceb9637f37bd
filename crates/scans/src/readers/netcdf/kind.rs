//! The types of the numbers of a variable, all of them big-endian.

use super::cursor::{Cursor, bad};
use crate::error::ScanReadError;

/// A type, as `nc_type` of `netcdf.h` numbers them.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    Char,
    I16,
    I32,
    F32,
    F64,
    U8,
    U16,
    U32,
    I64,
    U64,
}

impl Kind {
    pub(super) fn read(cursor: &mut Cursor) -> Result<Self, ScanReadError> {
        let offset = cursor.offset();
        Ok(match cursor.u32("a type")? {
            1 => Self::I8,
            2 => Self::Char,
            3 => Self::I16,
            4 => Self::I32,
            5 => Self::F32,
            6 => Self::F64,
            7 => Self::U8,
            8 => Self::U16,
            9 => Self::U32,
            10 => Self::I64,
            11 => Self::U64,
            other => return Err(bad(offset, "a type", &other.to_string(), "between 1 and 11")),
        })
    }

    /// What the NetCDF library writes where nobody has (NC_FILL_... of netcdf.h); bytes and text have none.
    pub(super) fn default_fill(self) -> Option<f64> {
        Some(match self {
            Self::I8 | Self::U8 | Self::Char => return None,
            Self::I16 => -32_767.0,
            Self::I32 => -2_147_483_647.0,
            Self::I64 => -9_223_372_036_854_775_806_i64 as f64,
            Self::F32 | Self::F64 => 9.969_209_968_386_869e36,
            Self::U16 => 65_535.0,
            Self::U32 => 4_294_967_295.0,
            Self::U64 => 18_446_744_073_709_551_614_u64 as f64,
        })
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::Char | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 | Self::I64 | Self::U64 => 8,
        }
    }

    /// The number in as many bytes as the type takes.
    pub(super) fn number(self, raw: &[u8]) -> f64 {
        let bits = raw.iter().fold(0u64, |bits, &byte| bits << 8 | u64::from(byte));
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::I16 => f64::from(bits as i16),
            Self::I32 => f64::from(bits as i32),
            Self::I64 => bits as i64 as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
            Self::Char | Self::U8 | Self::U16 | Self::U32 | Self::U64 => bits as f64,
        }
    }
}
