//! Files that people give in place of a scene.

use std::fmt;

use measurements::{heights_in, holds_a_spectrum};
use scans::{ForeignFile, ScanFormat};
use spectrum::ReadOptions;

/// The content of a file that is not a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileContent {
    /// Heights in this format.
    Scan(ScanFormat),
    /// A power spectrum.
    Spectrum,
    /// A file without numbers to read.
    Foreign(ForeignFile),
}

impl FileContent {
    /// Recognises heights, spectra and other files by their content; `None` for a scene and any other text.
    #[must_use]
    pub fn recognise(bytes: &[u8]) -> Option<Self> {
        // Workbooks are ZIP files, which their readers tell apart.
        let foreign = ForeignFile::recognise(bytes).filter(|kind| *kind != ForeignFile::Zip);
        let of_numbers = || match holds_a_spectrum(bytes, &ReadOptions::default()) {
            true => Some(FileContent::Spectrum),
            false => heights_in("", bytes).map(|scan| FileContent::Scan(scan.format)),
        };
        match ScanFormat::recognise(bytes) {
            Some(format) if format != ScanFormat::Workbook => Some(FileContent::Scan(format)),
            _ => foreign.map(FileContent::Foreign).or_else(of_numbers),
        }
    }
}

impl fmt::Display for FileContent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FileContent::Scan(format) => write!(f, "a scan ({format})"),
            FileContent::Spectrum => f.write_str("a power spectrum"),
            FileContent::Foreign(kind) => kind.fmt(f),
        }
    }
}
