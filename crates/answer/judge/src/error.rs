//! Errors of a judgement.

use elements::half_space::HalfSpaceError;
use spectrum::PsdError;
use spectrum::random_surfaces::RandomSurfaceError;
use study::plan::PlanError;
use units::OutOfBounds;

/// The reason why a scene cannot be judged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JudgeError {
    /// No surface has this spectrum, or a window of it does not fit the grid.
    #[error("making surfaces of the spectrum for the judge: {0}")]
    RandomSurface(#[from] RandomSurfaceError),
    /// A surface cannot be pressed.
    #[error("pressing a surface for the judge: {0}")]
    HalfSpace(#[from] HalfSpaceError),
    /// The profiles of a window have no spectrum.
    #[error("taking the profiles of a window for the judge: {0}")]
    Profile(#[from] PsdError),
    /// The pressure on a window is out of bounds for the models.
    #[error("pressing the models on a window for the judge: {0}")]
    Pressure(#[from] OutOfBounds),
    /// A model cannot be computed on a window.
    #[error("computing the models on a window for the judge: {0}")]
    Plan(#[from] PlanError),
}
