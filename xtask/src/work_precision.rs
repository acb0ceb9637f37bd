//! Run time against error, compared with what users have today: `docs/develop/performance.md`.

use std::process::{Command, ExitCode};

use xtask::checkout;

/// Builds the study in release mode and runs it: it measures for some minutes and rewrites the page's tables and
/// plots.
pub(crate) fn run() -> ExitCode {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // The program as well, because its scaling is measured from outside.
    for arguments in [
        ["build", "--release", "--package", "truearea-cli"].as_slice(),
        ["run", "--release", "--package", "truearea-work-precision"].as_slice(),
    ] {
        match Command::new(&cargo).args(arguments).current_dir(checkout("")).status() {
            Ok(status) if status.success() => {}
            Ok(_) => return ExitCode::FAILURE,
            Err(error) => {
                eprintln!("error: cargo: {error}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}
