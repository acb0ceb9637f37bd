//! The temporary files of the whole program, so that whoever ends it by a signal can remove them.

use std::collections::BTreeSet;
use std::fs::{File, Permissions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// The paths of all of them. A signal reaches no value of the program, hence a static.
static PATHS: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// While it is held, nobody else makes, renames or removes a temporary file.
pub(crate) type Locked = MutexGuard<'static, BTreeSet<PathBuf>>;

pub(crate) fn lock() -> Locked {
    // A set of paths is whole after any panic.
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// As long as this is held, no file is staged or published.
#[must_use = "files are staged and published again once this is dropped"]
pub struct Removed {
    _locked: Locked,
}

/// Removes every temporary file and empty new folder, after the end of a publication that has begun. For a program that ends without dropping
/// its values: hold what is returned until then.
pub fn remove_temporaries() -> Removed {
    let mut locked = lock();
    // What is in a folder comes behind it, and goes first. Nobody is left who could be told of an error.
    for path in std::mem::take(&mut *locked).into_iter().rev() {
        let _ = if path.is_dir() { std::fs::remove_dir(path) } else { std::fs::remove_file(path) };
    }
    Removed { _locked: locked }
}

/// A temporary file, which goes with its value.
pub(crate) struct Temporary {
    /// None once it has been renamed.
    file: Option<NamedTempFile>,
}

impl Temporary {
    /// An empty one in the folder of `target`.
    pub(crate) fn beside(target: &Path) -> io::Result<Self> {
        let mut paths = lock();
        let file = builder().tempfile_in(folder_of(target))?;
        paths.insert(file.path().to_owned());
        Ok(Temporary { file: Some(file) })
    }

    pub(crate) fn file(&mut self) -> &mut File {
        self.existing().as_file_mut()
    }

    /// Sets them where the disk knows permissions.
    pub(crate) fn set_permissions(&mut self, permissions: Permissions) {
        let _ = self.file().set_permissions(permissions);
    }

    /// Renames it to `target`, or removes it.
    pub(crate) fn rename(mut self, target: &Path, locked: &mut Locked) -> io::Result<()> {
        let Some(file) = self.file.take() else { return Ok(()) };
        locked.remove(file.path());
        file.persist(target).map(drop).map_err(|error| error.error)
    }

    fn existing(&mut self) -> &mut NamedTempFile {
        self.file.as_mut().expect("only `rename`, which consumes it, takes the file")
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(file) = self.file.take() {
            lock().remove(file.path());
        }
    }
}

/// A second name of a file, under which it stays when the first one is given away, until this is dropped. Where the disk
/// knows no second names the file moves there.
pub(crate) fn second_name(target: &Path) -> io::Result<NamedTempFile<()>> {
    builder().make_in(folder_of(target), |name| match std::fs::hard_link(target, name) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => std::fs::rename(target, name),
        done => done,
    })
}

fn folder_of(target: &Path) -> &Path {
    target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Temporary files are private by default; results get the permissions any new file gets.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}
