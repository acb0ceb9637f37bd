//! Random extreme states, by the crate of that name in its release profile: minutes of work are not for the dev profile.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

/// Hands everything on; what is not understood is refused there.
pub(crate) fn run(arguments: &[OsString]) -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--release", "--package", "stress", "--"])
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
