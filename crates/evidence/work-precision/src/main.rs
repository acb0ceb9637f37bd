//! Measures everything and rewrites `docs/develop/performance/` and the tables of `docs/develop/performance.md`: `cargo xtask work-precision`.
//!
//! With names of parts as arguments, `kernels` or `elements`, it measures these alone.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use tables::markdown::with_section;
use work_precision::bench::{Bench, Contents};
use work_precision::competitors::MissingPackage;
use work_precision::parts::{PARTS, Part};
use work_precision::point::{GivenQuantity, Outcome, Point};
use work_precision::reference::{self, repository};
use work_precision::sections::Measured;
use work_precision::verdicts::FOUR_LAWS;
use work_precision::{files, pictures, sections, stack, study};

/// Population whose states are plotted; the tables hold all.
const DRAWN: &str = "steel";

fn main() -> ExitCode {
    let parts = std::env::args().skip(1).map(|name| part(&name)).collect::<Result<Vec<&Part>, String>>();
    let (result, status) = match parts {
        Ok(parts) => (run(parts), ExitCode::FAILURE),
        Err(message) => (Err(message), ExitCode::from(2)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            status
        }
    }
}

/// Measures some parts; without any, the states and all parts.
fn run(parts: Vec<&Part>) -> Result<(), String> {
    println!("installing the competitors below target/");
    let mut bench = Bench::prepare();
    for MissingPackage { package, reason } in &bench.missing {
        println!("{package} is missing: {reason}");
    }
    if !parts.is_empty() {
        return parts.into_iter().try_for_each(|part| run_part(part, &mut bench));
    }
    run_states(&mut bench)?;
    for part in &PARTS {
        if let Err(reason) = run_part(part, &mut bench) {
            println!("not measured, so that its last contents stay: {reason}");
        }
    }
    Ok(())
}

fn part(name: &str) -> Result<&'static Part, String> {
    let names = PARTS.map(|part| part.name).join(", ");
    let unknown = || format!("there is no part '{name}'; choose some of {names}, or none for everything");
    PARTS.iter().find(|part| part.name == name).ok_or_else(unknown)
}

/// Measures a part, and rewrites its tables and files.
fn run_part(part: &Part, bench: &mut Bench) -> Result<(), String> {
    println!("\n{}", part.name);
    let Contents { sections, files } = (part.measure)(bench)?;
    for (name, text) in files {
        write(&folder().join(name), &text)?;
    }
    sections.iter().for_each(|(_, text)| println!("{text}"));
    write_sections(&page(), sections)
}

/// Measures statistical states and the stack, and rewrites their tables, files and plots.
fn run_states(bench: &mut Bench) -> Result<(), String> {
    let groups = reference::committed()?;
    let mut points = Vec::new();
    for group in &groups {
        println!("{}, {}", group.population, group.case.law());
        points.extend(study::points(group, bench.worker.as_mut(), &bench.missing));
    }
    gate(&points)?;
    let (facts, missing) = (bench.facts.clone(), bench.missing.clone());
    let measured = Measured { facts, missing, points, stack: stack::costs() };
    write_files(&folder(), &measured)?;
    println!("\n{}", sections::verdicts(&measured.points, &measured.stack));
    write_sections(&page(), sections::all(&measured))
}

fn page() -> PathBuf {
    repository("docs/develop/performance.md")
}

fn folder() -> PathBuf {
    repository("docs/develop/performance")
}

/// Checks all of our answers: times of wrong answers do not count.
fn gate(points: &[Point]) -> Result<(), String> {
    let wrong = |point: &&Point| {
        point.engine == point.engine.counterpart() && !matches!(point.outcome, Outcome::Right(_))
    };
    match points.iter().find(wrong) {
        Some(point) => Err(format!("a wrong answer of our own: {point:?}")),
        None => Ok(()),
    }
}

/// Writes a table for every law and question, a plot for the four laws, and the file of the stack.
fn write_files(folder: &Path, measured: &Measured) -> Result<(), String> {
    let Measured { facts, points, stack, .. } = measured;
    for law in sections::laws(points) {
        for given in GivenQuantity::ALL {
            let here: Vec<&Point> = points.iter().filter(|p| p.law == law && p.given == given).collect();
            let file = |extension: &str| folder.join(format!("{}.{extension}", files::stem(law, given)));
            write(&file("csv"), &files::points_csv(&here, facts))?;
            if FOUR_LAWS.contains(&law) {
                write(&file("svg"), &pictures::work_precision(&here, DRAWN, law, given, facts))?;
            }
        }
    }
    write(&folder.join("stack.csv"), &files::stack_csv(stack, facts))
}

/// Writes tables of the page, by name.
fn write_sections(
    path: &Path,
    sections: impl IntoIterator<Item = (&'static str, String)>,
) -> Result<(), String> {
    let mut page =
        std::fs::read_to_string(path).map_err(|error| format!("docs/develop/performance.md: {error}"))?;
    for (name, contents) in sections {
        page = with_section(&page, name, &contents)?;
    }
    write(path, &page)
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", path.display());
    path.parent().map_or(Ok(()), std::fs::create_dir_all).map_err(failed)?;
    std::fs::write(path, text).map_err(failed)
}
