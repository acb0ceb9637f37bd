//! Virtual environment with the competitors, below `target/`.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Packages, installed one by one, so that one failure does not affect the others.
const PACKAGES: [&str; 3] = ["scipy", "ContactMechanics", "tamaas"];

/// Competitor that is missing, and the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MissingPackage {
    /// Name of the package.
    pub package: String,
    /// Reason in one line.
    pub reason: String,
}

/// Python with the packages that could be installed.
#[derive(Debug)]
pub struct Environment {
    /// Path of the interpreter.
    pub python: PathBuf,
    /// Packages that could not be installed.
    pub missing: Vec<MissingPackage>,
}

impl Environment {
    /// Makes the environment in a folder, or completes an existing one: packages as pinned in `requirements.txt`.
    pub fn prepare(folder: &Path) -> Self {
        let python = folder.join("bin/python");
        if let Err(reason) = succeed(Command::new("python3").args(["-m", "venv"]).arg(folder)) {
            let nothing =
                |package: &&str| MissingPackage { package: (*package).to_owned(), reason: reason.clone() };
            return Environment { python, missing: PACKAGES.iter().map(nothing).collect() };
        }
        let constraints = scripts().join("requirements.txt");
        let missing = PACKAGES.iter().filter_map(|package| {
            let mut pip = Command::new(&python);
            pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--constraint"]);
            let reason = succeed(pip.arg(&constraints).arg(package)).err()?;
            Some(MissingPackage { package: (*package).to_owned(), reason })
        });
        let missing = missing.collect();
        Environment { python, missing }
    }

    /// Installs a wheel in place of an earlier one, without its dependencies.
    ///
    /// # Errors
    /// The last line of the error messages, if that fails.
    pub fn install_wheel(&self, wheel: &Path) -> Result<(), String> {
        let mut pip = Command::new(&self.python);
        pip.args([
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
            "--force-reinstall",
            "--no-deps",
        ]);
        succeed(pip.arg(wheel)).map(drop)
    }

    /// Runs a script of `competitors/` on one thread, and returns what it prints.
    ///
    /// # Errors
    /// The last line of its error messages, if it fails.
    pub fn output(
        &self,
        script: &str,
        arguments: impl IntoIterator<Item = impl AsRef<OsStr>>,
    ) -> Result<String, String> {
        let printed = succeed(self.command(script).args(arguments))?;
        Ok(String::from_utf8_lossy(&printed).into_owned())
    }

    /// A script of `competitors/`, to be run on one thread.
    pub(super) fn command(&self, script: &str) -> Command {
        let mut command = Command::new(&self.python);
        command.arg(scripts().join(script)).env("PYTHONDONTWRITEBYTECODE", "1");
        for threads in ["OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"] {
            command.env(threads, "1");
        }
        command
    }
}

/// Folder of the Python side.
fn scripts() -> PathBuf {
    crate::reference::repository("crates/evidence/work-precision/competitors")
}

/// Runs a command to its end and returns what it prints; the error is the last line of its error messages.
fn succeed(command: &mut Command) -> Result<Vec<u8>, String> {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default().to_owned();
    let program = program.to_string_lossy();
    match command.output() {
        Ok(Output { status, stdout, .. }) if status.success() => Ok(stdout),
        Ok(Output { status, stderr, .. }) => {
            let said = String::from_utf8_lossy(&stderr);
            let last = said.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
            Err(format!("{program}: {status}, {}", last.trim()))
        }
        Err(error) => Err(format!("{program}: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_reported_by_its_last_line() {
        let mut shell = Command::new("sh");
        let reason =
            succeed(shell.args(["-c", "echo first >&2; echo no such package >&2; exit 3"])).unwrap_err();
        assert!(reason.starts_with("sh: ") && reason.ends_with("no such package"), "{reason}");
        assert!(succeed(&mut Command::new("no-such-program")).is_err());
    }

    #[test]
    fn every_competitor_is_pinned() {
        let pins = std::fs::read_to_string(scripts().join("requirements.txt")).unwrap();
        for package in PACKAGES {
            assert!(pins.lines().any(|line| line.starts_with(&format!("{package}=="))), "{package}");
        }
    }
}
