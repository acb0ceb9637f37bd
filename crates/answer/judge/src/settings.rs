//! The settings of the judge, and their defaults.

use scene::JudgeChoices;

/// The default budget in operator applications times grid points: one to two seconds on two processors.
pub const DEFAULT_BUDGET: f64 = 6e7;

/// The default seed of the surfaces.
pub const DEFAULT_SEED: u64 = 1;

/// The default number of surfaces in each window.
pub const DEFAULT_REALISATIONS: usize = 4;

/// Grids that are tried, from fine to coarse: their sides have small factors, which fast Fourier transforms like.
pub(crate) const GRIDS: [usize; 10] = [1024, 768, 512, 384, 256, 192, 128, 96, 64, 48];

/// The settings of the judge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JudgeSettings {
    /// Points along each side of a surface; `None` for the largest number within the budget.
    pub grid: Option<usize>,
    /// Surfaces in each window; `None` for [`DEFAULT_REALISATIONS`] if the budget allows.
    pub realisations: Option<usize>,
    /// The seed of the surfaces.
    pub seed: u64,
    /// Operator applications times grid points that may be spent.
    pub budget: f64,
}

impl Default for JudgeSettings {
    fn default() -> Self {
        JudgeSettings { grid: None, realisations: None, seed: DEFAULT_SEED, budget: DEFAULT_BUDGET }
    }
}

impl JudgeSettings {
    /// The settings of a scene's section `[judge]`; the defaults without one.
    #[must_use]
    pub fn from_choices(choices: Option<&JudgeChoices>) -> Self {
        let Some(choices) = choices else { return JudgeSettings::default() };
        JudgeSettings {
            grid: choices.grid,
            realisations: choices.realisations,
            seed: choices.seed.unwrap_or(DEFAULT_SEED),
            budget: choices.budget.unwrap_or(DEFAULT_BUDGET),
        }
    }
}
