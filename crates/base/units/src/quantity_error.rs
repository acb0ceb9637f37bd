//! Errors of typed quantities.

use crate::bound::OutOfBounds;
use crate::printable::listed;

/// Errors of parsing a quantity with its unit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// The text does not start with a number.
    #[error("'{text}' does not start with a number; {} {what} reads like '{example}'", article(what))]
    NoNumber {
        /// The typed text.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// A valid example.
        example: &'static str,
    },
    /// A number without a unit.
    #[error("'{text}' has no unit; {} {what} needs one of {units}, as in '{example}'", article(what))]
    NoUnit {
        /// The typed text.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
        /// A valid example.
        example: &'static str,
    },
    /// A unit of another kind of quantity, or an unknown one.
    #[error("'{text}' has the unit '{unit}'; {} {what} needs one of {units}", article(what))]
    WrongUnit {
        /// The typed text.
        text: String,
        /// The unit in it.
        unit: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
    },
    /// A force where a pressure is wanted.
    #[error(
        "'{text}' is a force; a pressure is it over the area that bears it, and a scene takes both: force = \"{text}\" and \
         nominal_area = \"1 cm^2\" in [loads]"
    )]
    Force {
        /// The typed text.
        text: String,
    },
    /// Several values where one is expected.
    #[error(
        "'{text}' holds several values; repeat the option for each, or write [{}] in a scene",
        listed(values, "\"")
    )]
    Several {
        /// The typed text.
        text: String,
        /// Each of them.
        values: Vec<String>,
    },
    /// A unit in the wrong case, such as `mpa`.
    #[error("'{text}' has the unit '{unit}'; write {}", meant.join(" or "))]
    UnitCase {
        /// The typed text.
        text: String,
        /// The unit in it.
        unit: String,
        /// The quantities that it may mean, at least one.
        meant: Vec<String>,
    },
    /// A comma in a number.
    #[error("'{text}' has a comma; write {meant}")]
    Comma {
        /// The typed text.
        text: String,
        /// The text without the comma, both readings where it has two.
        meant: String,
    },
    /// A power of ten with `10^`.
    #[error("'{text}' has a power of ten; write {meant}")]
    PowerOfTen {
        /// The typed text.
        text: String,
        /// The text with `e`.
        meant: String,
    },
    /// Zero, negative or beyond the largest double.
    #[error("'{text}' is out of range; {} {what} must be greater than 0 and finite", article(what))]
    NotPositive {
        /// The typed text.
        text: String,
        /// The kind of quantity.
        what: &'static str,
    },
    /// A number outside its hardness scale.
    #[error(
        "'{text}' is off its scale: {error}; give the hardness as a Vickers number, such as 300 HV, or as a pressure"
    )]
    OffScale {
        /// The typed text.
        text: String,
        /// The number and its bound.
        error: OutOfBounds,
    },
    /// Beyond the largest double.
    #[error("'{text}' is out of range; it must be finite")]
    NotFinite {
        /// The typed text.
        text: String,
    },
    /// A standard uncertainty below 0 or beyond the largest double.
    #[error("'{text}' is out of range; a standard uncertainty must be at least 0 and finite")]
    Uncertainty {
        /// The typed text.
        text: String,
    },
    /// A value with its uncertainty where a single value is expected.
    #[error(
        "expected a single {what}, not '{text}'; uncertainties (+-, to) are allowed only for materials of scenes"
    )]
    OneValueWanted {
        /// The typed text.
        text: String,
        /// The kind of quantity.
        what: &'static str,
    },
}

/// The indefinite article of a kind of quantity.
fn article(what: &str) -> &'static str {
    if what.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" }
}
