//! Writers of heights in formats that other programs read, a module each.

mod gsf;
mod netcdf;
#[cfg(feature = "x3p")]
mod x3p;

use thiserror::Error;

use crate::file::ScanFile;

/// A format that heights are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WrittenFormat {
    /// Gwyddion Simple Field: maps in single precision.
    Gsf,
    /// ISO 25178-72: maps and profiles in double precision.
    #[cfg(feature = "x3p")]
    X3p,
    /// NetCDF-3 in the layout of contact.engineering: maps and profiles in double precision.
    NetCdf,
}

/// Error of heights that a format cannot hold.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ScanWriteError {
    /// A profile, in a format of maps.
    #[error("{format} holds maps, and this is a profile; write it as .x3p or .nc")]
    Profile {
        /// Ending of the format.
        format: &'static str,
    },
    /// Lines without a known distance, which no format holds.
    #[error("the lines of this scan are no map: how far they lie apart is not known")]
    Lines,
    /// An archive that cannot be packed.
    #[error("packing the archive: {0}")]
    Archive(String),
}

impl WrittenFormat {
    /// Every format.
    pub const ALL: &[Self] = &[
        Self::Gsf,
        #[cfg(feature = "x3p")]
        Self::X3p,
        Self::NetCdf,
    ];

    /// Ending of the names of its files.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Gsf => ".gsf",
            #[cfg(feature = "x3p")]
            Self::X3p => ".x3p",
            Self::NetCdf => ".nc",
        }
    }

    /// Returns the format that the name of a file ends in.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let name = name.to_lowercase();
        Self::ALL.iter().copied().find(|format| name.ends_with(format.ending()))
    }

    /// Writes heights in m with their gaps, the name of their channel, and a line on where they come from.
    ///
    /// Read back, heights equal those written to the last bit of the number that the format holds.
    ///
    /// # Errors
    /// [`ScanWriteError`] for scans that the format cannot hold.
    pub fn write(self, file: &ScanFile, provenance: &str) -> Result<Vec<u8>, ScanWriteError> {
        let provenance = provenance.replace(['\n', '\r', '\0'], " ");
        match self {
            Self::Gsf => gsf::write(file, &provenance),
            #[cfg(feature = "x3p")]
            Self::X3p => x3p::write(file, &provenance),
            Self::NetCdf => netcdf::write(file, &provenance),
        }
    }
}
