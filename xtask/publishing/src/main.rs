//! Chores that make what is handed out, called by `cargo xtask`, which says what they do and keeps their dependencies out of
//! the first command on a new machine.

mod package;
mod pyodide;
mod python;
mod site;
mod web;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use lexopt::prelude::*;

enum Chore {
    Package,
    Site,
    Python { anew: bool, wheel: Option<PathBuf> },
    Pyodide,
    Web { tests: bool },
}

fn main() -> ExitCode {
    let chore = match parse(lexopt::Parser::from_env()) {
        Ok(chore) => chore,
        Err(error) => {
            eprintln!("error: {error}; cargo xtask --help lists the chores");
            return ExitCode::from(2);
        }
    };
    match chore {
        Chore::Package => package::run(),
        Chore::Site => site::run(),
        Chore::Python { anew, wheel } => python::run(anew, wheel.as_deref()),
        Chore::Pyodide => ended(pyodide::run()),
        Chore::Web { tests } => ended(web::run(tests)),
    }
}

fn parse(mut parser: lexopt::Parser) -> Result<Chore, lexopt::Error> {
    let mut chore = match parser.next()? {
        Some(Value(name)) => match name.to_str() {
            Some("package") => Chore::Package,
            Some("site") => Chore::Site,
            Some("python") => Chore::Python { anew: false, wheel: None },
            Some("pyodide") => Chore::Pyodide,
            Some("web") => Chore::Web { tests: false },
            _ => return Err(Value(name).unexpected()),
        },
        Some(option) => return Err(option.unexpected()),
        None => return Err("a chore is missing".into()),
    };
    while let Some(option) = parser.next()? {
        match (option, &mut chore) {
            (Long("anew"), Chore::Python { anew, .. }) => *anew = true,
            (Long("wheel"), Chore::Python { wheel, .. }) => *wheel = Some(parser.value()?.into()),
            (Long("test"), Chore::Web { tests }) => *tests = true,
            (option, _) => return Err(option.unexpected()),
        }
    }
    Ok(chore)
}

/// Says an error, and returns the status of a chore.
fn ended(result: Result<(), Box<dyn Error>>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
