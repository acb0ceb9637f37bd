//! Options of a caller who knows more than the file says.

use crate::metadata::MeasurementMetadata;
use crate::scan_size::ScanSize;
use units::LengthUnit;

/// Beginning of the notes on options that a file has no use for.
pub const IGNORED: &str = "ignoring ";

/// Facts about a scan that the caller knows.
///
/// An option overrides the file, with a note where they differ. The file overrides the metadata, and both override the
/// fallbacks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScanOptions {
    /// The channel to read, by one of the names in [`ScanFile::channels`](crate::ScanFile::channels), or such a name
    /// without its number or the bracket at its end; of several that fit, the first with heights. Without it the first
    /// height channel is read.
    pub channel: Option<String>,
    /// The measurement to read from a container, by its name or that of its data file. Without it all are read. Also
    /// the file to read from any other ZIP file, which without it may hold one scan.
    pub measurement: Option<String>,
    /// Unit of lengths, and of heights unless `height_unit` is given. Refused for formats that fix their units.
    pub unit: Option<LengthUnit>,
    /// Unit of heights.
    pub height_unit: Option<LengthUnit>,
    /// Size of the scan.
    pub size: Option<ScanSize>,
    /// Unit of lengths and heights if options, file and metadata have none.
    pub fallback_unit: Option<LengthUnit>,
    /// Unit of heights in place of `fallback_unit`.
    pub fallback_height_unit: Option<LengthUnit>,
    /// Size of the scan if options, file and metadata have none.
    pub fallback_size: Option<ScanSize>,
    /// Metadata of a container; see [`read_metadata`](crate::read_metadata) for a `meta.yml` that lies
    /// beside a file.
    pub metadata: Option<MeasurementMetadata>,
    /// Most bytes that a file may unpack to, be it packed as a whole or in parts; 1 GiB if none is given.
    pub max_unpacked_bytes: Option<u64>,
}

impl ScanOptions {
    /// Most bytes that a file may unpack to by default.
    pub const MAX_UNPACKED_BYTES: u64 = 1 << 30;

    /// The unit of heights asked for.
    pub(crate) fn height_unit(&self) -> Option<LengthUnit> {
        self.height_unit.or(self.unit)
    }

    /// The size that the metadata gives to a scan whose file gives none.
    pub(crate) fn metadata_size(&self) -> Option<ScanSize> {
        self.metadata.as_ref()?.size()
    }

    pub(crate) fn unpacked_bound(&self) -> u64 {
        self.max_unpacked_bytes.unwrap_or(Self::MAX_UNPACKED_BYTES)
    }
}
