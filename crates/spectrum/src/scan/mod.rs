//! Measured heights and the files that hold them.

mod error;
mod file;
mod format;
mod heights;
mod length;
mod metadata;
mod nanoscope;
mod netcdf;
mod options;
mod size;
mod text;
mod units;

#[cfg(any(feature = "x3p", feature = "container"))]
mod archive;
#[cfg(feature = "container")]
mod container;
#[cfg(feature = "x3p")]
mod x3p;

#[cfg(feature = "container")]
pub use container::read_metadata;
pub use error::{Place, ScanReadError};
pub use file::{ScanFile, read_scans};
pub use format::ScanFormat;
pub use heights::{HeightMap, NonuniformLineScan, Scan, ScanError, UniformLineScan};
pub use length::{LengthUnit, UnknownLengthUnit};
pub use metadata::MeasurementMetadata;
pub use options::{ScanOptions, ScanSize};
