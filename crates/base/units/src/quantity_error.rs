//! What is wrong with a typed quantity.

use crate::bound::OutOfBounds;

/// What is wrong with a typed quantity.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// No number at its start.
    #[error("'{text}' does not start with a number; a {what} reads like '{example}'")]
    NoNumber {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// A good one.
        example: &'static str,
    },
    /// A number without a unit.
    #[error("'{text}' has no unit; a {what} needs one of {units}, as in '{example}'")]
    NoUnit {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
        /// A good one.
        example: &'static str,
    },
    /// A unit of something else, or of nothing.
    #[error("'{text}' has the unit '{unit}'; a {what} needs one of {units}")]
    WrongUnit {
        /// What was typed.
        text: String,
        /// Its unit.
        unit: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
    },
    /// Not a usable magnitude.
    #[error("'{text}' is out of range; a {what} must be greater than 0 and finite")]
    NotPositive {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
    },
    /// A number that its scale of hardness does not have.
    #[error(
        "'{text}' is off its scale: {error}; give the hardness as a Vickers number, such as 300 HV, or as a pressure"
    )]
    OffScale {
        /// What was typed.
        text: String,
        /// The number and its bound.
        error: OutOfBounds,
    },
    /// Beyond the largest double.
    #[error("'{text}' is out of range; it must be finite")]
    NotFinite {
        /// What was typed.
        text: String,
    },
    /// A standard uncertainty below 0 or beyond the largest double.
    #[error("'{text}' is out of range; a standard uncertainty must be at least 0 and finite")]
    Uncertainty {
        /// What was typed.
        text: String,
    },
    /// A spread where one value is wanted.
    #[error(
        "'{text}' says how well a {what} is known, and one value is wanted here; a scene takes it for its material, as \
         [material] youngs_modulus = \"210 GPa +- 5 GPa\""
    )]
    OneValueWanted {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
    },
}
