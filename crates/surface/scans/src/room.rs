//! Bound on unpacking that all packed parts of a file share.

use crate::error::ScanReadError;

/// The bytes that may be unpacked of a file, and how many of them are left.
pub(crate) struct Room {
    /// The bound for all parts together.
    pub(crate) bound: u64,
    /// The bytes left.
    pub(crate) left: u64,
}

impl Room {
    pub(crate) fn new(bound: u64) -> Self {
        Self { bound, left: bound }
    }

    /// Takes what a part needs, before it is unpacked.
    ///
    /// # Errors
    /// [`ScanReadError::ArchiveTooLarge`] where less is left.
    pub(crate) fn take(&mut self, bytes: u64, what: impl FnOnce() -> String) -> Result<(), ScanReadError> {
        let left = self.left.checked_sub(bytes).ok_or_else(|| ScanReadError::ArchiveTooLarge {
            what: what(),
            bound: self.bound,
            unit: "bytes",
        })?;
        self.left = left;
        Ok(())
    }
}
