//! Measures everything and rewrites `docs/develop/performance/` and the tables of `docs/develop/performance.md`: `cargo xtask work-precision`.
//!
//! With the argument `kernels`, in seconds, only the tables of single asperities.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use tables::markdown::with_section;
use work_precision::competitors::{Environment, MissingPackage, Worker};
use work_precision::machine::{self, Fact};
use work_precision::point::{GivenQuantity, Outcome, Point};
use work_precision::reference::{self, repository};
use work_precision::sections::Measured;
use work_precision::verdicts::FOUR_LAWS;
use work_precision::{files, kernels, pictures, scaling, sections, stack, study};

/// Population whose states are plotted; the tables hold all.
const DRAWN: &str = "steel";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let ran = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        [] => run(),
        ["kernels"] => run_kernels(),
        _ => Err(format!("unknown arguments {arguments:?}; give none, or kernels")),
    };
    match ran {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let groups = reference::committed()?;
    let (mut worker, missing, facts) = prepare();
    let mut points = Vec::new();
    for group in &groups {
        println!("{}, {}", group.population, group.case.law());
        points.extend(study::points(group, worker.as_mut(), &missing));
    }
    gate(&points)?;
    println!("single asperities, the stack, how the program grows");
    let kernels = kernels::costs(worker.as_mut())?;
    let stack = stack::costs();
    let scaling = scaling::measure(&repository("target/work-precision/tables"));
    let measured = Measured { facts, missing, points, kernels, stack, scaling };
    write_files(&repository("docs/develop/performance"), &measured)?;
    write_sections(&page(), sections::all(&measured))?;
    println!(
        "\n{}\n{}",
        sections::verdicts(&measured.points, &measured.stack),
        sections::kernel_verdicts(&measured.kernels)
    );
    Ok(())
}

/// Measures single asperities alone, and rewrites their file and tables.
fn run_kernels() -> Result<(), String> {
    let (mut worker, _, facts) = prepare();
    let kernels = kernels::costs(worker.as_mut())?;
    write(&repository("docs/develop/performance/kernels.csv"), &files::kernels_csv(&kernels, &facts))?;
    let (costs, verdicts) = (sections::kernel_costs(&kernels), sections::kernel_verdicts(&kernels));
    println!("\n{costs}\n{verdicts}");
    write_sections(&page(), [("kernels", costs), ("kernel-verdicts", verdicts)])
}

fn page() -> PathBuf {
    repository("docs/develop/performance.md")
}

/// Installs and starts the competitors, and lists machine and versions.
fn prepare() -> (Option<Worker>, Vec<MissingPackage>, Vec<Fact>) {
    println!("installing the competitors below target/");
    let environment = Environment::prepare(&repository("target/work-precision/venv"));
    let mut missing = environment.missing.clone();
    let worker = started(&environment, &mut missing);
    let mut facts = machine::facts();
    facts.extend(worker.iter().flat_map(|worker| worker.versions.clone()));
    (worker, missing, facts)
}

/// Starts the competitors' process, and reports the missing ones.
fn started(environment: &Environment, missing: &mut Vec<MissingPackage>) -> Option<Worker> {
    let worker = Worker::start(environment).map_err(|reason| {
        if missing.is_empty() {
            missing.push(MissingPackage { package: "Python".to_owned(), reason });
        }
    });
    let worker = worker.ok();
    missing.extend(worker.iter().flat_map(|worker| worker.missing.clone()));
    for MissingPackage { package, reason } in &*missing {
        println!("{package} is missing: {reason}");
    }
    worker
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

/// Writes a table for every law and question, a plot for the four laws, and the files of asperities, stack and
/// scaling.
fn write_files(folder: &Path, measured: &Measured) -> Result<(), String> {
    let Measured { facts, points, kernels, stack, scaling, .. } = measured;
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
    write(&folder.join("kernels.csv"), &files::kernels_csv(kernels, facts))?;
    write(&folder.join("stack.csv"), &files::stack_csv(stack, facts))?;
    if let Ok(scaling) = scaling {
        write(&folder.join("scaling.csv"), &files::scaling_csv(scaling, facts))?;
        write(&folder.join("scaling.svg"), &pictures::scaling(scaling, facts))?;
    }
    Ok(())
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
