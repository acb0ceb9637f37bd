//! Measured heights and the files that hold them: text, Nanoscope, NetCDF-3, X3P, containers of contact.engineering.
//!
//! The nouns:
//! * [`Scan`]: heights along an evenly or unevenly spaced line, or of a map, in m, without gaps;
//! * [`ScanFile`]: a [`Scan`] as read, with what the file says of its instrument and the assumptions made;
//! * [`ScanOptions`]: what a file may leave open, such as its unit and size;
//! * [`ScanFormat`]: which reader knows a file.
//!
//! What it does not do: it opens no paths, prints nothing, and does not detrend, filter or fill anything.

mod choice_of_size;
mod choice_of_units;
mod error;
mod file;
mod format;
mod heights;
mod metadata;
mod nanoscope;
mod netcdf;
mod options;
mod read;
mod scan_size;
mod single;
mod text;

#[cfg(any(feature = "x3p", feature = "container"))]
mod archive;
#[cfg(feature = "container")]
mod container;
#[cfg(feature = "x3p")]
mod x3p;

#[cfg(feature = "container")]
pub use container::read_metadata;
pub use error::{Mend, Place, ScanOption, ScanReadError};
pub use file::ScanFile;
pub use format::ScanFormat;
pub use heights::{HeightMap, NonuniformLineScan, Scan, ScanError, UniformLineScan};
pub use metadata::{MeasurementMetadata, Probe};
pub use options::ScanOptions;
pub use read::read_scans;
pub use scan_size::ScanSize;
pub use units::LengthUnit;

/// The example of the page runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
