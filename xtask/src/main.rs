//! Project chores, by name: `cargo xtask reproduce`, `golden`, `docs`, `instructions`, `layers`, `shared`, those of the crate
//! `publishing`, and the crates of evidence, `stress`, `coverage`, `work-precision` and `model-trials`.

mod budgets;
mod instructions;
mod layers;
mod programs;
mod shared;
mod work_precision;

use std::ffi::OsString;
use std::process::ExitCode;

use lexopt::prelude::*;

const HELP: &str = "\
cargo xtask reproduce          writes the paper's figures as tables and SVG, under target/reproduce
cargo xtask golden [--accept]  shows how far each golden curve has moved; --accept rewrites those that have
cargo xtask docs [--check]     draws the pictures of docs/; --check lists the committed ones that differ
cargo xtask instructions [--accept]
                               counts instructions of the main kernels and the paper against the accepted counts (needs
                               valgrind); --accept takes the new counts
cargo xtask layers             checks which crate may use which, what stays out of the core, and budgets of lines and words
cargo xtask shared             runs the tests that need the folder shared/ beside the checkout
cargo xtask python [--anew] [--wheel FILE]
                               builds the wheel and tries it in an environment below target/: tests, examples, notebooks, types
                               (minutes; needs python3 from 3.10 on and a package index); --anew makes the environment again;
                               --wheel tries a wheel or a source archive; the variable PYTHON names another interpreter
cargo xtask pyodide            builds the wheel for Pyodide, target/pyodide, and compares its answers under node with those of this
                               machine (minutes; needs node, python3, a package index, and the target wasm32-unknown-emscripten)
cargo xtask package            packs the crates as they are published, compiles each archive, and runs the examples of their
                               READMEs in a project elsewhere (minutes)
cargo xtask api [--accept]     compares the public items of the published crates with tests/contract/public-api; --accept takes
                               them as they are (minutes)
cargo xtask site               builds the documentation with search and references as a site, target/site, and checks its links
                               (needs mdbook and python3); takes the page for browsers from target/web
cargo xtask web [--test]       builds the page for browsers as a static folder, target/web (minutes); --test runs its tests in
                               Chromium (needs node)

Crates of evidence:
cargo xtask stress [--states N] [--seed S] [--threads T] [--only I]
                               holds random extreme states against the promises of every result: docs/develop/stress.md
cargo xtask coverage [--studies N] [--scans N] [--draws N] [--hurst H] [--seed S] [--only bias|coverage|advice|forms|seeds]
                               counts how often intervals of the area hold the truth, in studies of known surfaces, and
                               prints the tables of docs/guide/uncertainty.md (minutes)
cargo xtask work-precision [PART]...
                               measures run time against error, beside scipy and others; rewrites the tables of
                               docs/develop/performance.md (minutes); with names such as kernels or elements only theirs
cargo xtask model-trials [--anew]
                               compares every model with boundary elements and rewrites the tables and figures of
                               docs/guide/which-model.md; presses new surfaces only, --anew all of them (minutes)
cargo xtask gap-trials [--anew]
                               compares mean gap and stiffness of Persson's theory with boundary elements and rewrites the table
                               of docs/guide/gap.md; presses new spectra only, --anew all of them (minutes)
cargo xtask judge-trials [--anew]
                               compares the judge of scenes with whole bands solved at once and rewrites the tables of
                               docs/guide/judge.md; presses new surfaces only, --anew all of them (an hour)
cargo xtask layer-trials [--anew]
                               compares the judge on layers with whole bands solved at once and rewrites a table of
                               docs/guide/judge.md; presses new surfaces only, --anew all of them (an hour)
";

/// Program that compares with boundary elements, and rewrites tables of pages.
const TRIALS: &str = "truearea-model-trials";

enum Task {
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
    ModelTrials {
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
    WorkPrecision {
        parts: Vec<OsString>,
    },
}

fn main() -> ExitCode {
    match parse(lexopt::Parser::from_env()) {
        Ok(Some(Task::Program { name, arguments })) => programs::run(name, &arguments),
        Ok(Some(Task::Publishing { chore, arguments })) => programs::publish(&chore, &arguments),
        Ok(Some(Task::Reproduce { arguments })) => {
            programs::run_light("truearea-paper", "reproduce", &arguments)
        }
        Ok(Some(Task::ModelTrials { arguments })) => {
            // The page has a table of the paper's surface as well.
            let compared = programs::run(TRIALS, &arguments);
            if compared == ExitCode::SUCCESS { programs::run("other_models", &[]) } else { compared }
        }
        Ok(Some(Task::InRelease { package, arguments })) => programs::run_in_release(package, &arguments),
        Ok(Some(Task::Instructions { accept })) => instructions::run(accept),
        Ok(Some(Task::Layers)) => layers::run(),
        Ok(Some(Task::Shared)) => shared::run(),
        Ok(Some(Task::WorkPrecision { parts })) => work_precision::run(&parts),
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
                    Some("reproduce") => Task::Reproduce { arguments: following(&[], &mut parser)? },
                    Some("golden") => program("golden", &[], &mut parser)?,
                    Some("docs") => program("pictures", &[], &mut parser)?,
                    Some("instructions") => Task::Instructions { accept: false },
                    Some("layers") => Task::Layers,
                    Some("shared") => Task::Shared,
                    Some(chore @ ("package" | "api" | "site" | "python" | "pyodide" | "web")) => {
                        Task::Publishing { chore: chore.to_owned(), arguments: following(&[], &mut parser)? }
                    }
                    Some("stress") => in_release("truearea-stress", &mut parser)?,
                    Some("coverage") => in_release("truearea-coverage", &mut parser)?,
                    // The second names are those of earlier versions.
                    Some("work-precision" | "bench") => {
                        Task::WorkPrecision { parts: following(&[], &mut parser)? }
                    }
                    Some("model-trials" | "judge") => {
                        Task::ModelTrials { arguments: following(&["models"], &mut parser)? }
                    }
                    Some("gap-trials") => program(TRIALS, &["gap"], &mut parser)?,
                    Some("judge-trials") => program(TRIALS, &["judge"], &mut parser)?,
                    Some("layer-trials") => program(TRIALS, &["layers"], &mut parser)?,
                    _ => return Err(Value(name).unexpected()),
                };
                task = Some(named);
            }
            (Long("accept"), Some(Task::Instructions { accept })) => *accept = true,
            (Long("help") | Short('h'), _) => return Ok(None),
            (arg, _) => return Err(arg.unexpected()),
        }
    }
    Ok(task)
}

/// Program that gets `first` and the rest of the line.
fn program(name: &'static str, first: &[&str], rest: &mut lexopt::Parser) -> Result<Task, lexopt::Error> {
    Ok(Task::Program { name, arguments: following(first, rest)? })
}

fn following(first: &[&str], rest: &mut lexopt::Parser) -> Result<Vec<OsString>, lexopt::Error> {
    Ok(first.iter().map(OsString::from).chain(rest.raw_args()?).collect())
}

fn in_release(package: &'static str, rest: &mut lexopt::Parser) -> Result<Task, lexopt::Error> {
    Ok(Task::InRelease { package, arguments: rest.raw_args()?.collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(line: &str) -> Option<Task> {
        let words = std::iter::once("xtask").chain(line.split_whitespace());
        parse(lexopt::Parser::from_iter(words)).unwrap_or(None)
    }

    #[test]
    fn the_names_of_earlier_versions_call_the_same_tasks() {
        let Some(Task::WorkPrecision { parts }) = parsed("bench elements") else { panic!() };
        assert_eq!(parts, ["elements"]);
        let Some(Task::ModelTrials { arguments }) = parsed("judge --anew") else { panic!() };
        assert_eq!(arguments, ["models", "--anew"]);
        assert!(parsed("layers --anew").is_none() && parsed("judges").is_none());
    }
}
