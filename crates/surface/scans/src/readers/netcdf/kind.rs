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

    /// Number that the NetCDF library writes where nobody has (NC_FILL_... of netcdf.h); bytes and text have none.
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

    /// Adds the numbers in these bytes, each as `of` has it.
    pub(super) fn read_into(self, bytes: &[u8], values: &mut Vec<f64>, of: impl Fn(f64) -> f64) {
        macro_rules! read {
            ($type:ty) => {
                values.extend(bytes.as_chunks().0.iter().map(|raw| of(<$type>::from_be_bytes(*raw) as f64)))
            };
        }
        match self {
            Self::I8 => read!(i8),
            Self::I16 => read!(i16),
            Self::I32 => read!(i32),
            Self::I64 => read!(i64),
            Self::F32 => read!(f32),
            Self::F64 => read!(f64),
            Self::Char | Self::U8 => read!(u8),
            Self::U16 => read!(u16),
            Self::U32 => read!(u32),
            Self::U64 => read!(u64),
        }
    }

    /// The number in as many bytes as the type takes; nothing in fewer.
    pub(super) fn number(self, raw: &[u8]) -> Option<f64> {
        let mut values = Vec::with_capacity(1);
        self.read_into(raw, &mut values, |value| value);
        values.first().copied()
    }
}
