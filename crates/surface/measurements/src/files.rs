//! Access to files by name, supplied by the caller.

use std::collections::BTreeMap;
use std::io;

/// Source of the bytes of files, by the names that a scene uses.
pub trait Files: Sync {
    /// Returns all bytes of a file.
    ///
    /// # Errors
    /// The system's error if the file cannot be read.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Returns all bytes of the file called `sibling` in the folder of the file `name`; `None` if it does not exist.
    ///
    /// # Errors
    /// The system's error if the file exists but cannot be read.
    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>>;

    /// Returns the names of the files in a folder, sorted; `None` if the name is none of a folder.
    ///
    /// # Errors
    /// The system's error if the folder cannot be read.
    fn list(&self, _folder: &str) -> io::Result<Option<Vec<String>>> {
        Ok(None)
    }
}

/// Files held in memory, under their paths with `/` between folders, or with the other separator of Windows.
impl<B: AsRef<[u8]> + Sync> Files for BTreeMap<String, B> {
    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        let bytes = self.get(name).ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))?;
        Ok(bytes.as_ref().to_vec())
    }

    fn read_beside(&self, name: &str, sibling: &str) -> io::Result<Option<Vec<u8>>> {
        let folder = name.rfind(['/', '\\']).map_or("", |end| &name[..=end]);
        Ok(self.get(&format!("{folder}{sibling}")).map(|bytes| bytes.as_ref().to_vec()))
    }

    fn list(&self, folder: &str) -> io::Result<Option<Vec<String>>> {
        let inside = format!("{}/", folder.trim_end_matches('/'));
        let names =
            self.keys().filter_map(|path| path.strip_prefix(&inside)).filter(|name| !name.contains('/'));
        let names: Vec<String> = names.map(str::to_owned).collect();
        Ok((!names.is_empty()).then_some(names))
    }
}

/// A source without files, for scenes that use built-in spectra only.
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

/// Returns the last part of a path, the name by which formats and metadata know a file.
pub(crate) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
