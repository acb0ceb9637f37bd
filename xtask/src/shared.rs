//! Tests that need the folder of shared samples and references beside the checkout, and are ignored without it.

use std::process::{Command, ExitCode};

use xtask::checkout;

pub(crate) fn run() -> ExitCode {
    if !checkout("../shared").is_dir() {
        eprintln!("error: there is no folder shared/ beside the checkout");
        return ExitCode::FAILURE;
    }
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo).args(["test", "--workspace", "--tests", "--", "--ignored"]).status();
    match status {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: running cargo test: {error}");
            ExitCode::FAILURE
        }
    }
}
