//! The lateral size of a scan, and the scan that it makes of heights.

use units::display::length;

use crate::error::ScanReadError;
use crate::heights::{HeightMap, Scan, UniformLineScan};

/// Size of a scan: that of its period, so many spacings as there are points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanSize {
    /// Along a line or the rows of a map, in m, above 0.
    pub x_m: f64,
    /// Across the rows of a map, in m, above 0; without it points are as far apart as along x.
    pub y_m: Option<f64>,
}

impl ScanSize {
    /// The line with this size.
    pub(crate) fn line(self, heights_m: Vec<f64>) -> Result<Scan, ScanReadError> {
        let spacing_m = self.x_m / heights_m.len() as f64;
        Ok(Scan::UniformLine(UniformLineScan::new(spacing_m, heights_m)?))
    }

    /// The map with this size, from heights row after row.
    pub(crate) fn map(
        self,
        columns: usize,
        heights_m: Vec<f64>,
        notes: &mut Vec<String>,
    ) -> Result<Scan, ScanReadError> {
        let spacing_x_m = self.x_m / columns as f64;
        let spacing_y_m = match self.y_m {
            Some(y_m) => y_m / (heights_m.len() / columns.max(1)) as f64,
            None => {
                notes.push("only the size along x is given: rows are as far apart as columns".to_owned());
                spacing_x_m
            }
        };
        Ok(Scan::Map(HeightMap::new(columns, spacing_x_m, spacing_y_m, heights_m)?))
    }
}

impl std::fmt::Display for ScanSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.y_m {
            None => f.write_str(&length(self.x_m)),
            Some(y_m) => write!(f, "{} x {}", length(self.x_m), length(y_m)),
        }
    }
}
