//! A folder for files that are about to be staged.

use std::io;
use std::path::{Path, PathBuf};

use crate::temporaries::lock;

/// A folder that was made where there was none: it goes again with this value, or with a program that is ended, unless files
/// were published into it or it was told to stay.
#[derive(Debug)]
pub struct NewFolder {
    path: PathBuf,
}

impl NewFolder {
    /// Makes a folder, and those above it; `None` where it is there already.
    ///
    /// # Errors
    /// Why it cannot be made.
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

    /// It stays.
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
