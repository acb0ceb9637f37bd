//! Arguments that are numbers in SI units, or text with a unit.

use std::str::FromStr;

use pyo3::prelude::*;
use pyo3::types::{PyBool, PyString};
use units::{Bound, IndentationHardness, Length, Modulus, Pressure, QuantityError, SignedLength};

use crate::errors::{input, of_argument};

/// A quantity that is typed with its unit, or is a number in SI units.
pub trait Quantity: FromStr<Err = QuantityError> {
    /// The SI unit.
    const UNIT: &'static str;
    /// An example of its text, for messages.
    const EXAMPLE: &'static str;
    /// The bound on its number.
    const BOUND: Bound = Bound::Positive;

    /// Makes the quantity of a number in SI units.
    fn of_si(number: f64) -> Self;
}

impl Quantity for Length {
    const UNIT: &'static str = "m";
    const EXAMPLE: &'static str = "5 um";

    fn of_si(m: f64) -> Self {
        Length { m }
    }
}

impl Quantity for SignedLength {
    const UNIT: &'static str = "m";
    const EXAMPLE: &'static str = "-5 nm";
    const BOUND: Bound = Bound::Finite;

    fn of_si(m: f64) -> Self {
        SignedLength { m }
    }
}

impl Quantity for Modulus {
    const UNIT: &'static str = "Pa";
    const EXAMPLE: &'static str = "210 GPa";

    fn of_si(pa: f64) -> Self {
        Modulus { pa }
    }
}

impl Quantity for IndentationHardness {
    const UNIT: &'static str = "Pa";
    const EXAMPLE: &'static str = "3 GPa";

    fn of_si(pa: f64) -> Self {
        IndentationHardness { pa }
    }
}

impl Quantity for Pressure {
    const UNIT: &'static str = "Pa";
    const EXAMPLE: &'static str = "5 MPa";

    fn of_si(pa: f64) -> Self {
        Pressure::Pascals(pa)
    }
}

/// The quantity that an argument gives.
pub fn quantity<Q: Quantity>(argument: &str, given: &Given<'_>) -> PyResult<Q> {
    if let Ok(text) = given.cast::<PyString>() {
        return text.to_str()?.parse().map_err(|error| of_argument(argument, error));
    }
    let number = number(argument, given).map_err(|_| {
        let (unit, example, what) = (Q::UNIT, Q::EXAMPLE, type_name(given));
        of_argument(
            argument,
            format!("a number in {unit} is needed, or text such as '{example}', and this is {what}"),
        )
    })?;
    checked(argument, Q::BOUND, number).map(Q::of_si)
}

/// Returns the quantity of an argument that may be left out.
pub fn optional<Q: Quantity>(argument: &str, given: Option<&Given<'_>>) -> PyResult<Option<Q>> {
    given.map(|given| quantity(argument, given)).transpose()
}

/// A number within its bound.
pub fn checked(argument: &str, bound: Bound, number: f64) -> PyResult<f64> {
    bound
        .check("", number)
        .map_err(|error| input(format!("{argument} is {number}; it must be {}", error.bound)))
}

/// A plain number.
pub fn number(argument: &str, given: &Given<'_>) -> PyResult<f64> {
    let refused = || of_argument(argument, format!("a number is needed, and this is {}", type_name(given)));
    if given.is_instance_of::<PyBool>() || given.is_instance_of::<PyString>() {
        return Err(refused());
    }
    given.extract().map_err(|_| refused())
}

/// Describes the type of an argument, for messages.
pub fn type_name(given: &Given<'_>) -> String {
    given.get_type().name().map_or_else(|_| "something else".to_owned(), |name| format!("of type {name}"))
}

pub type Given<'py> = pyo3::Bound<'py, PyAny>;
