//! Measures run time and error, and rewrites the tables of `docs/develop/performance.md`: `cargo xtask work-precision`.
//!
//! With names of parts as arguments, such as `laws` or `elements`, it measures these alone. The scripts of the competitors call
//! it with `press` and `scan`.

use std::error::Error;
use std::process::ExitCode;

use tables::markdown::with_section;
use work_precision::environment::Environment;
use work_precision::machine::{Fact, facts};
use work_precision::map_programs;
use work_precision::part::{PARTS, Part};
use work_precision::reference::repository;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.split_first() {
        Some((name, rest)) if name == "press" => map_programs::press(rest),
        Some((name, rest)) if name == "scan" => map_programs::scan(rest),
        _ => measure(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Measures some parts; without names, all of them.
fn measure(names: &[String]) -> Result<(), Box<dyn Error>> {
    let named = names.iter().map(|name| part(name)).collect::<Result<Vec<&Part>, String>>()?;
    println!("installing the competitors below target/");
    let environment = Environment::prepare(&repository("target/work-precision/venv"));
    environment.missing.iter().for_each(|missing| println!("{missing}"));
    let mut facts = facts();
    facts.extend(environment.versions());
    if named.is_empty() {
        for part in &PARTS {
            if let Err(reason) = run(part, &environment, &facts) {
                println!("{} is not measured and keeps its last contents: {reason}", part.name);
            }
        }
    }
    named.into_iter().try_for_each(|part| run(part, &environment, &facts))
}

fn part(name: &str) -> Result<&'static Part, String> {
    let names = PARTS.map(|part| part.name).join(", ");
    let unknown = || format!("'{name}' is not a part; choose some of {names}, or none for everything");
    PARTS.iter().find(|part| part.name == name).ok_or_else(unknown)
}

/// Measures a part, and rewrites its section and its file.
fn run(part: &Part, environment: &Environment, facts: &[Fact]) -> Result<(), Box<dyn Error>> {
    println!("\n{}", part.name);
    let csv = (part.measure)(environment)?;
    let comments: String = facts.iter().map(|(name, value)| format!("# {name}: {value}\n")).collect();
    let file = repository("docs/develop/performance").join(format!("{}.csv", part.name));
    std::fs::write(file, comments + &csv)?;
    let table = (part.table)(&csv)?;
    println!("{table}");
    let path = repository("docs/develop/performance.md");
    let page = with_section(&std::fs::read_to_string(&path)?, part.name, &table)?;
    Ok(std::fs::write(path, page)?)
}
