//! Ranges of pressures, evenly spaced in their logarithms.

use std::str::FromStr;

use crate::{Pressure, QuantityError};

/// Pressures from one to another, as typed: `1kPa:1GPa:1000`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureRange {
    /// The first.
    pub from: Pressure,
    /// The last.
    pub to: Pressure,
    /// How many, both ends included: at least 2.
    pub points: u32,
}

/// What is wrong with a typed range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PressureRangeError {
    /// Not three parts.
    #[error("'{0}' is no range of pressures; one reads FROM:TO:COUNT, as in '1kPa:1GPa:1000'")]
    NotThreeParts(String),
    /// An end that is no pressure.
    #[error(transparent)]
    End(#[from] QuantityError),
    /// A count that is none.
    #[error("'{0}' must be a whole number from 2 to {most}", most = PressureRange::MOST_POINTS)]
    Count(String),
}

impl PressureRange {
    /// The most pressures in a range.
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

/// Values evenly spaced in their logarithms from one > 0 to another, both included; `points` is at least 2.
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
    fn a_bad_range_is_told_how_one_reads() {
        let message = |text: &str| text.parse::<PressureRange>().unwrap_err().to_string();
        assert_eq!(
            message("1kPa:1GPa"),
            "'1kPa:1GPa' is no range of pressures; one reads FROM:TO:COUNT, as in '1kPa:1GPa:1000'"
        );
        assert_eq!(message("1kPa:1GPa:1"), "'1' must be a whole number from 2 to 10000000");
        assert!(message("1:1GPa:5").contains("'1' has no unit; a pressure needs one of Pa"));
    }
}
