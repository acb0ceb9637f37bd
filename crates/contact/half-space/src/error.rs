//! What cannot be pressed.

use thiserror::Error;
use units::OutOfBounds;

/// A question that boundary elements have no answer to.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HalfSpaceError {
    /// A side of the grid without points, or with too many.
    #[error(
        "laying out boundary elements: there are {points} points along {along}, there must be from 1 to {largest}"
    )]
    Points {
        /// Which side.
        along: &'static str,
        /// How many points were given.
        points: usize,
        /// The most there may be.
        largest: usize,
    },
    /// A map of another size than the grid.
    #[error("laying out boundary elements: the map has {given} values, the grid {expected} points")]
    Size {
        /// Values given.
        given: usize,
        /// Points of the grid.
        expected: usize,
    },
    /// A height, modulus, pressure or tolerance out of its bounds.
    #[error("pressing boundary elements: {0}")]
    OutOfBounds(#[from] OutOfBounds),
    /// A load that is not below the pressure at which the surface flows.
    #[error(
        "pressing boundary elements: a nominal pressure of {nominal_pressure_pa:e} Pa cannot be carried, since no point \
         carries more than {saturation_pa:e} Pa; it must be less"
    )]
    CannotBeCarried {
        /// The nominal pressure in Pa.
        nominal_pressure_pa: f64,
        /// The pressure in Pa at which the surface flows.
        saturation_pa: f64,
    },
    /// The work was ended from outside.
    #[error("pressing boundary elements: ended before the surface was in equilibrium")]
    Cancelled,
}
