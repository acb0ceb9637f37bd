//! Bounds of input numbers, and the error for a number outside its bound.

/// The interval a value must lie in.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
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
    /// Greater than one value and less than another, neither included.
    Between {
        /// The excluded lower end.
        above: f64,
        /// The excluded upper end.
        below: f64,
    },
    /// Finite.
    Finite,
    /// Finite and at least this value.
    AtLeast(f64),
    /// From one value to another, both included.
    Within {
        /// The lower end.
        at_least: f64,
        /// The upper end.
        at_most: f64,
    },
    /// From 1e-30 to 1e30: no product or power of such numbers in any law leaves the range of doubles.
    Magnitude,
    /// From -1e30 to 1e30, zero included.
    Signed,
}

/// The ends of [`Bound::Magnitude`].
const SMALLEST: f64 = 1e-30;
const LARGEST: f64 = 1e30;

impl Bound {
    /// Returns true if `value` satisfies the bound. NaN and infinities never do.
    #[must_use]
    pub fn admits(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Bound::Positive => value > 0.0,
                Bound::Finite => true,
                Bound::LeftOpen { above, at_most } => above < value && value <= at_most,
                Bound::Between { above, below } => above < value && value < below,
                Bound::AtLeast(least) => value >= least,
                Bound::Within { at_least, at_most } => (at_least..=at_most).contains(&value),
                Bound::Magnitude => (SMALLEST..=LARGEST).contains(&value),
                Bound::Signed => value.abs() <= LARGEST,
            }
    }

    /// Returns `value` if the bound admits it.
    ///
    /// # Errors
    /// [`OutOfBounds`] with the quantity, the value and the simplest bound that is violated.
    pub fn check(self, quantity: &'static str, value: f64) -> Result<f64, OutOfBounds> {
        if self.admits(value) {
            return Ok(value);
        }
        // Report the simplest bound that is violated.
        let simplest = match self {
            Bound::Magnitude => Bound::Positive,
            Bound::Signed => Bound::Finite,
            other => other,
        };
        Err(OutOfBounds { quantity, value, bound: if simplest.admits(value) { self } else { simplest } })
    }
}

impl std::fmt::Display for Bound {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Bound::Positive => write!(f, "finite and greater than 0"),
            Bound::Finite => write!(f, "finite"),
            Bound::LeftOpen { above, at_most } => {
                write!(f, "greater than {above} and at most {}", short(*at_most))
            }
            Bound::Between { above, below } => {
                write!(f, "greater than {} and less than {}", short(*above), short(*below))
            }
            Bound::AtLeast(least) => write!(f, "finite and at least {}", short(*least)),
            Bound::Within { at_least, at_most } => {
                write!(f, "from {} to {}", short(*at_least), short(*at_most))
            }
            Bound::Magnitude => write!(f, "from {SMALLEST:e} to {LARGEST:e}"),
            Bound::Signed => write!(f, "from -{LARGEST:e} to {LARGEST:e}"),
        }
    }
}

/// Formats a number with an exponent only below 1e-3 and from 1e5.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// A quantity outside its bound; the message names quantity, value and bound.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{quantity} is {}; it must be {bound}", short(*.value))]
#[non_exhaustive]
pub struct OutOfBounds {
    /// Name of the quantity with its unit.
    pub quantity: &'static str,
    /// Value in that unit.
    pub value: f64,
    /// The violated bound.
    pub bound: Bound,
}

#[cfg(test)]
mod tests {
    use super::Bound;

    #[test]
    fn a_violation_is_reported_by_the_simplest_bound() {
        let told = |bound: Bound, value| bound.check("it", value).map_err(|error| error.to_string());
        assert_eq!(told(Bound::Magnitude, 1e-30), Ok(1e-30));
        assert_eq!(told(Bound::Magnitude, 1e-31).unwrap_err(), "it is 1e-31; it must be from 1e-30 to 1e30");
        assert_eq!(
            told(Bound::Magnitude, -1.0).unwrap_err(),
            "it is -1; it must be finite and greater than 0"
        );
        assert_eq!(told(Bound::Signed, -1e30), Ok(-1e30));
        let within = Bound::Within { at_least: 1.0, at_most: 10_000.0 };
        assert_eq!((told(within, 1.0), told(within, 1e4)), (Ok(1.0), Ok(1e4)));
        assert_eq!(told(within, 0.0).unwrap_err(), "it is 0; it must be from 1 to 10000");
        assert!(told(within, f64::NAN).is_err());
        let between = Bound::Between { above: 0.0, below: 1.0 };
        assert_eq!(told(between, 0.95), Ok(0.95));
        assert_eq!(told(between, 1.0).unwrap_err(), "it is 1; it must be greater than 0 and less than 1");
        assert!(told(between, 0.0).is_err() && told(between, f64::NAN).is_err());
        assert_eq!(told(Bound::Signed, -1e31).unwrap_err(), "it is -1e31; it must be from -1e30 to 1e30");
        assert_eq!(told(Bound::Signed, f64::NAN).unwrap_err(), "it is NaN; it must be finite");
    }
}
