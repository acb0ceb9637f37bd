//! Shows how far the golden curves have moved from the accepted ones: `cargo xtask golden`.

use std::process::{Command, ExitCode};

use tests::golden::{
    GoldenCurve, TOLERANCE, curves, deviations, readme_picture_is_current, rewrite_readme_picture,
};
use tests::write_differences;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let accept = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--accept"] => true,
        _ => {
            eprintln!("usage: cargo xtask golden [--accept]");
            return ExitCode::from(2);
        }
    };
    let curves = curves();
    let mut unchanged = true;
    for curve in &curves {
        println!("{}", curve.name);
        unchanged &= show(curve);
    }
    if let Some(page) = write_differences(&curves) {
        println!("old and new are drawn over each other in {}", page.display());
    }
    let picture_is_current = readme_picture_is_current();
    if !picture_is_current {
        println!("the README's picture differs");
    }
    match (unchanged && picture_is_current, accept) {
        (true, _) => ExitCode::SUCCESS,
        (false, true) => rewrite(),
        (false, false) => {
            println!(
                "\nsome curves moved by more than {TOLERANCE:e}; cargo xtask golden --accept takes them as they are"
            );
            ExitCode::FAILURE
        }
    }
}

/// Prints the largest deviation of each line of a curve; returns true if all are within the tolerance.
fn show(curve: &GoldenCurve) -> bool {
    let Some(accepted) = curve.accepted() else {
        println!("  new");
        return false;
    };
    let Some(columns) = deviations(&accepted, &curve.text()) else {
        println!("  other curves or another number of points");
        return false;
    };
    for (name, deviation) in &columns {
        let verdict = if *deviation > TOLERANCE { "  CHANGED" } else { "" };
        println!("  {deviation:8.1e}  {name}{verdict}");
    }
    columns.iter().all(|(_, deviation)| *deviation <= TOLERANCE)
}

/// Lets the golden test write its curves, and draws the README's picture.
fn rewrite() -> ExitCode {
    rewrite_readme_picture();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["test", "--quiet", "--package", "tests", "--test", "all", "golden::"])
        .env("INSTA_UPDATE", "always")
        .status();
    match status {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: running cargo test: {error}");
            ExitCode::FAILURE
        }
    }
}
