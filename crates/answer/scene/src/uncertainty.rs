//! Settings of the uncertainty analysis: typed values, checked against their bounds.

use serde_spanned::Spanned;
use units::Bound;

use super::error::SceneError;
use super::raw::RawUncertainty;
use super::values::{value_error, whole_number};

/// Settings of the uncertainty analysis in a scene. The analysis chooses those that are absent.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct UncertaintyChoices {
    /// The probability that an interval covers, above 0 and below 1.
    pub level: Option<f64>,
    /// Number of draws, from 20 to 1,000,000.
    pub draws: Option<usize>,
    /// Seed of the draws.
    pub seed: Option<u64>,
    /// Draws of the full design that shares of variance are taken from, from 64 to 1,000,000.
    pub shares_draws: Option<usize>,
    /// True if the scene turns the uncertainty analysis off.
    pub off: bool,
}

impl UncertaintyChoices {
    /// The probability that an interval covers: of 0 it is a point, of 1 it has no ends.
    pub const LEVEL: Bound = Bound::Between { above: 0.0, below: 1.0 };

    /// Draws that intervals rest on: below, no end of an interval of 95 % is among them; above, their own error is far below
    /// what few scans leave.
    pub const DRAWS: Bound = Bound::Within { at_least: 20.0, at_most: 1_000_000.0 };

    /// Draws of the design that shares of variance are taken from: below, a share is lost in its own error.
    pub const SHARES_DRAWS: Bound = Bound::Within { at_least: 64.0, at_most: 1_000_000.0 };

    /// Turns the draws off.
    pub(super) const OFF: Self =
        UncertaintyChoices { level: None, draws: None, seed: None, shares_draws: None, off: true };
}

pub(super) fn resolve_uncertainty(raw: &RawUncertainty) -> Result<UncertaintyChoices, SceneError> {
    let whole = |key, quantity, raw: &Option<Spanned<i64>>, bound| {
        raw.as_ref().map(|raw| whole_number(key, quantity, raw, bound)).transpose()
    };
    let draws = whole("uncertainty.draws", "the number of draws", &raw.draws, UncertaintyChoices::DRAWS)?;
    let seed = whole("uncertainty.seed", "the seed", &raw.seed, Bound::AtLeast(0.0))?;
    let shares_draws = whole(
        "uncertainty.shares_draws",
        "the number of draws for shares",
        &raw.shares_draws,
        UncertaintyChoices::SHARES_DRAWS,
    )?;
    let level = raw.level.as_ref().map(|raw| {
        let value = *raw.get_ref();
        let checked = UncertaintyChoices::LEVEL.check("the probability that an interval covers", value);
        checked.map_err(|error| value_error("uncertainty.level", &value.to_string(), raw.span(), error))
    });
    Ok(UncertaintyChoices {
        level: level.transpose()?,
        draws: draws.map(|draws| draws as usize),
        seed,
        shares_draws: shares_draws.map(|draws| draws as usize),
        off: raw.off,
    })
}
