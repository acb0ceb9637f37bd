//! What may be chosen of the judge, and what holds where nothing is.

use scene::JudgeChoices;

/// Operators times points that a scene spends where it sets no budget: one to two seconds of two processors.
pub const DEFAULT_BUDGET: f64 = 6e7;

/// The seed of the surfaces where none is set.
pub const DEFAULT_SEED: u64 = 1;

/// Surfaces pressed in each window where nothing else is set.
pub const DEFAULT_REALISATIONS: usize = 4;

/// Grids that are tried, from fine to coarse: their sides have small factors, which fast Fourier transforms like.
pub(crate) const GRIDS: [usize; 10] = [1024, 768, 512, 384, 256, 192, 128, 96, 64, 48];

/// The judge's choices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Points along each side of a surface; where absent, as many as the budget allows.
    pub grid: Option<usize>,
    /// Surfaces in each window; where absent, [`DEFAULT_REALISATIONS`] if the budget allows.
    pub realisations: Option<usize>,
    /// The seed of the surfaces.
    pub seed: u64,
    /// Solver operators times points that may be spent.
    pub budget: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { grid: None, realisations: None, seed: DEFAULT_SEED, budget: DEFAULT_BUDGET }
    }
}

impl Settings {
    /// Those of a scene's section `[judge]`, where it has one.
    #[must_use]
    pub fn of(choices: Option<&JudgeChoices>) -> Self {
        let Some(choices) = choices else { return Settings::default() };
        Settings {
            grid: choices.grid,
            realisations: choices.realisations,
            seed: choices.seed.unwrap_or(DEFAULT_SEED),
            budget: choices.budget.unwrap_or(DEFAULT_BUDGET),
        }
    }
}
