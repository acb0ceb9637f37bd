//! What may be chosen of the draws, and what holds where nothing is.

use scene::UncertaintyChoices;

/// The probability that an interval covers, where none is set.
pub const DEFAULT_LEVEL: f64 = 0.95;

/// How many draws are made where no number is set.
pub const DEFAULT_DRAWS: usize = 1000;

/// The seed of the draws where none is set.
pub const DEFAULT_SEED: u64 = 1;

/// How a scene's draws are made.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Settings {
    /// The probability that an interval covers, above 0 and below 1.
    pub level: f64,
    /// How many draws are made.
    pub draws: usize,
    /// The seed of the draws.
    pub seed: u64,
    /// Draws of the full design that shares of variance are taken from; where absent, a small one that says how far it
    /// can be trusted.
    pub shares_draws: Option<usize>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { level: DEFAULT_LEVEL, draws: DEFAULT_DRAWS, seed: DEFAULT_SEED, shares_draws: None }
    }
}

impl Settings {
    /// Those of a scene's section `[uncertainty]`, where it has one.
    #[must_use]
    pub fn of(choices: Option<&UncertaintyChoices>) -> Self {
        let Some(choices) = choices else { return Settings::default() };
        Settings {
            level: choices.level.unwrap_or(DEFAULT_LEVEL),
            draws: choices.draws.unwrap_or(DEFAULT_DRAWS),
            seed: choices.seed.unwrap_or(DEFAULT_SEED),
            shares_draws: choices.shares_draws,
        }
    }
}
