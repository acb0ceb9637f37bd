//! Project chores, by name: `cargo xtask reproduce`, `golden`, `docs`, `instructions`, `layers`, `shared`, `stress`,
//! `coverage`, `bench`, `judge`, `python`.

mod bench;
mod docs;
mod golden;
mod in_release;
mod instructions;
mod judge;
mod layers;
mod python;
mod reproduce;
mod shared;

use std::ffi::OsString;
use std::process::ExitCode;

use lexopt::prelude::*;

const HELP: &str = "\
cargo xtask reproduce          the paper's figures as tables and SVG, under target/reproduce
cargo xtask golden [--accept]  how far every golden curve has moved; --accept rewrites those that have
cargo xtask docs [--check]     draws the pictures of docs/; --check only tells which of the committed ones differ
cargo xtask instructions [--accept]
                               what the main kernels and the paper cost, against the accepted counts (needs valgrind);
                               --accept takes the counts as they are
cargo xtask layers             which crate may know which, and what stays out of the core
cargo xtask shared             the tests that need the folder shared/ beside the checkout
cargo xtask stress [--states N] [--seed S] [--threads T] [--only I]
                               random extreme states against what every result promises: docs/develop/stress.md
cargo xtask coverage [--studies N] [--scans N] [--draws N] [--hurst H] [--seed S] [--only bias|coverage|advice]
                               synthetic studies of known surfaces: do intervals of the area hold the truth as often as
                               they say? Prints the tables of docs/guide/uncertainty.md (minutes)
cargo xtask bench              run time against error, beside scipy and others; rewrites the tables of docs/develop/performance.md
cargo xtask judge [--anew]       every model held against boundary elements: rewrites the tables and figures of
                               docs/guide/which-model.md; presses what has not been pressed, --anew everything (minutes)
cargo xtask python [--anew]    builds the wheel and tries it in an environment below target/: tests, examples, notebooks, types
                               (minutes; needs python3 from 3.10 on and a package index); --anew makes the environment again
";

enum Task {
    Reproduce,
    Golden { accept: bool },
    Docs { check: bool },
    Instructions { accept: bool },
    Layers,
    Shared,
    Stress { arguments: Vec<OsString> },
    Coverage { arguments: Vec<OsString> },
    Bench,
    Judge { anew: bool },
    Python { anew: bool },
}

fn main() -> ExitCode {
    match parse() {
        Ok(Some(Task::Reproduce)) => reproduce::run(),
        Ok(Some(Task::Golden { accept })) => golden::run(accept),
        Ok(Some(Task::Docs { check })) => docs::run(check),
        Ok(Some(Task::Instructions { accept })) => instructions::run(accept),
        Ok(Some(Task::Layers)) => layers::run(),
        Ok(Some(Task::Shared)) => shared::run(),
        Ok(Some(Task::Stress { arguments })) => in_release::run("truearea-stress", &arguments),
        Ok(Some(Task::Coverage { arguments })) => in_release::run("truearea-coverage", &arguments),
        Ok(Some(Task::Bench)) => bench::run(),
        Ok(Some(Task::Judge { anew })) => judge::run(anew),
        Ok(Some(Task::Python { anew })) => python::run(anew),
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

fn parse() -> Result<Option<Task>, lexopt::Error> {
    let mut parser = lexopt::Parser::from_env();
    let mut task = None;
    while let Some(arg) = parser.next()? {
        match (arg, &mut task) {
            (Value(name), None) if name == "reproduce" => task = Some(Task::Reproduce),
            (Value(name), None) if name == "golden" => task = Some(Task::Golden { accept: false }),
            (Value(name), None) if name == "docs" => task = Some(Task::Docs { check: false }),
            (Value(name), None) if name == "instructions" => {
                task = Some(Task::Instructions { accept: false });
            }
            (Value(name), None) if name == "layers" => task = Some(Task::Layers),
            (Value(name), None) if name == "shared" => task = Some(Task::Shared),
            (Value(name), None) if name == "stress" => {
                let arguments = parser.raw_args()?.collect();
                task = Some(Task::Stress { arguments });
            }
            (Value(name), None) if name == "coverage" => {
                let arguments = parser.raw_args()?.collect();
                task = Some(Task::Coverage { arguments });
            }
            (Value(name), None) if name == "bench" => task = Some(Task::Bench),
            (Value(name), None) if name == "judge" => task = Some(Task::Judge { anew: false }),
            (Value(name), None) if name == "python" => task = Some(Task::Python { anew: false }),
            (Long("anew"), Some(Task::Judge { anew } | Task::Python { anew })) => *anew = true,
            (Long("check"), Some(Task::Docs { check })) => *check = true,
            (Long("accept"), Some(Task::Golden { accept } | Task::Instructions { accept })) => *accept = true,
            (Long("help") | Short('h'), _) => return Ok(None),
            (arg, _) => return Err(arg.unexpected()),
        }
    }
    Ok(task)
}
