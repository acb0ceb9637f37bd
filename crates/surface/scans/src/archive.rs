//! ZIP files within bounds.

use std::io::{Cursor, Read};

use memchr::memmem;
use zip::ZipArchive;

use crate::error::ScanReadError;
use crate::room::Room;

/// Most files in an archive; containers hold some hundreds.
const MOST_ENTRIES: usize = 10_000;
/// First bytes of an entry of the directory.
const ENTRY: &[u8] = b"PK\x01\x02";

/// A ZIP file whose entries all lie inside it, and which unpacks to no more than it may.
pub(crate) struct Archive<'b> {
    zip: ZipArchive<Cursor<&'b [u8]>>,
    paths: Vec<String>,
    room: Room,
}

impl<'b> Archive<'b> {
    /// Looks at the directory of an archive; nothing is unpacked yet.
    pub(crate) fn open(bytes: &'b [u8], bound: u64) -> Result<Self, ScanReadError> {
        // The library takes several hundred bytes for an entry of some fifty: entries are counted before.
        if memmem::find_iter(bytes, ENTRY).count() > MOST_ENTRIES {
            let what = "the archive".to_owned();
            return Err(ScanReadError::ArchiveTooLarge { what, bound: MOST_ENTRIES as u64, unit: "files" });
        }
        let zip = ZipArchive::new(Cursor::new(bytes)).map_err(|error| failure("the archive", &error))?;
        let paths: Result<Vec<_>, _> = zip.file_names().map(|path| path.map(String::from)).collect();
        let paths = paths.map_err(|error| failure("the archive", &error))?;
        if let Some(path) = paths.iter().find(|path| leads_outside(path)) {
            return Err(ScanReadError::PathOutside { path: path.clone() });
        }
        Ok(Self { zip, paths, room: Room::new(bound) })
    }

    pub(crate) fn paths(&self) -> impl Iterator<Item = &str> {
        self.paths.iter().map(String::as_str)
    }

    /// Unpacks an entry. The sizes in the directory are not trusted: unpacking stops at the bound.
    pub(crate) fn read(&mut self, path: &str) -> Result<Vec<u8>, ScanReadError> {
        let bound = self.room.left;
        self.read_at_most(path, bound)
    }

    /// Unpacks an entry that may not be larger than the bound.
    pub(crate) fn read_at_most(&mut self, path: &str, bound: u64) -> Result<Vec<u8>, ScanReadError> {
        let what = format!("'{path}'");
        let bound = bound.min(self.room.left);
        let shown = if bound == self.room.left { self.room.bound } else { bound };
        let too_large = |what: String| ScanReadError::ArchiveTooLarge { what, bound: shown, unit: "bytes" };
        let entry = self.zip.by_name(path).map_err(|error| failure(&what, &error))?;
        if entry.size() > bound {
            return Err(too_large(what));
        }
        let mut bytes = Vec::new();
        let unpacked = entry.take(bound.saturating_add(1)).read_to_end(&mut bytes);
        unpacked.map_err(|error| ScanReadError::Zip { what: what.clone(), problem: error.to_string() })?;
        let length = bytes.len() as u64;
        if length > bound {
            return Err(too_large(what));
        }
        self.room.take(length, || what)?;
        Ok(bytes)
    }
}

/// Returns true if a file begins as ZIP files do.
pub(crate) fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04")
}

/// Returns true if a file holds a name anywhere. ZIP files store names uncompressed.
pub(crate) fn is_named_in(bytes: &[u8], name: &str) -> bool {
    memmem::find(bytes, name.as_bytes()).is_some()
}

/// Names of the index of a container.
#[cfg(feature = "container")]
pub(crate) const INDEXES: [&str; 2] = ["index.json", "meta.yml"];

/// Returns true if a file names the index of a container; nothing is unpacked.
#[cfg(feature = "container")]
pub(crate) fn is_container(bytes: &[u8]) -> bool {
    is_zip(bytes) && INDEXES.iter().any(|index| is_named_in(bytes, index))
}

fn failure(what: &str, error: &zip::result::ZipError) -> ScanReadError {
    ScanReadError::Zip { what: what.to_owned(), problem: error.to_string() }
}

/// Returns true if a path is absolute, names a drive, or climbs.
pub(crate) fn leads_outside(path: &str) -> bool {
    let mut parts = path.split(['/', '\\']);
    path.starts_with(['/', '\\'])
        || path.contains('\0')
        || path.get(1..2) == Some(":")
        || parts.any(|part| part == "..")
}
