//! What cannot be pressed.

use gaussian_surfaces::SurfaceError;
use half_space::HalfSpaceError;
use thiserror::Error;

/// Why surfaces were not pressed.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ElementsError {
    /// There is no such surface.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// It cannot be pressed so.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
    /// Nothing to press, or nothing to press it with.
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
