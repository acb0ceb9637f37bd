//! Reasons for verdicts, as data and in one line.

use std::fmt;

use serde::Serialize;
use units::display::{length, percent, pressure, three_digits};

use crate::assumptions::BrokenAssumption;
use crate::verdict::WorstWindow;

/// The reason for a verdict.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Reason {
    /// Areas were compared.
    Compared {
        /// The curve's area over that of the elements.
        ratio: f64,
    },
    /// Areas were compared with the whole band, and on windows of it.
    ComparedOnWholeBand {
        /// The curve's area over that of the elements with the whole band.
        ratio: f64,
        /// The window on which the curve is farthest from the elements.
        worst: Option<WorstWindow>,
        /// The number of windows on which the curve agrees.
        agreeing: usize,
        /// The number of windows on which it was compared.
        windows: usize,
    },
    /// An assumption of the curve does not hold.
    Broken(BrokenAssumption),
    /// The hardness grows at small scales by a law that elements do not have, and the contact yields.
    StrengthGrows {
        /// The wavelength \[m\] at which the curve's pressure first exceeds its hardness.
        wavelength_m: f64,
    },
    /// The curve touches more than elements whose hardness grows, but no more than those with the constant hardness.
    BetweenHardnesses {
        /// The curve's area over that of the elements whose hardness grows.
        ratio: f64,
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
            Reason::Compared { ratio } => {
                write!(f, "{} times the area of boundary elements", three_digits(ratio))
            }
            Reason::ComparedOnWholeBand { ratio, worst, agreeing, windows } => {
                write!(f, "{} times the area of boundary elements", three_digits(ratio))?;
                if let Some(WorstWindow { longest_m, shortest_m, ratio, .. }) = worst {
                    write!(
                        f,
                        "; agrees on {agreeing} of {windows} windows, worst from {} to {}: {} times",
                        length(longest_m),
                        length(shortest_m),
                        three_digits(ratio)
                    )?;
                }
                Ok(())
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
                "yields from {} on by a hardness law of its own, which boundary elements do not have",
                length(wavelength_m)
            ),
            Reason::BetweenHardnesses { ratio } => write!(
                f,
                "{} times the area of boundary elements whose hardness grows; no more than of those with the constant hardness",
                three_digits(ratio)
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
