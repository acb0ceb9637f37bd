//! Errors of boundary elements.

use thiserror::Error;
use units::OutOfBounds;

/// Reason why a surface cannot be pressed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HalfSpaceError {
    /// A side of the grid has no points, or too many.
    #[error(
        "laying out boundary elements: there are {points} points along {along}, there must be from 1 to {largest}"
    )]
    Points {
        /// The side.
        along: &'static str,
        /// Number of points given.
        points: usize,
        /// Largest number of points.
        largest: usize,
    },
    /// A map has another size than the grid.
    #[error("laying out boundary elements: the map has {given} values, the grid {expected} points")]
    Size {
        /// Number of values given.
        given: usize,
        /// Number of points of the grid.
        expected: usize,
    },
    /// A height, modulus, pressure or tolerance is out of its bounds.
    #[error("pressing boundary elements: {0}")]
    OutOfBounds(#[from] OutOfBounds),
    /// The load is not below the pressure at which the surface yields.
    #[error(
        "pressing boundary elements: a nominal pressure of {nominal_pressure_pa:e} Pa cannot be carried, since no point \
         carries more than {saturation_pa:e} Pa; it must be less"
    )]
    CannotBeCarried {
        /// Nominal pressure \[Pa\].
        nominal_pressure_pa: f64,
        /// Pressure at which the surface yields \[Pa\].
        saturation_pa: f64,
    },
    /// The load is lost in the rounding of the heights.
    #[error(
        "pressing boundary elements: a nominal pressure of {nominal_pressure_pa:e} Pa moves the surface by less than its heights \
         are rounded to; it must be at least {least_pa:e} Pa"
    )]
    TooLight {
        /// Nominal pressure \[Pa\].
        nominal_pressure_pa: f64,
        /// Smallest nominal pressure \[Pa\] that this surface can be pressed with.
        least_pa: f64,
    },
    /// A surface of finite size has no mean gap that could be held.
    #[error(
        "pressing boundary elements: a mean gap needs a periodic surface that faces the half-space; give an \
         indentation"
    )]
    NoMeanGap,
    /// No point touches at this mean gap.
    #[error(
        "pressing boundary elements: nothing touches at a mean gap of {mean_gap_m:e} m, since the highest point is \
         {highest_m:e} m above the mean; it must be less"
    )]
    Apart {
        /// Mean gap \[m\].
        mean_gap_m: f64,
        /// Height \[m\] of the highest point over the mean.
        highest_m: f64,
    },
    /// The whole surface touches before the bodies have come so near.
    #[error(
        "pressing boundary elements: no gap is left at an indentation of {indentation_m:e} m, since the highest point is \
         {highest_m:e} m above the mean; it must be less"
    )]
    Closed {
        /// Indentation \[m\].
        indentation_m: f64,
        /// Height \[m\] of the highest point over the mean.
        highest_m: f64,
    },
    /// The kernel of a layer is one of waves, which a surface of finite size does not have.
    #[error(
        "pressing boundary elements: a layer needs a surface that repeats itself; make the boundary of the map periodic, or leave \
         out the layer"
    )]
    FreeLayer,
    /// Only a flat is pressed onto a map with missing points, without adhesion.
    #[error(
        "pressing boundary elements: the map has missing points ({missing}), and only a flat without adhesion is pressed onto such a map; \
         have them filled (gaps = \"harmonic\")"
    )]
    MissingPoints {
        /// Number of missing points.
        missing: usize,
    },
    /// No point of the map belongs to a specimen.
    #[error("pressing boundary elements: no point of the map has a height")]
    NoSpecimen,
    /// The work was cancelled.
    #[error("pressing boundary elements: ended before the surface was in equilibrium")]
    Cancelled,
}
