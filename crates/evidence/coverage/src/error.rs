//! Errors of a study.

use measurements::TopographyError;
use scene::SceneError;
use spectrum::random_surfaces::RandomSurfaceError;
use study::plan::PlanError;
use topography::TransformError;

/// Reason why a study cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// The surface does not exist.
    #[error(transparent)]
    RandomSurface(#[from] RandomSurfaceError),
    /// The spectrum drawn is none.
    #[error(transparent)]
    Spectrum(#[from] spectrum::PsdError),
    /// The synthetic scans cannot be read.
    #[error(transparent)]
    Scans(#[from] TopographyError),
    /// The scans cannot be transformed to a spectrum.
    #[error(transparent)]
    Transform(#[from] TransformError),
    /// The scene cannot be read.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The scene cannot be run.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The scene has no uncertain input.
    #[error("the scans of the study are not said to scatter")]
    Certain,
}
