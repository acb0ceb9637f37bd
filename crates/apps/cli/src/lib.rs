//! The `truearea` command line as a library: arguments, files and messages.
//!
//! It computes nothing itself: [`args`] parses the command line, `commands` fill the structs of [`questions`] and show their
//! answers in the words of [`report`], and [`output`] writes each file whole or not at all.

pub mod args;
mod commands;
pub mod failure;
mod files;
mod flags;
mod inputs;
mod interruption;
mod memory;
mod missing_file;
pub mod output;
mod picture;
mod place;
mod progress;
mod results_folder;
mod stderr;
mod suggestion;
mod targets;
mod terminal;
mod timings;
mod written;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

/// Runs the program on its command line, the program's name first, and yields its exit status: 0, 2 for bad input, 1
/// for what could not be written, 130 where it was asked to end.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    interruption::listen();
    let args: Vec<OsString> = args.into_iter().collect();
    if args.len() < 2 {
        stderr::say(suggestion::FIRST_WORDS);
        return ExitCode::from(2);
    }
    let typed: Vec<String> = args.iter().skip(1).map(|arg| arg.to_string_lossy().into_owned()).collect();
    match args::Args::try_parse_from(&args) {
        Ok(parsed) => match commands::run(parsed, &typed) {
            Ok(()) => ExitCode::SUCCESS,
            // A result that is in place is not interrupted.
            Err(_) if interruption::is_asked_for() && tables::staging::has_published() => ExitCode::SUCCESS,
            // A program that is ended often loses its input as well, which is not the fault of the input.
            Err(_) if interruption::is_asked_for() => failure::Failure::Interrupted.report(),
            Err(failure) => failure.report(),
        },
        Err(error) => {
            if let Some(word) = args.iter().find(|word| word.to_str().is_none()) {
                let word = word.to_string_lossy();
                let message = format!("'{word}' is not UTF-8, and names of files must be; rename the file");
                return failure::Failure::Input(message).report();
            }
            if let Some(message) =
                suggestion::for_file(&error, &args).or_else(|| suggestion::in_place_of(&error, &args))
            {
                return failure::Failure::Input(message).report();
            }
            // Printing help is not an error; a closed pipe is ignored.
            let _ = error.print();
            ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
        }
    }
}
