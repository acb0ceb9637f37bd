//! What a scene chooses of the judge.

/// The section `[judge]`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JudgeChoices {
    /// Points.
    pub grid: Option<usize>,
    /// Surfaces.
    pub realisations: Option<usize>,
    /// Seed.
    pub seed: Option<u64>,
    /// Budget.
    pub budget: Option<f64>,
    /// Off.
    pub off: bool,
}
