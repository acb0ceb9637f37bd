//! Where the files come from that a scene names: whoever runs a study hands them over by name.

use std::collections::BTreeMap;
use std::io;

/// Hands out the bytes of files by the names that stand in a scene.
pub trait Files: Sync {
    /// All bytes of a file.
    ///
    /// # Errors
    /// Why they cannot be had.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// All bytes of the file called `sibling` in the folder of the file `name`; none where there is no such file.
    ///
    /// # Errors
    /// Why they cannot be had, of a file that is there.
    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>>;
}

/// Files held in memory, under their paths with `/` between folders.
impl Files for BTreeMap<String, Vec<u8>> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        self.get(name).cloned().ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind('/').map_or("", |end| &name[..=end]);
        Ok(self.get(&format!("{folder}{sibling}")).cloned())
    }
}

/// No files at all: built-in spectra alone can be named.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoFiles;

impl Files for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::Error::from(io::ErrorKind::NotFound))
    }

    fn read_beside(&self, _: &str, _: &str) -> io::Result<Option<Vec<u8>>> {
        Ok(None)
    }
}

/// The last part of a path, which formats and metadata know a file by.
pub(crate) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
