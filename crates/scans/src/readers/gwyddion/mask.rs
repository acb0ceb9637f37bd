//! The mask over an image of Gwyddion: points that were not measured, or points that someone marked.

use super::object::FORMAT;
use crate::error::ScanReadError;
use crate::raster::Raster;

/// A mask covers the points where it is above this; its edges may be soft.
const COVERED_ABOVE: f64 = 0.5;

/// What a mask says of an image.
pub(super) enum Mask {
    /// It covers nothing, or is not of the grid of the image.
    Void,
    /// Points that were not measured: a flag for each of the image.
    Gaps { flags: Vec<u8>, count: usize },
    /// So many points marked for a purpose of their own.
    Marks { count: usize },
}

impl Mask {
    /// What a mask means. Images of Gwyddion have no gaps: its importers fill one value into points that were not measured,
    /// the mean of the others, and mask them; other programs write zeros there. Points that someone marked, such as grains,
    /// keep their own values.
    pub(super) fn read(mask: &Raster, image: &Raster) -> Result<Self, ScanReadError> {
        if (mask.columns, mask.rows) != (image.columns, image.rows) {
            return Ok(Self::Void);
        }
        let covering = mask.decode(FORMAT)?.values;
        let flags: Vec<u8> = covering.into_iter().map(|cover| u8::from(cover > COVERED_ABOVE)).collect();
        let count = flags.iter().filter(|&&flag| flag != 0).count();
        let values = image.decode(FORMAT)?.values;
        let covered = || values.iter().zip(&flags).filter(|(_, flag)| **flag != 0).map(|(value, _)| *value);
        let Some(first) = covered().next() else { return Ok(Self::Void) };
        let is_one_value = covered().all(|value| value == first);
        let is_elsewhere = || values.iter().zip(&flags).any(|(value, flag)| *flag == 0 && *value == first);
        if is_one_value && (first == 0.0 || !is_elsewhere()) {
            return Ok(Self::Gaps { flags, count });
        }
        Ok(Self::Marks { count })
    }
}
