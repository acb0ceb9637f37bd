//! Measured heights and the files that hold them: text, the formats of some thirty-five instruments and programs,
//! containers of contact.engineering.
//!
//! The nouns:
//! * [`Scan`]: heights along an evenly or unevenly spaced line, or of a map, in m;
//! * [`MeasuredScan`]: such heights as an instrument gives them, some points without any ([`MissingPoints`]);
//! * [`ScanFile`]: a scan as read, with the instrument that the file names and the assumptions made;
//! * [`ScanOptions`]: what a file may leave open, such as its unit and size;
//! * [`ScanFormat`]: which reader knows a file.
//!
//! It opens no paths, prints nothing, and does not detrend, filter or fill anything.

mod assemble;
mod channel;
mod choice_of_size;
mod choice_of_units;
mod cursor;
mod error;
mod file;
mod foreign;
mod format;
mod heights;
mod measure;
mod measured;
mod metadata;
mod missing_points;
mod numbers;
mod options;
mod raster;
mod read;
mod readers;
mod recognition;
#[cfg_attr(not(feature = "archives"), allow(dead_code, reason = "fewer formats unpack less"))]
mod room;
mod scan_size;
mod single;
mod statistics;
mod texts;
mod writers;

#[cfg(any(feature = "archives", feature = "x3p", feature = "container", feature = "workbook"))]
#[cfg_attr(not(feature = "archives"), allow(dead_code, reason = "fewer formats unpack less"))]
mod archive;
#[cfg(feature = "archives")]
mod inflate;
#[cfg(feature = "archives")]
mod unpacked;

pub use channel::ScanAxis;
pub use error::{FilePlace, Mend, ScanOption, ScanReadError, Unitless};
pub use file::ScanFile;
pub use foreign::ForeignFile;
pub use format::{FormatCheck, ScanFormat};
pub use heights::{HeightMap, NonuniformLineScan, ParallelLines, Scan, ScanError, UniformLineScan};
pub use measure::Measure;
pub use measured::MeasuredScan;
pub use metadata::{MeasurementMetadata, Probe};
pub use missing_points::MissingPoints;
pub use options::{IGNORED, ScanOptions};
pub use read::{read_scans, visit_channels};
#[cfg(feature = "container")]
pub use readers::container::read_metadata;
pub use scan_size::ScanSize;
pub use statistics::Statistics;
pub use units::LengthUnit;
pub use writers::{ScanWriteError, WrittenFormat};

/// The example of the page runs.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
