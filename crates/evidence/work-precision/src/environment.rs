//! Virtual environment with the competitors, below `target/`.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::machine::Fact;

/// Packages, installed one by one, so that one failure does not affect the others.
const PACKAGES: [&str; 3] = ["scipy", "ContactMechanics", "tamaas"];
/// Prints a line with name and version of Python and of each package that is installed.
const VERSIONS: &str = "
import importlib.metadata as found, platform
print('Python', platform.python_version())
for name in ('numpy', 'scipy', 'ContactMechanics', 'SurfaceTopography', 'tamaas'):
    try: print(name, found.version(name))
    except found.PackageNotFoundError: pass
";

/// Python with the packages that could be installed.
#[derive(Debug)]
pub struct Environment {
    python: PathBuf,
    /// Messages about packages that could not be installed.
    pub missing: Vec<String>,
}

impl Environment {
    /// Makes the environment in a folder, or completes an existing one: packages as pinned in `requirements.txt`.
    pub fn prepare(folder: &Path) -> Self {
        let python = folder.join("bin/python");
        if let Err(reason) = succeed(Command::new("python3").args(["-m", "venv"]).arg(folder)) {
            return Environment { python, missing: vec![reason] };
        }
        let mut environment = Environment { python, missing: Vec::new() };
        let pins = scripts().join("requirements.txt");
        for package in PACKAGES {
            let installed =
                environment.install(&[OsStr::new("--constraint"), pins.as_os_str(), OsStr::new(package)]);
            environment
                .missing
                .extend(installed.err().map(|reason| format!("{package} is missing: {reason}")));
        }
        environment
    }

    /// Installs a wheel in place of an earlier one, without its dependencies.
    ///
    /// # Errors
    /// The last line of the error messages, if that fails.
    pub fn install_wheel(&self, wheel: &Path) -> Result<(), String> {
        self.install(&[OsStr::new("--force-reinstall"), OsStr::new("--no-deps"), wheel.as_os_str()])
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
        let mut command = Command::new(&self.python);
        command.arg(scripts().join(script)).args(arguments).env("PYTHONDONTWRITEBYTECODE", "1");
        for threads in ["OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"] {
            command.env(threads, "1");
        }
        succeed(&mut command)
    }

    /// Versions of Python and of the packages.
    pub fn versions(&self) -> Vec<Fact> {
        let printed = succeed(Command::new(&self.python).args(["-c", VERSIONS])).unwrap_or_default();
        let pairs = printed.lines().filter_map(|line| line.split_once(' '));
        pairs.map(|(name, version)| (name.to_owned(), version.to_owned())).collect()
    }

    fn install(&self, arguments: &[&OsStr]) -> Result<(), String> {
        let mut pip = Command::new(&self.python);
        pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]);
        succeed(pip.args(arguments)).map(drop)
    }
}

/// Folder of the Python side.
fn scripts() -> PathBuf {
    crate::reference::repository("crates/evidence/work-precision/competitors")
}

/// Runs a command to its end and returns what it prints; the error is the last line of its error messages.
fn succeed(command: &mut Command) -> Result<String, String> {
    let program = Path::new(command.get_program()).file_name().unwrap_or_default().to_owned();
    let program = program.to_string_lossy();
    match command.output() {
        Ok(Output { status, stdout, .. }) if status.success() => {
            Ok(String::from_utf8_lossy(&stdout).into_owned())
        }
        Ok(Output { status, stderr, .. }) => {
            let messages = String::from_utf8_lossy(&stderr);
            let last = messages.lines().rfind(|line| !line.trim().is_empty()).unwrap_or_default();
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
