//! Student's t distribution (Student 1908, Biometrika 6:1): the deviation of the mean of a few values from the true
//! mean.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

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
/// 95 %.
#[must_use]
pub fn widening(values: usize) -> f64 {
    half_width(0.95, values) / normal_half_width(0.95)
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
        assert!((widening(8) / (2.364_624 / 1.959_964) - 1.0).abs() < 1e-6);
    }
}
