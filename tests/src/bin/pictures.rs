//! Draws the pictures of `docs/` from the program's own laws, and writes the page of its status: `cargo xtask docs`.

use std::process::ExitCode;

use tests::pictures::{pictures, rewrite, stale};
use tests::status;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let check = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        _ => {
            eprintln!("usage: cargo xtask docs [--check]");
            return ExitCode::from(2);
        }
    };
    let status = match status::page() {
        Ok(page) => page,
        Err(error) => {
            eprintln!("error: reading the sources of the questions: {error}");
            return ExitCode::FAILURE;
        }
    };
    let is_status_current = std::fs::read_to_string(status::path()).is_ok_and(|page| page == status);
    if !is_status_current {
        println!("docs/develop/status.md differs from the program");
    }
    let stale = stale();
    for name in &stale {
        println!("docs/pictures/{name}.svg is not what the program draws");
    }
    match (stale.is_empty() && is_status_current, check) {
        (true, _) => println!("{} pictures and the status, as the program has them", pictures().len()),
        (false, true) => {
            println!("\ncargo xtask docs draws them anew");
            return ExitCode::FAILURE;
        }
        (false, false) => {
            let written = rewrite().and_then(|()| Ok(std::fs::write(status::path(), status)?));
            if let Err(error) = written {
                eprintln!("error: writing pictures and status: {error}");
                return ExitCode::FAILURE;
            }
            println!("drawn anew; a file that is not a picture of the program is for you to delete");
        }
    }
    ExitCode::SUCCESS
}
