//! Run time against error, compared with what users have today: `docs/develop/performance.md`.

use std::ffi::OsString;
use std::process::{Command, ExitCode};

use xtask::checkout;

use crate::programs::run_in_release;

/// What is measured from outside, and is not built with the study: the program, and what the study's scripts call.
const MEASURED: [&str; 2] = ["truearea-cli", "truearea-work-precision"];

/// Builds the study in release mode and runs it: it measures for some minutes and rewrites the page's tables and
/// plots; with names of parts, only theirs.
pub(crate) fn run(parts: &[OsString]) -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    for package in MEASURED {
        let build = ["build", "--release", "--package", package];
        match Command::new(&cargo).args(build).current_dir(checkout("")).status() {
            Ok(status) if status.success() => {}
            Ok(_) => return ExitCode::FAILURE,
            Err(error) => {
                eprintln!("error: cargo: {error}");
                return ExitCode::FAILURE;
            }
        }
    }
    run_in_release("truearea-work-precision", parts)
}
