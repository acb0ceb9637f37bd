//! Lateral sizes: which one counts, and the scan it makes.

use units::display::length;

use crate::error::{Place, ScanReadError};
use crate::format::ScanFormat;
use crate::heights::{HeightMap, Scan, UniformLineScan};
use crate::options::{ScanOptions, ScanSize};

impl ScanSize {
    /// The size that counts: that of the options, else of the file, else of the metadata, else that to fall back on.
    pub(crate) fn of(options: &ScanOptions, stated: Option<Self>, notes: &mut Vec<String>) -> Option<Self> {
        if let (Some(wanted), Some(stated)) = (options.size, stated)
            && wanted != stated
        {
            notes.push(format!("the size {wanted} asked for replaces that of the file, {stated}"));
        }
        let told = options.size.or(stated).or_else(|| options.metadata_size());
        if let (Some(told), Some(unused)) = (told, options.fallback_size)
            && told != unused
        {
            notes.push(format!("the size {unused} given is not used: it is told to be {told}"));
        }
        told.or(options.fallback_size)
    }

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

/// Refuses a size asked for where every point has its position.
pub(crate) fn refuse_size(
    format: ScanFormat,
    place: Place,
    options: &ScanOptions,
) -> Result<(), ScanReadError> {
    if options.size.is_none() {
        return Ok(());
    }
    let found = "a line at uneven spacing with another size than its own".to_owned();
    Err(ScanReadError::Unsupported { format, place, found, mend: "leave out --size" })
}
