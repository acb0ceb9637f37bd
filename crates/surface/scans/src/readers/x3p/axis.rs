//! Axes, and the conversion of raw numbers to positions and heights.

use crate::raster::NumberType;

/// Places of the points along an axis.
#[derive(Clone, Copy)]
pub(super) enum ScanAxis {
    /// So far from each other, in m.
    Even(f64),
    /// At positions stored in the data.
    Given(Coordinate),
}

/// The type of a number, little-endian.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    I16,
    I32,
    F32,
    F64,
}

/// Conversion of raw numbers to lengths in m.
#[derive(Clone, Copy)]
pub(super) struct Coordinate {
    pub(super) kind: Kind,
    pub(super) increment: f64,
    pub(super) offset: f64,
}

impl ScanAxis {
    pub(super) fn given(self) -> Option<Coordinate> {
        match self {
            Self::Even(_) => None,
            Self::Given(coordinate) => Some(coordinate),
        }
    }
}
impl Coordinate {
    pub(super) fn length_m(self, raw: f64) -> f64 {
        raw * self.increment + self.offset
    }
}

impl Kind {
    pub(super) fn number_type(self) -> NumberType {
        match self {
            Self::I16 => NumberType::I16,
            Self::I32 => NumberType::I32,
            Self::F32 => NumberType::F32,
            Self::F64 => NumberType::F64,
        }
    }

    pub(super) fn number(self, raw: &[u8]) -> f64 {
        match (self, raw) {
            (Self::I16, &[a, b]) => f64::from(i16::from_le_bytes([a, b])),
            (Self::I32, &[a, b, c, d]) => f64::from(i32::from_le_bytes([a, b, c, d])),
            (Self::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            (Self::F64, &[a, b, c, d, e, f, g, h]) => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
            _ => f64::NAN,
        }
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I16 => 2,
            Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}
