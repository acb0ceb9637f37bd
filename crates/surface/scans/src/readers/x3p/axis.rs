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

/// Conversion of raw numbers to lengths in m.
#[derive(Clone, Copy)]
pub(super) struct Coordinate {
    pub(super) number: NumberType,
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
