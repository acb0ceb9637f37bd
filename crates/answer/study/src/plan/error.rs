//! Errors of plans.

use std::num::NonZeroU32;

use asperity::AsperityError;
use persson::hardness_laws::HardnessError;
use spectrum::FitError;
use units::display::{length, three_digits};

/// More scales than any spectrum resolves, and what still fits into memory under a handful of loads.
pub(super) const MOST_SCALES: usize = 2_000_000;

/// The largest number of rows of curves in memory; each takes some 150 bytes.
pub(super) const MOST_ROWS: usize = 10_000_000;

/// An error of a plan.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// No wavelength is left above the cutoff.
    #[error(
        "the cutoff {} leaves no scale: the longest wavelength is {}; choose a shorter one",
        length(*.cutoff_m), length(*.longest_m)
    )]
    NothingLeft {
        /// The cutoff \[m\].
        cutoff_m: f64,
        /// The longest wavelength \[m\].
        longest_m: f64,
    },
    /// The resampled spectrum would be too large.
    #[error(
        "{scales_per_decade} scales per decade make {} scales; at most {MOST_SCALES} are computed, choose fewer",
        three_digits(*.scales)
    )]
    TooManyScales {
        /// The requested number of scales per decade.
        scales_per_decade: NonZeroU32,
        /// The scales it makes.
        scales: f64,
    },
    /// Scales, loads and curves together are more than is held.
    #[error(
        "{curves} curves at {loads} loads over {scales} scales make {rows} rows; at most {MOST_ROWS} are held: take fewer \
         loads, curves or scales per decade, or cutoffs = \"shortest\""
    )]
    TooManyRows {
        /// Number of curves.
        curves: usize,
        /// Number of loads and separations per curve.
        loads: usize,
        /// Largest number of scales per curve.
        scales: usize,
        /// The rows that they and the sweeps over loads make, at most.
        rows: usize,
    },
    /// The observer of the plan cancelled it.
    #[error("ended before all was computed")]
    Cancelled,
    /// The fit has too little to go by.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A hardness that cannot be used with this spectrum, or cannot carry a load.
    #[error(transparent)]
    Hardness(#[from] HardnessError),
    /// A value that no model takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
}
