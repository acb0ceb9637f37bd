//! Destinations of results, checked before anything is read or computed: no result replaces its own input.

use std::io;
use std::path::{Path, PathBuf};

use same_file::Handle;
use tables::staging::folder_of;

use crate::failure::Failure;
use crate::place::Place;

/// The files that a command is about to write.
#[derive(Debug)]
pub(crate) struct Targets(Vec<Target>);

/// A file that is about to be written.
#[derive(Debug)]
struct Target {
    /// The option that names it.
    option: &'static str,
    path: PathBuf,
    /// The file at the path now, if there is one.
    existing: Option<Handle>,
}

impl Targets {
    /// No files.
    pub const NONE: Self = Targets(Vec::new());

    /// The places that one option names.
    ///
    /// # Errors
    /// Errors of [`add`](Self::add).
    pub fn named(option: &'static str, places: impl IntoIterator<Item = Place>) -> Result<Self, Failure> {
        let mut targets = Self::NONE;
        targets.add(option, places).map(|()| targets)
    }

    /// The files that are about to be put in place, whatever named them.
    pub fn of<'p>(paths: impl Iterator<Item = &'p Path>) -> Self {
        let target =
            |path: &Path| Target { option: "the result", path: path.to_owned(), existing: file(path) };
        Targets(paths.map(target).collect())
    }

    /// Adds the places that an option names; standard output is a target where it is redirected into a file.
    ///
    /// # Errors
    /// [`Failure::Input`] where a folder stands there or another target is the same file; [`Failure::System`] where its
    /// folder is not there.
    pub fn add(
        &mut self,
        option: &'static str,
        places: impl IntoIterator<Item = Place>,
    ) -> Result<(), Failure> {
        for place in places {
            match place {
                Place::Standard => {
                    let existing = Handle::stdout().ok().filter(is_file);
                    self.0.push(Target { option, path: PathBuf::from("-"), existing });
                }
                Place::File(path) => self.add_file(option, path)?,
            }
        }
        Ok(())
    }

    fn add_file(&mut self, option: &'static str, path: PathBuf) -> Result<(), Failure> {
        if path.is_dir() {
            return Err(Failure::Input(format!(
                "{option} {}: this is a folder; name a file in it",
                path.display()
            )));
        }
        let folder = folder_of(&path);
        folder.metadata().map_err(|error| Failure::writing(&path.display().to_string(), &error))?;
        // A device or a pipe is written to, and any other target is replaced by a new file in its folder.
        let is_new_folder = self.0.last().is_none_or(|last| last.path.parent() != path.parent());
        if is_new_folder && (path.is_file() || !path.exists()) {
            check_writable(folder)?;
        }
        let existing = file(&path);
        let target = Target { option, path, existing };
        if let Some(other) = self.0.iter().find(|other| other.is(&target)) {
            return Err(Failure::Input(format!(
                "{} {} and {option} {} are the same file; name two",
                other.option,
                other.path.display(),
                target.path.display()
            )));
        }
        self.0.push(target);
        Ok(())
    }

    /// Refuses a file that is about to be read and that a target would replace.
    ///
    /// # Errors
    /// An error that names the option and its file.
    pub fn spare(&self, input: &Place) -> io::Result<()> {
        let input = match input {
            Place::Standard => Handle::stdin().ok().filter(is_file),
            Place::File(path) => file(path),
        };
        let replaces = |target: &&Target| input.is_some() && target.existing == input;
        match self.0.iter().find(replaces) {
            None => Ok(()),
            Some(target) => Err(io::Error::other(format!(
                "{} {} would replace it; choose another file for the result",
                target.option,
                target.path.display()
            ))),
        }
    }
}

impl Target {
    /// Returns true if both are the same file, which need not be there yet.
    fn is(&self, other: &Target) -> bool {
        match (&self.existing, &other.existing) {
            (Some(one), Some(other)) => one == other,
            (None, None) => {
                let named = |target: &Target| {
                    let absolute = std::path::absolute(&target.path).unwrap_or_else(|_| target.path.clone());
                    let folder = absolute.parent().and_then(|folder| folder.canonicalize().ok());
                    (folder, absolute.file_name().map(ToOwned::to_owned))
                };
                // A device has no file that could be replaced; two results may go to one.
                !self.path.exists() && named(self) == named(other)
            }
            _ => false,
        }
    }
}

/// Returns true for a stream that is redirected from or into a file.
fn is_file(handle: &Handle) -> bool {
    handle.as_file().metadata().is_ok_and(|found| found.is_file())
}

/// Refuses a folder that could not be made or written to, before anything is computed for it.
///
/// # Errors
/// [`Failure::System`] that names the folder.
pub fn check_writable(folder: &Path) -> Result<(), Failure> {
    let there = folder.ancestors().find(|ancestor| ancestor.exists() && !ancestor.as_os_str().is_empty());
    tempfile::tempfile_in(there.unwrap_or(Path::new(".")))
        .map(drop)
        .map_err(|error| Failure::writing(&folder.display().to_string(), &error))
}

/// Opens a handle of a file that is there; none for a device, a pipe, or nothing at all.
fn file(path: &Path) -> Option<Handle> {
    if path.is_file() { Handle::from_path(path).ok() } else { None }
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn with(mut targets: Targets, option: &'static str, path: &Path) -> Result<Targets, Failure> {
        targets.add(option, [Place::File(path.to_owned())]).map(|()| targets)
    }

    #[test]
    fn a_file_is_known_under_all_its_names() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        std::fs::write(path("data"), "").unwrap();
        std::fs::write(path("other"), "").unwrap();
        std::fs::hard_link(path("data"), path("hard")).unwrap();
        std::os::unix::fs::symlink(path("data"), path("soft")).unwrap();
        for name in ["data", "hard", "soft"] {
            let targets = with(Targets::NONE, "--output", &path(name)).unwrap();
            let refusal = targets.spare(&Place::File(path("data"))).unwrap_err().to_string();
            assert!(refusal.starts_with("--output ") && refusal.contains(" would replace it"), "{refusal}");
            targets.spare(&Place::File(path("other"))).unwrap();
            assert!(with(targets, "--figure", &path("data")).is_err());
        }
    }

    #[test]
    fn two_results_need_two_files_but_may_share_a_device() {
        let folder = tempfile::tempdir().unwrap();
        let new = with(Targets::NONE, "--output", &folder.path().join("new")).unwrap();
        assert!(with(new, "--figure", &folder.path().join("./new")).is_err());
        let device = with(Targets::NONE, "--output", Path::new("/dev/null")).unwrap();
        let two = with(device, "--figure", Path::new("/dev/null")).unwrap();
        two.spare(&Place::from("/dev/null")).unwrap();
    }
}
