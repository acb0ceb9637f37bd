//! The mask over an image of Gwyddion: points that were not measured, or points that someone marked.

use super::object::FORMAT;
use crate::error::ScanReadError;
use crate::raster::Raster;

/// A mask covers the points where it is above this; its edges may be soft.
const COVERED_ABOVE: f64 = 0.5;

/// Residual between an interpolated value and the mean of its neighbours, as a share of their differences from
/// it. Gwyddion's solver leaves some thousandths; of points that were measured it is a hundredth on the smoothest of
/// surfaces, and a tenth to one on others.
const LARGEST_REMAINDER: f64 = 0.005;

/// Meaning of a mask of an image.
pub(super) enum Mask {
    /// It covers nothing, or is not of the grid of the image.
    Void,
    /// Points that were not measured: a flag for each of the image.
    MissingPoints { flags: Vec<u8>, count: usize },
    /// So many points marked for a purpose of their own.
    Marks { count: usize },
}

impl Mask {
    /// Interprets a mask. Images of Gwyddion have no missing points: its importers mask points that were not measured,
    /// and fill in the mean of the others or what Laplace's equation makes of the points around; other programs write
    /// zeros there. Points that someone marked, such as grains, keep their own values.
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
        let is_constant = is_one_value && (first == 0.0 || !is_elsewhere());
        if is_constant || is_interpolated(&values, &flags, image.columns) {
            return Ok(Self::MissingPoints { flags, count });
        }
        Ok(Self::Marks { count })
    }
}

/// Returns true if the covered points solve Laplace's equation: each is the mean of its neighbours.
fn is_interpolated(values: &[f64], flags: &[u8], columns: usize) -> bool {
    let rows = values.len() / columns;
    let (mut remainder, mut difference) = (0.0, 0.0);
    for row in 1..rows.saturating_sub(1) {
        for column in 1..columns.saturating_sub(1) {
            let at = row * columns + column;
            if flags[at] == 0 {
                continue;
            }
            let around =
                [at - columns, at - 1, at + 1, at + columns].map(|neighbour| values[neighbour] - values[at]);
            remainder += around.iter().sum::<f64>().abs();
            difference += around.iter().map(|value| value.abs()).sum::<f64>();
        }
    }
    difference > 0.0 && remainder < difference * LARGEST_REMAINDER
}
