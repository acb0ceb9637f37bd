//! What is wrong in a scene, and where it stands.

use std::fmt;
use std::ops::Range;

use crate::material::{MaterialError, MaterialProperty};
use crate::surface::SurfaceError;

/// Something wrong in a scene, and where.
#[derive(Debug)]
pub struct SceneError {
    /// What is wrong.
    pub problem: SceneProblem,
    /// The bytes of the scene to point at; the whole of it where absent.
    pub span: Option<Range<usize>>,
}

/// What is wrong in a scene.
#[derive(Debug)]
#[non_exhaustive]
pub enum SceneProblem {
    /// The text, a key or a value is none that a scene may have.
    Text(String),
    /// A curve needs what the material lacks.
    Material(MaterialError),
    /// The spectrum or the scans cannot be had.
    Surface(SurfaceError),
}

impl SceneError {
    pub(super) fn at(span: Range<usize>, problem: impl Into<SceneProblem>) -> Self {
        SceneError { problem: problem.into(), span: Some(span) }
    }

    pub(super) fn anywhere(problem: impl Into<SceneProblem>) -> Self {
        SceneError { problem: problem.into(), span: None }
    }

    /// The line of the scene that it points at, counted from 1.
    #[must_use]
    pub fn line(&self, scene: &str) -> Option<usize> {
        let before = scene.get(..self.span.as_ref()?.start)?;
        Some(1 + before.matches('\n').count())
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.problem.fmt(f)
    }
}

impl std::error::Error for SceneError {}

impl fmt::Display for SceneProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SceneProblem::Text(text) => f.write_str(text),
            SceneProblem::Material(error @ MaterialError::Missing(needed_for)) => {
                let key = match needed_for.property() {
                    MaterialProperty::YieldStrength => "yield_strength",
                    MaterialProperty::StrainGradientLength => "strain_gradient_length",
                };
                write!(f, "{error}: add {key} in [material]")
            }
            SceneProblem::Material(error) => error.fmt(f),
            SceneProblem::Surface(error) => error.fmt(f),
        }
    }
}

impl From<String> for SceneProblem {
    fn from(text: String) -> Self {
        SceneProblem::Text(text)
    }
}

impl From<&str> for SceneProblem {
    fn from(text: &str) -> Self {
        SceneProblem::Text(text.to_owned())
    }
}

impl From<MaterialError> for SceneProblem {
    fn from(error: MaterialError) -> Self {
        SceneProblem::Material(error)
    }
}

impl From<SurfaceError> for SceneProblem {
    fn from(error: SurfaceError) -> Self {
        SceneProblem::Surface(error)
    }
}
