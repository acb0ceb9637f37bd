//! Project chores, by name: `cargo xtask reproduce`, `golden`, `docs`, `instructions`, `layers`, `shared`, those of the crate
//! `publishing`, and the crates of evidence, `stress`, `trials`, `nature` and `work-precision`.

mod budgets;
mod files;
mod instructions;
mod layers;
mod programs;
mod shared;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use lexopt::prelude::*;

const HELP: &str = "\
cargo xtask reproduce          writes the paper's figures as tables and SVG, under target/reproduce
cargo xtask golden [--accept]  shows how far each golden curve has moved; --accept rewrites those that have
cargo xtask docs [--check]     draws the pictures of docs/ and writes docs/develop/status.md; --check lists those that differ
cargo xtask instructions [--accept]
                               counts instructions of the main kernels and the paper against the accepted counts (needs
                               valgrind); --accept takes the new counts
cargo xtask layers             checks which crate may use which, what stays out of the core, and budgets of lines and words
cargo xtask files --data FOLDER
                               reads the files of instruments in a folder, of packages on PyPI, and compares them with what other readers
                               found: docs/develop/compared_files.csv
cargo xtask shared             runs the tests that need the folder shared/ beside the checkout
cargo xtask python [--anew] [--wheel FILE]
                               builds the wheel and tries it in an environment below target/: tests, examples, notebooks, types
                               (minutes; needs python3 from 3.10 on and a package index); --anew makes the environment again;
                               --wheel tries a wheel or a source archive; the variable PYTHON names another interpreter
cargo xtask pyodide            builds the wheel for Pyodide, target/pyodide, and compares its answers under node with those of this
                               machine (minutes; needs node, python3, a package index, and the target wasm32-unknown-emscripten)
cargo xtask package            packs the crates as they are published, compiles each archive, and runs the examples of their
                               READMEs in a project elsewhere (minutes)
cargo xtask site               builds the documentation with search and references as a site, target/site, and checks its links
                               (needs mdbook and python3); takes the page for browsers from target/web
cargo xtask web [--test]       builds the page for browsers as a static folder, target/web (minutes); --test runs its tests in
                               Chromium (needs node)

Crates of evidence:
cargo xtask stress [--states N] [--seed S] [--threads T] [--only I]
                               holds random extreme states against the promises of every result: docs/develop/stress.md
cargo xtask trials models|judge|layers|gaps|flatness|flow|flattening|yielding [--anew]
                               compares models, the judge, and what theory says of each with boundary elements, and rewrites
                               their tables in docs; presses missing surfaces only, --anew all of them (an hour)
cargo xtask trials scenes FOLDER [--program PATH] [--anew]
                               compares reports on the files of a folder with whole bands pressed at once (minutes)
cargo xtask trials coverage [--studies N] [--draws N] [--seed S] [--cell N]... [--first N]
                               counts how often intervals of the area hold the truth, in studies of known surfaces (minutes)
cargo xtask nature --data FOLDER [--out FOLDER]
                               predicts measured contacts, rock joints and thermal resistances, and rewrites docs/guide/nature.md (minutes);
                               with --out writes the tables there, prints those of the page, and leaves docs alone
cargo xtask work-precision [PART]...
                               measures run time and error beside scipy and others, and rewrites the tables of
                               docs/develop/performance.md (minutes); with names such as laws or elements only theirs
";

enum Task {
    /// Comparison of the files in a folder.
    Files {
        data: Option<PathBuf>,
    },
    /// Program of another crate, and what it is called with.
    Program {
        name: &'static str,
        arguments: Vec<OsString>,
    },
    /// Chore of `publishing`, and what follows its name.
    Publishing {
        chore: String,
        arguments: Vec<OsString>,
    },
    Reproduce {
        arguments: Vec<OsString>,
    },
    Trials {
        arguments: Vec<OsString>,
    },
    /// Program of a crate of evidence, for long tasks.
    InRelease {
        package: &'static str,
        arguments: Vec<OsString>,
    },
    Instructions {
        accept: bool,
    },
    Layers,
    Shared,
}

fn main() -> ExitCode {
    match parse(lexopt::Parser::from_env()) {
        Ok(Some(Task::Program { name, arguments })) => programs::run(name, &arguments),
        Ok(Some(Task::Publishing { chore, arguments })) => programs::publish(&chore, &arguments),
        Ok(Some(Task::Reproduce { arguments })) => {
            programs::run_light("truearea-paper", "reproduce", &arguments)
        }
        Ok(Some(Task::Trials { arguments })) => {
            let compared = programs::run("truearea-trials", &arguments);
            // The page on models has a table of the paper's surface as well.
            let has_models = arguments.first().is_some_and(|name| name == "models");
            if has_models && compared == ExitCode::SUCCESS {
                programs::run("other_models", &[])
            } else {
                compared
            }
        }
        Ok(Some(Task::InRelease { package, arguments })) => programs::run_in_release(package, &arguments),
        Ok(Some(Task::Instructions { accept })) => instructions::run(accept),
        Ok(Some(Task::Layers)) => layers::run(),
        Ok(Some(Task::Shared)) => shared::run(),
        Ok(Some(Task::Files { data })) => match data {
            Some(folder) => files::run(&folder),
            None => {
                eprintln!("error: say where the files are: cargo xtask files --data FOLDER");
                ExitCode::from(2)
            }
        },
        Ok(None) => {
            print!("{HELP}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprint!("error: {error}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

fn parse(mut parser: lexopt::Parser) -> Result<Option<Task>, lexopt::Error> {
    let mut task = None;
    while let Some(arg) = parser.next()? {
        match (arg, &mut task) {
            (Value(name), None) => {
                let named = match name.to_str() {
                    Some("reproduce") => Task::Reproduce { arguments: following(&mut parser)? },
                    Some("golden") => program("golden", &mut parser)?,
                    Some("docs") => program("pictures", &mut parser)?,
                    Some("instructions") => Task::Instructions { accept: false },
                    Some("layers") => Task::Layers,
                    Some("shared") => Task::Shared,
                    Some("files") => Task::Files { data: None },
                    Some(chore @ ("package" | "site" | "python" | "pyodide" | "web")) => {
                        Task::Publishing { chore: chore.to_owned(), arguments: following(&mut parser)? }
                    }
                    Some("stress") => in_release("truearea-stress", &mut parser)?,
                    Some("trials") => Task::Trials { arguments: following(&mut parser)? },
                    Some("work-precision") => in_release("truearea-work-precision", &mut parser)?,
                    Some("nature") => program("truearea-nature", &mut parser)?,
                    _ => return Err(Value(name).unexpected()),
                };
                task = Some(named);
            }
            (Long("data"), Some(Task::Files { data })) => *data = Some(parser.value()?.into()),
            (Long("accept"), Some(Task::Instructions { accept })) => *accept = true,
            (Long("help") | Short('h'), _) => return Ok(None),
            (arg, _) => return Err(arg.unexpected()),
        }
    }
    Ok(task)
}

fn program(name: &'static str, rest: &mut lexopt::Parser) -> Result<Task, lexopt::Error> {
    Ok(Task::Program { name, arguments: following(rest)? })
}

fn in_release(package: &'static str, rest: &mut lexopt::Parser) -> Result<Task, lexopt::Error> {
    Ok(Task::InRelease { package, arguments: following(rest)? })
}

/// The rest of the line.
fn following(rest: &mut lexopt::Parser) -> Result<Vec<OsString>, lexopt::Error> {
    Ok(rest.raw_args()?.collect())
}
