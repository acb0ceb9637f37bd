#![doc = include_str!("../README.md")]

mod new_folder;
mod temporaries;

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

pub use new_folder::NewFolder;
use temporaries::Temporary;
pub use temporaries::{Removed, remove_temporaries};

/// A staged file that could not be put into its place. Nothing has changed, unless `not_restored` says so.
#[derive(Debug, thiserror::Error)]
#[error("writing {}: {error}{}", path.display(), left_behind(not_restored))]
pub struct PublishError {
    /// The place.
    pub path: PathBuf,
    /// Why.
    pub error: io::Error,
    /// The places, replaced before it, that could not be given back what they held, with why.
    pub not_restored: Vec<(PathBuf, io::Error)>,
}

fn left_behind(not_restored: &[(PathBuf, io::Error)]) -> String {
    let told = |(path, error): &(PathBuf, io::Error)| {
        format!("; {} is replaced already and could not be restored: {error}", path.display())
    };
    not_restored.iter().map(told).collect()
}

/// Files written aside, to be renamed into place together.
#[derive(Default)]
pub struct StagedFiles(Vec<Staged>);

/// One file, written aside.
struct Staged {
    aside: Temporary,
    target: PathBuf,
}

impl StagedFiles {
    /// Writes one file aside, in the folder it is meant for.
    ///
    /// # Errors
    /// What stopped `write`, or the writing itself. Nothing is left behind.
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
        let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let mut aside = Temporary::beside(&target)?;
        let mut buffered = BufWriter::new(aside.file());
        write(&mut buffered)?;
        buffered.flush()?;
        drop(buffered);
        self.0.push(Staged { aside, target });
        Ok(())
    }

    /// Renames every staged file into its place. Where one cannot be, those before it get back what they held.
    ///
    /// # Errors
    /// [`PublishError`] for the first path that could not be replaced.
    pub fn publish(self) -> Result<(), PublishError> {
        let mut left = self.0.into_iter();
        // Whoever removes temporaries waits for the end of this. What is left in the end needs the lock in order to go, and
        // is declared before it.
        let mut locked = temporaries::lock();
        let mut replaced: Vec<Replaced> = Vec::new();
        while let Some(Staged { aside, target }) = left.next() {
            // Nothing can fail after the last one, whose old file therefore need not be kept.
            let keep_old = left.len() > 0;
            match replace(aside, &target, keep_old, &mut locked) {
                Ok(old) => replaced.push(Replaced { target, old }),
                Err(error) => {
                    let restored = replaced.into_iter().rev().map(Replaced::restore);
                    return Err(PublishError {
                        path: target,
                        error,
                        not_restored: restored.filter_map(Result::err).collect(),
                    });
                }
            }
        }
        Ok(())
    }
}

/// A place that has its new file; what it held before goes with this value.
struct Replaced {
    target: PathBuf,
    old: Option<NamedTempFile<()>>,
}

impl Replaced {
    /// Gives the place back what it held.
    fn restore(self) -> Result<(), (PathBuf, io::Error)> {
        let restored = match self.old {
            Some(old) => put_back(old, &self.target),
            None => std::fs::remove_file(&self.target),
        };
        restored.map_err(|error| (self.target, error))
    }
}

/// Replaces the file at a place, and yields the old one where there was one and it is to be kept.
fn replace(
    mut aside: Temporary,
    target: &Path,
    keep_old: bool,
    locked: &mut temporaries::Locked,
) -> io::Result<Option<NamedTempFile<()>>> {
    let existing = target.metadata().ok();
    let old = match &existing {
        Some(existing) if existing.is_file() && keep_old => Some(temporaries::second_name(target)?),
        _ => None,
    };
    if let Some(existing) = existing {
        // Replacing a file does not make it readable to others.
        aside.set_permissions(existing.permissions());
    }
    if let Err(error) = aside.rename(target, locked) {
        // Where the old file only got a second name, it is still in its place.
        if let Some(old) = old.filter(|_| !target.exists()) {
            put_back(old, target)?;
        }
        return Err(error);
    }
    Ok(old)
}

fn put_back(old: NamedTempFile<()>, target: &Path) -> io::Result<()> {
    old.persist(target).map_err(|error| error.error)
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// Why it could not be written.
pub fn write_file(path: &Path, contents: impl AsRef<[u8]>) -> io::Result<()> {
    let mut files = StagedFiles::default();
    files.stage(path, |out| out.write_all(contents.as_ref()))?;
    files.publish().map_err(|error| error.error)
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
