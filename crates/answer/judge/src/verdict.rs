//! Verdicts on a model from a ratio of areas.

use serde::Serialize;

/// The ratio to the elements' area, either way, within which a model agrees, less one standard error of the elements. The
/// area of a light contact goes as the inverse of the rms gradient, so that a spectrum uncertain by a factor 1.8 makes it uncertain by as much.
pub const AGREEMENT: f64 = 4.0 / 3.0;

/// The number of standard errors between an area and the end of its bracket.
pub const ERRORS_GIVEN: f64 = 2.0;

/// The verdict on a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The area agrees with that of boundary elements within [`AGREEMENT`], less one standard error of the elements.
    Agrees,
    /// The area is larger.
    TooLarge,
    /// The area is smaller.
    TooSmall,
    /// An assumption of the curve does not hold, or it agrees with a map and not with Gaussian surfaces, which it is a model of.
    OutOfRange,
    /// No area of elements is available for comparison.
    NotJudged,
}

impl Verdict {
    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Agrees => "agrees",
            Verdict::TooLarge => "too-large",
            Verdict::TooSmall => "too-small",
            Verdict::OutOfRange => "out-of-range",
            Verdict::NotJudged => "not-judged",
        }
    }

    /// True for a verdict from a comparison of areas.
    #[must_use]
    pub fn compares(self) -> bool {
        matches!(self, Verdict::Agrees | Verdict::TooLarge | Verdict::TooSmall)
    }

    /// The verdict on a ratio to an area with this relative standard error. The bounds are narrowed by that error, so that a
    /// curve that agrees with the elements is within [`AGREEMENT`] of the truth.
    #[must_use]
    pub fn from_ratio(ratio: f64, relative_error: f64) -> Self {
        let bound = (AGREEMENT / (1.0 + relative_error)).max(1.0);
        if ratio > bound {
            Verdict::TooLarge
        } else if ratio * bound < 1.0 {
            Verdict::TooSmall
        } else {
            Verdict::Agrees
        }
    }
}

/// The window on which a curve is farthest from the elements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct WorstWindow {
    /// The longest wave of the window \[m\].
    pub longest_m: f64,
    /// The shortest wave of the window \[m\].
    pub shortest_m: f64,
    /// The curve's area over that of the elements.
    pub ratio: f64,
    /// The verdict on that ratio.
    pub verdict: Verdict,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_is_judged_the_same_either_way_and_the_bounds_are_narrowed_by_the_error() {
        assert_eq!(Verdict::from_ratio(1.3, 0.0), Verdict::Agrees);
        assert_eq!(Verdict::from_ratio(1.0 / 1.3, 0.0), Verdict::Agrees);
        assert_eq!(Verdict::from_ratio(1.4, 0.0), Verdict::TooLarge);
        assert_eq!(Verdict::from_ratio(1.0 / 1.4, 0.0), Verdict::TooSmall);
        assert_eq!(Verdict::from_ratio(1.3, 0.05), Verdict::TooLarge);
        assert_eq!(Verdict::from_ratio(1.25, 0.05), Verdict::Agrees);
        assert!(Verdict::Agrees.compares() && !Verdict::OutOfRange.compares());
    }
}
