//! Numbers as headers give them: counts, sizes and factors that make sense.

/// A whole number above 0.
pub(crate) fn count(text: &str) -> Option<usize> {
    text.parse().ok().filter(|&count: &usize| count > 0)
}

/// A number that is neither infinite nor none.
pub(crate) fn finite(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

/// Returns the number if it can be a length: finite and above 0.
pub(crate) fn positive(number: f64) -> Option<f64> {
    (number.is_finite() && number > 0.0).then_some(number)
}
