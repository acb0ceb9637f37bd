//! Comparisons with boundary elements, which rewrite tables and figures of the guide: `cargo xtask model-trials`, `gap-trials`,
//! `judge-trials` and `layer-trials`.

mod compare_gaps;
mod compare_judge;
mod compare_layers;
mod compare_models;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: truearea-model-trials models|gap|judge|layers [--anew]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match arguments[..] {
        ["models"] => compare_models::compare(false),
        ["models", "--anew"] => compare_models::compare(true),
        ["gap"] => compare_gaps::compare(false),
        ["gap", "--anew"] => compare_gaps::compare(true),
        ["judge"] => compare_judge::compare(false),
        ["judge", "--anew"] => compare_judge::compare(true),
        ["layers"] => compare_layers::compare(false),
        ["layers", "--anew"] => compare_layers::compare(true),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Path of a file of the guide.
fn guide(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/guide").join(name)
}
