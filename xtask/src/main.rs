//! Project chores, by name: `cargo xtask reproduce`, `golden`, `docs`, `instructions`, `layers`, `shared`, `python`, `package`, `web`, and the
//! crates of evidence, `stress`, `coverage`, `work-precision` and `model-trials`.

mod docs;
mod gap_trials;
mod golden;
mod in_release;
mod instructions;
mod judge_trials;
mod layers;
mod model_trials;
mod package;
mod python;
mod reproduce;
mod shared;
mod site;
mod web;
mod work_precision;

use std::error::Error;
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
cargo xtask layers             checks which crate may use which, and what stays out of the core
cargo xtask shared             runs the tests that need the folder shared/ beside the checkout
cargo xtask python [--anew]    builds the wheel and tries it in an environment below target/: tests, examples, notebooks, types
                               (minutes; needs python3 from 3.10 on and a package index); --anew makes the environment again
cargo xtask package            packs the crates as they are published, compiles each archive, and runs the examples of their
                               READMEs in a project elsewhere (minutes)
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
cargo xtask work-precision     measures run time against error, beside scipy and others; rewrites the tables of
                               docs/develop/performance.md (minutes)
cargo xtask model-trials [--anew]
                               compares every model with boundary elements and rewrites the tables and figures of
                               docs/guide/which-model.md; presses new surfaces only, --anew all of them (minutes)
cargo xtask gap-trials [--anew]
                               compares mean gap and stiffness of Persson's theory with boundary elements and rewrites the table
                               of docs/guide/gap.md; presses new spectra only, --anew all of them (minutes)
cargo xtask judge-trials [--anew]
                               compares the judge of scenes with whole bands solved at once and rewrites the tables of
                               docs/guide/judge.md; presses new surfaces only, --anew all of them (an hour)
";

enum Task {
    Reproduce,
    Golden { accept: bool },
    Docs { check: bool },
    Instructions { accept: bool },
    Layers,
    Shared,
    Package,
    Site,
    Python { anew: bool },
    Web { tests: bool },
    Stress { arguments: Vec<OsString> },
    Coverage { arguments: Vec<OsString> },
    WorkPrecision,
    ModelTrials { anew: bool },
    GapTrials { anew: bool },
    JudgeTrials { anew: bool },
}

fn main() -> ExitCode {
    match parse(lexopt::Parser::from_env()) {
        Ok(Some(Task::Reproduce)) => reproduce::run(),
        Ok(Some(Task::Golden { accept })) => golden::run(accept),
        Ok(Some(Task::Docs { check })) => docs::run(check),
        Ok(Some(Task::Instructions { accept })) => instructions::run(accept),
        Ok(Some(Task::Layers)) => layers::run(),
        Ok(Some(Task::Shared)) => shared::run(),
        Ok(Some(Task::Package)) => package::run(),
        Ok(Some(Task::Site)) => site::run(),
        Ok(Some(Task::Python { anew })) => python::run(anew),
        Ok(Some(Task::Web { tests })) => ended(web::run(tests)),
        Ok(Some(Task::Stress { arguments })) => in_release::run("truearea-stress", &arguments),
        Ok(Some(Task::Coverage { arguments })) => in_release::run("truearea-coverage", &arguments),
        Ok(Some(Task::WorkPrecision)) => work_precision::run(),
        Ok(Some(Task::ModelTrials { anew })) => ended(model_trials::compare(anew)),
        Ok(Some(Task::GapTrials { anew })) => ended(gap_trials::compare(anew)),
        Ok(Some(Task::JudgeTrials { anew })) => ended(judge_trials::compare(anew)),
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

fn parse(mut parser: lexopt::Parser) -> Result<Option<Task>, lexopt::Error> {
    let mut task = None;
    while let Some(arg) = parser.next()? {
        match (arg, &mut task) {
            (Value(name), None) => {
                let named = match name.to_str() {
                    Some("reproduce") => Task::Reproduce,
                    Some("golden") => Task::Golden { accept: false },
                    Some("docs") => Task::Docs { check: false },
                    Some("instructions") => Task::Instructions { accept: false },
                    Some("layers") => Task::Layers,
                    Some("shared") => Task::Shared,
                    Some("package") => Task::Package,
                    Some("site") => Task::Site,
                    Some("python") => Task::Python { anew: false },
                    Some("web") => Task::Web { tests: false },
                    Some("stress") => Task::Stress { arguments: parser.raw_args()?.collect() },
                    Some("coverage") => Task::Coverage { arguments: parser.raw_args()?.collect() },
                    // The second names are those of earlier versions.
                    Some("work-precision" | "bench") => Task::WorkPrecision,
                    Some("model-trials" | "judge") => Task::ModelTrials { anew: false },
                    Some("gap-trials") => Task::GapTrials { anew: false },
                    Some("judge-trials") => Task::JudgeTrials { anew: false },
                    _ => return Err(Value(name).unexpected()),
                };
                task = Some(named);
            }
            (
                Long("anew"),
                Some(
                    Task::ModelTrials { anew }
                    | Task::GapTrials { anew }
                    | Task::JudgeTrials { anew }
                    | Task::Python { anew },
                ),
            ) => *anew = true,
            (Long("test"), Some(Task::Web { tests })) => *tests = true,
            (Long("check"), Some(Task::Docs { check })) => *check = true,
            (Long("accept"), Some(Task::Golden { accept } | Task::Instructions { accept })) => *accept = true,
            (Long("help") | Short('h'), _) => return Ok(None),
            (arg, _) => return Err(arg.unexpected()),
        }
    }
    Ok(task)
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
        assert!(matches!(parsed("bench"), Some(Task::WorkPrecision)));
        assert!(matches!(parsed("judge --anew"), Some(Task::ModelTrials { anew: true })));
        assert!(parsed("bench --anew").is_none() && parsed("judges").is_none());
    }
}
