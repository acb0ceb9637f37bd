//! Why a scene cannot be judged at all.

use gaussian_surfaces::SurfaceError;
use half_space::HalfSpaceError;
use spectrum::PsdError;
use study::plan::PlanError;
use units::OutOfBounds;

/// Why there is no judgement.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JudgeError {
    /// The spectrum is none of a surface, or a window of it cannot be laid on the grid.
    #[error("making surfaces of the spectrum for the judge: {0}")]
    Surface(#[from] SurfaceError),
    /// A surface cannot be pressed.
    #[error("pressing a surface for the judge: {0}")]
    HalfSpace(#[from] HalfSpaceError),
    /// The profiles of a window have no spectrum.
    #[error("taking the profiles of a window for the judge: {0}")]
    Profile(#[from] PsdError),
    /// The longer waves leave a pressure that no model takes.
    #[error("pressing the models on a window for the judge: {0}")]
    Pressure(#[from] OutOfBounds),
    /// A model cannot be carried out on a window.
    #[error("carrying out the models on a window for the judge: {0}")]
    Plan(#[from] PlanError),
}
