//! Chores that are programs of other crates.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use xtask::checkout;

/// Runs a program in the profile and with the features of the tests, so that both share what they build. The program refuses
/// arguments that it does not know.
pub(crate) fn run(program: &str, arguments: &[OsString]) -> ExitCode {
    call(&["run", "--quiet", "--bin", program, "--"], arguments)
}

/// Runs a program with the features of its own crate alone, which builds less on a new checkout.
pub(crate) fn run_light(package: &str, program: &str, arguments: &[OsString]) -> ExitCode {
    call(&["run", "--quiet", "--package", package, "--bin", program, "--"], arguments)
}

/// Runs a chore of `xtask/publishing`, which is a workspace of its own.
pub(crate) fn publish(chore: &str, arguments: &[OsString]) -> ExitCode {
    let manifest = ["--manifest-path", "xtask/publishing/Cargo.toml", "--target-dir", "target/publishing"];
    let run = ["run", "--quiet", "--locked"].into_iter().chain(manifest).chain(["--", chore]);
    call(&run.collect::<Vec<_>>(), arguments)
}

/// Runs the program of a crate in release mode, for tasks of minutes and hours.
pub(crate) fn run_in_release(package: &str, arguments: &[OsString]) -> ExitCode {
    call(&["run", "--quiet", "--release", "--package", package, "--"], arguments)
}

fn call(cargo_arguments: &[&str], arguments: &[OsString]) -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    match Command::new(cargo).args(cargo_arguments).args(arguments).current_dir(checkout("")).status() {
        Ok(status) => ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)),
        Err(error) => {
            eprintln!("error: running cargo: {error}");
            ExitCode::FAILURE
        }
    }
}
