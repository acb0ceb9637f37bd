//! Errors of the arguments, as Python's exceptions.

use std::fmt::Display;

use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, create_exception};
use units::printable::message;

create_exception!(
    truearea,
    InputError,
    PyValueError,
    "What was given cannot be used; the message names the argument, its value, and the bound that it breaks."
);

/// An error of what was given, in its own words.
pub fn input(error: impl Display) -> PyErr {
    InputError::new_err(message(&error.to_string()))
}

/// An error of one argument, headed by its name.
pub fn of_argument(argument: &str, error: impl Display) -> PyErr {
    input(format!("{argument}: {error}"))
}
