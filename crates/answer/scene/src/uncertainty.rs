//! Settings of the uncertainty analysis: typed values, checked against their bounds.

use serde::Serialize;
use units::Bound;

use super::error::SceneError;
use super::raw::RawUncertainty;
use super::values::{number, whole_number};

/// Settings of the uncertainty analysis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct UncertaintySettings {
    /// The probability that an interval covers, above 0 and below 1.
    pub level: f64,
    /// Number of draws, from 20 to 1,000,000.
    pub draws: usize,
    /// Seed of the draws.
    pub seed: u64,
    /// Draws of the full design that shares of variance are taken from, from 64 to 1,000,000; a small design, with its error, if
    /// absent.
    pub shares_draws: Option<usize>,
    /// True if the scene turns the uncertainty analysis off.
    #[serde(skip)]
    pub off: bool,
}

impl Default for UncertaintySettings {
    fn default() -> Self {
        UncertaintySettings { level: 0.95, draws: 2000, seed: 1, shares_draws: None, off: false }
    }
}

impl UncertaintySettings {
    /// The probability that an interval covers: of 0 it is a point, of 1 it has no ends.
    pub const LEVEL: Bound = Bound::Between { above: 0.0, below: 1.0 };

    /// Draws that intervals rest on: below, no end of an interval of 95 % is among them; above, their own error is far below
    /// what few scans leave.
    pub const DRAWS: Bound = Bound::Within { at_least: 20.0, at_most: 1_000_000.0 };

    /// Draws of the design that shares of variance are taken from: below, a share is lost in its own error.
    pub const SHARES_DRAWS: Bound = Bound::Within { at_least: 64.0, at_most: 1_000_000.0 };
}

pub(super) fn resolve_uncertainty(raw: &RawUncertainty) -> Result<UncertaintySettings, SceneError> {
    let draws =
        whole_number("uncertainty.draws", "the number of draws", &raw.draws, UncertaintySettings::DRAWS)?;
    let seed = whole_number("uncertainty.seed", "the seed", &raw.seed, Bound::AtLeast(0.0))?;
    let shares_draws = whole_number(
        "uncertainty.shares_draws",
        "the number of draws for shares",
        &raw.shares_draws,
        UncertaintySettings::SHARES_DRAWS,
    )?;
    let covers = "the probability that an interval covers";
    let level = raw.level.as_ref();
    let level = level.map(|level| number("uncertainty.level", covers, level, UncertaintySettings::LEVEL));
    let usual = UncertaintySettings::default();
    Ok(UncertaintySettings {
        level: level.transpose()?.unwrap_or(usual.level),
        draws: draws.map_or(usual.draws, |draws| draws as usize),
        seed: seed.unwrap_or(usual.seed),
        shares_draws: shares_draws.map(|draws| draws as usize),
        off: raw.off,
    })
}
