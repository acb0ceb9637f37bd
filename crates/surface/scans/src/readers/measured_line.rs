//! Lines whose file gives the position of every point as it was measured or computed.

use super::even_axis::even_spacing;
use crate::channel::{Lateral, Samples};
use crate::numbers;
use crate::raster::Decoded;

/// Positions this share of a spacing off are even.
const EVEN: f64 = 1e-3;

/// A line from its lowest position on.
pub(super) struct MeasuredLine {
    pub(super) lateral: Lateral,
    pub(super) samples: Samples<'static>,
    /// Processing of the line, if any.
    pub(super) notes: Vec<String>,
}

impl MeasuredLine {
    /// The line of heights at positions in m, which may fall throughout; heights stay in their unit.
    pub(super) fn new(mut positions_m: Vec<f64>, mut heights: Vec<Option<f64>>) -> Self {
        let mut notes = Vec::new();
        if positions_m.len() > 1 && positions_m.is_sorted_by(|a, b| a > b) {
            notes.push("positions fall from point to point: the profile is read from its end".to_owned());
            positions_m.reverse();
            heights.reverse();
        }
        let columns = heights.len();
        let decoded: Decoded = heights.into_iter().collect();
        let lateral = match spacing_m(&positions_m) {
            Some(x_m) => Lateral::Spacing { x_m, y_m: None },
            None => Lateral::Positions(positions_m),
        };
        Self { lateral, samples: Samples::Decoded { columns, decoded }, notes }
    }
}

/// The spacing of positions that rise evenly.
fn spacing_m(positions_m: &[f64]) -> Option<f64> {
    let length_m = positions_m.last()? - positions_m.first()?;
    let rounding_m = EVEN * length_m / positions_m.len() as f64;
    even_spacing(positions_m, rounding_m).and_then(numbers::positive)
}
