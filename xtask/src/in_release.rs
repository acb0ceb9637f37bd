//! Tasks of minutes, by crates of their own in their release profile: such work is not for the dev profile.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

/// Hands everything on to the program of a crate; what is not understood is refused there.
pub(crate) fn run(package: &str, arguments: &[OsString]) -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--release", "--package", package, "--"])
        .args(arguments)
        .status();
    match status {
        Ok(status) => ExitCode::from(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)),
        Err(error) => {
            eprintln!("error: running cargo: {error}");
            ExitCode::FAILURE
        }
    }
}
