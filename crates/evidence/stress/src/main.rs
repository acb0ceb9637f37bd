//! `cargo xtask stress`: draws states, reports broken promises, and ends with 1 if there are any.

use std::io::IsTerminal;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lexopt::prelude::*;
use stress::{Group, Scope};

const HELP: &str = "\
cargo xtask stress [--states N] [--seed S] [--threads T] [--only I] [--law NAME | --group NAME]

N states of the statistical model (10 million), and of all other groups in proportion, drawn from the seed S (1), on T
threads (all); the result does not depend on T. --only repeats the state number I alone, --law those of one law, --group
N states of one group, both by their names in the report. Written to target/stress/report.txt and report.csv.
";

struct Arguments {
    states: std::ops::Range<u64>,
    seed: u64,
    threads: usize,
    scope: Scope,
}

fn main() -> ExitCode {
    match parse() {
        Ok(Some(arguments)) => stress(&arguments),
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

fn parse() -> Result<Option<Arguments>, lexopt::Error> {
    let mut arguments = Arguments { states: 0..10_000_000, seed: 1, threads: 0, scope: Scope::Everything };
    let mut parser = lexopt::Parser::from_env();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("states") => arguments.states.end = parser.value()?.parse()?,
            Long("only") => {
                let index = parser.value()?.parse()?;
                arguments.states = index..index + 1;
            }
            Long("seed") => arguments.seed = parser.value()?.parse()?,
            Long("threads") => arguments.threads = parser.value()?.parse()?,
            Long("law") => arguments.scope = Scope::Law(parser.value()?.parse()?),
            Long("group") => arguments.scope = Scope::Group(parser.value()?.parse_with(Group::named)?),
            Long("help") | Short('h') => return Ok(None),
            other => return Err(other.unexpected()),
        }
    }
    Ok(Some(arguments))
}

fn stress(arguments: &Arguments) -> ExitCode {
    let begun = Instant::now();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads).build().expect("threads");
    let bar = progress_bar(arguments.states.end - arguments.states.start);
    // A panic is caught and reported with its inputs.
    std::panic::set_hook(Box::new(|_| ()));
    let Arguments { scope, states, seed, .. } = arguments;
    let tally = pool.install(|| stress::run(*scope, states.clone(), *seed, |states| bar.inc(states)));
    let _ = std::panic::take_hook();
    bar.finish_and_clear();
    let text = stress::summary(&tally);
    print!("{text}");
    let seconds = begun.elapsed().as_secs_f64();
    println!(
        "\nseed {}: {} broken, {seconds:.0} s on {} threads",
        arguments.seed,
        tally.broken(),
        pool.current_num_threads()
    );
    if let Err(error) = write(&tally, &text) {
        eprintln!("error: writing to target/stress: {error}");
        return ExitCode::FAILURE;
    }
    if tally.broken() == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn progress_bar(states: u64) -> ProgressBar {
    let target = if std::io::stderr().is_terminal() {
        ProgressDrawTarget::stderr()
    } else {
        ProgressDrawTarget::hidden()
    };
    let style =
        ProgressStyle::with_template("{wide_bar} {pos}/{len} states, {eta} left").expect("a template");
    let bar = ProgressBar::with_draw_target(Some(states), target);
    bar.set_style(style);
    bar
}

fn write(tally: &stress::Tally, text: &str) -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../target/stress");
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("report.txt"), text)?;
    stress::write_csv(tally, std::fs::File::create(folder.join("report.csv"))?)?;
    Ok(())
}
