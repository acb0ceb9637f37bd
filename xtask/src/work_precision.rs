//! Run time against error, compared with what users have today: `docs/develop/performance.md`.

use std::ffi::OsString;
use std::process::ExitCode;

use crate::programs::{build_in_release, run_in_release};

/// Programs that are measured from outside: the command line, and those that the scripts of the study call.
const MEASURED: [&str; 2] = ["truearea-cli", "truearea-work-precision"];

/// Builds the study in release mode and runs it: it measures for some minutes and rewrites the page's tables and
/// plots; with names of parts, only theirs.
pub(crate) fn run(parts: &[OsString]) -> ExitCode {
    if MEASURED.iter().any(|package| build_in_release(package) != ExitCode::SUCCESS) {
        return ExitCode::FAILURE;
    }
    run_in_release("truearea-work-precision", parts)
}
