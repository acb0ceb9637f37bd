//! Sources of input and destinations of results: standard streams, or files that appear whole or not at all.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use tables::staging::{NewFolder, StagedFiles};

use crate::failure::Failure;
use crate::inputs::{bytes_at, spare_inputs};
use crate::interruption;
use crate::place::Place;
use crate::stderr::say;
use crate::targets::Targets;
use crate::terminal::standard_output;

impl Place {
    /// All bytes that stand there.
    ///
    /// # Errors
    /// [`Failure::Input`] that names the place.
    pub fn read(&self) -> Result<Vec<u8>, Failure> {
        match self {
            Place::File(path) if path.is_dir() => {
                let (folder, scene) = (path.display(), path.join("scene.toml"));
                if scene.is_file() {
                    let message =
                        format!("{folder}: this is a folder; name the scene in it, {}", scene.display());
                    return Err(Failure::Input(message));
                }
                Err(Failure::Input(format!(
                    "{folder}: this is a folder; name a scene in it, or try `truearea report {folder}`"
                )))
            }
            place => bytes_at(place).map_err(|error| Failure::reading(&place.name(), &error)),
        }
    }

    /// Writes there; a file is replaced only once `write` has succeeded.
    ///
    /// # Errors
    /// Errors of [`stage`](Self::stage) and [`publish`].
    pub fn write<E: Into<Stopped>>(
        &self,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        let mut files = StagedFiles::default();
        self.stage(&mut files, write)?;
        publish(files)
    }

    /// Writes a file aside, to be published with others; standard output gets it at once.
    ///
    /// # Errors
    /// [`Failure::System`] that names the place; [`Failure::ClosedPipe`] where nobody reads stdout any more; what else
    /// stopped `write`.
    pub fn stage<E: Into<Stopped>>(
        &self,
        files: &mut StagedFiles,
        write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
    ) -> Result<(), Failure> {
        match self {
            Place::Standard => {
                spare_inputs(&Targets::named("--output", [Place::Standard])?)?;
                let mut stdout = BufWriter::new(standard_output());
                let written = write(&mut stdout).map_err(Into::into).and_then(|()| Ok(stdout.flush()?));
                written.map_err(|stopped: Stopped| stopped.writing("standard output"))
            }
            Place::File(path) => stage(files, path, write),
        }
    }
}

/// Puts every staged file into its place, or none where one would replace an input.
///
/// # Errors
/// [`Failure::Input`] that names that input; errors of [`publish_over_input`].
pub fn publish(files: StagedFiles) -> Result<(), Failure> {
    spare_inputs(&Targets::of(files.targets().map(|(target, _)| target)))?;
    publish_over_input(files)
}

/// Puts every staged file into its place, or none; one may replace the table that it extends.
///
/// # Errors
/// [`Failure::System`] that names the path; [`Failure::Interrupted`] where the program has been asked to end.
pub fn publish_over_input(files: StagedFiles) -> Result<(), Failure> {
    if interruption::is_asked_for() {
        return Err(Failure::Interrupted);
    }
    for folder in files.publish()?.unfinished {
        say(&format!(
            "note: {}: an earlier run was killed while it replaced files here; those that this run has not written may be of \
             another run",
            folder.display()
        ));
    }
    Ok(())
}

/// Reason that something was not written.
#[derive(Debug)]
pub enum Stopped {
    /// The output could not be written.
    Writing(io::Error),
    /// The command failed, so that there was nothing to write.
    Failed(Failure),
}

impl From<io::Error> for Stopped {
    fn from(error: io::Error) -> Self {
        Stopped::Writing(error)
    }
}

impl<E: Into<Failure>> From<E> for Stopped {
    fn from(error: E) -> Self {
        Stopped::Failed(error.into())
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

/// Writes one file aside; a failure names it.
pub(crate) fn stage<E: Into<Stopped>>(
    files: &mut StagedFiles,
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), Failure> {
    files
        .stage(path, |out| write(out).map_err(Into::<Stopped>::into))
        .map_err(|stopped| stopped.writing(&path.display().to_string()))
}

/// Returns the bytes read from `source` as text, without a byte-order mark; `what` names the expected content.
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

/// Makes the folder that `option` names, where there is none.
///
/// # Errors
/// Errors of [`new_folder`].
pub fn make_folder(option: &str, folder: &Path) -> Result<(), Failure> {
    new_folder(option, folder).map(|made| made.map(NewFolder::keep).unwrap_or_default())
}

/// Makes the folder that `option` names, where there is none; it goes again where nothing comes to lie in it.
///
/// # Errors
/// [`Failure::Input`] where a file has its name; [`Failure::System`] that names the folder.
pub fn new_folder(option: &str, folder: &Path) -> Result<Option<NewFolder>, Failure> {
    if folder.is_file() {
        return Err(Failure::Input(format!(
            "{option} {}: results go into a folder, and this is a file; name a folder",
            folder.display()
        )));
    }
    NewFolder::make(folder).map_err(|error| Failure::writing(&folder.display().to_string(), &error))
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
