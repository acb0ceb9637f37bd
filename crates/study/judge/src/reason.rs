//! Reasons for verdicts, as data and in one line.

use std::fmt;

use serde::Serialize;
use units::display::{length, percent, pressure, three_digits};

use crate::assumptions::BrokenAssumption;

/// The reason for a verdict.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reason {
    /// Areas were compared: for the verdict on a curve, on its worst window.
    Compared {
        /// The longest wave of the window \[m\].
        longest_m: f64,
        /// The shortest one \[m\].
        shortest_m: f64,
        /// The curve's area over that of the elements.
        ratio: f64,
        /// Mean pressure on the window over E* times its rms gradient.
        pressure_over_gradient: f64,
        /// The number of windows on which the curve agrees.
        agreeing: usize,
        /// The number of windows on which it was compared.
        windows: usize,
    },
    /// An assumption of the curve does not hold.
    Broken(BrokenAssumption),
    /// The strength grows at small scales, and the contact yields: boundary elements have only one hardness.
    StrengthGrows {
        /// The wavelength \[m\] at which the curve's pressure first exceeds its hardness.
        wavelength_m: f64,
    },
    /// Too few points of the grid would touch.
    TooLight,
    /// The budget leaves this load out.
    LoadNotChosen,
    /// The curve has no area on the window.
    NoArea,
    /// The work was cancelled first.
    Cancelled,
    /// Even the coarsest grid is beyond the budget.
    BeyondBudget,
    /// The spectrum is of one wavelength, or makes no surface.
    NoSurface,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Reason::Compared { longest_m, shortest_m, ratio, pressure_over_gradient, agreeing, windows } => {
                write!(
                    f,
                    "{} times the area of boundary elements from {} to {} at p/(E* h') = {}; agrees on {agreeing} of {windows} \
                     windows",
                    three_digits(ratio),
                    length(longest_m),
                    length(shortest_m),
                    three_digits(pressure_over_gradient)
                )
            }
            Reason::Broken(BrokenAssumption::Yields(above)) => write!(
                f,
                "assumes that nothing yields, but from {} on the real pressure, {}, exceeds the hardness, {}",
                length(above.wavelength_m),
                pressure(above.pressure_pa),
                pressure(above.hardness_pa)
            ),
            Reason::Broken(BrokenAssumption::Unfitted { wavelength_m, load_share }) => write!(
                f,
                "from {} on, {} of the load rests on asperities outside the fitted range of the law",
                length(wavelength_m),
                percent(load_share)
            ),
            Reason::StrengthGrows { wavelength_m } => write!(
                f,
                "yields from {} on with a strength that grows at small scales; boundary elements know one hardness only",
                length(wavelength_m)
            ),
            Reason::TooLight => f.write_str("too few grid points would touch"),
            Reason::LoadNotChosen => f.write_str("the budget leaves this load out; raise judge.budget"),
            Reason::NoArea => f.write_str("the curve has no area here"),
            Reason::Cancelled => f.write_str("cancelled before it was solved"),
            Reason::BeyondBudget => f.write_str("even the coarsest grid exceeds judge.budget"),
            Reason::NoSurface => f.write_str("no surface can be made of the spectrum"),
        }
    }
}

impl Reason {
    /// The reason of a worst window, as that of its curve: with the number of windows on which the curve agrees, and was
    /// compared.
    pub(crate) fn over_windows(mut self, agreeing_windows: usize, compared_windows: usize) -> Self {
        if let Reason::Compared { agreeing, windows, .. } = &mut self {
            (*agreeing, *windows) = (agreeing_windows, compared_windows);
        }
        self
    }
}
