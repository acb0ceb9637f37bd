//! Where input comes from and results go: standard streams, or files that appear whole or not at all.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::failure::Failure;
use crate::plan::PlanError;

/// A path, or `-` for stdin or stdout.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// stdin or stdout.
    Standard,
    /// A file.
    File(PathBuf),
}

impl From<&str> for Place {
    fn from(text: &str) -> Self {
        if text == "-" { Place::Standard } else { Place::File(PathBuf::from(text)) }
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Place::Standard => write!(f, "-"),
            Place::File(path) => write!(f, "{}", path.display()),
        }
    }
}

impl Place {
    /// All bytes that stand there.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the place.
    pub fn read(&self) -> Result<Vec<u8>, Failure> {
        let mut bytes = Vec::new();
        match self {
            Place::Standard => {
                io::Read::read_to_end(&mut io::stdin().lock(), &mut bytes)
                    .map_err(|error| Failure::reading("standard input", &error))?;
            }
            Place::File(path) => {
                bytes = std::fs::read(path)
                    .map_err(|error| Failure::reading(&path.display().to_string(), &error))?;
            }
        }
        Ok(bytes)
    }

    /// Writes there; a file is replaced only once `write` has succeeded.
    ///
    /// # Errors
    /// [`Failure::System`] that names the place; [`Failure::ClosedPipe`] where nobody reads stdout any more; what else
    /// stopped `write`.
    pub fn write<E: Into<Stopped>>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        match self {
            Place::Standard => {
                let mut stdout = BufWriter::new(io::stdout().lock());
                written(write, &mut stdout).map_err(|stopped| stopped.writing("standard output"))
            }
            Place::File(path) => {
                let mut files = StagedFiles::default();
                files.stage(path, write)?;
                files.publish()
            }
        }
    }
}

/// Why something was not written.
#[derive(Debug)]
pub enum Stopped {
    /// It could not be written.
    Writing(io::Error),
    /// There was nothing to write.
    Failed(Failure),
}

impl From<io::Error> for Stopped {
    fn from(error: io::Error) -> Self {
        Stopped::Writing(error)
    }
}

impl From<Failure> for Stopped {
    fn from(failure: Failure) -> Self {
        Stopped::Failed(failure)
    }
}

impl From<PlanError> for Stopped {
    fn from(error: PlanError) -> Self {
        Stopped::Failed(Failure::input(error))
    }
}

impl Stopped {
    fn writing(self, what: &str) -> Failure {
        match self {
            Stopped::Writing(error) => Failure::writing(what, &error),
            Stopped::Failed(failure) => failure,
        }
    }
}

fn written<E: Into<Stopped>>(
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    out: &mut impl Write,
) -> Result<(), Stopped> {
    write(out).map_err(Into::into)?;
    out.flush().map_err(Into::into)
}

/// What was read from `source` as text, without a byte-order mark; `what` it is meant to be.
///
/// # Errors
/// [`Failure::Input`] that names the first line that is not UTF-8.
pub fn utf8<'b>(bytes: &'b [u8], source: &str, what: &str) -> Result<&'b str, Failure> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
        Failure::Input(format!("{source}, line {line}: not UTF-8 text; save the {what} as UTF-8"))
    })?;
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

/// Files written aside, to be renamed into place together.
#[derive(Default)]
pub struct StagedFiles(Vec<(NamedTempFile, PathBuf)>);

impl StagedFiles {
    /// Writes one file aside, in the folder it is meant for.
    ///
    /// # Errors
    /// [`Failure::System`] that names the path, or what else stopped `write`. Nothing is left behind.
    pub fn stage<E: Into<Stopped>>(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        let failed = |error: io::Error| Failure::writing(&path.display().to_string(), &error);
        let stopped = |stopped: Stopped| stopped.writing(&path.display().to_string());
        // A device or a pipe cannot be replaced, and a link is to be followed.
        if path.metadata().is_ok_and(|existing| !existing.is_file()) {
            let mut file = BufWriter::new(std::fs::File::options().write(true).open(path).map_err(failed)?);
            return written(write, &mut file).map_err(stopped);
        }
        let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder =
            target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut aside = builder().tempfile_in(folder).map_err(failed)?;
        let mut buffered = BufWriter::new(&mut aside);
        written(write, &mut buffered).map_err(stopped)?;
        drop(buffered);
        self.0.push((aside, target));
        Ok(())
    }

    /// Renames every staged file into its place.
    ///
    /// # Errors
    /// [`Failure::System`] that names the first path that could not be replaced.
    pub fn publish(self) -> Result<(), Failure> {
        for (aside, target) in self.0 {
            // Replacing a file does not make it readable to others.
            if let Ok(existing) = target.metadata() {
                let _ = aside.as_file().set_permissions(existing.permissions());
            }
            aside
                .persist(&target)
                .map_err(|error| Failure::writing(&target.display().to_string(), &error.error))?;
        }
        Ok(())
    }
}

/// Temporary files are private by default; results get the permissions any new file gets.
fn builder() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.csv");
        std::fs::write(&path, "old").unwrap();
        let place = Place::File(path.clone());
        let failed = place.write(|out| {
            out.write_all(b"half")?;
            Err(io::Error::other("no more"))
        });
        assert!(matches!(failed, Err(Failure::System(message)) if message.ends_with("table.csv: no more")));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
        place.write(|out| out.write_all(b"new")).unwrap();
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "new");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_permissions_are_those_of_new_files() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (real, link) = (folder.path().join("real.csv"), folder.path().join("link.csv"));
        std::fs::write(&real, "old").unwrap();
        std::os::unix::fs::symlink(&real, &link).unwrap();
        Place::File(link.clone()).write(|out| out.write_all(b"new")).unwrap();
        assert_eq!(std::fs::read_to_string(&real).unwrap(), "new");
        assert!(link.is_symlink());
        let plain = folder.path().join("plain");
        std::fs::write(&plain, "").unwrap();
        let mode = |path: &Path| path.metadata().unwrap().permissions().mode();
        assert_eq!(mode(&real), mode(&plain));
    }
}
