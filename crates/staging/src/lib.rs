#![doc = include_str!("../README.md")]

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

/// A staged file that could not be put into its place.
#[derive(Debug, thiserror::Error)]
#[error("writing {}: {error}", path.display())]
pub struct PublishError {
    /// The place.
    pub path: PathBuf,
    /// Why.
    pub error: io::Error,
}

/// Files written aside, to be renamed into place together.
#[derive(Default)]
pub struct StagedFiles(Vec<(NamedTempFile, PathBuf)>);

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
        let folder =
            target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut aside = builder().tempfile_in(folder)?;
        let mut buffered = BufWriter::new(&mut aside);
        write(&mut buffered)?;
        buffered.flush()?;
        drop(buffered);
        self.0.push((aside, target));
        Ok(())
    }

    /// Renames every staged file into its place.
    ///
    /// # Errors
    /// [`PublishError`] for the first path that could not be replaced.
    pub fn publish(self) -> Result<(), PublishError> {
        for (aside, target) in self.0 {
            // Replacing a file does not make it readable to others.
            if let Ok(existing) = target.metadata() {
                let _ = aside.as_file().set_permissions(existing.permissions());
            }
            aside
                .persist(&target)
                .map_err(|error| PublishError { path: target.clone(), error: error.error })?;
        }
        Ok(())
    }
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

/// Temporary files are private by default; results get the permissions any new file gets.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}
