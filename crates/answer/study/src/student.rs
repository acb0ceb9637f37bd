//! Student's t distribution (Student 1908, Biometrika 6:1): the deviation of the mean of a few values from the true
//! mean.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// The normal quantile at 97.5 %, with the decimals of printed tables.
const NORMAL_975: f64 = 1.960;

/// Degrees of freedom up to which printed tables list Student's t.
const TABULATED: usize = 15;

/// Returns the half width of an interval of this probability, in standard errors of the mean of `values` >= 2 values: the
/// quantile of Student's t of n - 1 degrees of freedom.
#[must_use]
pub fn half_width(level: f64, values: usize) -> f64 {
    let freedom = values.saturating_sub(1).max(1) as f64;
    let quantile = |t: StudentsT| t.inverse_cdf(0.5 + 0.5 * level);
    StudentsT::new(0.0, 1.0, freedom).map_or(f64::INFINITY, quantile)
}

/// Returns the half width of an interval of this probability, in standard deviations of a normal distribution.
#[must_use]
pub fn normal_half_width(level: f64) -> f64 {
    Normal::standard().inverse_cdf(0.5 + 0.5 * level)
}

/// Returns the factor by which the standard error of a mean of `values` >= 2 values is widened so that twice of it covers
/// 95 %. Exact to a thousandth: quantiles have three decimals, as in printed tables.
#[must_use]
pub fn widening(values: usize) -> f64 {
    let freedom = values.saturating_sub(1).max(1);
    if freedom <= TABULATED {
        return (1e3 * half_width(0.95, values)).round() / 1e3 / NORMAL_975;
    }
    // Cornish & Fisher's expansion to second order.
    let (square, inverse) = (NORMAL_975 * NORMAL_975, (freedom as f64).recip());
    let first = (square + 1.0) / 4.0;
    let second = ((5.0 * square + 16.0) * square + 3.0) / 96.0;
    1.0 + inverse * (first + inverse * second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (values, t) in [(2, 12.706_205), (3, 4.302_653), (6, 2.570_582), (31, 2.042_272)] {
            assert!((half_width(0.95, values) / t - 1.0).abs() < 1e-6, "{values}");
        }
        assert!((normal_half_width(0.95) - 1.959_964).abs() < 1e-6);
    }

    #[test]
    fn widening_has_the_digits_of_the_printed_table() {
        let table = [
            12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160,
            2.145, 2.131,
        ];
        for (index, t) in table.into_iter().enumerate() {
            assert_eq!(widening(index + 2), t / 1.960, "{} values", index + 2);
        }
    }

    #[test]
    fn widening_falls_to_one_without_a_step() {
        let factors: Vec<f64> = (2..40).map(widening).collect();
        assert!(factors.windows(2).all(|pair| pair[1] < pair[0] && pair[1] > 1.0));
        assert!((widening(16) - widening(17)).abs() < 0.01);
    }
}
