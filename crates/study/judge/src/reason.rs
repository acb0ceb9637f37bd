//! Why a verdict is what it is, as data and in one line.

use std::fmt;

use serde::Serialize;
use units::display::{length, pressure, three_digits};

use crate::assumptions::Broken;

/// Why a verdict is what it is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reason {
    /// Areas were compared; of a whole band, on its worst window.
    Compared {
        /// The longest wave of the window \[m\].
        longest_m: f64,
        /// The shortest one \[m\].
        shortest_m: f64,
        /// The curve's area over that of the elements.
        ratio: f64,
        /// Mean pressure on the window over E* times its rms gradient.
        pressure_over_gradient: f64,
        /// On how many windows the curve agrees.
        agreeing: usize,
        /// Of how many.
        windows: usize,
    },
    /// An assumption of the curve does not hold.
    Broken(Broken),
    /// The strength grows at small scales, and matters: elements whose pressure is bounded by one hardness cannot tell.
    StrengthGrows {
        /// The wavelength \[m\] at which the curve's pressure first exceeds its hardness.
        wavelength_m: f64,
    },
    /// Too few points of the grid would touch.
    TooLight,
    /// The budget does not allow for this load.
    LoadNotChosen,
    /// The curve has no area there.
    NoArea,
    /// The work was ended first.
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
            Reason::Broken(Broken::Yields(above)) => write!(
                f,
                "takes no yielding into account, and its real pressure exceeds the hardness from {} on: {} over {}",
                length(above.wavelength_m),
                pressure(above.pressure_pa),
                pressure(above.hardness_pa)
            ),
            Reason::Broken(Broken::Unfitted { wavelength_m, load_share }) => write!(
                f,
                "{} of the load stands on asperities outside the range that the law was fitted in, from {} on",
                percent(load_share),
                length(wavelength_m)
            ),
            Reason::StrengthGrows { wavelength_m } => write!(
                f,
                "its strength grows at small scales, and its pressure exceeds it from {} on: elements know \
                 one hardness only",
                length(wavelength_m)
            ),
            Reason::TooLight => f.write_str("too few points of the grid would touch"),
            Reason::LoadNotChosen => f.write_str("the budget leaves this load out; set judge.budget"),
            Reason::NoArea => f.write_str("the curve has no area there"),
            Reason::Cancelled => f.write_str("ended before it was solved"),
            Reason::BeyondBudget => f.write_str("even the coarsest grid is beyond judge.budget"),
            Reason::NoSurface => f.write_str("the spectrum makes no surface"),
        }
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}
