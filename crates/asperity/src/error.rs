//! What can be wrong with the numbers that describe a material, and the bounds they are held against.

/// The interval a value must lie in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Finite and greater than zero.
    Positive,
    /// Greater than `above`, at most `at_most`.
    LeftOpen {
        /// The excluded lower end.
        above: f64,
        /// The included upper end.
        at_most: f64,
    },
    /// Finite.
    Finite,
    /// Finite and at least this value.
    AtLeast(f64),
}

impl Bound {
    /// Whether `value` satisfies the bound. NaN and infinities never do.
    pub fn admits(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Bound::Positive => value > 0.0,
                Bound::Finite => true,
                Bound::LeftOpen { above, at_most } => above < value && value <= at_most,
                Bound::AtLeast(least) => value >= least,
            }
    }

    /// `value`, or the error that names the quantity, the value and this bound.
    ///
    /// # Errors
    /// [`AsperityError`] where the bound does not admit `value`.
    pub fn check(self, quantity: &'static str, value: f64) -> Result<f64, AsperityError> {
        if self.admits(value) { Ok(value) } else { Err(AsperityError { quantity, value, bound: self }) }
    }
}

impl std::fmt::Display for Bound {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Bound::Positive => write!(f, "finite and greater than 0"),
            Bound::Finite => write!(f, "finite"),
            Bound::LeftOpen { above, at_most } => write!(f, "greater than {above} and at most {at_most}"),
            Bound::AtLeast(least) => write!(f, "finite and at least {}", short(*least)),
        }
    }
}

/// A number as people write it, with an exponent only where it is far from 1.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// A quantity outside the range in which the laws make sense; its message names quantity, value and bound.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{quantity} is {}; it must be {bound}", short(*.value))]
pub struct AsperityError {
    /// What was being given, with its unit.
    pub quantity: &'static str,
    /// The value given, in that unit.
    pub value: f64,
    /// What it must satisfy.
    pub bound: Bound,
}
