//! Errors of pressing rough surfaces.

use crate::half_space::HalfSpaceError;
use spectrum::random_surfaces::RandomSurfaceError;
use thiserror::Error;

/// Reason why surfaces were not pressed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ElementsError {
    /// The surface cannot be made.
    #[error(transparent)]
    Surface(#[from] RandomSurfaceError),
    /// The surface cannot be pressed.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
    /// There are no surfaces, or no loads.
    #[error(
        "pressing surfaces: there are {surfaces} surfaces and {loads} loads; there must be one of each at least"
    )]
    Nothing {
        /// Number of surfaces.
        surfaces: usize,
        /// Number of loads.
        loads: usize,
    },
}
