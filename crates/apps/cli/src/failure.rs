//! Failures of a command: the message, and the exit status.

use std::process::ExitCode;

use interface::finite_elements::{ConductanceError, ContactLawError};
use study::plan::PlanError;
use tables::staging::PublishError;
use tables::{Refusal, TableError};

use crate::stderr::say;

/// The exit status of a program that was asked to end: 128, and 2 for Ctrl-C.
pub const INTERRUPTED: u8 = 130;

/// Reason that a command ends without its result.
#[derive(Debug)]
pub enum Failure {
    /// Bad input; the message names where, what, and against which bound. Exit status 2.
    Input(String),
    /// Something that could not be read or written. Exit status 1.
    System(String),
    /// The reader of stdout is gone, which ends a pipeline quietly. Exit status 0.
    ClosedPipe,
    /// Somebody asked the program to end before its result was there. Exit status 130, as shells have it.
    Interrupted,
    /// Somebody ended the work early; its result is there, and the message says what it rests on. Exit status 130.
    EndedEarly(String),
}

/// Makes errors bad input, said in their own words.
macro_rules! bad_input {
    ($($error:ty),*) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Failure::input(error)
            }
        }
    )*};
}

bad_input!(TableError, Refusal, ContactLawError, ConductanceError);

impl From<PublishError> for Failure {
    fn from(error: PublishError) -> Self {
        match error.not_restored[..] {
            [] => Failure::writing(&error.path.display().to_string(), &error.error),
            _ => Failure::System(error.to_string()),
        }
    }
}

impl From<PlanError> for Failure {
    fn from(error: PlanError) -> Self {
        match error {
            PlanError::Cancelled => Failure::Interrupted,
            error => Failure::input(error),
        }
    }
}

impl Failure {
    /// Bad input, said in the error's own words.
    pub fn input(error: impl std::fmt::Display) -> Self {
        Failure::Input(error.to_string())
    }

    /// Writing `what` failed.
    pub fn writing(what: &str, error: &std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
            std::io::ErrorKind::AlreadyExists => Failure::Input(format!("{what}: {error}")),
            _ => Failure::System(format!("writing {what}: {error}")),
        }
    }

    /// Reading `what` failed: it is input like any other.
    pub fn reading(what: &str, error: &std::io::Error) -> Self {
        Failure::Input(format!("reading {what}: {error}"))
    }

    /// Says it on stderr and turns it into the exit status.
    pub fn report(self) -> ExitCode {
        let (message, status) = match self {
            Failure::EndedEarly(message) => (message, INTERRUPTED),
            Failure::Input(message) => (message, 2),
            Failure::System(message) => (message, 1),
            Failure::Interrupted => ("ended before the result was there".to_owned(), INTERRUPTED),
            Failure::ClosedPipe => return ExitCode::SUCCESS,
        };
        say(&format!("error: {message}"));
        ExitCode::from(status)
    }
}
