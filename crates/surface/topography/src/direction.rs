//! Axis of a map along which its spectrum is taken.

use scans::{IGNORED, Scan, ScanAxis, ScanFile};
use serde::{Deserialize, Serialize};

use crate::cut_lines::LEAST_POINTS;
use crate::error::TransformError;

/// Axis along which the lines of a map run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Direction {
    /// Along the rows.
    #[default]
    X,
    /// Along the columns.
    Y,
    /// Along both, with a spectrum for each.
    Both,
}

units::named!(Direction, "direction", { X => "x", Y => "y", Both => "both" });

impl From<ScanAxis> for Direction {
    fn from(axis: ScanAxis) -> Self {
        match axis {
            ScanAxis::X => Self::X,
            ScanAxis::Y => Self::Y,
        }
    }
}

/// Returns true if a scan also has lines along y.
pub(crate) fn has_two(scan: &Scan) -> bool {
    match scan {
        Scan::Map(_) => true,
        Scan::Lines(lines) => lines.across().is_some(),
        Scan::UniformLine(_) | Scan::NonuniformLine(_) => false,
    }
}

/// Exchanges x and y of a map, or selects the lines cut out of it along y. Line scans stay unchanged, with a note.
///
/// # Errors
/// [`TransformError::NoLines`] if missing points left no line along y.
pub(crate) fn turned(mut file: ScanFile<Scan>) -> Result<ScanFile<Scan>, TransformError> {
    file.scan = match file.scan {
        Scan::Map(map) => Scan::Map(map.turned()),
        Scan::Lines(lines) => Scan::Lines(
            lines.into_across().ok_or(TransformError::NoLines { axis: ScanAxis::Y, least: LEAST_POINTS })?,
        ),
        line => {
            file.notes.push(format!("{IGNORED}the direction y: the spectrum of a line is along it"));
            line
        }
    };
    Ok(file)
}
