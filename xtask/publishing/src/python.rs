//! The Python package: its wheel, built and tested in a virtual environment.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use xtask::checkout;

/// Largest size of a wheel in bytes.
const LARGEST_WHEEL: u64 = 8_000_000;

/// Builds the wheel unless one is given, installs it with the dependencies of its tests, and runs them: tests and examples, notebooks,
/// and types by three checkers.
pub(crate) fn run(anew: bool, wheel: Option<&Path>) -> ExitCode {
    match carry_out(anew, wheel) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn carry_out(anew: bool, given: Option<&Path>) -> Result<(), String> {
    let root = &checkout("");
    // The tests run in another folder.
    let given = given.map(std::path::absolute).transpose().map_err(|error| error.to_string())?;
    let mut place = Place::new(root, anew)?;
    place.variables =
        vec![("TRUEAREA_PROGRAM", command_line(root)?), ("TRUEAREA_QUESTIONS", questions(root)?)];
    let wheel = match given {
        Some(wheel) => wheel.display().to_string(),
        None => place.wheel()?,
    };
    place.install(&wheel, "[tests,notebooks]")?;
    let config = place.package.join("pyproject.toml").display().to_string();
    let tests = place.package.join("tests").display().to_string();
    let pytest = ["--quiet", "--config-file", &config];
    place.run("pytest", &[&pytest[..], &[&tests]].concat())?;
    place.run("pytest", &[&pytest[..], &["--doctest-modules", "--pyargs", "truearea"]].concat())?;
    if !place.has_typed_numpy() {
        println!("types are not checked: numpy before 2.3 has none for masked arrays");
        return Ok(());
    }
    place.run("mypy", &["--strict", "--package", "truearea"])?;
    let allowed = place.package.join("stubtest-allowed.txt").display().to_string();
    place.run("stubtest", &["truearea", "--allowlist", &allowed, "--ignore-unused-allowlist"])?;
    let python = place.in_environment("python").display().to_string();
    place.run("pyright", &["--pythonpath", &python, "--project", &config])
}

/// Folder of the environment of a named interpreter, by its version.
fn environment_name(python: &OsStr) -> Result<String, String> {
    let script = "import platform; print(platform.python_version(), end='')";
    let output = Command::new(python).args(["-c", script]).output();
    let output = output.map_err(|error| format!("running {}: {error}", python.display()))?;
    Ok(format!("environment-{}", String::from_utf8_lossy(&output.stdout)))
}

/// Builds the command line of this checkout, whose digits the tests compare with.
fn command_line(root: &Path) -> Result<PathBuf, String> {
    // With the features that the whole workspace resolves to, as `cargo test --workspace` has built it.
    cargo(root, &["build", "--quiet", "--workspace", "--bin", "truearea"], "building the command line")?;
    Ok(root.join("target/debug/truearea").with_extension(std::env::consts::EXE_EXTENSION))
}

/// Lets the crates answer the random questions that the tests ask once more.
fn questions(root: &Path) -> Result<PathBuf, String> {
    cargo(root, &["test", "--quiet", "--workspace", "--test", "front_ends"], "answering random questions")?;
    Ok(root.join("target/tmp/questions.json"))
}

fn cargo(root: &Path, arguments: &[&str], doing: &str) -> Result<(), String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    match Command::new(cargo).args(arguments).current_dir(root).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{doing} has failed ({status})")),
        Err(error) => Err(format!("running cargo: {error}")),
    }
}

/// Folders of the package and of its environment.
pub(crate) struct Place {
    environment: String,
    package: PathBuf,
    built: PathBuf,
    /// Environment variables of every call: the command line and the answered questions that tests compare with.
    variables: Vec<(&'static str, PathBuf)>,
}

impl Place {
    /// Makes the virtual environment, unless it is there.
    pub(crate) fn new(root: &Path, anew: bool) -> Result<Self, String> {
        let python = std::env::var_os("PYTHON");
        let place = Place {
            environment: python.as_deref().map_or_else(|| Ok("environment".to_owned()), environment_name)?,
            package: root.join("python"),
            built: root.join("target/python"),
            variables: Vec::new(),
        };
        std::fs::create_dir_all(&place.built)
            .map_err(|error| format!("making {}: {error}", place.built.display()))?;
        if anew && place.environment().exists() {
            std::fs::remove_dir_all(place.environment())
                .map_err(|error| format!("removing the old environment: {error}"))?;
        }
        if !place.in_environment("python").exists() {
            let python = python.unwrap_or_else(|| "python3".into());
            place.call(&python, &["-m".as_ref(), "venv".as_ref(), place.environment().as_os_str()])?;
        }
        Ok(place)
    }

    /// Installs a wheel in place of an earlier one of the same version, with the dependencies of `extras`, as `[tests]`.
    pub(crate) fn install(&self, wheel: &str, extras: &str) -> Result<(), String> {
        self.python(&["-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", wheel])?;
        self.python(&["-m", "pip", "install", "--quiet", &format!("{wheel}{extras}")])
    }

    fn environment(&self) -> PathBuf {
        self.built.join(&self.environment)
    }

    pub(crate) fn in_environment(&self, program: &str) -> PathBuf {
        let programs = if cfg!(windows) { "Scripts" } else { "bin" };
        self.environment().join(programs).join(program)
    }

    /// Builds the wheel, and checks its size.
    pub(crate) fn wheel(&self) -> Result<String, String> {
        let wheels = self.built.join("wheels");
        if wheels.exists() {
            std::fs::remove_dir_all(&wheels).map_err(|error| format!("removing old wheels: {error}"))?;
        }
        let folder = wheels.display().to_string();
        let package = self.package.display().to_string();
        self.python(&["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", &folder, &package])?;
        let mut files = std::fs::read_dir(&wheels).map_err(|error| format!("reading {folder}: {error}"))?;
        let wheel = files.next().ok_or("no wheel was built")?.map_err(|error| error.to_string())?;
        let bytes = wheel.metadata().map_err(|error| error.to_string())?.len();
        let name = wheel.file_name().display().to_string();
        println!("{name}: {:.1} MB", bytes as f64 / 1e6);
        if bytes > LARGEST_WHEEL {
            return Err(format!("{name} has {bytes} bytes; a wheel may have {LARGEST_WHEEL}"));
        }
        Ok(wheel.path().display().to_string())
    }

    /// Returns true if the numpy of the environment has types for masked arrays. Python 3.10 has none that does.
    fn has_typed_numpy(&self) -> bool {
        let script = "import numpy; exit(tuple(map(int, numpy.__version__.split('.')[:2])) < (2, 3))";
        Command::new(self.in_environment("python"))
            .args(["-c", script])
            .status()
            .is_ok_and(|status| status.success())
    }

    pub(crate) fn python(&self, arguments: &[&str]) -> Result<(), String> {
        self.run("python", arguments)
    }

    /// Runs a program of the environment, away from the sources, so that the installed package is imported.
    fn run(&self, program: &str, arguments: &[&str]) -> Result<(), String> {
        let arguments: Vec<&OsStr> = arguments.iter().map(OsStr::new).collect();
        self.call(self.in_environment(program).as_os_str(), &arguments)
    }

    fn call(&self, program: &OsStr, arguments: &[&OsStr]) -> Result<(), String> {
        let typed =
            arguments.iter().map(|argument| argument.display().to_string()).collect::<Vec<_>>().join(" ");
        let name = Path::new(program).file_name().unwrap_or(program).display();
        println!("\n-- {name} {typed}");
        let status = Command::new(program)
            .args(arguments)
            .current_dir(&self.built)
            .env("CARGO_TARGET_DIR", &self.built)
            .envs(self.variables.iter().map(|(name, path)| (name, path)))
            .env("PIP_DISABLE_PIP_VERSION_CHECK", "1")
            .status()
            .map_err(|error| format!("running {}: {error}", program.display()))?;
        if status.success() { Ok(()) } else { Err(format!("{name} {typed} has failed ({status})")) }
    }
}
