//! Errors of a trial.

use thiserror::Error;

/// Reason why a trial has no result.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum TrialError {
    /// A spectrum or a surface cannot be made.
    #[error("making a surface: {0}")]
    RandomSurface(#[from] spectrum::random_surfaces::RandomSurfaceError),
    /// A surface cannot be pressed.
    #[error(transparent)]
    Elements(#[from] elements::half_space::HalfSpaceError),
    /// A model cannot be built.
    #[error("building a model: {0}")]
    Material(#[from] study::material::MaterialError),
    /// A load is out of range.
    #[error("running the models: {0}")]
    Load(#[from] units::OutOfBounds),
    /// The models cannot be run.
    #[error("running the models: {0}")]
    Plan(#[from] study::plan::PlanError),
    /// A scene cannot be read.
    #[error("reading a scene: {0}")]
    Scene(String),
    /// A spectrum cannot be sampled.
    #[error("sampling a spectrum: {0}")]
    Samples(#[from] spectrum::PsdError),
    /// Random surfaces cannot be made or pressed.
    #[error(transparent)]
    Random(#[from] elements::ElementsError),
    /// A theory has no gap.
    #[error("computing a gap: {0}")]
    Gap(#[from] study::gap_law::GapError),
    /// Flow through a gap cannot be solved.
    #[error(transparent)]
    Flow(#[from] transport::flow::FlowError),
    /// A pressed surface has no field of gaps.
    #[error(transparent)]
    GapField(#[from] transport::GapFieldError),
    /// The judge cannot press its surfaces.
    #[error(transparent)]
    Judge(#[from] judge::JudgeError),
    /// Synthetic scans cannot be read.
    #[error(transparent)]
    Scans(#[from] measurements::TopographyError),
    /// Scans cannot be transformed to a spectrum.
    #[error(transparent)]
    Transform(#[from] topography::TransformError),
    /// The scene of a study has no uncertain input.
    #[error("the scans of the study are not said to scatter")]
    Certain,
    /// The page has no section for a table.
    #[error("{0}")]
    Page(String),
    /// A table of results cannot be read or written.
    #[error("the table of results: {0}")]
    Table(#[from] csv::Error),
}
