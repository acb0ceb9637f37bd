//! The settings of draws, and their defaults.

use scene::UncertaintyChoices;

/// The default probability of an interval.
pub const DEFAULT_LEVEL: f64 = 0.95;

/// The default number of draws.
pub const DEFAULT_DRAWS: usize = 2000;

/// The default seed of the draws.
pub const DEFAULT_SEED: u64 = 1;

/// The settings of draws.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Settings {
    /// The probability that an interval covers, above 0 and below 1.
    pub level: f64,
    /// The number of draws.
    pub draws: usize,
    /// The seed of the draws.
    pub seed: u64,
    /// The size of the full design for shares of variance; `None` for a small one, with its error.
    pub shares_draws: Option<usize>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { level: DEFAULT_LEVEL, draws: DEFAULT_DRAWS, seed: DEFAULT_SEED, shares_draws: None }
    }
}

impl Settings {
    /// The settings of a scene's section `[uncertainty]`; the defaults without one.
    #[must_use]
    pub fn from_choices(choices: Option<&UncertaintyChoices>) -> Self {
        let Some(choices) = choices else { return Settings::default() };
        Settings {
            level: choices.level.unwrap_or(DEFAULT_LEVEL),
            draws: choices.draws.unwrap_or(DEFAULT_DRAWS),
            seed: choices.seed.unwrap_or(DEFAULT_SEED),
            shares_draws: choices.shares_draws,
        }
    }
}
