//! Ranges of logarithmically spaced pressures.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::{Pressure, QuantityError};

/// A range of pressures, typed as `1kPa:1GPa:1000`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PressureRange {
    /// The first pressure.
    pub from: Pressure,
    /// The last pressure.
    pub to: Pressure,
    /// Number of pressures with both ends, at least 2.
    pub points: u32,
}

/// Errors of parsing a [`PressureRange`].
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PressureRangeError {
    /// The text does not have three parts.
    #[error("'{0}' is not a range of pressures; write FROM:TO:COUNT, as in '1kPa:1GPa:1000'")]
    NotThreeParts(String),
    /// An end is not a pressure.
    #[error(transparent)]
    End(#[from] QuantityError),
    /// The count is not a whole number in range.
    #[error("'{0}' must be a whole number from 2 to {most}", most = PressureRange::MOST_POINTS)]
    Count(String),
}

impl PressureRange {
    /// Largest number of pressures in a range.
    pub const MOST_POINTS: u32 = 10_000_000;
}

impl FromStr for PressureRange {
    type Err = PressureRangeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, points] = parts[..] else {
            return Err(PressureRangeError::NotThreeParts(text.to_owned()));
        };
        let count = points.trim().parse().ok().filter(|count| (2..=Self::MOST_POINTS).contains(count));
        let points = count.ok_or_else(|| PressureRangeError::Count(points.to_owned()))?;
        Ok(PressureRange { from: from.parse()?, to: to.parse()?, points })
    }
}

/// Yields `points` >= 2 logarithmically spaced values from `from` > 0 to `to` > 0, both included.
pub fn log_spaced(from: f64, to: f64, points: u32) -> impl Iterator<Item = f64> + Clone {
    let ratio = to / from;
    let last = points - 1;
    let value = move |at: u32| from * ratio.powf(f64::from(at) / f64::from(last));
    (0..last).map(value).chain([to])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_has_both_its_ends_and_equal_ratios() {
        let range: PressureRange = "1 kPa:1GPa:7".parse().unwrap();
        let [from_pa, to_pa] = [range.from, range.to].map(|end| end.pascals(None).unwrap());
        let found: Vec<f64> = log_spaced(from_pa, to_pa, range.points).collect();
        for (found, exponent) in found.iter().zip(3..) {
            assert!((found / 10f64.powi(exponent) - 1.0).abs() < 1e-14);
        }
        assert_eq!((found.len(), found[0], found[6]), (7, 1e3, 1e9));
    }

    #[test]
    fn a_bad_range_is_refused_with_an_example() {
        let message = |text: &str| text.parse::<PressureRange>().unwrap_err().to_string();
        assert_eq!(
            message("1kPa:1GPa"),
            "'1kPa:1GPa' is not a range of pressures; write FROM:TO:COUNT, as in '1kPa:1GPa:1000'"
        );
        assert_eq!(message("1kPa:1GPa:1"), "'1' must be a whole number from 2 to 10000000");
        assert!(message("1:1GPa:5").contains("'1' has no unit; a pressure needs one of Pa"));
    }
}
