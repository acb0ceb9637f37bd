//! Files written aside and renamed into place together: either all appear whole, or none does and the old ones stay.
//!
//! Until it is published, a file is a temporary file in the folder of its target. Dropping [`StagedFiles`] removes it. A
//! program that a signal ends calls [`remove_temporaries`] first. The module [`reading`] reads files and streams up to a bound.
//!
//! ```
//! use std::io::{self, Write};
//! use tables::staging::StagedFiles;
//!
//! let folder = std::env::temp_dir().join(format!("staging-example-{}", std::process::id()));
//! std::fs::create_dir_all(&folder)?;
//! let mut files = StagedFiles::default();
//! files.stage(&folder.join("area.csv"), |out| writeln!(out, "wavelength_m,area_fraction"))?;
//! files.stage(&folder.join("area.svg"), |out| -> io::Result<()> { out.write_all(b"<svg/>") })?;
//! assert!(!folder.join("area.csv").exists());
//! files.publish()?;
//! assert!(folder.join("area.csv").exists());
//! # std::fs::remove_dir_all(folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod new_folder;
pub mod reading;
mod temporaries;
mod unfinished;

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

pub use new_folder::NewFolder;
use temporaries::Temporary;
pub use temporaries::{Removed, folder_of, has_published, remove_temporaries};
use unfinished::Markers;

/// Findings of a publication.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub struct Published {
    /// Folders in which an earlier publication was killed between two files, or another is under way.
    pub unfinished: Vec<PathBuf>,
}

/// A staged file could not be put into place. Nothing has changed but the files in `not_restored`.
#[derive(Debug, thiserror::Error)]
#[error("writing {}: {error}{}", path.display(), left_behind(not_restored))]
pub struct PublishError {
    /// The target path.
    pub path: PathBuf,
    /// The system's error.
    pub error: io::Error,
    /// Targets replaced earlier that could not be restored, with the reason.
    pub not_restored: Vec<(PathBuf, io::Error)>,
}

fn left_behind(not_restored: &[(PathBuf, io::Error)]) -> String {
    let describe = |(path, error): &(PathBuf, io::Error)| {
        format!("; {} is replaced already and could not be restored: {error}", path.display())
    };
    not_restored.iter().map(describe).collect()
}

/// Files written aside, to be renamed into place together.
#[derive(Default)]
pub struct StagedFiles(Vec<Staged>);

/// A file written aside.
struct Staged {
    aside: Temporary,
    target: PathBuf,
}

impl StagedFiles {
    /// Writes one file aside, in the folder of its target.
    ///
    /// # Errors
    /// Any error of `write` or of the file system; [`io::ErrorKind::AlreadyExists`] if a staged file has the same
    /// target. Nothing is left behind.
    pub fn stage<E: From<io::Error>>(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), E> {
        // A device or a pipe cannot be replaced, and a link is to be followed.
        if path.metadata().is_ok_and(|existing| !existing.is_file()) {
            let mut file = BufWriter::new(std::fs::File::options().write(true).open(path)?);
            write(&mut file)?;
            return Ok(file.flush()?);
        }
        let target = resolve(path);
        if self.0.iter().any(|staged| staged.target == target) {
            let message = "two results go into this file; name two files";
            return Err(io::Error::new(io::ErrorKind::AlreadyExists, message).into());
        }
        let mut aside = Temporary::beside(&target)?;
        let mut buffered = BufWriter::new(aside.file());
        write(&mut buffered)?;
        buffered.flush()?;
        drop(buffered);
        self.0.push(Staged { aside, target });
        Ok(())
    }

    /// Makes the last staged file the first to be renamed into place.
    pub fn last_first(&mut self) {
        self.0.rotate_right(1);
    }

    /// The targets of the staged files, without links, and the files that hold their contents until then.
    pub fn targets(&self) -> impl Iterator<Item = (&Path, &Path)> {
        self.0.iter().map(|staged| (staged.target.as_path(), staged.aside.path()))
    }

    /// Renames every staged file into place. If one fails, the targets before it are restored.
    ///
    /// # Errors
    /// [`PublishError`] for the first path that could not be replaced.
    pub fn publish(self) -> Result<Published, PublishError> {
        if self.0.is_empty() {
            return Ok(Published::default());
        }
        let targets: Vec<PathBuf> = self.0.iter().map(|staged| staged.target.clone()).collect();
        let mut left = self.0.into_iter();
        // `remove_temporaries` waits for this lock. `left` is declared before it: files left at the end need the lock
        // to be dropped.
        let mut locked = temporaries::lock();
        let (markers, unfinished) = Markers::place(targets.iter().map(PathBuf::as_path));
        let mut replaced: Vec<Replaced> = Vec::new();
        while let Some(Staged { aside, target }) = left.next() {
            // Nothing can fail after the last file, so its old version need not be kept.
            let keep_old = left.len() > 0;
            match replace(aside, &target, keep_old, &mut locked) {
                Ok(old) => replaced.push(Replaced { target, old }),
                Err(error) => {
                    let restored = replaced.into_iter().rev().map(Replaced::restore);
                    let not_restored: Vec<_> = restored.filter_map(Result::err).collect();
                    if not_restored.is_empty() && unfinished.is_empty() {
                        markers.remove();
                    }
                    return Err(PublishError { path: target, error, not_restored });
                }
            }
        }
        markers.remove();
        temporaries::record_publication(&locked);
        Ok(Published { unfinished })
    }
}

/// Returns the path without links. The file need not exist, but then its folder has to.
#[must_use]
pub fn resolve(path: &Path) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let in_folder = || Some(absolute.parent()?.canonicalize().ok()?.join(absolute.file_name()?));
    path.canonicalize().ok().or_else(in_folder).unwrap_or_else(|| path.to_owned())
}

/// A target with its new file; dropping this value deletes the old one.
struct Replaced {
    target: PathBuf,
    old: Option<NamedTempFile<Option<File>>>,
}

impl Replaced {
    /// Restores the old file.
    fn restore(self) -> Result<(), (PathBuf, io::Error)> {
        let restored = match self.old {
            Some(old) => put_back(old, &self.target),
            None => std::fs::remove_file(&self.target),
        };
        restored.map_err(|error| (self.target, error))
    }
}

/// Replaces the file at `target`; returns the old one if there was one and `keep_old` is set.
fn replace(
    mut aside: Temporary,
    target: &Path,
    keep_old: bool,
    locked: &mut temporaries::Locked,
) -> io::Result<Option<NamedTempFile<Option<File>>>> {
    let existing = target.metadata().ok();
    let old = match &existing {
        Some(existing) if existing.is_file() && keep_old => Some(temporaries::second_name(target)?),
        _ => None,
    };
    if let Some(existing) = existing {
        // Keep the permissions of the replaced file.
        aside.set_permissions(existing.permissions());
    }
    if let Err(error) = aside.rename(target, locked) {
        // If the old file only got a second name, it is still in place.
        if let Some(old) = old.filter(|_| !target.exists()) {
            put_back(old, target)?;
        }
        return Err(error);
    }
    Ok(old)
}

fn put_back(old: NamedTempFile<Option<File>>, target: &Path) -> io::Result<()> {
    old.persist(target).map(drop).map_err(|error| error.error)
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// Any error of the file system.
pub fn write_file(path: &Path, contents: impl AsRef<[u8]>) -> io::Result<()> {
    let mut files = StagedFiles::default();
    files.stage(path, |out| out.write_all(contents.as_ref()))?;
    files.publish().map(drop).map_err(|error| error.error)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn staged(folder: &Path, files: &[&str]) -> StagedFiles {
        let mut staged = StagedFiles::default();
        for name in files {
            staged.stage(&folder.join(name), |out| out.write_all(b"new")).unwrap();
        }
        staged
    }

    #[test]
    fn files_appear_together_and_leave_nothing_beside_them() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "old").unwrap();
        staged(folder.path(), &["a", "b", "c"]).publish().unwrap();
        assert_eq!(names(folder.path()), ["a", "b", "c"]);
        assert_eq!(std::fs::read_to_string(folder.path().join("a")).unwrap(), "new");
    }

    #[test]
    fn two_results_never_share_a_file() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("inner")).unwrap();
        for name in ["a", "new"] {
            std::fs::write(folder.path().join("a"), "old").unwrap();
            let mut files = staged(folder.path(), &[name]);
            let again = folder.path().join("inner/..").join(name);
            let error = files.stage(&again, |out| out.write_all(b"other")).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::AlreadyExists);
            files.publish().unwrap();
            assert_eq!(std::fs::read_to_string(&again).unwrap(), "new");
        }
        assert_eq!(names(folder.path()), ["a", "inner", "new"]);
    }

    /// A full disk, or any other fault in the middle of a file: whatever the number of bytes written, targets keep their
    /// contents and no file is left aside.
    #[test]
    fn a_writer_that_fails_after_any_number_of_bytes_changes_no_file() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "old").unwrap();
        for bytes in [0, 1, 8191, 8192, 8193, 100_000] {
            let mut files = staged(folder.path(), &["a", "b"]);
            let failed = files.stage(&folder.path().join("c"), |out| {
                out.write_all(&vec![b'x'; bytes])?;
                Err(io::Error::from(io::ErrorKind::StorageFull))
            });
            assert_eq!(failed.unwrap_err().kind(), io::ErrorKind::StorageFull);
            drop(files);
            assert_eq!(names(folder.path()), ["a"]);
            assert_eq!(std::fs::read_to_string(folder.path().join("a")).unwrap(), "old");
        }
    }

    /// A program that is killed between two renames leaves the marker.
    #[test]
    fn the_next_publication_tells_of_one_that_was_killed() {
        let folder = tempfile::tempdir().unwrap();
        let targets = [folder.path().join("a"), folder.path().join("b")];
        let (_killed, before) = Markers::place(targets.iter().map(PathBuf::as_path));
        assert!(before.is_empty());
        let published = staged(folder.path(), &["a", "b"]).publish().unwrap();
        assert_eq!(published.unfinished, [folder.path().canonicalize().unwrap()]);
        let published = staged(folder.path(), &["a", "b"]).publish().unwrap();
        assert!(published.unfinished.is_empty());
        assert_eq!(names(folder.path()), ["a", "b"]);
    }

    #[test]
    fn where_one_file_cannot_be_published_none_is() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), "old").unwrap();
        let staged = staged(folder.path(), &["a", "b", "c", "d"]);
        // A folder has taken the place in the meantime.
        std::fs::create_dir(folder.path().join("c")).unwrap();
        let error = staged.publish().unwrap_err();
        assert_eq!(error.path, folder.path().join("c"));
        assert!(error.not_restored.is_empty(), "{error}");
        assert_eq!(names(folder.path()), ["a", "c"]);
        assert_eq!(std::fs::read_to_string(folder.path().join("a")).unwrap(), "old");
    }
}
