//! Why a study cannot be carried out.

use gaussian_surfaces::SurfaceError;
use measurements::TopographyError;
use scene::SceneError;
use study::plan::PlanError;
use topography::TransformError;

/// Why a study cannot be carried out.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// There is no surface as asked for.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// The synthetic scans do not read.
    #[error(transparent)]
    Scans(#[from] TopographyError),
    /// They make no spectrum.
    #[error(transparent)]
    Transform(#[from] TransformError),
    /// The scene about them does not read.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The scene cannot be carried out.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// Nothing of a scene is said to scatter.
    #[error("the scans of the study are not said to scatter")]
    Certain,
}
