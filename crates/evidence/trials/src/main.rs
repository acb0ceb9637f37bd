//! Runs trials and rewrites their tables of the documentation: `cargo xtask trials`.

mod compare;

use std::path::PathBuf;
use std::process::ExitCode;

use lexopt::prelude::*;
use trials::coverage::{CELLS, TAILS_HEADER, tails, tails_rows};
use uncertainty::UncertaintySettings;

const HELP: &str = "\
cargo xtask trials models|judge|layers|gaps|flatness|flow|flattening|yielding [--anew]
        compares with boundary elements and rewrites tables of docs; presses missing surfaces only, --anew all
cargo xtask trials scenes FOLDER [--program PATH] [--anew]
        compares reports of a program, truearea beside this one, on files of a folder with whole bands pressed at once
cargo xtask trials coverage [--studies N] [--draws N] [--seed S] [--cell N]... [--first N]
        runs N synthetic studies (400) in each of nine cells, with so many draws (1000), and prints how often intervals hold
        the truth; --cell N runs one cell (again for more), --first N begins with that study
";

type Outcome = Result<(), Box<dyn std::error::Error>>;

enum Trials {
    Compare { compare: fn(bool) -> Outcome, anew: bool },
    Scenes { folder: PathBuf, program: PathBuf, anew: bool },
    Coverage(Coverage),
}

struct Coverage {
    studies: u32,
    first: u32,
    seed: u64,
    draws: usize,
    cells: Vec<usize>,
}

fn main() -> ExitCode {
    let outcome = match parse() {
        Ok(Some(Trials::Compare { compare, anew })) => compare(anew),
        Ok(Some(Trials::Scenes { folder, program, anew })) => compare::scenes(&folder, &program, anew),
        Ok(Some(Trials::Coverage(coverage))) => count_held_truths(&coverage),
        Ok(None) => {
            print!("{HELP}");
            Ok(())
        }
        Err(error) => {
            eprint!("error: {error}\n\n{HELP}");
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

fn parse() -> Result<Option<Trials>, lexopt::Error> {
    let mut parser = lexopt::Parser::from_env();
    let mut trials = match parser.next()? {
        Some(Value(name)) => named(&name).ok_or_else(|| Value(name).unexpected())?,
        Some(Long("help") | Short('h')) => return Ok(None),
        Some(other) => return Err(other.unexpected()),
        None => return Err("name the trials".into()),
    };
    while let Some(argument) = parser.next()? {
        match (argument, &mut trials) {
            (Long("anew"), Trials::Compare { anew, .. } | Trials::Scenes { anew, .. }) => *anew = true,
            (Value(path), Trials::Scenes { folder, .. }) => *folder = path.into(),
            (Long("program"), Trials::Scenes { program, .. }) => *program = parser.value()?.into(),
            (Long("studies"), Trials::Coverage(coverage)) => coverage.studies = parser.value()?.parse()?,
            (Long("first"), Trials::Coverage(coverage)) => coverage.first = parser.value()?.parse()?,
            (Long("cell"), Trials::Coverage(coverage)) => coverage.cells.push(parser.value()?.parse()?),
            (Long("draws"), Trials::Coverage(coverage)) => coverage.draws = parser.value()?.parse()?,
            (Long("seed"), Trials::Coverage(coverage)) => coverage.seed = parser.value()?.parse()?,
            (Long("help") | Short('h'), _) => return Ok(None),
            (other, _) => return Err(other.unexpected()),
        }
    }
    Ok(Some(trials))
}

fn named(name: &std::ffi::OsStr) -> Option<Trials> {
    let comparison = |compare| Some(Trials::Compare { compare, anew: false });
    match name.to_str()? {
        "models" => comparison(compare::models),
        "judge" => comparison(compare::judge),
        "layers" => comparison(compare::layers),
        "gaps" => comparison(compare::gaps),
        "flatness" => comparison(compare::flatness),
        "flow" => comparison(compare::flow),
        "yielding" => comparison(compare::yielding),
        "flattening" => comparison(compare::flattening),
        "scenes" => Some(Trials::Scenes {
            folder: PathBuf::from("."),
            program: std::env::current_exe().ok()?.with_file_name("truearea"),
            anew: false,
        }),
        "coverage" => Some(Trials::Coverage(Coverage {
            studies: 400,
            first: 0,
            seed: 1,
            draws: 1000,
            cells: Vec::new(),
        })),
        _ => None,
    }
}

/// Runs the cells one after the other and prints each when it is done.
fn count_held_truths(coverage: &Coverage) -> Outcome {
    let settings = UncertaintySettings { draws: coverage.draws, ..UncertaintySettings::default() };
    println!("{TAILS_HEADER}");
    for (number, cell) in (1..).zip(&CELLS) {
        if coverage.cells.is_empty() || coverage.cells.contains(&number) {
            let trials = cell.trials(coverage.first, coverage.studies, coverage.seed, &settings)?;
            print!("{}", tails_rows(number, cell, &tails(&trials)));
        }
    }
    Ok(())
}
