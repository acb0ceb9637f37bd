//! Why a trial has no result.

use gaussian_surfaces::SurfaceError;
use half_space::HalfSpaceError;
use thiserror::Error;

/// Why a trial has no result.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TrialError {
    /// A spectrum or a surface cannot be made.
    #[error("making a surface: {0}")]
    Surface(#[from] SurfaceError),
    /// A surface cannot be pressed.
    #[error(transparent)]
    Elements(#[from] HalfSpaceError),
    /// A table of results cannot be read or written.
    #[error("the table of results: {0}")]
    Table(#[from] csv::Error),
}
