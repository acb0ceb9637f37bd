//! A folder for files that are about to be staged.

use std::io;
use std::path::{Path, PathBuf};

use super::temporaries::lock;

/// A newly created folder. It is removed when this value is dropped or a signal ends the program, unless it holds
/// published files or [`NewFolder::keep`] was called.
#[derive(Debug)]
pub struct NewFolder {
    path: PathBuf,
}

impl NewFolder {
    /// Creates a folder and its parents; `None` if it exists already.
    ///
    /// # Errors
    /// Any error of the file system.
    pub fn make(path: &Path) -> io::Result<Option<Self>> {
        if path.is_dir() {
            return Ok(None);
        }
        let mut paths = lock();
        std::fs::create_dir_all(path)?;
        let path = path.canonicalize()?;
        paths.insert(path.clone());
        Ok(Some(NewFolder { path }))
    }

    /// Keeps the folder.
    pub fn keep(self) {
        lock().remove(&self.path);
    }
}

impl Drop for NewFolder {
    fn drop(&mut self) {
        if lock().remove(&self.path) {
            // A folder with files in it stays.
            let _ = std::fs::remove_dir(&self.path);
        }
    }
}
