//! Along which axis of a map its spectrum is taken.

use scans::{Axis, Scan, ScanFile};
use serde::{Deserialize, Serialize};

use crate::cut_lines::LEAST_POINTS;
use crate::error::TransformError;

/// Along which axis of a map its lines run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Along its rows.
    #[default]
    X,
    /// Along its columns.
    Y,
    /// Along both, each a spectrum of its own.
    Both,
}

units::named!(Direction, "direction", { X => "x", Y => "y", Both => "both" });

impl From<Axis> for Direction {
    fn from(axis: Axis) -> Self {
        match axis {
            Axis::X => Self::X,
            Axis::Y => Self::Y,
        }
    }
}

/// Whether a scan can be taken along y as well.
pub(crate) fn has_two(scan: &Scan) -> bool {
    match scan {
        Scan::Map(_) => true,
        Scan::Lines(lines) => lines.across().is_some(),
        Scan::UniformLine(_) | Scan::NonuniformLine(_) => false,
    }
}

/// A map with x and y exchanged, or the lines that were cut out of it along y. Other scans know one direction and stay as
/// they are, with a note of it.
///
/// # Errors
/// [`TransformError::NoLines`] where gaps left no line along y.
pub(crate) fn turned(mut file: ScanFile<Scan>) -> Result<ScanFile<Scan>, TransformError> {
    file.scan = match file.scan {
        Scan::Map(map) => Scan::Map(map.turned()),
        Scan::Lines(lines) => Scan::Lines(
            lines.into_across().ok_or(TransformError::NoLines { axis: Axis::Y, least: LEAST_POINTS })?,
        ),
        line => {
            file.notes
                .push("a line has one direction: its spectrum is that along it, not along y".to_owned());
            line
        }
    };
    Ok(file)
}
