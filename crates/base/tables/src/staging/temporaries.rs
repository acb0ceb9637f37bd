//! The temporary files of the whole program, so that a signal handler can remove them.

use std::collections::BTreeSet;
use std::fs::{File, Permissions};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

/// Paths of all temporary files. A signal handler reaches no other value of the program, hence a static.
static PATHS: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// True once files were published. Written under the lock, and a static for the same reason.
static PUBLISHED: AtomicBool = AtomicBool::new(false);

/// Beginning of the names of temporary files.
const PREFIX: &str = ".truearea-tmp-";

/// Lock under which temporary files are created, renamed and removed.
pub(crate) type Locked = MutexGuard<'static, BTreeSet<PathBuf>>;

pub(crate) fn lock() -> Locked {
    // No panic leaves a set of paths half changed.
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Guard: no file is staged or published while it is held.
#[must_use = "dropping it allows staging and publishing again"]
pub struct Removed {
    _locked: Locked,
}

/// Returns true if this program has published files.
#[must_use]
pub fn has_published() -> bool {
    PUBLISHED.load(Ordering::Relaxed)
}

/// Records that files were published.
pub(crate) fn record_publication(_locked: &Locked) {
    PUBLISHED.store(true, Ordering::Relaxed);
}

/// Removes every temporary file and empty new folder, after any publication under way has finished.
///
/// For a program that ends without dropping its values: hold the returned guard until then.
pub fn remove_temporaries() -> Removed {
    let mut locked = lock();
    // In reverse order, files are removed before their folders. The program is ending: errors have no reader.
    for path in std::mem::take(&mut *locked).into_iter().rev() {
        let _ = if path.is_dir() { std::fs::remove_dir(path) } else { std::fs::remove_file(path) };
    }
    Removed { _locked: locked }
}

/// A temporary file, removed when dropped.
pub(crate) struct Temporary {
    /// `None` once renamed.
    file: Option<NamedTempFile>,
}

impl Temporary {
    /// Creates an empty temporary file in the folder of `target`.
    pub(crate) fn beside(target: &Path) -> io::Result<Self> {
        let mut paths = lock();
        loop {
            let file = builder().tempfile_in(folder_of(target))?;
            hold(file.as_file());
            // Another run may have taken it for one of a killed run before it was held.
            if file.path().exists() {
                paths.insert(file.path().to_owned());
                return Ok(Temporary { file: Some(file) });
            }
        }
    }

    pub(crate) fn path(&self) -> &Path {
        self.file.as_ref().map_or(Path::new(""), NamedTempFile::path)
    }

    pub(crate) fn file(&mut self) -> &mut File {
        self.existing().as_file_mut()
    }

    /// Sets permissions if the file system has them.
    pub(crate) fn set_permissions(&mut self, permissions: Permissions) {
        let _ = self.file().set_permissions(permissions);
    }

    /// Renames the file to `target`, or removes it on failure.
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

/// Gives a file a second name, under which it survives a replacement until the returned value is dropped. File systems
/// without hard links move the file instead.
pub(crate) fn second_name(target: &Path) -> io::Result<NamedTempFile<Option<File>>> {
    let old = File::open(target).ok().inspect(hold);
    builder().make_in(folder_of(target), |name| {
        match std::fs::hard_link(target, name) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists => std::fs::rename(target, name),
            done => done,
        }?;
        Ok(old.as_ref().and_then(|old| old.try_clone().ok()))
    })
}

/// Holds a temporary file as one of a program that runs; the system lets it go when the program ends. Where files that
/// are held cannot be read, or cannot be held at all, those of killed runs stay.
fn hold(file: &File) {
    if cfg!(unix) {
        let _ = file.lock_shared();
    }
}

/// Removes the temporary files in a folder that no running program holds.
pub(crate) fn remove_abandoned(folder: &Path) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries
        .filter(|entry| entry.file_name().as_encoded_bytes().starts_with(PREFIX.as_bytes()))
        .map(|entry| entry.path())
    {
        let is_abandoned = |file: &File| cfg!(unix) && file.try_lock().is_ok();
        // The lock lasts until the file is gone, so that nobody takes it up in between.
        if let Some(_held) = File::open(&path).ok().filter(is_abandoned) {
            let _ = std::fs::remove_file(&path);
        }
    }
}

/// Returns the folder of a file by its path, `.` of a name alone.
#[must_use]
pub fn folder_of(target: &Path) -> &Path {
    target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Builds temporary files with the permissions of any new file; the default is private to the user.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}
